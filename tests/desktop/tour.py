"""A tour of the desktop, which QGIS runs with `--code`: what a user does, and what is seen then, as JSON.

TOUR_ZIP is the plugin, or it is on QGIS_PLUGINPATH; TOUR_CLOUDS are two clouds without a system, separated by
a semicolon; TOUR_FOLDER is an empty folder.

What differs between versions of QGIS is imported where it is used: an error while this file is read opens a
window that waits for a click.
"""

import json
import os
import traceback
from pathlib import Path

import processing
import pyplugin_installer
import qgis.utils
from processing.core.ProcessingResults import resultsList
from processing.gui.BatchAlgorithmDialog import BatchAlgorithmDialog
from qgis.core import Qgis, QgsApplication, QgsProcessingContext, QgsProject
from qgis.PyQt.QtCore import QTimer
from qgis.PyQt.QtGui import QColor, QGuiApplication
from qgis.PyQt.QtWidgets import QAction, QApplication, QDockWidget, QTextEdit
from qgis.utils import iface, loadPlugin, plugins, startPlugin

FOLDER = Path(os.environ["TOUR_FOLDER"])
CLOUDS = os.environ["TOUR_CLOUDS"].split(";")
SECONDS = 900
"""The longest that an algorithm may take, when it compiles for the first time on a computer that is busy."""

seen = {"during": "start", "messages": [], "bars": [], "runs": [], "errors": []}

dialogs = []
"""Those that were opened; they are hidden, because a closed one would be deleted."""


def note_message(text, tag, level):
    """Note a message of the log that warns."""
    if level in (Qgis.MessageLevel.Warning, Qgis.MessageLevel.Critical):
        seen["messages"].append([seen["during"], f"{tag}: {text}"])


def note_bar(_):
    """Note a bar above the map that warns."""
    item = iface.messageBar().currentItem()
    if item.level() in (Qgis.MessageLevel.Warning, Qgis.MessageLevel.Critical):
        seen["bars"].append([seen["during"], f"{item.title()} {item.text()}"])


def note_exception(kind, value, trace, *further, **named):
    """Note what QGIS would show in a window that waits for the user."""
    seen["errors"].append("".join(traceback.format_exception(kind, value, trace)))


def facts_of(layer, tree):
    """Return what a user sees of a layer."""
    vector = layer.type() == layer.VectorLayer
    return {
        "name": layer.name(),
        "source": layer.source(),
        "visible": tree.findLayer(layer.id()).isVisible(),
        "system": layer.crs().authid() if layer.crs().isValid() else None,
        "extent": layer.extent().toString(2),
        "features": layer.featureCount() if vector else None,
        "renderer": layer.renderer().type(),
        "aliases": [field.alias() for field in layer.fields()] if vector else None,
    }


def project():
    """Return what a user sees of the project."""
    tree, extent = QgsProject.instance().layerTreeRoot(), iface.mapCanvas().extent()
    return {
        "layers": [facts_of(node.layer(), tree) for node in tree.findLayers()],
        "canvas": [extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum()],
        "results": [entry.name for entry in resultsList.getResults()],
        "layouts": [layout.name() for layout in QgsProject.instance().layoutManager().printLayouts()],
    }


def log_of(dialog):
    """Return the text of the log of a dialog."""
    texts = (edit.toPlainText() for edit in dialog.findChildren(QTextEdit))
    return next((text for text in texts if "started at" in text), "")


def run(key, values, picture, cancel=False):
    """Run an algorithm from its dialog, and wait until its layers are there."""
    seen["during"] = picture
    dialog = processing.createAlgorithmDialog(f"ichnograph:{key}", values)
    dialogs.append(dialog)
    dialog.resize(1150, 900)
    dialog.show()
    yield 500
    dialog.grab().save(str(FOLDER / f"{picture}_dialog.png"))
    finished = []
    dialog.algorithmFinished.connect(lambda succeeded, _: finished.append(succeeded))
    dialog.runAlgorithm()
    if cancel:
        yield 100
        dialog.cancelButton().click()
    for _ in range(10 * SECONDS):
        # QGIS 3.40 does not signal the end of a run that was cancelled.
        if finished or "Execution failed after" in log_of(dialog):
            break
        yield 100
    else:
        raise RuntimeError(f"{key} does not end: {log_of(dialog)}")
    yield 1500
    seen["runs"].append(
        {"name": picture, "succeeded": bool(finished and finished[0]), "log": log_of(dialog), **project()}
    )
    dialog.hide()
    iface.mainWindow().grab().save(str(FOLDER / f"{picture}.png"))


