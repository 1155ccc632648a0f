"""The feedback of QGIS, as progress for the core and as sentences in the log."""

from collections.abc import Iterable, Mapping

from qgis.core import QgsProcessingFeedback

from ..algorithms.progress import Progress
from .labels import with_labels


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

    def info(self, sentence: str) -> None:
        """Write a sentence to the log."""
        self._feedback.pushInfo(with_labels(sentence, self._labels))

    def warn(self, sentences: Iterable[str]) -> None:
        """Write sentences to the log as warnings."""
        for sentence in sentences:
            self._feedback.pushWarning(with_labels(sentence, self._labels))

    def _report(self, fraction: float, message: str) -> None:
        self._feedback.setProgress(100 * fraction)
        # The core repeats its message with every chunk.
        if message and message != self._last_message:
            self._last_message = message
            self._feedback.setProgressText(message)
