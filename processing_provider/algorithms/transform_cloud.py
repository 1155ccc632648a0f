"""The algorithm `transformcloud`."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ...algorithms.progress import Progress
from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_CLOUDS
from ..log import Log
from ..parameters.clouds import CLOUDS
from ..parameters.files import JsonFile
from ..parameters.folders import FolderDestination

if TYPE_CHECKING:
    from ...algorithms.clouds.source import Source
    from ...algorithms.registration.output.transforms import ScanTransform


class TransformCloudAlgorithm(Algorithm):
    """Move clouds by the transformations of a registration."""

    key = "transformcloud"
    title = "Transform laser scans"
    chapter = "Clouds"
    summary = "Moves each scan to the control points by the transformation that registerscans found for it."
    about = (
        "Each cloud is moved by the transformation of the scan with the same name, and written to the folder "
        "under that name, to a tenth of a millimetre. It keeps all attributes, its normals are rotated, and "
        "it gets the coordinate reference system of the control points."
    )
    words = ("transform", "register", "georeference", "rotate", "point cloud", "tls", "lidar", "las", "laz")
    needs = FOR_CLOUDS
    inputs = (
        CLOUDS,
        JsonFile(
            "TRANSFORMS",
            "Transformations",
            "The json file that registerscans writes, or your own with the name and matrix of each scan.",
        ),
    )
    destinations = (
        FolderDestination(
            "OUTPUT_FOLDER",
            "Transformed clouds",
            "Folder for one cloud per scan. LAS, LAZ and text keep their format; all others become LAZ.",
            listing="CLOUDS",
        ),
    )
    numbers = (
        ("SCANS_TRANSFORMED", "Number of scans that were transformed"),
        ("POINTS", "Number of points in the clouds"),
    )

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Find the transformation of each cloud; the points are moved when the files are written."""
        from ...algorithms.clouds.cloud import open_sources, parts
        from ...algorithms.clouds.writing.transformation import (
            refuse_other_units,
            rounding_warnings,
            transform_cloud,
            transformed_names,
        )
        from ...algorithms.registration.output.transforms import match_clouds, read_transforms

        transforms = read_transforms(values["TRANSFORMS"])
        sources = open_sources(values["INPUT"])
        scans, warnings = match_clouds(transforms, [source.path for source in sources])
        log.warn(warnings)
        found = [(source, scan) for source, scan in zip(sources, scans) if scan]
        sources = tuple(source for source, _ in found)
        refuse_other_units(sources)
        for source, scan in found:
            log.warn(source.warnings)
            log.warn(rounding_warnings(source, scan.matrix))
        if transforms.crs is None:
            log.warn(
                [f"{transforms.path} states no coordinate reference system, so the results have none either."]
            )
        numbers = {"SCANS_TRANSFORMED": len(found), "POINTS": 0}

        def write(source: "Source", scan: "ScanTransform", progress: Progress, path: Path) -> None:
            count = transform_cloud(source, scan.matrix, path, transforms.crs, progress)
            log.info(f"{source.path.name}: {count} points, moved as the scan {scan.name}.")
            numbers["POINTS"] += count

        writers = {
            name: partial(write, source, scan, progress)
            for name, (_, scan), (source, progress) in zip(
                transformed_names(sources), found, parts(sources, log.progress)
            )
        }
        return Outcome({"OUTPUT_FOLDER": writers}, numbers)
