"""The provider in a QGIS that runs without a screen."""

import os
import site
import sys
from pathlib import Path
from typing import Callable

from ichnograph.processing_provider.algorithm import Algorithm
from ichnograph.processing_provider.provider import Provider
from qgis.core import QgsApplication


def run_with_provider(run: Callable[[Provider], None]) -> None:
    """Start QGIS and its toolbox, run something with the provider of this plugin, and leave Python."""
    # As on the desktop, where the help has sections.
    application = QgsApplication([], True, "", "desktop")
    application.initQgis()
    site.addsitedir(str(Path(QgsApplication.pkgDataPath()) / "python" / "plugins"))
    from processing.core.Processing import Processing

    Processing.initialize()
    provider = Provider()
    QgsApplication.processingRegistry().addProvider(provider)
    run(provider)
    sys.stdout.flush()
    # QGIS's widgets crash if Python takes them down in its own order.
    os._exit(0)


def own_algorithms(provider: Provider) -> list[Algorithm]:
    """Return the algorithms of a provider that are not models."""
    return [item for item in provider.algorithms() if isinstance(item, Algorithm)]
