"""The surfaces that two scans share, as observations of their poses."""

from dataclasses import dataclass

import numpy as np

from ..adjustment.similarity import Pose, parameter_design
from ..settings import Model


@dataclass(frozen=True)
class Equations:
    """The share of a tie in the normal equations of both poses.

    Attributes
    ----------
    normal : ndarray, shape (2 u, 2 u)
        A'PA.
    right : ndarray, shape (2 u,)
        A'Pl.
    """

    normal: np.ndarray
    right: np.ndarray


@dataclass(frozen=True)
class Tie:
    """Patches that two scans see; each observes that they lie in one plane.

    Attributes
    ----------
    scans : tuple of int
        The numbers of both scans.
    centres : tuple of ndarray, shape (k, 3)
        Of the patches, in either scan.
    normals : tuple of ndarray, shape (k, 3)
        The same; of one direction at the poses at which they were paired.
    variances : ndarray, shape (k,)
        Of the distance of two patches, square metres.
    common_std : float
        Standard deviation of what all patches err by in common, as a small motion of one scan against the
        other, with a change of its scale if the model has one: metres in its middle, and as much at the mean
        distance of the patches from it.
    overlap : float
        The part of the cells of the scan with fewer cells that have a partner, 0..1.
    """

    scans: tuple[int, int]
    centres: tuple[np.ndarray, np.ndarray]
    normals: tuple[np.ndarray, np.ndarray]
    variances: np.ndarray
    common_std: float
    overlap: float

    def __len__(self) -> int:
        return len(self.variances)

    def distances(self, one: Pose, other: Pose) -> np.ndarray:
        """Return how far the patches of the first scan are from those of the second, along the normals."""
        apart = one.apply(self.centres[0]) - other.apply(self.centres[1])
        return np.asarray(np.einsum("ij,ij->i", self.directions(one, other), apart))

    def directions(self, one: Pose, other: Pose) -> np.ndarray:
        """Return the means of both normals, shape (k, 3), in the control frame."""
        both = self.normals[0] @ one.rotation.T + self.normals[1] @ other.rotation.T
        return both / np.linalg.norm(both, axis=1, keepdims=True)

    def rms(self, one: Pose, other: Pose) -> float:
        """Return the root mean square of the distances, metres."""
        return float(np.sqrt(np.mean(self.distances(one, other) ** 2)))

    def equations(self, one: Pose, other: Pose, model: Model) -> Equations:
        """Return the share in the normal equations at the poses.

        The motion that all patches err by is eliminated: with its derivatives G and P of the patches alone,
        the weights are P - P G (G'PG + 1 / common_std^2)^-1 G'P.
        """
        scale = 1 / np.sqrt(self.variances)
        design = self._design(one, other, model) * scale[:, None]
        common = self.motions(one, other, model) * scale[:, None]
        inner = common.T @ common + np.eye(common.shape[1]) / self.common_std**2
        gain = np.linalg.solve(inner, common.T)
        misfit = -self.distances(one, other) * scale
        weighted = design - common @ (gain @ design)
        return Equations(weighted.T @ design, weighted.T @ misfit)

    def _design(self, one: Pose, other: Pose, model: Model) -> np.ndarray:
        """Return the derivatives of the distances by the parameters of both poses, shape (k, 2 u)."""
        normals = self.directions(one, other)
        forth, back = (
            np.einsum("ij,ijk->ik", normals, parameter_design(pose.rotated(centres), model))
            for pose, centres in zip((one, other), self.centres)
        )
        # The normal turns with both scans, by half of the rotation of either. Without this, the distances
        # would change if all scans turned together, and surfaces would seem to hold them there.
        apart = one.apply(self.centres[0]) - other.apply(self.centres[1])
        turned = 0.5 * np.cross(normals, apart)
        columns, turned = (slice(3, 4), turned[:, 2:]) if model.levelled else (slice(3, 6), turned)
        forth[:, columns] += turned
        back[:, columns] -= turned
        return np.column_stack([forth, -back])

    def motions(self, one: Pose, other: Pose, model: Model) -> np.ndarray:
        """Return the derivatives of the distances by a small motion of the first scan, shape (k, 6 or 7).

        Shifts, and rotations about the middle of the patches, in metres at their mean distance from it; if
        the model has a scale, also its change: an error of all ranges is one.
        """
        normals, places = self.directions(one, other), one.apply(self.centres[0])
        arms = places - places.mean(axis=0)
        radius = np.sqrt((arms**2).sum(axis=1).mean())
        columns = [normals, np.cross(arms, normals) / radius]
        if model.scaled:
            columns.append(np.einsum("ij,ij->i", arms, normals) / radius)
        return np.column_stack(columns)


def free_directions(normals: np.ndarray, share: float) -> np.ndarray:
    """Return the directions along which patches slide, shape (k, 3); none if they hold everything.

    Parameters
    ----------
    normals : ndarray, shape (n, 3)
    share : float
        A direction that less than this part of the patches faces, by the squares of the cosines, is free.
    """
    values, vectors = np.linalg.eigh(normals.T @ normals / len(normals))
    return vectors[:, values < share].T


def spoken(direction: np.ndarray) -> str:
    """Return a direction in words; its azimuth is counted from y, and both ways are the same."""
    if abs(direction[2]) > np.sqrt(0.5):
        return "up and down"
    return f"at an azimuth of {np.degrees(np.arctan2(direction[0], direction[1])) % 180:.0f} degrees"