def last_command():
    """Return the last command of the history, which is a file before QGIS 3.24 and a database since."""
    try:
        from processing.core.ProcessingLog import ProcessingLog
    except ImportError:
        from qgis.gui import QgsGui

        entries = QgsGui.historyProviderRegistry().queryEntries(providerId="processing")
        return max(entries, key=lambda entry: entry.timestamp).entry["python_command"]
    return ProcessingLog.getLogEntries()[-1].text


def run_again():
    """Run the last entry of the history, with the parameters that it has kept."""
    seen["history"] = last_command()
    key, values = eval(seen["history"].replace("processing.run", ""))
    yield from run(key.partition(":")[2], values, "from_history")


def batch():
    """Thin three clouds in a batch, a row each."""
    seen["during"] = "batch"
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("ichnograph:thincloud")
    dialog = BatchAlgorithmDialog(algorithm)
    dialogs.append(dialog)
    dialog.show()
    panel, context = dialog.mainWidget(), QgsProcessingContext()
    panel.addRow(2)
    thinned = [FOLDER / f"thin_{number}.laz" for number in range(3)]
    for row, path in enumerate(thinned):
        cloud = CLOUDS[row % len(CLOUDS)]
        panel.wrappers[row][panel.parameter_to_column["INPUT"]].setParameterValue([cloud], context)
        panel.tblParameters.cellWidget(row + 1, panel.parameter_to_column["OUTPUT"]).setValue(str(path))
    yield 300
    dialog.grab().save(str(FOLDER / "batch.png"))
    dialog.runAlgorithm()
    for _ in range(10 * SECONDS):
        if all(path.is_file() for path in thinned):
            break
        yield 100
    yield 1000
    seen["batch"] = [path.name for path in thinned if path.is_file()]
    dialog.hide()


def tour():
    """Install the plugin, and use it as a user does."""
    qgis.utils.showException = note_exception
    QgsApplication.messageLog().messageReceived.connect(note_message)
    iface.messageBar().widgetAdded.connect(note_bar)
    iface.mainWindow().resize(1400, 900)
    if "TOUR_ZIP" in os.environ:
        pyplugin_installer.instance().installFromZipFile(os.environ["TOUR_ZIP"])
    elif loadPlugin("ichnograph"):
        startPlugin("ichnograph")
    yield 500
    seen["installed"] = "ichnograph" in plugins
    for part in (the_tutorial, work_with_runs, batch, facade, model, look_from_above):
        yield from noting_errors(part)


def noting_errors(part):
    """Do a part of the tour; what is wrong must be seen by the test, and so must the other parts."""
    try:
        yield from part()
    except Exception:
        seen["errors"].append(traceback.format_exc())


def the_tutorial():
    """Go the way of the tutorial, from dialog to dialog."""
    example = FOLDER / "house"
    yield from run("exampledata", {"OUTPUT_FOLDER": str(example)}, "exampledata")
    lists, scans = (sorted(map(str, example.glob(f"house_0*.{kind}"))) for kind in ("txt", "laz"))
    control = {"CONTROL": str(example / "control.txt"), "CRS": "EPSG:25833"}
    transforms = str(FOLDER / "transforms.json")
    yield from run("registerscans", {"TARGETS": lists, **control, "TRANSFORMS": transforms}, "registerscans")
    registered = FOLDER / "registered"
    moved = {"INPUT": scans, "TRANSFORMS": transforms, "OUTPUT_FOLDER": str(registered)}
    yield from run("transformcloud", moved, "transformcloud")
    QgsProject.instance().clear()
    yield from run("siteplan", {"INPUT": [str(registered)]}, "siteplan")
    walls, rooms = (QgsProject.instance().mapLayersByName(name)[0].id() for name in ("Walls", "Rooms"))
    sheet = {"WALLS": walls, "ROOMS": rooms, "SCALE": 100, "PDF": str(FOLDER / "plan.pdf")}
    yield from run("planlayout", sheet, "planlayout")


