"""Packages that are missing: everything is listed, and running says what to install."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest
from ichnograph.processing_provider import dependencies

VERSION = "{}.{}".format(*sys.version_info)


@pytest.fixture
def without(monkeypatch):
    def without(*modules, managed):
        for module in modules:
            monkeypatch.setitem(sys.modules, module, None)
        monkeypatch.setattr(dependencies, "_is_managed_by_distribution", lambda: managed)
        return dependencies.explain_missing(dependencies.lacking(dependencies.ALL))

    return without


def test_the_sentence_names_package_interpreter_and_command(without):
    sentence = without("laspy", "skimage", managed=False)

    assert sentence.startswith(f"The Python {VERSION} of QGIS lacks scikit-image, laspy; run `")
    assert "python3 -m pip install --user scikit-image laspy`" in sentence


def test_what_contains_gdal_or_proj_never_comes_from_pip(without, monkeypatch):
    assert "; install pyproj from the source of QGIS, not by pip, then" in without("pyproj", managed=False)
    sentence = without("rasterio", "laspy", managed=False)
    assert "pip install --user laspy`, install rasterio, pyproj from" in sentence

    monkeypatch.setattr(sys, "platform", "win32")
    sentence = without(managed=False)
    assert "`python -m pip install --user laspy` in the OSGeo4W Shell, add python3-rasterio," in sentence
    assert "python3-pyproj with the OSGeo4W installer, then start QGIS again." in sentence


def test_on_debian_the_distribution_comes_first(without):
    sentence = without("skimage", "lazrs", managed=True)

    assert "`sudo apt install python3-skimage && " in sentence
    assert "pip install --user --break-system-packages --no-deps lazrs`" in sentence


def test_a_desktop_is_warned_before_it_runs(provider, without):
    algorithm = provider.algorithm("siteplan").create()

    assert algorithm.canExecute() == (True, "")
    sentence = without("numba", managed=True)
    assert algorithm.canExecute() == (False, sentence)


def test_a_missing_package_disables_only_what_needs_it(provider, without):
    without("laspy", "numba", managed=True)

    disabled = {item.name() for item in _algorithms(provider) if not item.create().canExecute()[0]}
    assert disabled == {
        "siteplan",
        "densityimage",
        "extractwalls",
        "findtargets",
        "thincloud",
        "transformcloud",
        "facadedetails",
        "facadeplanes",
    }


def _algorithms(provider):
    """Return the algorithms without the models, which consist of them."""
    return [item for item in provider.algorithms() if item.group() != "Models"]


IMPORTED = """
import importlib, json, sys
for name in {blocked!r}:
    sys.modules[name] = None
for name in {modules!r}:
    importlib.import_module(name)
