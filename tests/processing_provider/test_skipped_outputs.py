"""What the dialog of an algorithm or of a model gives to the run and to the history."""

import pytest


@pytest.fixture
def dialog(provider):
    """Open the dialog of an algorithm, with values as *Run again* sets them."""
    from processing.gui.AlgorithmDialog import AlgorithmDialog

    opened = []

    def dialog(key, **values):
        opened.append(AlgorithmDialog(provider.algorithm(key).create(), False, None))
        opened[-1].setParameters(values)
        return opened[-1]

    yield dialog
    for window in opened:
        window.close()


def history_of(dialog):
    """Return the values that the history of QGIS keeps of a run."""
    from qgis.core import QgsProcessing, QgsProcessingContext  # noqa: F401 - the command names the first

    values = dialog.mainWidget().createProcessingParameters()
    command = dialog.algorithm().asPythonCommand(values, QgsProcessingContext())
    return eval(command.replace("processing.run", ""))[1]


@pytest.mark.parametrize(
    ("key", "made", "skipped"),
    [
        ("siteplan", "WALLS", "ROOMS"),
        ("Control points and scans to site plan", "siteplan:Walls", "siteplan:Rooms"),
    ],
)
def test_a_run_from_the_history_makes_no_output_that_was_switched_off(dialog, key, made, skipped):
    given = {"INPUT": ["a.laz"], "SCANS": ["a.laz"], "CONTROL": "control.txt", skipped: None}
    first = history_of(dialog(key, **given))
    again = history_of(dialog(key, **first))

    assert first[made] == again[made] == "TEMPORARY_OUTPUT"
    assert first[skipped] is again[skipped] is None