def look_from_above():
    """Open the files of the plan by hand, and look at them in three dimensions.

    The screen is photographed, because Qt's widgets do not paint the view. It comes last, because QGIS 3.40
    crashes if layers go that a view shows.
    """
    seen["during"] = "walls_3d"
    QgsProject.instance().clear()
    made = next(run["layers"] for run in seen["runs"] if run["name"] == "siteplan")
    for layer in (layer for layer in reversed(made) if layer["features"]):
        walls = iface.addVectorLayer(layer["source"].partition("|")[0], layer["name"], "ogr")
    # The facade before has no reference system, and a new view begins where the map is.
    QgsProject.instance().setCrs(walls.crs())
    iface.zoomFull()
    yield 2000
    iface.mainWindow().findChild(QAction, "mActionNew3DMapCanvas").trigger()
    yield 1000
    docks = iface.mainWindow().findChildren(QDockWidget)
    for dock in docks:
        if "3D" in dock.windowTitle():
            dock.setFloating(True)
    # Newer versions open it in a window of its own.
    windows = [*QApplication.topLevelWidgets(), *docks]
    view = next(window for window in windows if "3D" in window.windowTitle() and window.isVisible())
    view.resize(1100, 800)
    view.move(0, 0)
    view.raise_()
    for _ in range(60):
        yield 1000
        picture = QGuiApplication.primaryScreen().grabWindow(0, 0, 0, 1100, 800)
        seen["clay"] = share_of_clay(picture.toImage())
        if seen["clay"] > 0.02:
            break
    QGuiApplication.primaryScreen().grabWindow(0, 0, 0, 1100, 800).save(str(FOLDER / "walls_3d.png"))


def share_of_clay(image):
    """Return the share of pixels that have the red of lit walls, which the plan below them has not."""
    image = image.scaled(110, 80)
    colours = [QColor(image.pixel(x, y)) for x in range(image.width()) for y in range(image.height())]
    return sum(colour.red() > max(40, 1.8 * colour.blue()) for colour in colours) / len(colours)


def work_with_runs():
    """Write into the same file again, repeat a run, and cancel one."""
    QgsProject.instance().clear()
    walls = {"WALLS": str(FOLDER / "walls.gpkg"), "DENSITY": None, "ROOMS": None, "REPORT": None}
    for number, cloud in enumerate(CLOUDS):
        values = {"INPUT": [cloud], **walls, "STOREY": False, "REFINE": number == 0}
        yield from run("siteplan", values, f"again_{number}")
    yield from run_again()
    yield from run("siteplan", {"INPUT": CLOUDS, "PIXEL_SIZE": 0.02}, "cancelled", cancel=True)


def facade():
    """Draw the facade of the example."""
    QgsProject.instance().clear()
    yield from run("facadedetails", {"INPUT": [str(FOLDER / "house" / "facade.laz")]}, "facade")


def model():
    """Draw the facade of the example by a model, which runs in the background."""
    QgsProject.instance().clear()
    scans = {"SCANS": [str(FOLDER / "house" / "facade.laz")], "facadedetails:Schedule": None}
    yield from run("Facade to drawing", scans, "model")
    seen["history_of_model"] = last_command()


def step(steps):
    """Do the next step, and go on after the pause that it asks for."""
    try:
        pause = next(steps)
    except StopIteration:
        leave()
    except Exception:  # what is wrong must be seen by the test
        seen["errors"].append(traceback.format_exc())
        leave()
    else:
        QTimer.singleShot(pause, lambda: step(steps))


def leave():
    """Write what was seen, and end QGIS at once, because it would ask whether to save the project."""
    seen["left"] = sorted(file.name for file in FOLDER.iterdir())
    (FOLDER / "seen.json").write_text(json.dumps(seen, indent=1), encoding="utf-8")
    os._exit(0)


QTimer.singleShot(3000, lambda: step(tour()))
