"""The targets of one station."""

from collections.abc import Sequence
from typing import Callable, Union

import numpy as np

from ..progress import Progress
from .checkerboards.candidates import best_of_neighbours, checkerboard_candidates
from .checkerboards.checkerboard import TILES, WIDTH, checkerboard_at
from .range_image.range_image import RangeImage
from .results import Rejection, StationTargets, Target
from .settings import TargetSettings, Wanted
from .spheres.candidates import Candidate, sphere_candidates
from .spheres.sphere import sphere_at
from .view import view_of


def search_station(
    name: str, image: RangeImage, settings: TargetSettings, progress: Progress = Progress()
) -> StationTargets:
    """Find the targets in a range image.

    Parameters
    ----------
    name : str
        Of the scan.
    image : RangeImage
    settings : TargetSettings
    progress : Progress
    """
    found: list[Target] = []
    rejections: list[Rejection] = []
    if settings.wanted is not Wanted.SPHERES and image.intensity is not None:
        progress.update(0.0, f"Searching {name} for black and white targets")
        targets, failed = _checkerboards(image, settings, progress.part(0.0, 0.5))
        found += targets
        rejections += failed
    if settings.wanted is not Wanted.CHECKERBOARDS:
        progress.update(0.5, f"Searching {name} for spheres")
        targets, failed = _spheres(image, settings, progress.part(0.5, 1.0))
        found += targets
        rejections += failed
    found.sort(key=lambda target: (bool(target.doubt), image.pixel(target.xyz)[1]))
    return StationTargets(
        name=name,
        position=image.position,
        step=image.step,
        points=len(image.xyz),
        has_intensity=image.intensity is not None,
        targets=tuple(found),
        views=tuple(view_of(image, target, settings) for target in found),
        rejections=tuple(rejections),
    )


def _checkerboards(
    image: RangeImage, settings: TargetSettings, progress: Progress
) -> tuple[list[Target], list[Rejection]]:
    candidates = checkerboard_candidates(image, settings.checkerboards.candidates)
    found, failed = _examined(
        [item.xyz for item in candidates[: settings.most_candidates]],
        lambda row: checkerboard_at(image, candidates[row], settings.size, settings.checkerboards),
        settings.same_place,
        progress,
    )
    return without_tiles(found, failed, settings)


def _spheres(
    image: RangeImage, settings: TargetSettings, progress: Progress
) -> tuple[list[Target], list[Rejection]]:
    diameters = settings.spheres.candidates.usual_m if settings.size is None else (settings.size,)
    candidates = sphere_candidates(image, diameters, settings.spheres.candidates)
    found, failed = _examined(
        [item.xyz for item in candidates[: settings.most_candidates]],
        lambda row: sphere_at(image, candidates[row], diameters, settings.spheres),
        settings.same_place,
        progress,
    )
    return [_of_known_size(image, item, found, settings) for item in found], failed


def _of_known_size(
    image: RangeImage, target: Target, found: list[Target], settings: TargetSettings
) -> Target:
    """Return a sphere of uncertain diameter with that of the others, if only one of them is possible."""
    certain = {item.size for item in found if len(item.possible) == 1 and not item.doubt}
    usual = tuple(certain & set(target.possible))
    if len(target.possible) == 1 or len(usual) != 1:
        return target
    again = sphere_at(
        image,
        Candidate(target.xyz - usual[0] / 2 * target.xyz / np.linalg.norm(target.xyz), usual[0] / 2, 0.0),
        usual,
        settings.spheres,
    )
    return again if isinstance(again, Target) else target


def _examined(
    places: Sequence[np.ndarray],
    examine: Callable[[int], Union[Target, Rejection]],
    same_place: float,
    progress: Progress,
) -> tuple[list[Target], list[Rejection]]:
    """Examine candidates, best first, except those on a target that is already sure."""
    found: list[Target] = []
    failed: list[Rejection] = []
    for row, place in enumerate(places):
        progress.update(row / len(places))
        if any(np.linalg.norm(place - item.xyz) < same_place * item.size for item in found if not item.doubt):
            continue
        result = examine(row)
        if isinstance(result, Rejection):
            failed.append(result)
        else:
            found = _with(found, result, same_place)
    return found, failed


def _with(found: list[Target], new: Target, same_place: float) -> list[Target]:
    """Return the targets with a new one; of two at the same place only the better one."""
    same = [
        item for item in found if np.linalg.norm(item.xyz - new.xyz) < same_place * max(item.size, new.size)
    ]
    best = max([*same, new], key=lambda item: (not item.doubt, item.quality))
    return [item for item in found if all(item is not other for other in same)] + [best]


def without_tiles(
    found: list[Target], failed: list[Rejection], settings: TargetSettings
) -> tuple[list[Target], list[Rejection]]:
    """Move the targets that lie among other crossings to the rejections: the rim of a tiled surface.

    Those are corners of tiles, and patterns that look like a target themselves and are as large. Crossings of
    fields too large for a target count if there are several, as in the middle of large tiles. A crossing at
    the target is its own, seen from another candidate.

    Parameters
    ----------
    found : list of Target
        Black and white ones.
    failed : list of Rejection
    settings : TargetSettings
    """
    crossings = [(item.xyz, np.inf) for item in failed if item.test == TILES]
    crossings += [(item.xyz, item.size) for item in found]
    large = np.array([item.xyz for item in failed if item.test == WIDTH and item.value > item.limit])
    kept = []
    for item in found:
        away = [np.linalg.norm(item.xyz - place) / min(item.size, size) for place, size in crossings]
        near = sum(settings.same_place < distance < settings.tiled_reach for distance in away)
        if near > settings.most_tiles or _places_near(item, large, settings) > settings.most_large:
            passed = max((other.passed for other in failed), default=0) + 1
            failed.append(
                Rejection(item.kind, item.xyz, "crossings nearby", passed, float(near), settings.most_tiles)
            )
        else:
            kept.append(item)
    return kept, failed


def _places_near(target: Target, crossings: np.ndarray, settings: TargetSettings) -> int:
    """Return at how many places near a target there are crossings, each of which several candidates see."""
    if not len(crossings):
        return 0
    away = np.linalg.norm(crossings - target.xyz, axis=1) / target.size
    near = crossings[(away > settings.same_place) & (away < settings.tiled_reach)]
    return len(best_of_neighbours(near, settings.same_place * target.size))
