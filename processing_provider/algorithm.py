"""Base of the algorithms: it reads the parameters, calls the core and writes the files with their styles."""

# ruff: noqa: D102, N802 - QGIS defines and names the methods.

import warnings
from abc import abstractmethod
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional, Union

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProject,
)
from qgis.PyQt.QtGui import QIcon

from ..algorithms.errors import IchnographError, InputError, MissingPackageError
from ..algorithms.files import Outputs, new_folder
from ..algorithms.staging import recover
from .dependencies import ALL, explain_broken, explain_missing, lacking
from .help import help_of
from .interruption import compilation_announced, interruptible
from .labels import with_labels
from .language import translated
from .layers import reopen_layers
from .log import Log
from .manual import page_url
from .parameters.destinations import Destination, FolderWriters, Writer, check_outputs
from .parameters.parameter import Parameter
from .projections import projections_kept
from .skipped_outputs import with_skipped
from .styles import MARK, show_when_loaded, style_of

ICONS = Path(__file__).parent / "icons"


@dataclass(frozen=True)
class Outcome:
    """The result of an algorithm, before it is written.

    Attributes
    ----------
    writers : dict of str to callable(Path)
        Writers of the files, by the names of the destinations; of a folder, the writers of its files by name.
    numbers : dict of str to float
        Values of the numeric outputs.
    styles : dict of str to dict
        Values of the variables of the styles, by the names of the destinations.
    """

    writers: Mapping[str, Union[Writer, FolderWriters]]
    numbers: Mapping[str, Any]
    styles: Mapping[str, dict[str, Any]] = field(default_factory=dict)


