"""The frame of an elevation, its planes and its details."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.facade.elevation import Frame, Plane, frame_of
from ichnograph.tests.algorithms.facade.samples import site_of, small_elevation


@given(
    azimuth=st.floats(0, 360),
    tilt=st.floats(-40, 40),
    uvw=st.tuples(*[st.floats(-50, 50)] * 3),
)
def test_a_frame_turns_back_and_forth(azimuth, tilt, uvw):
    frame = Frame(np.array([412345.678, 5812345.789, 71.234]), azimuth, tilt)
    place = frame.world(np.array([uvw]))

    np.testing.assert_allclose(frame.axes @ frame.axes.T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(frame.local(place - frame.origin, frame.origin)[0], uvw, atol=1e-8)
    np.testing.assert_allclose(
        site_of({"x0": frame.origin[0], "y0": frame.origin[1], "z0": frame.origin[2],
                 "azimuth": azimuth, "tilt": tilt}, [uvw[:2]])[0],
        frame.world(np.array([(*uvw[:2], 0.0)]))[0], atol=1e-8,
    )  # fmt: skip


def test_u_is_right_v_is_up_and_w_towards_the_viewer():
    from_south = Frame(np.zeros(3), 180.0, 0.0)
    np.testing.assert_allclose(from_south.axes, [[1, 0, 0], [0, 0, 1], [0, -1, 0]], atol=1e-12)


def test_the_frame_of_a_plane_looks_along_its_normal_from_its_centre():
    tilt = np.radians(2.0)
    normal = np.array([0.0, -np.cos(tilt), np.sin(tilt)])
    frame = frame_of(Plane(normal, np.array([1.0, 2.0, 3.0]), 0.0, 3), np.array([100.0, 200.0, 0.0]))

    np.testing.assert_allclose(frame.origin, (101, 202, 3))
    assert (frame.azimuth, frame.tilt) == pytest.approx((180, 2))
    np.testing.assert_allclose(frame.axes[2], normal, atol=1e-12)


def test_distances_from_a_plane_are_positive_on_the_side_of_the_scanner():
    plane = Plane(np.array([0.0, -1.0, 0.0]), np.array([0.0, 5.0, 0.0]), 0.0, 3)
    np.testing.assert_allclose(plane.distances(np.array([(3.0, 4.0, 1.0), (0, 7, 0)])), (1, -2))


def test_sizes_of_a_detail_follow_its_outline_and_their_deviations_its_edges():
    (detail,) = small_elevation().details

    assert (detail.width, detail.height, detail.sill, detail.area) == (1.0, 1.5, 1.0, 1.5)
    assert np.isnan(detail.width_std)
    assert detail.height_std == pytest.approx(np.hypot(0.002, 0.003))
