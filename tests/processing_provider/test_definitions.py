"""Lists of files and of points in history, in dialogs, in batches and in the model designer."""

import pytest

SCANS = ["/scans/a.laz", "/scans/b.e57", "/scans/c.ptx"]


@pytest.fixture
def algorithm(provider):
    def algorithm(key):
        kept.append(provider.algorithm(key).create())
        return kept[-1]

    kept = []
    return algorithm


@pytest.fixture
def context(plugin):
    from qgis.core import QgsProcessingContext

    return QgsProcessingContext()


@pytest.fixture
def field(algorithm, context):
    """Return the wrapper of the widget of a parameter, as its dialog makes it."""
    from processing.gui.wrappers import WidgetWrapperFactory
    from qgis.PyQt import sip
    from qgis.PyQt.QtWidgets import QDialog, QVBoxLayout

    dialog = QDialog()
    layout = QVBoxLayout(dialog)
    kept = []

    def field(key, name):
        wrapper = WidgetWrapperFactory.create_wrapper(algorithm(key).parameterDefinition(name), dialog)
        layout.addWidget(wrapper.widget)
        kept.append(wrapper)
        return wrapper

    yield field
    sip.delete(dialog)


def test_the_file_chooser_offers_clouds_first(algorithm):
    filters = algorithm("siteplan").parameterDefinition("INPUT").createFileFilter()

    first, last = filters.split(";;")
    assert all(f"*.{ending}" in first for ending in ("laz", "las", "e57", "ptx", "xyz"))
    assert last == "All files (*)"


def test_add_directory_takes_the_clouds_of_a_folder(algorithm, tmp_path):
    from qgis.core import QgsFileUtils

    extensions = QgsFileUtils.extensionsFromFilter(
        algorithm("siteplan").parameterDefinition("INPUT").createFileFilter()
    )
    assert {"laz", "e57"} <= set(extensions)


def test_the_history_records_scans_and_targets(algorithm, context):
    command = algorithm("siteplan").asPythonCommand({"INPUT": SCANS}, context)
    assert f"'INPUT':{SCANS!r}" in command

    given = {"CONTROL": "/lists/control.txt", "TARGETS": ["/lists/a.txt", "/lists/b.txt"]}
    command = algorithm("registerscans").asPythonCommand(given, context)
    assert "'CONTROL':'/lists/control.txt'" in command
    assert "'TARGETS':['/lists/a.txt', '/lists/b.txt']" in command


def test_layers_are_recorded_by_their_source(algorithm, context):
    from qgis.core import QgsVectorLayer

    layer = QgsVectorLayer("PointZ?field=name:string", "picked", "memory")
    assert layer.source() in algorithm("registerscans").asPythonCommand({"TARGETS": [layer]}, context)


@pytest.mark.parametrize(
    ("key", "name", "value"),
    [
        ("siteplan", "INPUT", SCANS),
        ("registerscans", "TARGETS", ["/lists/a.txt", "/lists/b.txt"]),
        ("registerscans", "CONTROL", "/lists/control.txt"),
    ],
)
def test_run_again_keeps_the_files(field, context, key, name, value):
    wrapper = field(key, name)
    wrapper.setParameterValue(value, context)

    assert wrapper.parameterValue() == value


def test_an_empty_list_is_no_value(field, context):
    wrapper = field("siteplan", "INPUT")
    wrapper.setParameterValue(SCANS, context)
    wrapper.setParameterValue(None, context)

    assert wrapper.parameterValue() is None


def test_control_points_can_be_a_layer_of_the_project(field, context):
    from qgis.core import QgsProject, QgsVectorLayer

    layer = QgsVectorLayer("PointZ?field=name:string", "surveyed", "memory")
    QgsProject.instance().addMapLayer(layer)
    wrapper = field("registerscans", "CONTROL")
    wrapper.setParameterValue(layer.id(), context)

    assert wrapper.parameterValue() == layer.id()
    QgsProject.instance().clear()


def test_a_text_list_is_not_opened_as_a_layer(algorithm, field, context, tmp_path, capfd):
    path = tmp_path / "control.txt"
    path.write_text("1 2 3\n4 5 6\n7 8 9\n")
    registration = algorithm("registerscans")
    field("registerscans", "CONTROL").setParameterValue(str(path), context)
    definition = registration.parameterDefinition("CONTROL")
    assert definition.checkValueIsAcceptable(str(path), context)
    values = {"CONTROL": str(path), "TARGETS": [str(path), str(path)]}
    registration.asPythonCommand(values, context)
    assert registration.validateInputCrs(values, context)
    if hasattr(registration, "asMap"):  # since QGIS 3.24
        assert registration.asMap(values, context)["inputs"] == values
        command, succeeded = registration.asQgisProcessCommand(values, context)
        assert succeeded and command.count(f"--TARGETS={path}") == 2 and f"--CONTROL={path}" in command

    assert capfd.readouterr() == ("", "")


def test_a_batch_has_a_row_for_each_of_three_scans(algorithm, context):
    from processing.gui.BatchPanel import BatchPanel, BatchPanelFillWidget
    from qgis.gui import QgsMessageBar
    from qgis.PyQt import sip
    from qgis.PyQt.QtWidgets import QDialog

    class Dialog(QDialog):
        def messageBar(self):  # noqa: N802 - QGIS's name
            return bar

    dialog, bar = Dialog(), QgsMessageBar()
    siteplan = algorithm("siteplan")
    panel = BatchPanel(dialog, siteplan)
    column = panel.parameter_to_column["INPUT"]
    fill = BatchPanelFillWidget(siteplan.parameterDefinition("INPUT"), column, panel)
    first = fill.findStartingRow()
    for row, scan in enumerate(SCANS):
        fill.setRowValue(first + row, scan, context)

    assert panel.batchRowCount() == 3
    rows = [panel.wrappers[row][column].parameterValue() for row in range(3)]
    for widget in (fill, panel, bar, dialog):
        sip.delete(widget)
    assert rows == [[scan] for scan in SCANS]


def test_in_the_model_designer_inputs_of_the_model_can_be_chosen(algorithm, context):
    from processing.gui.wrappers import WidgetWrapperFactory
    from qgis.core import QgsProcessingModelAlgorithm
    from qgis.gui import QgsProcessingModelerParameterWidget
    from qgis.PyQt import sip
    from qgis.PyQt.QtWidgets import QDialog

    class ModelerParametersDialog(QDialog):
        pass

    dialog = ModelerParametersDialog()
    dialog.model, dialog.childId, dialog.context = QgsProcessingModelAlgorithm(), "1", context
    definition = algorithm("siteplan").parameterDefinition("INPUT")

    wrapper = WidgetWrapperFactory.create_wrapper(definition, dialog)
    assert isinstance(wrapper, QgsProcessingModelerParameterWidget)
    sip.delete(wrapper)
    sip.delete(dialog)


def test_a_copy_is_like_the_original(algorithm):
    definition = algorithm("siteplan").parameterDefinition("INPUT")
    copy = definition.clone()

    assert type(copy) is type(definition)
    assert (copy.name(), copy.description(), copy.help()) == (
        definition.name(),
        definition.description(),
        definition.help(),
    )
    assert copy.createFileFilter() == definition.createFileFilter()
