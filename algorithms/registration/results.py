"""The results of a registration; lengths in metres, angles in degrees, in the control frame."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from rasterio.crs import CRS

from .settings import Settings

REGISTERED = "registered"


@dataclass(frozen=True)
class Estimate:
    """A parameter of a transformation.

    Attributes
    ----------
    name : str
        shift_x, shift_y, shift_z, rotation_x, rotation_y, rotation_z or scale.
    value, std : float
        Metres, degrees or a ratio. The standard deviation is q_x = sigma0 sqrt(q_kk) (paper, eq. 5).
    """

    name: str
    value: float
    std: float


@dataclass(frozen=True)
class Correspondence:
    """A target and its control point; arrays have shape (3,), along x, y and z of the control frame.

    Attributes
    ----------
    target, control : str
    surveyed : bool
        False if the control point was appended from another scan.
    used : bool
        False if the target was rejected as an outlier; its redundancy, studentized residual and detectable
        bias are then nan, and `normalized` is the value that led to the rejection.
    position : ndarray
        Of the control point.
    residual : ndarray
        v, from the control point to the transformed target.
    redundancy : ndarray
        Redundancy numbers, 0..1.
    normalized : ndarray
        Baarda's w, by the a priori standard deviation.
    studentized : ndarray
        Pope's tau, by the a posteriori one.
    detectable : ndarray
        Minimal detectable bias, metres; nan where nothing checks the coordinate.
    covariance : ndarray, shape (3, 3)
        Of the transformed target, by the a posteriori standard deviation, square metres.
    """

    target: str
    control: str
    surveyed: bool
    used: bool
    position: np.ndarray
    residual: np.ndarray
    redundancy: np.ndarray
    normalized: np.ndarray
    studentized: np.ndarray
    detectable: np.ndarray
    covariance: np.ndarray

    @property
    def length(self) -> float:
        """The length of the residual."""
        return float(np.linalg.norm(self.residual))


@dataclass(frozen=True)
class ScaleTest:
    """The scale that the targets suggest, whether or not the model has one.

    Attributes
    ----------
    deviation, std : float
        m - 1 and its standard deviation, in parts per million.
    significant : bool
        Whether the deviation differs from 0, by a t-test.
    advice : str
        A sentence.
    """

    deviation: float
    std: float
    significant: bool
    advice: str


@dataclass(frozen=True)
class GlobalTest:
    """The chi-square test of an adjustment.

    Attributes
    ----------
    sum_of_squares : float
        v'Pv.
    redundancy : float
        n - u; of one scan among several, the sum of its redundancy numbers.
    sigma0 : float
        A posteriori over a priori standard deviation, sqrt(v'Pv / (n - u)); nan without redundancy.
    probability : float
        Of a v'Pv as large or larger, if the a priori standard deviations are right; nan without redundancy.
    """

    sum_of_squares: float
    redundancy: float
    sigma0: float
    probability: float


@dataclass(frozen=True)
class SurfaceChange:
    """How the surfaces that a scan shares with others changed the pose that its targets gave it.

    Attributes
    ----------
    shift : float
        The farthest that a target moved, metres.
    sigmas : float
        The root mean square change of the parameters, in standard deviations by the targets alone.
    std : float
        The largest standard deviation of a target by the targets alone, metres.
    used : bool
        False if the targets rule the change out, so that it was not made.
    """

    shift: float
    sigmas: float
    std: float
    used: bool


@dataclass(frozen=True)
class SharedSurfaces:
    """The surfaces that two scans share.

    Attributes
    ----------
    scans : tuple of str
    overlap : float
        The part of the surface cells of the scan with fewer that has a partner in the other, 0..1.
    patches : int
        Of about a metre.
    rms : float
        Root mean square distance of the patches after the adjustment, metres.
    free : ndarray, shape (k, 3)
        Directions in the control frame along which the scans slide, because hardly any patch faces them.
    """

    scans: tuple[str, str]
    overlap: float
    patches: int
    rms: float
    free: np.ndarray


@dataclass(frozen=True)
class Placement:
    """How surfaces placed a scan that its targets did not: what speaks for its pose, and for the next best.

    Attributes
    ----------
    scans : tuple of str
        With which its surfaces agree.
    agreeing, contradicting : int
        Patches of about a metre that others saw too, and patches through which others saw.
    targets : int
        Of the scan, on known points.
    next_agreeing, next_contradicting : int or None
        At the next best pose; None if there is no other pose at which surfaces agree.
    next_share : float or None
        The evidence for it, as a part of that for the pose.
    next_shift, next_turn_deg : float or None
        How far away the scanner would stand, metres, and turned by how much.
    station : ndarray, shape (3,), or None
        Of the scanner; of an adjusted scan in the control frame.
    """

    scans: tuple[str, ...]
    agreeing: int
    contradicting: int
    targets: int
    next_agreeing: Optional[int] = None
    next_contradicting: Optional[int] = None
    next_share: Optional[float] = None
    next_shift: Optional[float] = None
    next_turn_deg: Optional[float] = None
    station: Optional[np.ndarray] = None


@dataclass(frozen=True)
class ScanRegistration:
    """One scan; unless `status` is `REGISTERED`, all that belongs to a transformation is None or empty.

    Attributes
    ----------
    name : str
    status : str
        `REGISTERED`, or the reason why not in a word: ambiguous, mirrored, units, tilted, scale, collinear,
        coincident, too few, too many, chance, no overlap, misfit, sliding.
    reason : str
        A sentence with the remedy; empty if registered.
    matrix : ndarray, shape (4, 4), or None
        From the scan to the control frame.
    scale : float or None
    estimates : tuple of Estimate
    std : float or None
        The largest standard deviation that the transformation gives a target of the scan, in any direction,
        metres.
    correlations : ndarray, shape (u, u)
        Of the estimates, in their order.
    correspondences : tuple of Correspondence
        In the order of the scan's list.
    unmatched : tuple of str
        Targets that match neither a surveyed nor an appended point; they were appended to the control points.
    test : GlobalTest or None
    scale_test : ScaleTest or None
    chance : float or None
        Expected number of accidental matches of as many targets; None if matched by names.
    round : int or None
        1 if surveyed points sufficed, 2 if it needed points appended in round 1, and so on; None if targets
        did not place the scan.
    rivals : tuple of dict of str to str
        Equally good solutions, target to control point (if ambiguous).
    warnings : tuple of str
    targets : int
        The number of targets in the list.
    surfaces : SurfaceChange or None
        None if surfaces do not tie the scan to others, or if they placed it.
    placement : Placement or None
        None if targets placed the scan, or if its frame is that of the registration.
    """

    name: str
    status: str
    reason: str
    targets: int
    matrix: Optional[np.ndarray] = None
    scale: Optional[float] = None
    estimates: tuple[Estimate, ...] = ()
    std: Optional[float] = None
    correlations: Optional[np.ndarray] = None
    correspondences: tuple[Correspondence, ...] = ()
    unmatched: tuple[str, ...] = ()
    test: Optional[GlobalTest] = None
    scale_test: Optional[ScaleTest] = None
    chance: Optional[float] = None
    round: Optional[int] = None
    rivals: tuple[dict[str, str], ...] = ()
    warnings: tuple[str, ...] = ()
    surfaces: Optional[SurfaceChange] = None
    placement: Optional[Placement] = None

    @property
    def registered(self) -> bool:
        """Whether the scan has a transformation."""
        return self.status == REGISTERED

    @property
    def is_frame(self) -> bool:
        """Whether the frame of the scan is that of all, because there are no control points."""
        return self.registered and self.round is None and self.placement is None


@dataclass(frozen=True)
class ControlPoint:
    """A surveyed point, or one that was appended from scans.

    Attributes
    ----------
    name : str
        Of an appended point, 'scan:target' of the scan that saw it first.
    position : ndarray, shape (3,)
    covariance : ndarray, shape (3, 3)
        By the a priori standard deviations; zero for a surveyed point that is held fixed.
    origin : str
        'surveyed', or the name of the scan that saw it first.
    scans : tuple of str
        The scans that use it.
    """

    name: str
    position: np.ndarray
    covariance: np.ndarray
    origin: str
    scans: tuple[str, ...]

    @property
    def surveyed(self) -> bool:
        """Whether the point comes from the control list."""
        return self.origin == "surveyed"


@dataclass(frozen=True)
class Registration:
    """All scans of a call.

    Attributes
    ----------
    settings : Settings
    tolerance : float
        The tolerance that was used for distances between surveyed points, metres.
    scans : tuple of ScanRegistration
        In the order they were given.
    points : tuple of ControlPoint
        The surveyed points in their order, then the appended ones.
    test : GlobalTest
        Of the block adjustment.
    crs : CRS or None
    warnings : tuple of str
    surfaces : tuple of SharedSurfaces
        Of the pairs of scans that surfaces tie.
    """

    settings: Settings
    tolerance: float
    scans: tuple[ScanRegistration, ...]
    points: tuple[ControlPoint, ...]
    test: GlobalTest
    crs: Optional[CRS] = None
    warnings: tuple[str, ...] = ()
    surfaces: tuple[SharedSurfaces, ...] = ()

    @property
    def registered(self) -> tuple[ScanRegistration, ...]:
        """The scans that have a transformation."""
        return tuple(scan for scan in self.scans if scan.registered)

    @property
    def max_residual(self) -> float:
        """The largest length of a residual of a target that was used; nan without any."""
        lengths = [item.length for scan in self.registered for item in scan.correspondences if item.used]
        return max(lengths, default=float("nan"))
