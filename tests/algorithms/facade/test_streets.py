"""Simulated streets: what is built, what is scanned, and how elevations are compared with it."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.facade.development.curves import Chain
from ichnograph.algorithms.facade.elevation import OPENING, Detail, Edges, Elevation
from ichnograph.tests.scenes.facades.streets import STREETS
from ichnograph.tests.scenes.facades.streets.clutter import sill
from ichnograph.tests.scenes.facades.streets.cuts import CUTS, ROOMS, STREET, WHOLE, cut
from ichnograph.tests.scenes.facades.streets.judging import judge_street, seen
from ichnograph.tests.scenes.facades.streets.masonry import Masonry, standing
from ichnograph.tests.scenes.facades.streets.openings import WINDOW, pointed, round_arch, segmental
from matplotlib.path import Path
from shapely.affinity import translate
from shapely.geometry import MultiPolygon, box

PLACE = (31.0, (412_345.67, 5_812_345.71, 71.3))
COARSE = 0.05
CHORD = 0.0011
"""What is drawn flat in front of a round tower is seen a little narrower on its chord (m)."""

EXACT = Edges(0.001, 0.001, 0.001, 0.001)


@pytest.fixture(params=sorted(STREETS))
def scene(request):
    return STREETS[request.param](2).moved(*PLACE)


def house() -> Masonry:
    masonry = Masonry(np.random.default_rng(0))
    masonry.wall(standing(0, 6, 5))
    masonry.opening(masonry.faces[0], box(2.5, 3, 3.5, 4.5), WINDOW, 0.2)
    return masonry


def drawn(scene, azimuth=None):
    """Return an elevation that shows all openings as they were built."""
    details = tuple(
        Detail(number, OPENING, "free", true.outline, true.outline, EXACT, 0.0, true.depth, 0, None, None)
        for number, true in enumerate(scene.details)
    )  # fmt: skip
    frame = scene.frame if azimuth is None else replace(scene.frame, azimuth=azimuth)
    return Elevation(frame, MultiPolygon([box(*scene.wall.bounds)]), details, (), 0.01)


def test_openings_lie_in_the_wall_apart_from_each_other(scene):
    left, bottom, right, top = scene.wall.bounds
    for number, opening in enumerate(scene.details):
        assert box(left, bottom - 1e-6, right, top).covers(opening.outline)
        assert all(opening.outline.distance(other.outline) > 0.1 for other in scene.details[:number])


def test_no_point_of_the_wall_lies_in_an_opening(scene):
    scan = replace(scene, bulge=(0.0, 0.0)).scan(COARSE, 0.002)
    uvw = scene.frame.local(scan.points, np.zeros(3))
    for opening in scene.details:
        if not opening.turned:
            within = Path(opening.outline.buffer(-0.05).exterior.coords).contains_points(uvw[:, :2])
            assert not np.any(within & (np.abs(uvw[:, 2] - opening.layer) < 0.02))


def test_the_same_seed_gives_the_same_scan_and_another_seed_another_street(scene):
    again, other = (STREETS[scene.name](seed).moved(*PLACE) for seed in (2, 3))
    assert np.array_equal(again.scan(COARSE).points, scene.scan(COARSE).points)
    assert not np.array_equal(other.stations, scene.stations)


def test_rooms_are_seen_through_glass_and_the_street_in_front():
    scene = STREETS["terrace"](2)
    scan = scene.scan(COARSE)
    depths = {name: scene.frame.local(cut(scan, scene, name).points, np.zeros(3))[:, 2] for name in CUTS}
    assert depths[WHOLE].min() < -3 and depths[WHOLE].max() > 1
    assert depths[ROOMS].min() < -3 and depths[ROOMS].max() < 0.5
    assert depths[STREET].min() > -1 and depths[STREET].max() > 1


def test_a_sill_hides_the_lower_edge_of_a_window_from_the_street():
    masonry = house()
    below = np.array([(3.0, 2.985, 0.0)])
    assert seen(masonry.scene("plain", [(3, 1.6, 8)]), below).all()
    sill(masonry, masonry.faces[0], masonry.faces[0].openings[0])
    assert not seen(masonry.scene("with sill", [(3, 1.6, 8)]), below).any()


def test_a_wall_that_bulges_is_scanned_as_it_stands():
    masonry = house()
    flat, bent = (masonry.scene("house", [(3, 1.6, 8)], bulge=(out, 0.0)) for out in (0.0, 0.02))
    middle = [scene.frame.local(scene.scan(COARSE, 0.0).points, np.zeros(3)) for scene in (flat, bent)]
    out = [uvw[(abs(uvw[:, 0] - 3) < 0.2) & (abs(uvw[:, 1] - 2.5) < 0.2), 2].mean() for uvw in middle]
    assert out[1] - out[0] == pytest.approx(0.02, abs=0.001)


def test_arches_are_as_wide_and_high_as_asked():
    for arch in (segmental(1, 2, 1.2, 2, 0.2), round_arch(1, 2, 1.2, 2), pointed(1, 2, 1.2, 2)):
        assert arch.bounds == pytest.approx((1, 2, 2.2, 4), abs=0.0005)


def test_openings_drawn_as_built_are_all_found(scene):
    judgement = judge_street(drawn(scene), scene)
    assert not judgement.missed and not judgement.invented and judgement.right_side
    assert len(judgement.pairs) == sum(not true.turned for true in scene.details)
    assert np.allclose([pair.size for pair in judgement.pairs], 0, atol=CHORD)


def test_openings_of_a_tower_that_is_rolled_out_are_compared_on_their_walls():
    scene = STREETS["polygonal_tower"](2).moved(*PLACE)
    starts = sorted({true.origin for true in scene.details})
    last = next(true for true in scene.details if true.origin == starts[-1])
    side = float(np.linalg.norm(np.subtract(starts[1], starts[0])))
    corners = scene.frame.world([*starts, *last.places(np.array([[side, 0.0]]))])
    chain = Chain(corners[:, :2], 1)
    frame = replace(scene.frame, origin=np.append(chain.anchor, corners[0, 2]))
    outlines = [translate(true.built, (starts.index(true.origin) - 1.5) * side) for true in scene.details]
    flat = drawn(scene)
    details = tuple(replace(one, outline=outline) for one, outline in zip(flat.details, outlines))
    judgement = judge_street(replace(flat, frame=frame, details=details, curve=chain), scene)
    assert len(judgement.pairs) == len(scene.details) == 6 and not judgement.invented
    assert np.allclose([pair.size for pair in judgement.pairs], 0, atol=CHORD)


def test_an_opening_that_is_not_drawn_is_missed_and_one_that_is_not_there_invented():
    scene = house().scene("house", [(3, 1.6, 8)])
    elevation = drawn(scene)
    assert judge_street(replace(elevation, details=()), scene).missed == scene.details
    elsewhere = replace(elevation.details[0], outline=box(0.5, 1, 1.5, 2))
    judgement = judge_street(replace(elevation, details=(*elevation.details, elsewhere)), scene)
    assert judgement.invented == (elsewhere,)


def test_an_opening_that_nobody_saw_is_not_missed():
    masonry = house()
    masonry.block(masonry.faces[0], box(1.5, 2, 4.5, 5), 0.5, 0.6, (90, 90, 90), 0.5)
    scene = masonry.scene("behind a board", [(3, 1.6, 8)])
    judgement = judge_street(replace(drawn(scene), details=()), scene)
    assert judgement.hidden == scene.details and not judgement.missed


def test_a_facade_drawn_from_inside_is_on_the_wrong_side():
    scene = house().scene("house", [(3, 1.6, 8)]).moved(*PLACE)
    assert not judge_street(drawn(scene, (scene.frame.azimuth + 180) % 360), scene).right_side
