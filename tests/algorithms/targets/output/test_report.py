"""The report of a search."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.output.report import CROSS, marked, write_report
from ichnograph.algorithms.targets.settings import TargetSettings
from ichnograph.tests.algorithms.targets.made_targets import search, station, target, view


@pytest.fixture
def page(tmp_path):
    found = search(station("hall", target(), target(doubt="few points")), station("attic <1>"))
    write_report(found, TargetSettings(), tmp_path / "report.html")
    return (tmp_path / "report.html").read_text(encoding="utf-8")


def test_every_target_has_a_picture_and_a_row(page):
    assert page.count("<img") == 2
    assert page.count("black and white</td>") == 2


def test_doubtful_targets_stand_out_with_their_reason(page):
    assert 'class="marked"' in page
    assert "Doubtful: few points" in page


def test_a_scan_without_targets_says_why(page):
    assert "attic &lt;1&gt;" in page
    assert "Nothing in attic &lt;1&gt; looks like a sphere." in page


def test_the_cross_is_drawn_around_the_centre_and_leaves_it_free():
    picture = marked(view())
    red = np.argwhere(np.all(picture == CROSS, axis=2))

    np.testing.assert_allclose(red.mean(axis=0), np.array(picture.shape[:2]) / 2, atol=2)
    assert not np.all(picture[160, 160] == CROSS)
