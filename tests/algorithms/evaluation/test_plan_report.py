"""The report of a comparison of plans."""

import re

from ichnograph.algorithms.evaluation.plan import compare_plan
from ichnograph.algorithms.evaluation.plan_report import write_plan_report
from shapely.geometry import MultiPolygon, box

WALL = box(0, 0, 10, 0.5)


def test_it_shows_the_numbers_and_the_longest_errors(tmp_path):
    agreement = compare_plan(box(0, 0, 5, 0.5), WALL, 0.05)
    write_plan_report(tmp_path / "report.html", agreement, ["A <doubt>."])
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert f"{agreement.completeness:.1%} of the reference is in the plan" in page
    assert "A &lt;doubt&gt;." in page
    assert page.count("<svg") == 2
    assert ">missing<" in page and ">wrong<" in page
    assert "http" not in page


def test_a_perfect_plan_has_no_errors(tmp_path):
    write_plan_report(tmp_path / "report.html", compare_plan(WALL, WALL, 0.05))
    assert "There are no errors." in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_completeness_and_correctness_are_listed_at_several_tolerances(tmp_path):
    write_plan_report(tmp_path / "report.html", compare_plan(WALL, WALL, 0.03))
    page = (tmp_path / "report.html").read_text(encoding="utf-8")

    rows = re.findall(r'<td class="w">([\d.]+) cm</td><td>([\d.]+)</td><td>([\d.]+)</td>', page)
    assert rows == [(at, "100.0", "100.0") for at in ("1.0", "2.0", "3.0", "5.0", "10.0", "20.0", "50.0")]


def test_of_many_errors_the_longest_are_listed(tmp_path):
    invented = [box(2 * place, 5, 2 * place + 0.1 * (place + 1), 5.1) for place in range(30)]
    agreement = compare_plan(MultiPolygon([WALL, *invented]), WALL, 0.05)
    write_plan_report(tmp_path / "report.html", agreement)
    page = (tmp_path / "report.html").read_text(encoding="utf-8")

    assert "The longest 20 of 30." in page
    lengths = [float(text) for text in re.findall(r'<td class="w">wrong</td><td>([\d.]+)</td>', page)]
    assert lengths == sorted(lengths, reverse=True)
    assert len(lengths) == 20
