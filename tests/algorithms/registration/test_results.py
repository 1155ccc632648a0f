"""What results say about themselves."""

from dataclasses import replace

import numpy as np
from ichnograph.tests.algorithms.registration.made_registrations import (
    CORNER,
    correspondence,
    refused,
    registration,
    rejected,
    scan,
)


def test_the_longest_residual_is_that_of_a_target_that_was_used():
    good = correspondence("1", "A", CORNER, residual=(0.003, 0.0, 0.004))
    outlier = rejected("2", "B", CORNER, (0.3, 0.0, 0.0))
    found = replace(registration(), scans=(scan("S1", [good, outlier], CORNER),))

    assert good.length == 0.005
    assert found.max_residual == 0.005


def test_refused_scans_have_no_part_in_it():
    found = registration(scans=1, more=[refused("S9")])

    assert [item.name for item in found.registered] == ["S01"]
    assert np.isnan(replace(found, scans=(refused("S9"),)).max_residual)
