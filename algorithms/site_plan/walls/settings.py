"""The settings of wall extraction: what a person may doubt, each with its reason."""

from dataclasses import dataclass

from ...settings import judged, physical


@dataclass(frozen=True)
class HeightGateSettings:
    """Where a wall may stand, by the heights of the points."""

    flat_m: float = physical(0.15, "Occupied height of a single bin of 0.1 m: a horizontal surface.")
    ground_step_m: float = judged(0.3, "The ground is seen if the lowest point lies no higher above it.")
    ground_share: float = judged(0.05, "Where fewer pixels show the ground, it was cut off.")
    column_height_m: float = judged(1.5, "Three quarters of the window of heights: few bushes fill them.")
    slice_height_m: float = judged(0.7, "A cloud that is thinner than this may be a horizontal slice.")
    slice_percentile: float = judged(
        99.9, "Of the points' heights: single points above a slice do not count."
    )
    floor_width_m: float = judged(1.0, "A slice shows lines, and few squares of floor of this width.")
    floor_share: float = judged(0.2, "Share of the pixels that such squares cover at a flat site.")
    sheet_share: float = judged(0.5, "Those that stand above one another spread less: 0.2 to 0.4 at walls.")
    body_m: float = judged(0.4, "Foliage is as thick each way; a partition with two rough faces is thinner.")
    rim_px: int = judged(2, "Width of the ragged rim around the body of a bush.")
    reaching_m: float = judged(0.2, "Two bins below a ceiling: one of them may be the ceiling itself.")
    behind_m: float = judged(0.5, "A wall behind furniture fills more below the ceiling than a beam does.")
    room_gap_m: float = judged(0.5, "Ceilings nearer to each other, as beside a beam, are of one room.")


@dataclass(frozen=True)
class RegionSettings:
    """Columns, which fail both shape criteria of the paper."""

    column_width_m: float = physical(2.0, "Free columns and piers are seldom wider.")
    post_width_m: float = physical(0.5, "The outline of a narrower column may hold no pixel without points.")
    hollow_share: float = judged(0.8, "A column's outline covers less of its convex hull; a bush is full.")


@dataclass(frozen=True)
class ClosingSettings:
    """Gaps that are closed where the user names none."""

    seen_m: float = physical(0.8, "A thick wall between its faces; ground that was seen is kept open.")
    blind_m: float = physical(0.4, "Narrower than any passage, as nothing shows where the ground was seen.")


@dataclass(frozen=True)
class OutlineSettings:
    """How the steps of outlines of pixels are straightened."""

    tolerance_px: float = judged(0.5, "A straightened outline is within half a pixel of the steps' middles.")
    corner_px: int = judged(3, "A corner between longer sides is one of the wall, and not a step.")


@dataclass(frozen=True)
class WallHeightSettings:
    """Base and top of a wall."""

    base_percentile: float = judged(
        10.0, "Of the lowest points of its pixels: a few reflections do not count."
    )
    top_percentile: float = judged(90.0, "Of the highest points of its pixels: a crown above does not count.")


@dataclass(frozen=True)
class WallSettings:
    """The settings of wall extraction, by stage."""

    height_gate: HeightGateSettings = HeightGateSettings()
    regions: RegionSettings = RegionSettings()
    closing: ClosingSettings = ClosingSettings()
    outlines: OutlineSettings = OutlineSettings()
    heights: WallHeightSettings = WallHeightSettings()
