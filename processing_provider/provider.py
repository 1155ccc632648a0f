"""The provider: what QGIS lists under Ichnograph in the toolbox."""

# ruff: noqa: D102, N802 - the methods and their names are QGIS's.

from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from .algorithm import ICON
from .compare_lengths import CompareLengthsAlgorithm
from .compare_plan import ComparePlanAlgorithm
from .density_image import DensityImageAlgorithm
from .extract_walls import ExtractWallsAlgorithm
from .facade_details import FacadeDetailsAlgorithm
from .facade_planes import FacadePlanesAlgorithm
from .register_scans import RegisterScansAlgorithm
from .simulate_registration import SimulateRegistrationAlgorithm
from .site_plan import SitePlanAlgorithm
from .thin_cloud import ThinCloudAlgorithm
from .transform_cloud import TransformCloudAlgorithm


class Provider(QgsProcessingProvider):
    """Lists the algorithms, and says which files they can write."""

    def id(self) -> str:
        return "ichnograph"

    def name(self) -> str:
        return "Ichnograph"

    def longName(self) -> str:
        return "Ichnograph: laser scans to site plans and elevations"

    def icon(self) -> QIcon:
        return QIcon(ICON)

    def svgIconPath(self) -> str:
        return ICON

    def supportsNonFileBasedOutput(self) -> bool:
        return False

    def supportedOutputRasterLayerExtensions(self) -> list:
        return ["tif", "tiff"]

    def supportedOutputVectorLayerExtensions(self) -> list:
        return ["gpkg", "shp"]

    def loadAlgorithms(self) -> None:
        for algorithm in (
            SitePlanAlgorithm,
            DensityImageAlgorithm,
            ExtractWallsAlgorithm,
            ComparePlanAlgorithm,
            ThinCloudAlgorithm,
            TransformCloudAlgorithm,
            RegisterScansAlgorithm,
            SimulateRegistrationAlgorithm,
            FacadeDetailsAlgorithm,
            FacadePlanesAlgorithm,
            CompareLengthsAlgorithm,
        ):
            self.addAlgorithm(algorithm())
