"""Photograph the dialog of an algorithm, on a desktop or without a screen.

ALGORITHM=ichnograph:siteplan PICTURE=dialog.png xvfb-run qgis --nologo --code scripts/dialog_picture.py
"""

import os

import processing
from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QTimer
from qgis.PyQt.QtWidgets import QWidget

SECONDS = 2
"""Time for the desktop, and then for the dialog, to draw themselves."""


def open_dialog() -> None:
    """Show the dialog, and take the picture a little later."""
    dialog = processing.createAlgorithmDialog(os.environ["ALGORITHM"], {})
    dialog.resize(1150, 950)
    dialog.show()
    QTimer.singleShot(1000 * SECONDS, lambda: take_picture(dialog))


def take_picture(dialog: QWidget) -> None:
    """Save the picture and leave QGIS."""
    dialog.grab().save(os.environ["PICTURE"])
    dialog.close()
    QgsApplication.exit()


QTimer.singleShot(1000 * SECONDS, open_dialog)
