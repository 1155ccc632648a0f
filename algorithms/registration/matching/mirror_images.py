"""Whether the mirror image of a list fits: two columns are swapped, or an axis is reversed.

The mirror image of targets in one plane fits as well as the targets themselves; of a levelled scan, if the
plane is vertical or horizontal. Then the targets do not show whether the list is mirrored.
"""

from dataclasses import dataclass

import numpy as np

from .matching_task import MatchingTask
from .rivals import as_likely, redundancy, squares_of
from .solution import Solution

SWAPPED = np.array([[0, 1, 0], [1, 0, 0], [0, 0, 1]])
REVERSED = np.diag([1, 1, -1])


@dataclass(frozen=True)
class MirrorImage:
    """A mirror image of a list that fits the control points.

    Attributes
    ----------
    mirror : ndarray, shape (3, 3)
        Multiplies the targets from the right.
    cause : str
        What would have happened to the list.
    solution : Solution
        The best one of the mirrored targets.
    """

    mirror: np.ndarray
    cause: str
    solution: Solution

    def replaces(self, task: MatchingTask, best: Solution) -> bool:
        """Return whether the mirror image fits so much better that the list must be mirrored."""
        return not self._equals(task, best, self.solution, best)

    def rivals(self, task: MatchingTask, best: Solution) -> bool:
        """Return whether the mirror image fits as well as the list."""
        return self._equals(task, best, best, self.solution)

    def _equals(self, task: MatchingTask, best: Solution, better: Solution, other: Solution) -> bool:
        """Return whether `other` is about as likely as `better`, one of them being the `best` of the list."""
        count = max(best.matched, self.solution.matched)
        of_better, of_other = (
            squares_of(task, item, count, np.eye(3) if item is best else self.mirror)
            for item in (better, other)
        )
        redundant = redundancy(count, task.settings.model)
        return as_likely(of_other, of_better, redundant, task.settings.matches.decision)


def mirror_images(task: MatchingTask, least: int) -> list[MirrorImage]:
    """Return the mirror images of the list with a solution of `least` targets.

    Without a level, one mirror image stands for all.
    """
    causes = [(SWAPPED, "x and y are swapped, or an axis is reversed")]
    if task.settings.model.levelled:
        causes = [(SWAPPED, "x and y are swapped, or one of them is reversed"), (REVERSED, "z is reversed")]
    images = []
    for mirror, cause in causes:
        solutions = task.solutions(task.scan.xyz @ mirror, task.settings.model, least)
        if solutions:
            images.append(MirrorImage(mirror, cause, solutions[0]))
    return images


def mirrored_list(task: MatchingTask, image: MirrorImage) -> tuple[str, str]:
    """Return status and reason of a list that is mirrored."""
    return (
        "mirrored",
        f"{image.solution.matched} of {len(task.scan.names)} targets of {task.scan.name} fit the mirror "
        f"image of the control points: in one of the two lists {image.cause}; correct it.",
    )
