"""The provider: the algorithms that QGIS lists under Ichnograph in the toolbox."""

# ruff: noqa: D102, N802 - QGIS defines and names the methods.

from configparser import ConfigParser
from pathlib import Path

from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from .algorithm import ICONS
from .algorithms.compare_lengths import CompareLengthsAlgorithm
from .algorithms.compare_plan import ComparePlanAlgorithm
from .algorithms.density_image import DensityImageAlgorithm
from .algorithms.example_data import ExampleDataAlgorithm
from .algorithms.extract_walls import ExtractWallsAlgorithm
from .algorithms.facade_details import FacadeDetailsAlgorithm
from .algorithms.facade_planes import FacadePlanesAlgorithm
from .algorithms.find_targets import FindTargetsAlgorithm
from .algorithms.plan_layout import PlanLayoutAlgorithm
from .algorithms.register_scans import RegisterScansAlgorithm
from .algorithms.simulate_registration import SimulateRegistrationAlgorithm
from .algorithms.site_plan import SitePlanAlgorithm
from .algorithms.thin_cloud import ThinCloudAlgorithm
from .algorithms.transform_cloud import TransformCloudAlgorithm
from .language import translated
from .model import Model

MODELS = Path(__file__).parent / "models"

METADATA = Path(__file__).parents[1] / "metadata.txt"


def version() -> str:
    """Return the version of the plugin."""
    parser = ConfigParser()
    parser.read(METADATA, encoding="utf-8")
    return parser["general"]["version"]


class Provider(QgsProcessingProvider):
    """Lists the algorithms and the kinds of files that they can write."""

    def id(self) -> str:
        return "ichnograph"

    def name(self) -> str:
        return "Ichnograph"

    def longName(self) -> str:
        return translated("Ichnograph: laser scans to site plans and elevations")

    def icon(self) -> QIcon:
        return QIcon(self.svgIconPath())

    def svgIconPath(self) -> str:
        return str(ICONS / "ichnograph.svg")

    def versionInfo(self) -> str:
        return version()

    def supportsNonFileBasedOutput(self) -> bool:
        return False

    def supportedOutputRasterLayerExtensions(self) -> list[str]:
        return ["tif", "tiff"]

    def supportedOutputVectorLayerExtensions(self) -> list[str]:
        return ["gpkg", "shp"]

    def loadAlgorithms(self) -> None:
        for algorithm in (
            SitePlanAlgorithm,
            DensityImageAlgorithm,
            ExtractWallsAlgorithm,
            ComparePlanAlgorithm,
            PlanLayoutAlgorithm,
            ThinCloudAlgorithm,
            TransformCloudAlgorithm,
            FindTargetsAlgorithm,
            RegisterScansAlgorithm,
            SimulateRegistrationAlgorithm,
            FacadeDetailsAlgorithm,
            FacadePlanesAlgorithm,
            CompareLengthsAlgorithm,
            ExampleDataAlgorithm,
        ):
            self.addAlgorithm(algorithm())
        for path in sorted(MODELS.glob("*.model3")):
            self.addAlgorithm(Model(path))
