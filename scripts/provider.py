"""The provider in a QGIS that runs without a screen."""

import site
from pathlib import Path

from ichnograph.processing_provider.algorithm import Algorithm
from ichnograph.processing_provider.provider import Provider
from qgis.core import QgsApplication


def provider_in(application: QgsApplication) -> Provider:
    """Start QGIS and its toolbox, and return the provider of this plugin."""
    application.initQgis()
    site.addsitedir(str(Path(QgsApplication.pkgDataPath()) / "python" / "plugins"))
    from processing.core.Processing import Processing

    Processing.initialize()
    provider = Provider()
    QgsApplication.processingRegistry().addProvider(provider)
    return provider


def own_algorithms(provider: Provider) -> list[Algorithm]:
    """Return the algorithms of a provider that are not models."""
    return [item for item in provider.algorithms() if isinstance(item, Algorithm)]
