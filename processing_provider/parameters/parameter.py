"""Kinds of parameters: name, label, unit, default, limits and help of each stand together, once.

A parameter makes its QGIS definition, and reads and checks its value. A value that cannot be used raises
`InputError`, with one sentence for the user.
"""

# ruff: noqa: D102 - what overrides a method or property is described where that is.

import math
import sys
from abc import ABC, abstractmethod
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Union

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsMapLayer,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFile,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProcessingUtils,
    QgsProperty,
)
from qgis.PyQt.QtCore import QFile

from ...algorithms.errors import InputError


@dataclass(frozen=True)
class Parameter(ABC):
    """What all parameters have.

    Attributes
    ----------
    name : str
        The name that scripts and models store.
    label : str
        What the dialog shows.
    help : str
        Plain text: what it does, and when to change it.
    """

    name: str
    label: str
    help: str

    @property
    def description(self) -> str:
        """The label, with the unit if there is one."""
        return self.label

    @property
    def explanation(self) -> str:
        """The help, with the default and the limits if there are any."""
        return self.help

    def definition(self) -> QgsProcessingParameterDefinition:
        """Return a new definition, which QGIS will own."""
        definition = self._definition()
        definition.setHelp(self.explanation)
        return definition

    @abstractmethod
    def _definition(self) -> QgsProcessingParameterDefinition:
        """Return a definition without help."""

    @abstractmethod
    def value(self, algorithm: QgsProcessingAlgorithm, parameters: dict, context: QgsProcessingContext):
        """Return the value of this parameter among `parameters`, or raise `InputError`."""

    def sources(self, value) -> list:
        """Return the files that a value stands for, which no output may replace."""
        return []


@dataclass(frozen=True)
class Number(Parameter):
    """A number; if it has no default, it is optional, and None where the user does not set it."""

    unit: str
    minimum: float
    default: Optional[float] = None
    maximum: float = sys.float_info.max
    whole: bool = False
    advanced: bool = False
    decimals: int = 3

    @property
    def description(self) -> str:
        return f"{self.label} ({self.unit})"

    @property
    def explanation(self) -> str:
        default = "not set" if self.default is None else f"{self.default:g}"
        return f"{self.help} Default {default}; {self._limits()}."

    def _definition(self) -> QgsProcessingParameterNumber:
        kinds = QgsProcessingParameterNumber.Type
        definition = QgsProcessingParameterNumber(
            self.name,
            self.description,
            kinds.Integer if self.whole else kinds.Double,
            self.default,
            self.default is None,
            self.minimum,
            min(self.maximum, 2**31 - 1) if self.whole else self.maximum,
        )
        definition.setMetadata({"widget_wrapper": {"decimals": self.decimals}})
        return _marked(definition) if self.advanced else definition

    def value(self, algorithm, parameters, context) -> Union[int, float, None]:
        # As a string, for QGIS reads a word as 0, and does not tell an empty value from it.
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        if not text:
            return self.default
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not self.minimum <= value <= self.maximum or (self.whole and value % 1):
            kind = "whole number" if self.whole else "number"
            raise InputError(f"{self.name} must be a {kind}, {self._limits()} ({self.unit}), not {text}.")
        return int(value) if self.whole else value

    def _limits(self) -> str:
        if self.maximum == sys.float_info.max:
            return f"at least {self.minimum:g}"
        return f"from {self.minimum:g} to {self.maximum:g}"


@dataclass(frozen=True)
class Choice(Parameter):
    """One of several options, by its number from 0; the first is the default."""

    options: tuple
    advanced: bool = False

    @property
    def explanation(self) -> str:
        numbered = "; ".join(f"{number} {option}" for number, option in enumerate(self.options))
        return f"{self.help} {numbered}. Default 0."

    def _definition(self) -> QgsProcessingParameterEnum:
        # Optional, for a model that was stored before an advanced choice was added has no value of it.
        definition = QgsProcessingParameterEnum(
            self.name,
            self.description,
            list(self.options),
            allowMultiple=False,
            defaultValue=0,
            optional=self.advanced,
        )
        return _marked(definition) if self.advanced else definition

    def value(self, algorithm, parameters, context) -> int:
        # As a string, for QGIS takes what it does not know for the default.
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        numbers = {str(number): number for number in range(len(self.options))}
        if text and text not in numbers:
            choices = " or ".join(f"{number} ({option})" for number, option in enumerate(self.options))
            raise InputError(f"{self.name} must be {choices}, not {text}.")
        return numbers.get(text, 0)


