"""`simulateregistration`, run as scripts run it."""

import csv

import pytest
from ichnograph.tests.scenes.targets import target_scene


@pytest.fixture
def control(tmp_path):
    points = target_scene(20, 5, 5).control
    path = tmp_path / "control.txt"
    rows = (f"{name} {x:.4f} {y:.4f} {z:.4f}" for name, (x, y, z) in zip(points.names, points.xyz))
    path.write_text("\n".join(rows), encoding="utf-8")
    return str(path)


def test_it_writes_a_table_and_a_report_and_returns_the_success_rate(run, control, tmp_path, feedback):
    table, report = tmp_path / "trials.csv", tmp_path / "report.html"
    result = run(
        "simulateregistration", feedback, CONTROL=control, TRIALS=10, TABLE=str(table), REPORT=str(report)
    )

    with table.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 10
    assert result["SUCCESS_RATE"] == sum(row["success"] == "1" for row in rows) / 10 > 0.8
    assert "Simulated registration with control" in report.read_text(encoding="utf-8")
    assert any(info.startswith("All targets right in ") for info in feedback.infos)
    assert feedback.fractions[-1] > 90


def test_the_parameters_reach_the_simulation(run, control, tmp_path):
    def table(name, **parameters):
        path = tmp_path / name
        run(
            "simulateregistration",
            **{"CONTROL": control, "TRIALS": 3, "TABLE": str(path), "REPORT": None, **parameters},
        )
        return path.read_bytes()

    plain = table("plain.csv")
    assert table("again.csv") == plain
    changes = {"SEED": 2, "SIGMA": 0.001, "SCALE_PPM": 100, "TARGETS_PER_SCAN": 6, "MODEL": 2, "REACH": 15}
    for name, value in changes.items():
        assert table(f"{name}.csv", **{name: value}) != plain


def test_the_log_names_ambiguous_points(run, tmp_path, feedback):
    corners = [f"C{x}{y}{z} {4 * x} {4 * y} {4 * z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    (tmp_path / "cube.txt").write_text("\n".join(corners), encoding="utf-8")
    result = run(
        "simulateregistration",
        feedback,
        CONTROL=str(tmp_path / "cube.txt"),
        TARGETS_PER_SCAN=8,
        TRIALS=2,
        TABLE=None,
        REPORT=None,
    )

    assert result["SUCCESS_RATE"] == 0
    assert "ambiguous: 2" in feedback.infos
    assert any("C000 and C" in warning for warning in feedback.warnings)


@pytest.mark.parametrize(
    ("parameters", "sentence"),
    [
        (
            {"TARGETS_PER_SCAN": 21},
            "control.txt has 20 points, but Targets seen in each scan (TARGETS_PER_SCAN) is 21; lower it",
        ),
        (
            {"TARGETS_PER_SCAN": 2},
            "(TARGETS_PER_SCAN) is 2, but Transformation (MODEL) needs at least 3; raise it.",
        ),
        ({"TRIALS": 0}, "(TRIALS) must be a whole number"),
        ({"TABLE": "trials.txt"}, "end the name in .csv."),
    ],
)
def test_what_makes_no_sense_is_refused_in_a_sentence(run, control, tmp_path, parameters, sentence):
    from qgis.core import QgsProcessingException

    with pytest.raises(QgsProcessingException) as caught:
        run("simulateregistration", **{"CONTROL": control, "TABLE": None, "REPORT": None, **parameters})
    assert sentence in str(caught.value)


def test_planned_points_at_whole_metres_are_not_said_to_be_rounded(run, tmp_path, feedback):
    rows = [f"P{n} {412300 + n * n % 37} {5812300 + 5 * n} {70 + n % 3}" for n in range(12)]
    (tmp_path / "planned.txt").write_text("\n".join(rows), encoding="utf-8")
    run(
        "simulateregistration",
        feedback,
        CONTROL=str(tmp_path / "planned.txt"),
        TRIALS=1,
        TABLE=None,
        REPORT=None,
    )

    assert not any("multiples of" in warning for warning in feedback.warnings)
