"""A facade from points to an elevation, on simulated scans whose details are known."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import COLOURED, OPENING, PROJECTION, RECESS, Points
from ichnograph.algorithms.facade.left_out import NOT_STRAIGHT
from ichnograph.algorithms.facade.measurement import measure_facade
from ichnograph.algorithms.facade.settings import ALL_REGIONS, NO_REGIONS, FacadeSettings
from ichnograph.tests.algorithms.facade.samples import bare, upright
from ichnograph.tests.scenes.facades import FACADES
from ichnograph.tests.scenes.facades.judging import in_scene, judge

SPACING = 0.02
PLACE = (31.0, (412345.67, 5812345.71, 71.3))


def points_of(scan):
    origin = np.floor(scan.points.min(axis=0))
    return Points(
        scan.points - origin, origin, scan.rgb.astype(np.float32), scan.intensity.astype(np.float32),
        scan.station.astype(np.int32),
    )  # fmt: skip


@pytest.fixture(scope="module", params=sorted(FACADES))
def measured(request):
    """Scan and measure a facade at coordinates of a grid."""
    scene = FACADES[request.param](0).moved(*PLACE)
    points = points_of(scene.scan(SPACING))
    return scene, points, measure_facade(points, FacadeSettings())


@pytest.fixture(scope="module")
def medina():
    scene = FACADES["medina"](0)
    points = points_of(scene.scan(SPACING))
    return scene, points, measure_facade(points, FacadeSettings())


def test_every_detail_is_found_and_none_invented(measured):
    scene, _, elevation = measured
    judgement = judge(elevation, scene)

    assert [true.kind for true in judgement.missed] == []
    assert [detail.kind for detail in judgement.invented] == []
    assert np.median([pair.iou for pair in judgement.pairs]) > 0.97


def test_widths_and_heights_are_unbiased_and_their_deviations_hold(measured):
    scene, _, elevation = measured
    pairs = judge(elevation, scene).pairs
    errors = np.concatenate([pair.size for pair in pairs])
    said = np.concatenate([(pair.found.width_std, pair.found.height_std) for pair in pairs])

    assert abs(errors.mean()) < 0.2 * SPACING
    assert errors.std() < 0.5 * SPACING
    assert np.mean(np.abs(errors) <= 3 * said) > 0.8


def test_arches_are_arches_and_the_rest_are_rectangles(measured):
    scene, _, elevation = measured
    for pair in judge(elevation, scene).pairs:
        corners = len(pair.true.outline.exterior.coords)
        assert pair.found.shape == ("arch" if corners > 10 else "rectangle")


def test_the_whole_wall_is_a_polygon_with_its_openings_as_holes(measured):
    scene, _, elevation = measured
    wall = max(elevation.wall.geoms, key=lambda part: part.area)
    found = in_scene(wall, elevation, scene).bounds
    true = scene.wall.bounds

    assert np.abs(np.subtract(found, true)[[0, 2, 3]]).max() < 2 * SPACING
    for detail in elevation.details:
        share = elevation.wall.intersection(detail.outline).area / detail.area
        assert share < 0.05 if detail.kind in (OPENING, RECESS) else share > 0.9


def test_what_a_tree_or_a_car_or_a_cornice_hides_is_unseen_and_not_a_window(measured):
    _, _, elevation = measured
    for area in elevation.unseen:
        for detail in elevation.details:
            assert area.intersection(detail.outline).area < 0.1 * area.area


def test_the_elevation_begins_at_the_left_end_and_the_foot_of_the_wall(measured):
    _, _, elevation = measured
    assert elevation.wall.bounds[:2] == pytest.approx((0, 0), abs=0.001)


def test_depths_are_those_that_were_built(measured):
    scene, _, elevation = measured
    for pair in judge(elevation, scene).pairs:
        if pair.true.kind in (PROJECTION, RECESS):
            # A window has a pane 15 mm behind its frame.
            assert pair.found.depth == pytest.approx(pair.true.depth, abs=0.02)


def test_the_order_of_the_points_changes_nothing(medina):
    _, points, elevation = medina
    order = np.random.default_rng(3).permutation(len(points.xyz))
    shuffled = measure_facade(
        Points(
            points.xyz[order], points.origin, points.rgb[order], points.intensity[order], points.scan[order]
        ),
        FacadeSettings(),
    )
    assert_same_outlines(elevation, shuffled, 1e-5)


@pytest.mark.parametrize(
    ("angle", "shift"), [(0, (412345.6, 5812345.7, 71.3)), (77, (0, 0, 0)), (200, (9, 9, 9))]
)
def test_rotation_and_shift_move_no_outline_by_more_than_a_millimetre(medina, angle, shift):
    scene, points, elevation = medina
    turn = np.radians(angle)
    rotation = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
    turned = measure_facade(
        replace(points, xyz=(points.xyz + points.origin) @ rotation.T, origin=np.array(shift, float)),
        FacadeSettings(),
    )
    assert_same_outlines(elevation, turned, 0.001)
    assert [pair.found.number for pair in judge(turned, scene.moved(angle, shift)).pairs] == [
        pair.found.number for pair in judge(elevation, scene).pairs
    ]


def assert_same_outlines(elevation, other, tolerance):
    assert len(other.details) == len(elevation.details)
    for detail, same in zip(elevation.details, other.details):
        assert (same.kind, same.shape) == (detail.kind, detail.shape)
        assert same.outline.bounds == pytest.approx(detail.outline.bounds, abs=tolerance)
        assert same.outline.hausdorff_distance(detail.outline) < 1.5 * tolerance


def test_without_colour_openings_recesses_and_projections_remain_and_a_warning_says_so(medina):
    scene, points, _ = medina
    elevation = measure_facade(replace(points, rgb=None), FacadeSettings())
    judgement = judge(elevation, scene)

    assert {true.kind for true in judgement.missed} == {COLOURED}
    assert judgement.invented == ()
    assert "no colour" in elevation.warnings[0]
    assert all(detail.colour is None for detail in elevation.details)


def test_without_intensity_a_warning_names_cast_shadows(medina):
    scene, points, _ = medina
    elevation = measure_facade(replace(points, intensity=None), FacadeSettings())
    found = {pair.true.kind for pair in judge(elevation, scene).pairs}

    assert "no intensity" in elevation.warnings[0]
    assert {OPENING, RECESS, PROJECTION} <= found
    assert all(detail.intensity is None for detail in elevation.details)


def test_scans_of_different_gain_are_compared_each_with_its_own(medina):
    scene, points, elevation = medina
    gain = np.where(points.scan == 1, np.float32(0.3), np.float32(1.0))
    other = measure_facade(replace(points, intensity=points.intensity * gain), FacadeSettings())

    assert judge(other, scene).missed == judge(other, scene).invented == ()
    assert len(other.details) == len(elevation.details)


def test_a_wall_without_details_is_a_wall():
    elevation = measure_facade(bare(upright(4, 3)), FacadeSettings())
    assert elevation.details == ()
    assert elevation.wall.area == pytest.approx(12, rel=0.005)


def test_a_stain_is_left_out_with_its_reason_unless_the_plain_chain_is_asked_for():
    xyz = upright(4, 3)
    u, v = xyz[:, 0] - 2, xyz[:, 2] - 1.5
    angle = np.arctan2(v, u)
    stain = np.hypot(u, v) < 0.5 + 0.2 * np.sin(3 * angle) + 0.12 * np.cos(5 * angle)
    rgb = np.where(stain[:, None], (110.0, 100, 90), (210.0, 200, 180)).astype(np.float32)
    points = replace(bare(xyz), rgb=rgb)
    elevation = measure_facade(points, FacadeSettings())

    (left_out,) = elevation.left_out
    assert elevation.details == ()
    assert (left_out.kind, left_out.reason) == (COLOURED, NOT_STRAIGHT)
    assert left_out.area == pytest.approx(0.83, abs=0.05)
    assert len(measure_facade(points, FacadeSettings(coloured=ALL_REGIONS)).details) == 1
    without = measure_facade(points, FacadeSettings(coloured=NO_REGIONS))
    assert without.left_out == () and not any("intensity" in warning for warning in without.warnings)


def test_without_regularise_every_outline_follows_the_points(medina):
    _, points, _ = medina
    elevation = measure_facade(points, FacadeSettings(regularise=False))
    assert {detail.shape for detail in elevation.details} == {"free"}


def test_smaller_details_than_asked_for_are_left_out(medina):
    _, points, _ = medina
    elevation = measure_facade(points, FacadeSettings(min_area_m2=1.0))
    assert elevation.details and min(detail.raw.area for detail in elevation.details) >= 1.0
