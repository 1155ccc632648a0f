"""The page of a simulation."""

from ichnograph.algorithms.registration.simulation.simulation_report import write_simulation_report


def test_the_report_names_failures_and_ambiguous_points(box, tmp_path):
    write_simulation_report(box, tmp_path / "box.html")

    page = (tmp_path / "box.html").read_text(encoding="utf-8")
    for words in ("In 0 of 5 trials (0.0%) all 8 targets", "ambiguous", "Points confused with", "P7"):
        assert words in page
    assert "Errors of the transformations" not in page


def test_the_report_of_a_good_layout_has_errors_and_no_failures(found, tmp_path):
    write_simulation_report(found, tmp_path / "found.html")

    page = (tmp_path / "found.html").read_text(encoding="utf-8")
    assert "(100.0%)" in page
    assert "No control points were confused with each other." in page
    assert "Errors of the transformations" in page
    assert "Failures" not in page
    assert "nan" not in page
