"""The results of scans and points."""

from ichnograph.tests.algorithms.registration.hall import HALL, labels, register, scanned


def test_noise_larger_than_sigma_says_is_told_and_nothing_rejected():
    targets, _ = scanned(HALL, noise=0.009)
    scan = register(HALL, targets, tolerance=0.08)

    assert len(labels(scan)) == 8
    assert scan.test.probability < 0.001
    assert any("SIGMA" in warning for warning in scan.warnings)