"""


def test_an_algorithm_imports_nothing_but_what_it_needs(provider):
    for algorithm in _algorithms(provider):
        blocked = [name for name in dependencies.ALL if name not in algorithm.needs]
        code = IMPORTED.format(blocked=blocked, modules=_core_of(type(algorithm)))
        done = subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True)
        assert done.returncode == 0, f"{algorithm.name()}: {done.stderr}"


def _core_of(algorithm):
    """Return the modules of the core that an algorithm and its parameters import when it runs."""
    todo, done, core = [algorithm.__module__], set(), set()
    while todo:
        module = todo.pop()
        done.add(module)
        source = Path(sys.modules[module].__file__).read_text(encoding="utf-8")
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.ImportFrom) and node.level:
                parent = ".".join(module.split(".")[: -node.level])
                name = f"{parent}.{node.module}"
                if name.startswith("ichnograph.algorithms") and "report" not in name:
                    core.add(name)
                elif ".parameters." in name and name not in done:
                    todo.append(name)
    return sorted(core)


def test_values_that_packages_read_are_refused_without_them(provider, without, monkeypatch):
    from qgis.core import QgsProcessingContext

    monkeypatch.delitem(sys.modules, "ichnograph.algorithms.evaluation.outlines", raising=False)
    sentence = without("rasterio", "rasterio.crs", managed=True)
    layer = "Polygon?field=id:integer"
    algorithm = provider.algorithm("compareplan").create()
    given = {"WALLS": _memory(layer), "REFERENCE": _memory(layer)}
    assert algorithm.checkParameterValues(given, QgsProcessingContext()) == (False, sentence)


def _memory(definition):
    from qgis.core import QgsVectorLayer

    return QgsVectorLayer(definition, "walls", "memory")


def test_a_script_is_refused_when_it_runs(run, room, without, tmp_path):
    from qgis.core import QgsProcessingException

    sentence = without("lazrs", managed=True)
    with pytest.raises(QgsProcessingException) as caught:
        run("thincloud", INPUT=room, OUTPUT=str(tmp_path / "thin.las"))
    assert str(caught.value) == sentence


def test_without_pye57_only_e57_files_are_refused_with_the_remedy(run, room, monkeypatch, tmp_path):
    from qgis.core import QgsProcessingException

    for module in ("pye57", "pyquaternion"):
        monkeypatch.setitem(sys.modules, module, None)
    monkeypatch.setattr(dependencies, "_is_managed_by_distribution", lambda: True)
    run("thincloud", INPUT=room, SPACING=1, OUTPUT=str(tmp_path / "thin.las"))
    scan = tmp_path / "scan.e57"
    scan.write_bytes(b"ASTM-E57")
    with pytest.raises(QgsProcessingException) as caught:
        run("thincloud", INPUT=str(scan), OUTPUT=str(tmp_path / "thin.las"))
    sentence = str(caught.value)
    assert sentence.startswith(
        f"{scan} cannot be read: The Python {VERSION} of QGIS lacks pye57, pyquaternion; run `"
    )
    assert "pip install --user --break-system-packages --no-deps pye57 pyquaternion`" in sentence
    assert "apt" not in sentence


def test_a_package_that_is_installed_but_broken_is_reported(run, monkeypatch, room, tmp_path):
    from qgis.core import QgsProcessingException

    monkeypatch.setitem(sys.modules, "ichnograph.algorithms.clouds.thinning.thinning", None)
    with pytest.raises(QgsProcessingException, match=f"Python {VERSION} of QGIS cannot be loaded"):
        run("thincloud", INPUT=room, OUTPUT=str(tmp_path / "thin.las"))


REPORTING = ("jinja2", "matplotlib")


@pytest.fixture
def lengths(tmp_path):
    """Write a schedule and a reference; return parameters of comparelengths."""
    given = {"SCHEDULE": "id,width,height,sill\n1,1.2,1.5,0.9\n", "REFERENCE": "id,width\n1,1.19\n"}
    for name, content in given.items():
        (tmp_path / f"{name}.csv").write_text(content)
    return {**{name: str(tmp_path / f"{name}.csv") for name in given}, "TABLE": str(tmp_path / "table.csv")}


def test_without_the_packages_of_reports_only_the_report_is_refused(
    run, lengths, without, tmp_path, monkeypatch
):
    from qgis.core import QgsProcessingException

    for name in [name for name in sys.modules if name.startswith("ichnograph.algorithms.reporting.")]:
        monkeypatch.delitem(sys.modules, name)
    for module in ("lengths_report", "plan_report"):
        monkeypatch.delitem(sys.modules, f"ichnograph.algorithms.evaluation.{module}", raising=False)
    without(*REPORTING, managed=True)
    assert run("comparelengths", **lengths, REPORT=None)["COUNT"] == 1
    with pytest.raises(QgsProcessingException) as caught:
        run("comparelengths", **lengths, REPORT=str(tmp_path / "report.html"))
    assert str(caught.value).startswith(
        f"Report of the lengths (REPORT) cannot be written: The Python {VERSION} of QGIS lacks jinja2, "
        "matplotlib; run `"
    )
    assert "sudo apt install python3-jinja2 python3-matplotlib`" in str(caught.value)


@pytest.mark.parametrize(
    "key", ["registerscans", "simulateregistration", "siteplan", "compareplan", "comparelengths"]
)
def test_a_report_is_not_made_by_default_without_its_packages(provider, without, key):
    def by_default():
        algorithm = provider.algorithm(key).create()
        return algorithm.parameterDefinition("REPORT").createByDefault()

    usual = by_default()
    without("matplotlib", managed=True)
    assert (usual, by_default()) == (True, False)
