"""Reading the imports of modules, on which the tests of the architecture rest."""

import pytest
from ichnograph.scripts import house
from ichnograph.scripts.house import Module, modules, room_of


@pytest.fixture
def module(tmp_path, monkeypatch):
    """Return a function that writes a module of `algorithms.facade` and reads it."""
    monkeypatch.setattr(house, "ROOT", tmp_path)
    folder = tmp_path / "algorithms" / "facade"
    (folder / "planes").mkdir(parents=True)
    for path in (folder / "__init__.py", folder / "planes" / "__init__.py", folder / "planes" / "voxels.py"):
        path.touch()

    def module(text):
        (folder / "wall.py").write_text(text)
        return Module((folder / "wall.py").relative_to(tmp_path))

    return module


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("import numpy as np", "numpy"),
        ("from qgis.core import QgsProject", "qgis.core"),
        ("from .planes.voxels import gather", "algorithms.facade.planes.voxels"),
        ("from .planes import voxels", "algorithms.facade.planes.voxels"),
        ("from . import planes", "algorithms.facade.planes"),
        ("from ..errors import InputError", "algorithms.errors"),
        ("from ...processing_provider.log import Log", "processing_provider.log"),
        ("import ichnograph.algorithms.facade.planes", "algorithms.facade.planes"),
        ("def f():\n    from .planes.voxels import gather", "algorithms.facade.planes.voxels"),
    ],
)
def test_an_import_is_named_from_the_root(module, text, name):
    (found,) = module(text).imports()

    assert (found.module, found.for_types) == (name, False)


def test_imports_for_type_checkers_are_marked(module):
    text = "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from .planes.voxels import Voxels\n"
    found = {item.module: item.for_types for item in module(text).imports()}

    assert found == {"typing": False, "algorithms.facade.planes.voxels": True}


@pytest.mark.parametrize(
    ("text", "computes"),
    [
        ("LARGEST = 3", False),
        ("class A:\n    def __init__(self):\n        pass", False),
        ("class A:\n    @property\n    def area(self):\n        return 1", False),
        ("class A:\n    def area(self):\n        return 1", True),
        ("def area():\n    return 1", True),
    ],
)
def test_functions_and_methods_compute_properties_do_not(module, text, computes):
    assert module(text).computes is computes


def test_the_room_of_a_module_is_its_package_in_the_core():
    assert room_of("algorithms.facade.planes.voxels") == "facade"
    assert room_of("algorithms.facade") == "facade"
    assert room_of("algorithms.errors") == "root"


def test_all_modules_of_the_plugin_are_read():
    names = {module.name for module in modules()}

    assert {"algorithms.errors", "algorithms.facade", "processing_provider.provider"} <= names
    assert not any(name.startswith("tests") for name in names)