class Algorithm(QgsProcessingAlgorithm):
    """Base of the algorithms.

    A subclass sets the attributes below, and its `compute` calls the core.

    Attributes
    ----------
    key, title, chapter : str
        Id, name and group in the toolbox.
    summary, about : str
        One sentence, and a few more; plain text.
    words : tuple of str
        Search words of the toolbox.
    inputs : tuple of Parameter
    destinations : tuple of Destination
    numbers : tuple of (str, str)
        Names and labels of the numeric outputs.
    needs : tuple of str
        The modules without which it does not run.
    project : QgsProject or None
        Of the run.
    """

    key = title = chapter = summary = about = ""
    words: tuple[str, ...] = ()
    inputs: tuple[Parameter, ...] = ()
    destinations: tuple[Destination, ...] = ()
    numbers: tuple[tuple[str, str], ...] = ()
    needs: tuple[str, ...] = ALL

    def __init__(self) -> None:
        super().__init__()
        self._layers: list[str] = []
        self.project: Any = None

    @abstractmethod
    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Call the core with the values of the inputs and the paths of the destinations, by name.

        The path of a file that the user does not want is None.
        """

    def name(self) -> str:
        return self.key

    def displayName(self) -> str:
        return translated(self.title)

    def group(self) -> str:
        return translated(self.chapter)

    def groupId(self) -> str:
        return self.chapter.replace(" ", "").lower()

    def icon(self) -> QIcon:
        return QIcon(self.svgIconPath())

    def svgIconPath(self) -> str:
        return str(ICONS / f"{self.key}.svg")

    def tags(self) -> list[str]:
        return list(self.words)

    def shortDescription(self) -> str:
        return translated(self.summary)

    def shortHelpString(self) -> str:
        return help_of(self.about, self.inputs, self.destinations, self._named())

    def helpUrl(self) -> str:
        return page_url(self.key)

    def createInstance(self) -> "Algorithm":
        return type(self)()

    def initAlgorithm(self, configuration: Optional[dict[str, Any]] = None) -> None:
        for parameter in (*self.inputs, *self.destinations):
            self.addParameter(parameter.definition())
        for output in self.destinations:
            for definition in output.further_outputs():
                self.addOutput(definition)
        for name, label in self.numbers:
            self.addOutput(QgsProcessingOutputNumber(name, translated(label)))

    def canExecute(self) -> tuple[bool, str]:
        missing = lacking(self.needs)
        return not missing, translated(explain_missing(missing)) if missing else ""

    def preprocessParameters(self, parameters: dict[str, Any]) -> dict[str, Any]:
        return with_skipped(self, parameters)

    def checkParameterValues(
        self, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> tuple[bool, str]:
        try:
            self._values(parameters, context)
        except IchnographError as error:
            return False, self._said(str(error))
        except ImportError as error:
            # Reading a layer needs the packages.
            missing = lacking(self.needs)
            return False, self._said(explain_missing(missing) if missing else explain_broken(error))
        return True, ""

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        with self._plain_errors(), projections_kept(), interruptible(feedback.isCanceled):
            # Only the desktop calls canExecute.
            missing = lacking(self.needs)
            if missing:
                raise QgsProcessingException(self._said(explain_missing(missing)))
            log = Log(feedback, self._named())
            self.project = context.project() or QgsProject.instance()
            log.warn(self._unknown(parameters))
            values = self._values(parameters, context)
            chosen = {output: output.value(self, parameters, context) for output in self.destinations}
            files = {output: path for output, path in chosen.items() if path}
            sources = self._sources(values)
            check_outputs(files, sources)
            for path in files.values():
                recover(path.parent)
                recover(path)
            wanted = {output.name: files.get(output) for output in self.destinations}
            with _without_deprecations(), compilation_announced(log.info):
                outcome = self.compute({**values, **wanted}, log)
            styles = _write(files, outcome, sources, log, self._labels())
            for output, path in files.items():
                log.warn(output.warnings(path, outcome.writers[output.name]))
        focus = [str(path) for output, path in files.items() if output.focus]
        show_when_loaded(styles, focus, context)
        self._layers = [str(path) for path in styles]
        results = dict(outcome.numbers)
        for output, path in files.items():
            results.update(output.results(path, outcome.writers[output.name]))
        return results

    def postProcessAlgorithm(
        self, context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        reopen_layers(self._layers, context)
        return {}

    def validateInputCrs(self, parameters: dict[str, Any], context: QgsProcessingContext) -> bool:
        # QGIS would try to open files that are not layers; the algorithms compare the systems themselves.
        return True

    @contextmanager
    def _plain_errors(self) -> Iterator[None]:
        """Raise exceptions of the core as the one of QGIS, whose text the user sees."""
        try:
            yield
        except MissingPackageError as error:
            sentence = explain_missing(lacking(error.modules))
            text = f"{error.what} cannot be {error.done}: {sentence}"
            raise QgsProcessingException(self._said(text)) from error
        except IchnographError as error:
            raise QgsProcessingException(self._said(str(error))) from error
        except MemoryError as error:
            sentence = "There is not enough memory; cut or thin the input, or close other programs."
            raise QgsProcessingException(self._said(sentence)) from error
        except ImportError as error:
            raise QgsProcessingException(self._said(explain_broken(error))) from error

    def _said(self, sentence: str) -> str:
        """Return a sentence of the core as the user reads it."""
        return with_labels(translated(sentence), self._named())

    def _labels(self) -> dict[str, str]:
        return {item.name: translated(item.label) for item in (*self.inputs, *self.destinations)}

    def _named(self) -> dict[str, str]:
        """Return what a person reads in place of the ids of parameters and of algorithms."""
        others = self.provider().algorithms() if self.provider() else []
        titles = {item.name(): item.displayName() for item in others if isinstance(item, Algorithm)}
        return {**titles, **self._labels()}

    def _values(self, parameters: dict[str, Any], context: QgsProcessingContext) -> dict[str, Any]:
        return {parameter.name: parameter.value(self, parameters, context) for parameter in self.inputs}

    def _unknown(self, parameters: dict[str, Any]) -> list[str]:
        known = {parameter.name for parameter in (*self.inputs, *self.destinations)}
        unknown = [name for name in parameters if name not in known]
        return [f"{self.key} has no parameter {name}; it is ignored." for name in unknown]

    def _sources(self, values: dict[str, Any]) -> list[str]:
        return [path for item in self.inputs for path in item.sources(values[item.name])]


def _write(
    files: dict[Destination, Path], outcome: Outcome, sources: list[str], log: Log, labels: Mapping[str, str]
) -> dict[Path, Optional[str]]:
    """Write all files with their styles, or none of them; return the styles of the layers by path."""
    styles: dict[Path, Optional[str]] = {path: None for output, path in files.items() if output.is_layer}
    read = {Path(source).resolve() for source in sources}
    jobs = [
        (output, path, write)
        for output, target in files.items()
        for path, write in output.files(target, outcome.writers[output.name]).items()
    ]
    # Layers whose names differ only in the extension would share one style file.
    stems = [path.with_suffix("") for output, path, _ in jobs if output.style_of(path)]
    for output, path, _ in jobs:
        if path.resolve() in read:
            raise InputError(f"{output.name}: {path} is an input as well; choose another folder.")
    with ExitStack() as stack:
        for _, path, _ in jobs:
            stack.enter_context(new_folder(path.parent))
        outputs = stack.enter_context(Outputs())
        for output, path, write in jobs:
            log.progress.update(1.0, f"Writing {path.name}")
            with outputs.staged(path) as temporary:
                try:
                    write(temporary)
                except MissingPackageError:
                    raise
                except IchnographError as error:
                    # Name the file that the user chose, not the temporary one.
                    raise type(error)(str(error).replace(str(temporary), str(path))) from error
                output.revise(temporary, labels)
                named = output.style_of(path)
                if named:
                    style = style_of(named, temporary, outcome.styles.get(output.name, {}))
                    styles[path] = style
                    if _is_ours(path.with_suffix(".qml")) and stems.count(path.with_suffix("")) == 1:
                        temporary.with_suffix(".qml").write_text(style, encoding="utf-8")
    return styles


@contextmanager
def _without_deprecations() -> Iterator[None]:
    """Keep from the user what packages tell their developers; QGIS would show it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        yield


def _is_ours(style: Path) -> bool:
    """Whether a style may be written there; the user's own is kept."""
    return not style.exists() or MARK in style.read_text(encoding="utf-8", errors="replace")
