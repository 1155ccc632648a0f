"""One site from one or more scan files of any readable format."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, TypeVar, Union

import numpy as np
from rasterio.crs import CRS

from ..errors import InputError
from ..progress import Progress
from ..reference_systems import horizontal, is_local, name_of, position_warning, require_metres
from ..tables.remarks import system_remark
from .formats import format_of, readable_formats
from .settings import ReadingSettings
from .source import Chunk, Source, unreadable

SourceKind = TypeVar("SourceKind", bound=Source)


@dataclass(frozen=True)
class Cloud:
    """The points of several files in one coordinate reference system.

    Attributes
    ----------
    sources : tuple of Source
        One for each file, in the given order.
    origin : ndarray of float64, shape (3,)
        Near the points; multiples of 100 m in x and y, 0 in z.
    crs : CRS or None
        Horizontal and in metres.
    warnings : tuple of str
        What the user should know about the files, in sentences.
    """

    sources: tuple[Source, ...]
    origin: np.ndarray
    crs: Optional[CRS]
    warnings: tuple[str, ...]

    def chunks(
        self, progress: Progress = Progress(), size: int = ReadingSettings.chunk_points
    ) -> Iterator[Chunk]:
        """Yield the points of all files in order; can be called any number of times.

        Parameters
        ----------
        progress : Progress
        size : int
            Largest number of points in a chunk.

        Raises
        ------
        InputError
            If a file is truncated or damaged.
        CancelledError
            If the caller asked to stop.
        """
        for source, part in parts(self.sources, progress):
            yield from source.chunks(self.origin, part, size)

    def positions(
        self, progress: Progress = Progress(), size: int = ReadingSettings.chunk_points
    ) -> Iterator[np.ndarray]:
        """Yield only the positions of the points, shape (n, 3), as `chunks` does; faster."""
        for source, part in parts(self.sources, progress):
            yield from source.positions(self.origin, part, size)

    @property
    def expected_points(self) -> int:
        """How many points the files announce; 0 for those that do not."""
        return sum(source.expected_points for source in self.sources)


def parts(sources: Sequence[SourceKind], progress: Progress) -> Iterator[tuple[SourceKind, Progress]]:
    """Yield every source with its part of the progress, in proportion to the bytes."""
    sizes = [source.path.stat().st_size for source in sources]
    ends = np.cumsum(sizes) / sum(sizes)
    for source, start, stop in zip(sources, [0.0, *ends], ends):
        yield source, progress.part(start, stop)


def open_cloud(
    paths: Sequence[Union[str, Path]],
    crs: Optional[CRS] = None,
    settings: ReadingSettings = ReadingSettings(),
) -> Cloud:
    """Open scan files as one site.

    Parameters
    ----------
    paths : sequence of str or Path
    crs : CRS, optional
        For the files that do not state one.
    settings : ReadingSettings

    Raises
    ------
    InputError
        If a file is missing, empty, truncated, of another format than its extension says or
        of an unknown one, or if the coordinates are not metres of one reference system.
    """
    sources = open_sources(paths, settings)
    common, warnings = _common_crs(sources, crs)
    code = common.to_epsg() if common else None
    middle = sources[0].middle
    return Cloud(
        sources=sources,
        origin=np.array([*(np.floor(middle[:2] / 100) * 100), 0.0]),
        crs=common,
        warnings=(
            *(
                sentence
                for source in sources
                for sentence in source.warnings
                if sentence != system_remark(source.path, str(code))
            ),
            *warnings,
            *_misplaced(sources, common),
        ),
    )


def open_scans(paths: Sequence[Union[str, Path]], settings: ReadingSettings = ReadingSettings()) -> Cloud:
    """Open scan files that are not registered yet, each in a coordinate system of its own.

    Raises
    ------
    InputError
        As `open_cloud`, but reference systems in metres may differ.
    """
    sources = open_sources(paths, settings)
    for source in sources:
        if source.crs:
            require_metres(source.crs, str(source.path))
    warnings = tuple(sentence for source in sources for sentence in source.warnings)
    return Cloud(sources=sources, origin=np.zeros(3), crs=None, warnings=warnings)


def clouds_in(folder: Path) -> list[Path]:
    """Return the clouds in a folder, by name.

    TXT and CSV files are returned only if there are no others, because lists of points, which are no
    clouds, lie beside clouds as such files.

    Raises
    ------
    InputError
        If there are none, or the folder cannot be read.
    """
    try:
        found = [(path, format_of(path)) for path in sorted(folder.iterdir())]
    except OSError as error:
        raise unreadable(folder, error) from error
    clouds = [path for path, known in found if known]
    certain = [path for path, known in found if known and not known.may_be_list]
    if not clouds:
        raise InputError(f"The folder {folder} holds no point cloud; choose another, or single files.")
    return certain or clouds


def open_sources(
    paths: Sequence[Union[str, Path]], settings: ReadingSettings = ReadingSettings()
) -> tuple[Source, ...]:
    """Open scan files, each in a coordinate system of its own; see `open_cloud`."""
    if not paths:
        raise InputError("No point cloud was given; choose at least one file.")
    files = [Path(path) for path in paths]
    resolved = [path.resolve() for path in files]
    repeated = next((path for i, path in enumerate(files) if resolved[i] in resolved[:i]), None)
    if repeated:
        raise InputError(f"{repeated} is listed twice; remove one entry.")
    return tuple(_open(path, settings) for path in files)


def _open(path: Path, settings: ReadingSettings) -> Source:
    known = format_of(path)
    if known is None:
        raise InputError(f"{path} has an unknown extension; convert it to {readable_formats()}.")
    if not path.is_file():
        raise InputError(f"{path} does not exist or is not a file; check the name and the folder.")
    if path.stat().st_size == 0:
        raise InputError(f"{path} is empty; copy or export it again.")
    source: Source = known.open(path, settings)
    return source


def _common_crs(sources: tuple[Source, ...], chosen: Optional[CRS]) -> tuple[Optional[CRS], tuple[str, ...]]:
    """Return the reference system of all sources, and what the user should know about it."""
    if chosen is not None:
        chosen = horizontal(chosen)
        require_metres(chosen, "the cloud in the chosen coordinate reference system")
        chosen = None if is_local(chosen) else chosen
    known = [(source.path, source.crs or chosen) for source in sources if source.crs or chosen]
    if not known:
        return None, (
            f"There is no coordinate reference system in {names_of(sources)} and none was chosen, "
            "so the results have none either.",
        )
    first, common = known[0]
    for path, crs in known:
        require_metres(crs, str(path))
        if crs != common:
            raise InputError(
                f"{first} is in {name_of(common)}, but {path} in {name_of(crs)}; "
                "reproject them to the same coordinate reference system."
            )
    silent = tuple(source for source in sources if not (source.crs or chosen))
    if silent:
        return common, (
            f"There is no coordinate reference system in {names_of(silent)}, so {name_of(common)} "
            "of the other files is used for them.",
        )
    if chosen is not None and chosen != common:
        return common, (f"{first} is in {name_of(common)}, so the chosen {name_of(chosen)} is not used.",)
    return common, ()


def _misplaced(sources: tuple[Source, ...], crs: Optional[CRS]) -> tuple[str, ...]:
    """Return a sentence on the files that do not fit the reference system, one for each reason."""
    alike: dict[tuple[str, ...], list[Source]] = {}
    for source in sources:
        alike.setdefault(position_warning(crs, source.middle, ""), []).append(source)
    return tuple(
        sentence
        for files in alike.values()
        for sentence in position_warning(crs, files[0].middle, names_of(tuple(files)))
    )


def names_of(sources: tuple[Source, ...]) -> str:
    """Return the names of files for a message; of many, the first and how many more."""
    names = [source.path.name for source in sources]
    return ", ".join(names) if len(names) <= 3 else f"{names[0]} and {len(names) - 1} more files"
