"""Every facade of a building or a street, measured one after the other."""

from dataclasses import dataclass, replace

from ..errors import NothingFoundError
from ..progress import Progress
from .development.development import FLAT
from .elevation import Elevation
from .measurement import measure_facade
from .planes.front import AUTOMATIC
from .selection import Selection
from .settings import FacadeSettings


@dataclass(frozen=True)
class DrawnFacade:
    """A facade and its elevation.

    Attributes
    ----------
    number : int
        Of the facade; 1 where the cloud was measured as it is.
    selection : Selection
    elevation : Elevation
    """

    number: int
    selection: Selection
    elevation: Elevation


@dataclass(frozen=True)
class EveryFacade:
    """All facades that could be measured.

    Attributes
    ----------
    drawn : tuple of DrawnFacade
        By number.
    warnings : tuple of str
        Which could not be measured, and why.
    """

    drawn: tuple[DrawnFacade, ...]
    warnings: tuple[str, ...]


def measure_selection(
    selection: Selection, settings: FacadeSettings = FacadeSettings(), progress: Progress = Progress()
) -> DrawnFacade:
    """Measure the chosen facade of a cloud, rolled out if UNROLL wants it.

    Raises
    ------
    NothingFoundError
        If there is no upright plane, or the wall does not turn as UNROLL says.
    """
    selection = selection.unrolled(settings)
    development = selection.development
    if development is not None:
        progress.update(0.0, development.said)
    elevation = measure_facade(selection.points, settings, progress, selection.plane)
    if development is not None:
        elevation = replace(elevation, curve=development.curve.moved(selection.whole.origin[:2]))
    return DrawnFacade(1 if selection.chosen is None else selection.chosen.number, selection, elevation)


def measure_every(
    first: DrawnFacade,
    settings: FacadeSettings = FacadeSettings(),
    progress: Progress = Progress(),
) -> EveryFacade:
    """Measure all wanted facades of a cloud.

    SIDE applies to the chosen one only, because the others face other ways: their side is found.
    Where facades are rolled out, each is drawn with all that turns with it, and those that do not turn are
    drawn flat.

    Parameters
    ----------
    first : DrawnFacade
        The chosen one, which is measured already.
    settings : FacadeSettings
    progress : Progress
    """
    settings = replace(settings, side=AUTOMATIC)
    wanted = first.selection.wanted
    numbers = [facade.number for facade in wanted]
    # A cloud without facades is measured as it is.
    drawn = [first] if first.number in numbers or not numbers else []
    warnings: list[str] = []
    for number, facade in enumerate(wanted):
        part = progress.part(number / len(wanted), (number + 1) / len(wanted))
        if facade.number == first.number:
            continue
        developments = [item.selection.development for item in drawn]
        if any(known is not None and known.holds(facade.ends.mean(axis=0)) for known in developments):
            continue
        part.update(0.0, f"Facade {facade.number}:")
        try:
            drawn.append(_measured(first.selection.of(facade, settings), settings, part))
        except NothingFoundError as error:
            warnings.append(f"Facade {facade.number} is not drawn: {error}")
            continue
        warnings += [f"Facade {facade.number}: {warning}" for warning in drawn[-1].elevation.warnings]
    return EveryFacade(tuple(sorted(drawn, key=lambda item: item.number)), tuple(warnings))


def _measured(selection: Selection, settings: FacadeSettings, progress: Progress) -> DrawnFacade:
    try:
        return measure_selection(selection, settings, progress)
    except NothingFoundError:
        if settings.unroll == FLAT:
            raise
        return measure_selection(selection, replace(settings, unroll=FLAT), progress)
