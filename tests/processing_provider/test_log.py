"""What the log shows of the sentences of the core."""

import pytest
from ichnograph.processing_provider.log import Log


class Shown:
    """A feedback of QGIS that remembers what it shows."""

    def __init__(self):
        self.texts = []
        self.pushInfo = self.pushWarning = self.setProgressText = self.texts.append

    def isCanceled(self):  # noqa: N802 - QGIS's name
        return False

    def setProgress(self, percent):  # noqa: N802 - QGIS's name
        pass


@pytest.fixture
def shown():
    return Shown()


@pytest.fixture
def log(plugin, shown):
    return Log(shown, {"FACADE": "Number of the facade"})


def test_all_that_is_shown_names_parameters_by_their_labels(log, shown):
    log.info("FACADE takes another one.")
    log.warn(["FACADE takes another one."])
    log.progress.update(0.5, "FACADE takes another one.")

    assert shown.texts == 3 * ["Number of the facade (FACADE) takes another one."]


def test_a_message_of_the_progress_is_shown_once(log, shown):
    for fraction in (0.1, 0.2):
        log.progress.update(fraction, "Reading a.laz")
    assert shown.texts == ["Reading a.laz"]
