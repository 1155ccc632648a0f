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

    def info(self, sentence: str) -> None:
        """Write a sentence to the log."""
        self._feedback.pushInfo(sentence)

    def warn(self, sentences: Iterable[str]) -> None:
        """Write sentences to the log as warnings."""
        for sentence in sentences:
            self._feedback.pushWarning(sentence)

    def _report(self, fraction: float, message: str) -> None:
        self._feedback.setProgress(100 * fraction)
        # The core repeats its message with every chunk.
        if message and message != self._last_message:
            self._last_message = message
            self._feedback.setProgressText(message)
