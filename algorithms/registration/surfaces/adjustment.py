"""The block of all scans: those that targets placed, and those that surfaces place beside them."""

from collections.abc import Mapping
from dataclasses import replace

from ...progress import Progress
from ..adjustment.block_adjustment import adjust_block
from ..lists.point_list import PointList
from ..matching.refusals import Refusal
from ..sequential_registration import SequentialRegistration
from ..settings import Settings
from .patches import Surfaces
from .placement import placed_by_surfaces
from .refinement import Refined, refine


def adjust_with_surfaces(
    sequence: SequentialRegistration,
    scans: Mapping[str, PointList],
    surfaces: Mapping[str, Surfaces],
    settings: Settings,
    progress: Progress = Progress(),
) -> Refined:
    """Adjust scans by their targets, tie them by surfaces, place further ones by surfaces, and tie these too.

    Parameters
    ----------
    sequence : SequentialRegistration
        With at least one scan.
    scans : mapping of str to PointList
        All of them, near their origins.
    surfaces : mapping of str to Surfaces
        Near the same origins; empty to adjust by the targets alone.
    settings : Settings
    progress : Progress

    Raises
    ------
    CancelledError
        If the caller asked to stop.
    """
    first = sequence.placed[0]
    if first.held:
        sequence = placed_by_surfaces(
            sequence, [first.pose], scans, surfaces, settings, progress.part(0.0, 0.8)
        )
        return _hanging_together(refine(sequence, None, surfaces, settings, progress.part(0.8, 1.0)))
    by_targets = adjust_block(sequence, settings)
    if not surfaces:
        return Refined(sequence, by_targets)
    refined = refine(sequence, by_targets, surfaces, settings, progress.part(0.0, 0.3))
    poses = refined.adjusted.block.poses
    more = placed_by_surfaces(sequence, poses, scans, surfaces, settings, progress.part(0.3, 0.8))
    if len(more.placed) == len(sequence.placed):
        return replace(refined, sequence=more)
    return refine(more, by_targets, surfaces, settings, progress.part(0.8, 1.0))


def _hanging_together(refined: Refined) -> Refined:
    """Return a result without the first scan if no other is placed: nothing shows that it is right."""
    sequence = refined.sequence
    if len(sequence.placed) > 1:
        return refined
    name = sequence.placed[0].scan.name
    refusal = Refusal(
        "no overlap",
        f"No other scan could be placed beside {name}, whose frame would be that of all; see why not, or "
        "choose another scan as the first.",
    )
    alone = replace(sequence, placed=(), refused={**sequence.refused, name: refusal})
    return replace(refined, sequence=alone)
