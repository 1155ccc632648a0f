"""Every algorithm on simulated data, run as QGIS runs it; for the benchmarks of cancelling and of leaks."""

import os
import site
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional

import numpy as np
import rasterio.crs
from ichnograph.algorithms.registration.lists.point_list import PointList
from ichnograph.tests.algorithms.targets.made_targets import one_target
from ichnograph.tests.processing_provider.room import covered_points, write_las
from ichnograph.tests.scenes import SCENES
from ichnograph.tests.scenes.__main__ import write_laz
from ichnograph.tests.scenes.facades import FACADES
from ichnograph.tests.scenes.facades.__main__ import write_laz as write_facade
from ichnograph.tests.scenes.targets import target_scene

CRS = "EPSG:25833"

SOURCES = {
    "extractwalls": ("densityimage",),
    "compareplan": ("densityimage", "extractwalls", "siteplan"),
    "planlayout": ("siteplan",),
    "transformcloud": ("registerscans",),
}
"""Algorithms whose outputs are inputs of others."""


@dataclass
class ProviderRuns:
    """The algorithms of the plugin in a QGIS without a screen, and inputs for them.

    Attributes
    ----------
    folder : Path
        For inputs and outputs.
    points : int, optional
        About as many has each cloud; None for a room and a storehouse, which take each algorithm a second.
    """

    folder: Path
    points: Optional[int] = None
    inputs: dict[str, tuple[str, dict[str, Any]]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._start_qgis()
        (self.folder / "out").mkdir()
        self._clouds()
        self._lists()
        self._others()

    def needed_for(self, chosen: Optional[list[str]]) -> list[str]:
        """Return the algorithms that are chosen, or all, and those whose outputs they take as inputs."""
        needed = set(chosen or self.inputs)
        for name in needed.copy():
            needed.update(SOURCES.get(name, ()))
        return [name for name in self.inputs if name in needed]

    def run(self, name: str, feedback: Any = None) -> dict[str, Any]:
        """Run an algorithm with all outputs; return its results."""
        import processing

        algorithm, parameters = self.inputs[name]
        outputs = {
            item.name(): self._output(algorithm, item)
            for item in self._provider.algorithm(algorithm).destinationParameterDefinitions()
        }
        results: dict[str, Any] = processing.run(
            f"ichnograph:{algorithm}", {**outputs, **parameters}, feedback=feedback
        )
        _remove_layouts()
        return results

    def _output(self, algorithm: str, item: Any) -> str:
        extension = "" if item.type() == "folderDestination" else f".{item.defaultFileExtension()}"
        return str(self.folder / "out" / f"{algorithm}_{item.name().lower()}{extension}")

    def _start_qgis(self) -> None:
        os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
        os.environ["QGIS_CUSTOM_CONFIG_PATH"] = str(self.folder / "profile")
        from qgis.core import QgsApplication

        self._application = QgsApplication([], True)
        self._application.initQgis()
        site.addsitedir(str(Path(QgsApplication.pkgDataPath()) / "python" / "plugins"))
        from processing.core.Processing import Processing

        Processing.initialize()
        import ichnograph

        self._plugin = ichnograph.classFactory(None)
        self._plugin.initProcessing()
        self._provider: Any = self._plugin.provider

    def _clouds(self) -> None:
        cloud, facade = self.folder / "interior.laz", self.folder / "facade.laz"
        if self.points is None:
            write_las(cloud, covered_points()[::2], rasterio.crs.CRS.from_user_input(CRS))
            write_facade(facade, FACADES["storehouse"](0).scan(spacing=0.08), CRS)
        else:
            scan = SCENES["interior"](0).scan(angular_step=0.2 * (10_000_000 / self.points) ** 0.5)
            write_laz(cloud, scan, np.arange(min(len(scan.points), self.points)), CRS)
            scene = FACADES["medina"](0)
            write_facade(facade, scene.scan(spacing=0.01 * (900_000 / self.points) ** 0.5), CRS)
        out = self.folder / "out"
        self.inputs.update(
            thincloud=("thincloud", {"INPUT": [str(cloud)], "SPACING": 0.02}),
            densityimage=("densityimage", {"INPUT": [str(cloud)]}),
            extractwalls=("extractwalls", {"INPUT": str(out / "densityimage_density.tif")}),
            siteplan=("siteplan", {"INPUT": [str(cloud)]}),
            compareplan=(
                "compareplan",
                {
                    "WALLS": str(out / "siteplan_walls.gpkg"),
                    "REFERENCE": str(out / "extractwalls_walls.gpkg"),
                },
            ),
            facadedetails=("facadedetails", {"INPUT": [str(facade)]}),
            facadeplanes=("facadeplanes", {"INPUT": [str(facade)]}),
        )

    def _lists(self) -> None:
        scene = target_scene(60, 15, 9, seed=1)
        control, targets = self._written(scene.control, "control"), self._written(scene.targets, "interior")
        self.inputs["registerscans"] = ("registerscans", {"CONTROL": control, "TARGETS": [targets]})
        transforms = str(self.folder / "out" / "registerscans_transforms.json")
        self.inputs["transformcloud"] = (
            "transformcloud",
            {"INPUT": [str(self.folder / "interior.laz")], "TRANSFORMS": transforms},
        )
        self.inputs["simulateregistration"] = (
            "simulateregistration",
            {"CONTROL": control, "TRIALS": max((self.points or 0) // 5000, 2)},
        )

    def _others(self) -> None:
        """Add the algorithms whose inputs are neither clouds of buildings nor lists of targets."""
        scan = one_target("black and white", 0.15, 4.0)
        hall, tape = self.folder / "hall.xyz", self.folder / "tape.csv"
        columns = np.column_stack([scan.xyz, scan.intensity])
        np.savetxt(hall, columns, "%.5f %.5f %.5f %d", header="x y z intensity", comments="")
        tape.write_text("id,width,height\n" + "".join(f"{n},1.{n},2.{n}\n" for n in range(10, 60)))
        walls = str(self.folder / "out" / "siteplan_walls.gpkg")
        self.inputs.update(
            findtargets=("findtargets", {"INPUT": [str(hall)]}),
            comparelengths=("comparelengths", {"SCHEDULE": str(tape), "REFERENCE": str(tape)}),
            planlayout=("planlayout", {"WALLS": walls}),
        )

    def harder_searches(self) -> None:
        """Add registrations that search long: a grid of 400 points, and an unknown scale with outliers."""
        random = np.random.default_rng(0)
        grid = np.array([[5.0 * x, 5.0 * y, 1.5] for x in range(20) for y in range(20)])
        places = random.uniform(0, (8, 7, 3), (50, 3))
        picked = np.concatenate([places[:10], random.uniform(0, (8, 7, 3), (40, 3))])
        for name, control, targets, model in (
            ("grid", grid, grid + random.normal(0, 0.002, grid.shape), 0),
            ("outliers", places, 2.5 * picked + random.normal(0, 0.01, picked.shape), 4),
        ):
            self.inputs[f"registerscans, {name}"] = (
                "registerscans",
                {
                    "CONTROL": self._listed(control, f"{name}_control"),
                    "TARGETS": [self._listed(targets, f"{name}_scan")],
                    "MODEL": model,
                    "SIGMA": 0.01 if model == 4 else 0.003,
                    "CRS": CRS,
                },
            )

    def _written(self, points: PointList, name: str) -> str:
        path = self.folder / f"{name}.txt"
        rows = zip(points.names, points.xyz.tolist())
        path.write_text("".join(f"{label} {x:.5f} {y:.5f} {z:.5f}\n" for label, (x, y, z) in rows))
        return str(path)

    def _listed(self, xyz: np.ndarray, name: str) -> str:
        path = self.folder / f"{name}.txt"
        np.savetxt(path, xyz, "%.5f")
        return str(path)


def _remove_layouts() -> None:
    """Remove what `planlayout` adds to the project; the event loop of the desktop deletes its objects."""
    from qgis.core import QgsProject
    from qgis.PyQt.QtCore import QCoreApplication, QEvent

    manager = QgsProject.instance().layoutManager()
    if manager.layouts():
        manager.clear()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        QCoreApplication.processEvents()
