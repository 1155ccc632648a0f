"""Every facade of a building or a street, measured one after the other."""

from dataclasses import dataclass, replace

from ..errors import NothingFoundError
from ..progress import Progress
from .elevation import Elevation
from .measurement import measure_facade
from .planes.side import AUTOMATIC
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


def measure_every(
    first: DrawnFacade,
    settings: FacadeSettings = FacadeSettings(),
    progress: Progress = Progress(),
) -> EveryFacade:
    """Measure all wanted facades of a cloud.

    SIDE applies to the chosen one only, because the others face other ways: their side is found.

    Parameters
    ----------
    first : DrawnFacade
        The chosen one, which is measured already.
    settings : FacadeSettings
    progress : Progress
    """
    settings = replace(settings, side=AUTOMATIC)
    wanted = first.selection.wanted or (None,)
    drawn, warnings = [], []
    for number, facade in enumerate(wanted):
        part = progress.part(number / len(wanted), (number + 1) / len(wanted))
        if facade is None or facade.number == first.number:
            drawn.append(first)
            continue
        part.update(0.0, f"Facade {facade.number}:")
        selection = first.selection.of(facade, settings)
        try:
            elevation = measure_facade(selection.points, settings, part, selection.plane)
        except NothingFoundError as error:
            warnings.append(f"Facade {facade.number} is not drawn: {error}")
            continue
        warnings += [f"Facade {facade.number}: {warning}" for warning in elevation.warnings]
        drawn.append(DrawnFacade(facade.number, selection, elevation))
    return EveryFacade(tuple(drawn), tuple(warnings))
