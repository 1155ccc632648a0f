"""The algorithm `transformcloud`."""

from functools import partial

from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.clouds import CLOUDS
from ..parameters.destinations import FolderDestination
from ..parameters.files import JsonFile


class TransformCloudAlgorithm(Algorithm):
    """Move clouds to where a registration puts them."""

    key = "transformcloud"
    title = "Transform laser scans"
    chapter = "Clouds"
    summary = "Moves each scan to the control points by the transformation that registerscans found for it."
    about = (
        "Every cloud is moved by the transformation of the scan of its name, and written to the folder under "
        "the same name, to a tenth of a millimetre. All attributes stay, normals turn along, and the "
        "coordinate reference system of the control points is set."
    )
    words = ("transform", "register", "georeference", "rotate", "point cloud", "tls", "lidar", "las", "laz")
    inputs = (
        CLOUDS,
        JsonFile(
            "TRANSFORMS",
            "Transformations",
            "The json file that registerscans writes, or one by hand with the name and matrix of each scan.",
        ),
    )
    destinations = (
        FolderDestination(
            "OUTPUT_FOLDER",
            "Transformed clouds",
            "Folder for one cloud per scan. LAS, LAZ and text stay what they are; all else becomes LAZ.",
            listing="CLOUDS",
        ),
    )
    numbers = (
        ("SCANS_TRANSFORMED", "Number of scans that were transformed"),
        ("POINTS", "Number of points in the clouds"),
    )

    def compute(self, values: dict, log: Log) -> Outcome:
        """Find the transformation of each cloud; the points are moved when the files are written."""
        from ...algorithms.clouds.cloud import open_sources, parts
        from ...algorithms.clouds.writing.transformation import (
            transform_cloud,
            transformed_names,
            unit_warnings,
        )
        from ...algorithms.registration.output.transforms import match_clouds, read_transforms

        transforms = read_transforms(values["TRANSFORMS"])
        sources = open_sources(values["INPUT"])
        scans, warnings = match_clouds(transforms, [source.path for source in sources])
        log.warn(warnings)
        sources = tuple(source for source, scan in zip(sources, scans) if scan)
        scans = tuple(scan for scan in scans if scan)
        log.warn(unit_warnings(sources))
        if transforms.crs is None:
            log.warn(
                [f"{transforms.path} names no coordinate reference system, so the results have none either."]
            )
        numbers = {"SCANS_TRANSFORMED": len(scans), "POINTS": 0}

        def write(source, scan, progress, path):
            count = transform_cloud(source, scan.matrix, path, transforms.crs, progress)
            log.info(f"{source.path.name}: {count} points, moved as the scan {scan.name}.")
            numbers["POINTS"] += count

        writers = {
            name: partial(write, source, scan, progress)
            for name, scan, (source, progress) in zip(
                transformed_names(sources), scans, parts(sources, log.progress)
            )
        }
        return Outcome({"OUTPUT_FOLDER": writers}, numbers)
