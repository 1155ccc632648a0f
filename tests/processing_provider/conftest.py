"""A QGIS without a screen, in a profile of its own, with the plugin loaded."""

import os
import site
from pathlib import Path

import pytest
from ichnograph.tests.processing_provider.room import room_points, write_las
from rasterio.crs import CRS


@pytest.fixture(scope="session")
def qgis_application(tmp_path_factory):
    pytest.importorskip("qgis.core", reason="QGIS's Python bindings are not installed")
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    os.environ["QGIS_CUSTOM_CONFIG_PATH"] = str(tmp_path_factory.mktemp("profile"))
    from qgis.core import QgsApplication

    application = QgsApplication([], True)
    application.initQgis()
    # QGIS finds its own plugins there; the `processing` module is one of them.
    site.addsitedir(str(Path(QgsApplication.pkgDataPath()) / "python" / "plugins"))
    from processing.core.Processing import Processing

    Processing.initialize()
    yield application
    Processing.deinitialize()


@pytest.fixture(scope="session")
def plugin(qgis_application):
    import ichnograph

    plugin = ichnograph.classFactory(None)
    plugin.initProcessing()
    yield plugin
    plugin.unload()


@pytest.fixture
def provider(plugin):
    return plugin.provider


@pytest.fixture(scope="session")
def run(plugin):
    """Run an algorithm by its id, as scripts do."""
    import processing

    def run(algorithm, feedback=None, **parameters):
        return processing.run(f"ichnograph:{algorithm}", parameters, feedback=feedback)

    return run


@pytest.fixture(scope="session")
def room(tmp_path_factory):
    """Write the room, in UTM coordinates."""
    path = tmp_path_factory.mktemp("clouds") / "room.laz"
    write_las(path, room_points(), CRS.from_epsg(25833))
    return str(path)


@pytest.fixture
def feedback(qgis_application):
    """Return a feedback that remembers."""
    from qgis.core import QgsProcessingFeedback

    class Feedback(QgsProcessingFeedback):
        def __init__(self):
            super().__init__(False)
            self.infos, self.warnings, self.steps, self.fractions = [], [], [], []
            self.progressChanged.connect(self.fractions.append)

        def pushInfo(self, info):  # noqa: N802 - QGIS's name
            self.infos.append(info)

        def pushWarning(self, warning):  # noqa: N802 - QGIS's name
            self.warnings.append(warning)

        def setProgressText(self, text):  # noqa: N802 - QGIS's name
            self.steps.append(text)

    return Feedback()
