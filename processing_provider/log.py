"""The feedback of QGIS, as progress for the core and as sentences in the log."""

from collections.abc import Iterable, Mapping

from qgis.core import QgsProcessingFeedback

from ..algorithms.progress import Progress
from .labels import with_labels
from .language import translated


class Log:
    """Shows the user progress, information and warnings.

    Parameters
    ----------
    feedback : QgsProcessingFeedback
    labels : dict of str to str
        The labels of the parameters by their ids, which the sentences of the core name.
    """

    def __init__(self, feedback: QgsProcessingFeedback, labels: Mapping[str, str]) -> None:
        self.progress = Progress(self._report, feedback.isCanceled)
        self._feedback = feedback
        self._labels = labels
        self._last_message = ""
        self._fraction = 0.0

    def info(self, sentence: str) -> None:
        """Write a sentence to the log."""
        self._feedback.pushInfo(with_labels(translated(sentence), self._labels))

    def warn(self, sentences: Iterable[str]) -> None:
        """Write sentences to the log as warnings."""
        for sentence in sentences:
            self._feedback.pushWarning(with_labels(translated(sentence), self._labels))

    def _report(self, fraction: float, message: str) -> None:
        # A search that starts again does not move the bar back.
        self._fraction = max(self._fraction, fraction)
        self._feedback.setProgress(100 * self._fraction)
        # The core repeats its message with every chunk.
        if message and message != self._last_message:
            self._last_message = message
            self._feedback.setProgressText(with_labels(translated(message), self._labels))
