"""How many patches of a scan agree with what other scans saw, and how many contradict it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..adjustment.similarity import Pose
from .motions import Searched


@dataclass(frozen=True)
class Evidence:
    """What speaks for a pose, and what against it.

    Attributes
    ----------
    agreeing : int
        Patches where another scan saw surface that faces the same way; of this scan in the views of the
        others, and of the others in the view of this one.
    contradicting : int
        Patches through which another scan saw.
    normals : ndarray, shape (agreeing, 3)
        What the patches that agree face, in the control frame.
    scans : tuple of str
        With which at least one patch agrees.
    """

    agreeing: int
    contradicting: int
    normals: np.ndarray
    scans: tuple[str, ...]

    def weight(self, against: float) -> float:
        """Return the evidence in patches, each that contradicts counted `against` times."""
        return self.agreeing - against * self.contradicting

    def across(self) -> tuple[float, np.ndarray]:
        """Return the direction that fewest patches face, by the squares of cosines, after their number."""
        values, vectors = np.linalg.eigh(self.normals.T @ self.normals)
        return float(values[0]), vectors[:, 0]


@dataclass(frozen=True)
class Stood:
    """A scan whose pose is known.

    Attributes
    ----------
    name : str
    scan : Searched
    pose : Pose
    """

    name: str
    scan: Searched
    pose: Pose


def evidence_for(pose: Pose, scan: Searched, others: Sequence[Stood]) -> Evidence:
    """Compare a scan at a pose with others; what one of them saw and another saw through counts as neither.

    Parameters
    ----------
    pose : Pose
    scan : Searched
    others : sequence of Stood
    """
    places, normals = _patches(scan, pose)
    seen, through = (np.zeros(len(places), bool) for _ in range(2))
    agreeing, contradicting, facing, scans = 0, 0, [], []
    for other in others:
        forth = other.scan.view.judged(into(places, other.pose), normals @ other.pose.rotation)
        theirs, towards = _patches(other.scan, other.pose)
        back = scan.view.judged(into(theirs, pose), towards @ pose.rotation)
        seen |= forth > 0
        through |= forth < 0
        agreeing += int((back > 0).sum())
        contradicting += int((back < 0).sum())
        facing.append(towards[back > 0])
        if (forth > 0).any() or (back > 0).any():
            scans.append(other.name)
    facing.append(normals[seen & ~through])
    return Evidence(
        agreeing=agreeing + int((seen & ~through).sum()),
        contradicting=contradicting + int((through & ~seen).sum()),
        normals=np.concatenate(facing),
        scans=tuple(scans),
    )


def _patches(scan: Searched, pose: Pose) -> tuple[np.ndarray, np.ndarray]:
    """Return middles and normals of the patches of a scan in the control frame."""
    own = scan.surfaces
    return pose.apply(own.centres[scan.patches]), own.normals[scan.patches] @ pose.rotation.T


def into(places: np.ndarray, pose: Pose) -> np.ndarray:
    """Return places of the control frame in that of a scan."""
    return np.asarray((places - pose.position) @ pose.rotation / pose.scale + pose.centre)
