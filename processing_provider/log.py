"""The feedback of QGIS, as progress for the core and as sentences in the log."""

from collections.abc import Iterable

from qgis.core import QgsProcessingFeedback

from ..algorithms.progress import Progress


class Log:
    """Shows the user progress, information and warnings.

    Parameters
    ----------
    feedback : QgsProcessingFeedback
    """

    def __init__(self, feedback: QgsProcessingFeedback) -> None:
        self.progress = Progress(self._report, feedback.isCanceled)
        self._feedback = feedback
        self._last_message = ""
        self._fraction = 0.0

    def info(self, sentence: str) -> None:
        """Write a sentence to the log."""
        self._feedback.pushInfo(sentence)

    def warn(self, sentences: Iterable[str]) -> None:
        """Write sentences to the log as warnings."""
        for sentence in sentences:
            self._feedback.pushWarning(sentence)

    def _report(self, fraction: float, message: str) -> None:
        # A search that starts again does not move the bar back.
        self._fraction = max(self._fraction, fraction)
        self._feedback.setProgress(100 * self._fraction)
        # The core repeats its message with every chunk.
        if message and message != self._last_message:
            self._last_message = message
            self._feedback.setProgressText(message)
