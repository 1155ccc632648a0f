"""The control points, surveyed or appended from registered scans (paper, chapter 4).

Appended points have a covariance, also among each other: all targets of one scan share the error of its pose,
and pass it on to the scans that are registered to them.
"""

from dataclasses import dataclass, replace

import numpy as np

from ..lists.point_list import PointList


@dataclass(frozen=True)
class ControlNetwork:
    """Control points, surveyed and appended.

    Attributes
    ----------
    names : tuple of str
    labels : tuple of str
        The names that targets may have: of an appended point, that of its target.
    points : ndarray, shape (p, 3)
        Near the origin.
    origins : tuple of str
        The scan that a point comes from; empty if surveyed.
    sources : tuple of str
        The same, also of points that an earlier registration appended.
    sigmas : ndarray, shape (p,)
        Standard deviations of the coordinates of given points; 0 of appended ones, which have covariances.
    loose : ndarray of int, shape (q,)
        The points whose errors are correlated with others'.
    covariance : ndarray, shape (3 q, 3 q)
        Of the loose points.
    """

    names: tuple[str, ...]
    labels: tuple[str, ...]
    points: np.ndarray
    origins: tuple[str, ...]
    sources: tuple[str, ...]
    sigmas: np.ndarray
    loose: np.ndarray
    covariance: np.ndarray

    @classmethod
    def of_surveyed(
        cls, names: tuple[str, ...], points: np.ndarray, control_sigma: float
    ) -> "ControlNetwork":
        """Return a network without appended points."""
        nothing, blank = np.zeros((0, 0)), ("",) * len(names)
        sigmas = np.full(len(names), control_sigma)
        return cls(names, names, points, blank, blank, sigmas, np.zeros(0, int), nothing)

    @classmethod
    def of_list(cls, control: PointList, control_sigma: float) -> "ControlNetwork":
        """Return the network of a list; what an earlier registration appended keeps its standard deviation.

        Parameters
        ----------
        control : PointList
            Near the origin.
        control_sigma : float
            Standard deviation of a surveyed coordinate, metres.
        """
        network = cls.of_surveyed(control.names, control.xyz, control_sigma)
        if not control.origins or control.stds is None:
            return network
        known = np.array([bool(origin) for origin in control.origins]) & np.isfinite(control.stds)
        prefixes = [f"{origin}:" if origin else "" for origin in control.origins]
        return replace(
            network,
            sources=control.origins,
            labels=tuple(
                name[len(prefix) :] if name.startswith(prefix) else name
                for name, prefix in zip(control.names, prefixes)
            ),
            sigmas=np.where(known, control.stds, network.sigmas),
        )

    @property
    def surveyed(self) -> np.ndarray:
        """Which points are given, bool of shape (p,): surveyed, or appended by an earlier registration."""
        return np.array([not origin for origin in self.origins], bool)

    def distance_variances(self) -> np.ndarray:
        """Return the variances of the distances between all points, shape (p, p)."""
        alone = self.sigmas**2
        variances = alone[:, None] + alone[None, :]
        count = len(self.loose)
        if not count:
            return variances
        blocks = self.covariance.reshape(count, 3, count, 3).transpose(0, 2, 1, 3)
        own = blocks[np.arange(count), np.arange(count)]
        alone[self.loose] = 0.0
        towards = self.points[self.loose][:, None, :] - self.points[None, :, :]
        towards /= np.maximum(np.linalg.norm(towards, axis=2), np.finfo(float).tiny)[:, :, None]
        of_one = np.einsum("ijk,ikl,ijl->ij", towards, own, towards) + alone[None, :]
        variances[self.loose] = of_one
        variances[:, self.loose] = of_one.T
        among = towards[:, self.loose]
        both = own[:, None] + own[None, :] - blocks - blocks.transpose(1, 0, 2, 3)
        among_loose = np.einsum("ijk,ijkl,ijl->ij", among, both, among)
        variances[np.ix_(self.loose, self.loose)] = np.maximum(among_loose, 0.0)
        np.fill_diagonal(variances, 0.0)
        return variances

    def with_correlated(self, points: np.ndarray) -> "ControlNetwork":
        """Return the network with `points` among the loose ones, if they are not held fixed."""
        fresh = np.setdiff1d(points, self.loose)
        fresh = fresh[self.sigmas[fresh] > 0]
        if not len(fresh):
            return self
        old = len(self.covariance)
        covariance = np.zeros((old + 3 * len(fresh),) * 2)
        covariance[:old, :old] = self.covariance
        covariance[old:, old:] = np.diag(np.repeat(self.sigmas[fresh] ** 2, 3))
        return replace(self, loose=np.r_[self.loose, fresh], covariance=covariance)

    def covariance_with_loose(self, points: np.ndarray) -> np.ndarray:
        """Return the covariance of `points` with all loose ones, shape (3 k, 3 q)."""
        size = len(self.covariance)
        rows = np.full(len(self.points), -1)
        rows[self.loose] = np.arange(len(self.loose))
        wanted = rows[points]
        blocks = np.zeros((len(points), 3, size))
        if size:
            blocks[wanted >= 0] = self.covariance.reshape(-1, 3, size)[wanted[wanted >= 0]]
        return blocks.reshape(3 * len(points), size)

    def covariance_between(self, points: np.ndarray, other: int) -> np.ndarray:
        """Return the covariance of `points` with the point `other`, shape (3 k, 3)."""
        column = np.flatnonzero(self.loose == other)
        if not len(column):
            return np.zeros((3 * len(points), 3))
        return self.covariance_with_loose(points)[:, 3 * column[0] : 3 * column[0] + 3]

    def covariance_of(self, points: np.ndarray) -> np.ndarray:
        """Return the covariance of `points` among each other, shape (3 k, 3 k)."""
        return np.hstack([self.covariance_between(points, point) for point in points])

    def _new_name(self, name: str) -> str:
        """Return a name that no point has, by primes if need be."""
        while name in self.names:
            name += "'"
        return name

    def appended(
        self,
        scan: str,
        targets: tuple[str, ...],
        points: np.ndarray,
        covariance: np.ndarray,
        with_loose: np.ndarray,
    ) -> "ControlNetwork":
        """Return the network with the unmatched targets of a scan.

        Parameters
        ----------
        scan : str
        targets : tuple of str
        points : ndarray, shape (k, 3)
        covariance : ndarray, shape (3 k, 3 k)
        with_loose : ndarray, shape (3 k, 3 q)
            Covariance with the loose points.
        """
        count = len(self.points)
        return replace(
            self,
            names=self.names + tuple(self._new_name(f"{scan}:{target}") for target in targets),
            labels=self.labels + targets,
            points=np.concatenate([self.points, points]),
            origins=self.origins + (scan,) * len(targets),
            sources=self.sources + (scan,) * len(targets),
            sigmas=np.r_[self.sigmas, np.zeros(len(targets))],
            loose=np.r_[self.loose, count + np.arange(len(targets))],
            covariance=np.block([[self.covariance, with_loose.T], [with_loose, covariance]]),
        )