@dataclass(frozen=True)
class Flag(Parameter):
    """A choice between yes and no."""

    default: bool
    advanced: bool = True

    @property
    def explanation(self) -> str:
        return f"{self.help} Default {'yes' if self.default else 'no'}."

    def _definition(self) -> QgsProcessingParameterBoolean:
        definition = QgsProcessingParameterBoolean(self.name, self.description, self.default)
        return _marked(definition) if self.advanced else definition

    def value(self, algorithm, parameters, context) -> bool:
        # As a string, for QGIS takes any word for yes.
        text = algorithm.parameterAsString(parameters, self.name, context).strip().lower()
        words = {
            "true": True,
            "yes": True,
            "1": True,
            "false": False,
            "no": False,
            "0": False,
            "": self.default,
        }
        if text not in words:
            raise InputError(f"{self.name} must be true or false, not {text}.")
        return words[text]


@dataclass(frozen=True)
class CloudFiles(Parameter):
    """One or more point cloud files."""

    def _definition(self) -> QgsProcessingParameterMultipleLayers:
        files = QgsProcessing.SourceType.TypeFile
        return QgsProcessingParameterMultipleLayers(self.name, self.description, files)

    def value(self, algorithm, parameters, context) -> list:
        given = _files(parameters.get(self.name), context)
        if not given:
            raise InputError(f"{self.name} is empty; choose at least one point cloud file.")
        return [path for item in given for path in _in_folder(item)]

    def sources(self, value) -> list:
        return value


@dataclass(frozen=True)
class RasterFile(Parameter):
    """A raster, from a file or a loaded layer."""

    def _definition(self) -> QgsProcessingParameterRasterLayer:
        return QgsProcessingParameterRasterLayer(self.name, self.description)

    def value(self, algorithm, parameters, context) -> str:
        given = parameters.get(self.name)
        if isinstance(given, QgsMapLayer):
            return given.source()
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        if not text:
            raise InputError(f"{self.name} is empty; choose a raster.")
        return _source(text, context)

    def sources(self, value) -> list:
        return [value]


@dataclass(frozen=True)
class PlainFile(Parameter):
    """A file that is no layer; a subclass says of which kind."""

    kind = ""

    def _definition(self) -> QgsProcessingParameterFile:
        files = f"{self.kind.upper()} files (*.{self.kind});;All files (*)"
        return QgsProcessingParameterFile(self.name, self.description, fileFilter=files)

    def value(self, algorithm, parameters, context) -> str:
        path = algorithm.parameterAsFile(parameters, self.name, context).strip()
        if not path:
            raise InputError(f"{self.name} is empty; choose a {self.kind} file.")
        return path

    def sources(self, value) -> list:
        return [value]


@dataclass(frozen=True)
class JsonFile(PlainFile):
    """A json file."""

    kind = "json"


@dataclass(frozen=True)
class TableFile(PlainFile):
    """A table."""

    kind = "csv"


@dataclass(frozen=True)
class ReferenceSystem(Parameter):
    """An optional coordinate reference system."""

    def _definition(self) -> QgsProcessingParameterCrs:
        return QgsProcessingParameterCrs(self.name, self.description, optional=True)

    def value(self, algorithm, parameters, context) -> Optional[QgsCoordinateReferenceSystem]:
        crs = algorithm.parameterAsCrs(parameters, self.name, context)
        if crs.isValid():
            return crs
        text = algorithm.parameterAsString(parameters, self.name, context).strip()
        if text:
            raise InputError(f"{self.name} {text} is not known; write it like EPSG:25832.")
        return None


def _marked(definition: QgsProcessingParameterDefinition) -> QgsProcessingParameterDefinition:
    """Put a definition among the advanced ones."""
    advanced = QgsProcessingParameterDefinition.Flag.FlagAdvanced
    definition.setFlags(definition.flags() | advanced)
    return definition


def _files(given, context: QgsProcessingContext) -> list:
    """Return the paths in any of the spellings that dialogs, scripts, models and command lines have."""
    if isinstance(given, QgsProperty):
        given, _ = given.value(context.expressionContext())
    if isinstance(given, QgsMapLayer):
        return [given.source()]
    if isinstance(given, (list, tuple)):
        return [path for item in given for path in _files(item, context)]
    return [_source(path, context) for path in _split(str(given))] if given else []


def _in_folder(path: str) -> list:
    """Return the clouds in a folder, as another algorithm may have written it, or the path itself."""
    if not Path(path).is_dir():
        return [path]
    from ...algorithms.clouds.cloud import clouds_in

    return [str(cloud) for cloud in clouds_in(Path(path))]


def _split(text: str) -> list:
    """Return the paths in a text that may hold several, separated by semicolons or line ends."""
    if QFile.exists(text):
        return [text]
    return [part.strip() for part in text.replace("\n", ";").split(";") if part.strip()]


def _source(text: str, context: QgsProcessingContext) -> str:
    """Return the path of a file, which may be given by the id or name of a loaded layer."""
    loading = False
    layer = None if QFile.exists(text) else QgsProcessingUtils.mapLayerFromString(text, context, loading)
    return layer.source() if layer else text
