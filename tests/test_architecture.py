"""The rules of the house, as docs/architecture.md states them, checked on the text of the code."""

import ast
import re
import subprocess
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest
from ichnograph.algorithms.clouds.formats import readable_formats
from ichnograph.scripts.constants_page import page
from ichnograph.scripts.house import CHAPTERS, PLUGIN, ROOT, SHARED, Module, modules, room_of

LONGEST_FILE = 400
"""Lines; most files fit into 300."""

EVERYWHERE = (*PLUGIN, "benchmarks", "scripts", "tests")

UNTESTED = {
    "algorithms.errors": "declares exceptions",
}
"""Modules without a test file of their name, and why they need none."""


def imports_of_algorithms():
    """Yield the importing module and the imported one, for every import within or out of `algorithms`."""
    for module in modules("algorithms"):
        for item in module.imports():
            yield module, item.module


def is_in(name, package):
    return name == package or name.startswith(f"{package}.")


def test_the_core_never_imports_qgis_or_the_provider():
    wrong = [
        f"{module.path} imports {name}"
        for module, name in imports_of_algorithms()
        if any(is_in(name, package) for package in ("qgis", "processing", "PyQt5", "processing_provider"))
    ]
    assert not wrong, "algorithms must run without QGIS; move this into processing_provider"


def test_the_plugin_imports_nothing_that_is_not_installed_with_it():
    wrong = [
        f"{module.path} imports {item.module}"
        for module in modules()
        for item in module.imports()
        if any(is_in(item.module, folder) for folder in ("tests", "benchmarks", "scripts"))
    ]
    assert not wrong, "tests, benchmarks and scripts are not in the plugin's zip"


def test_the_plugin_imports_itself_by_relative_imports_only():
    absolute = [
        f"{module.path}:{node.lineno}"
        for module in modules()
        for node in ast.walk(module.tree)
        if isinstance(node, ast.ImportFrom)
        and not node.level
        and (node.module or "").split(".")[0] in ("ichnograph", *PLUGIN)
    ]
    assert not absolute, "users may give the plugin's folder another name; import with dots"


def test_no_chapter_imports_another_one():
    wrong = [
        f"{module.path} imports {name}"
        for module, name in imports_of_algorithms()
        if is_in(name, "algorithms") and room_of(name) not in allowed_for(room_of(module.name))
    ]
    assert not wrong, "share code through geometry, reporting, clouds or a module of algorithms"


def allowed_for(room):
    """Return the packages of `algorithms` that a package of it may import, itself included."""
    if room in ("root", "geometry", "tables"):
        return {"root", "geometry", room}
    if room in ("reporting", "clouds"):
        return {"root", "geometry", "tables", room}
    return {"root", *SHARED, "clouds", room}


def test_no_module_imports_itself_through_others():
    every = modules()
    names = {module.name for module in every}
    graph = {
        module.name: {item.module for item in module.imports() if not item.for_types} & names - {module.name}
        for module in every
    }
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(f"these modules import each other in a circle: {' <- '.join(error.args[1])}")


def test_every_package_of_the_core_is_a_chapter_or_shared():
    folders = {path.parent.name for path in (ROOT / "algorithms").glob("*/__init__.py")}

    assert folders == {*CHAPTERS, *SHARED}, "list a new package in scripts/house.py and docs/architecture.md"


def test_every_folder_of_the_plugin_is_a_package_that_says_what_it_is():
    folders = {module.path.parent for module in modules()}
    silent = [
        str(folder)
        for folder in sorted(folders)
        if not (ROOT / folder / "__init__.py").exists()
        or not ast.get_docstring(Module(folder / "__init__.py").tree)
    ]
    assert not silent, "write an __init__.py with a docstring"


def test_every_package_lists_public_names_that_exist():
    wrong = []
    for module in modules():
        if module.is_package:
            _, listing, names = (ast.get_docstring(module.tree) or "").partition("Public names")
            found = re.findall(r"`([\w.]+)`", names)
            wrong += [f"{module.path}: {name}" for name in found if not is_defined(name, module.path.parent)]
            wrong += [] if listing and found else [f"{module.path} lists none"]
    assert not wrong, "correct the public names in the docstrings of these packages"


def is_defined(name, folder):
    """Return whether a dotted name is a module below a folder, or is assigned or defined in one."""
    path = Path(folder, *name.split("."))
    if (ROOT / path).is_dir() or (ROOT / path.with_suffix(".py")).exists():
        return True
    within = path.parent / "__init__.py" if (ROOT / path.parent).is_dir() else path.parent.with_suffix(".py")
    return (ROOT / within).exists() and path.name in Module(within).defined()


def test_every_module_that_computes_has_a_test_file_of_its_name():
    missing = [
        str(test_of(module))
        for module in modules("algorithms")
        if module.computes
        and not module.is_package
        and module.name not in UNTESTED
        and not (ROOT / test_of(module)).exists()
    ]
    assert not missing, "write these tests, or say in UNTESTED why none is needed"


def test_every_module_listed_as_untested_exists():
    assert {*UNTESTED} <= {module.name for module in modules("algorithms")}


def test_of(module):
    return Path("tests", *module.path.parts[:-1], f"test_{module.path.name}")


test_of.__test__ = False


def test_no_file_is_too_long_to_read():
    long = [
        f"{module.path}: {module.lines}" for module in modules(*EVERYWHERE) if module.lines > LONGEST_FILE
    ]

    assert not long, f"divide files of more than {LONGEST_FILE} lines by what they are about"


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


@pytest.fixture
def version():
    """Return the version in metadata.txt, which QGIS reads."""
    return re.search(r"(?m)^version=(.+)$", text_of("metadata.txt"))[1]


@pytest.mark.parametrize(
    ("name", "pattern"),
    [
        ("pyproject.toml", r'(?m)^version = "(.+)"$'),
        ("CITATION.cff", r"(?m)^version: (.+)$"),
        ("CHANGELOG.md", r"(?m)^## \[(.+?)\]"),
        ("metadata.txt", r"(?m)^changelog=\n +(.+)$"),
    ],
)
def test_the_version_is_that_of_the_metadata(version, name, pattern):
    found = re.search(pattern, text_of(name))

    assert found, f"{name} has no version"
    assert found[1] == version, f"correct the version in {name}; metadata.txt has {version}"


def test_pyproject_lists_every_package_of_the_core():
    listed = re.search(r"(?ms)^packages = \[(.*?)^\]", text_of("pyproject.toml"))[1]
    folders = [module.name for module in modules("algorithms") if module.is_package]

    expected = ["ichnograph", *sorted(f"ichnograph.{name}" for name in folders)]
    assert re.findall(r'"(.+?)"', listed) == expected, "correct `packages` in pyproject.toml"


def test_pyproject_packs_every_file_that_is_not_python():
    patterns = re.search(r'(?m)^"\*" = \[(.*?)\]', text_of("pyproject.toml"))[1]
    others = [
        path.relative_to(ROOT)
        for path in (ROOT / "algorithms").rglob("*.*")
        if path.suffix != ".py" and "__pycache__" not in path.parts
    ]

    missing = [str(path) for path in others if not any(map(path.match, re.findall(r'"(.+?)"', patterns)))]
    assert not missing, "add these to package-data in pyproject.toml"


@pytest.mark.parametrize("name", ["README.md", "docs/siteplan.md", "metadata.txt", "CHANGELOG.md"])
def test_the_readable_formats_are_those_of_the_code(name):
    words = " ".join(text_of(name).split())

    assert readable_formats() in words, f"list the formats in {name} as `FORMATS` does"


def test_the_page_of_constants_is_that_of_the_settings():
    assert page() == text_of("docs/constants.md"), "run `make constants`"


PAGES = sorted(
    path.relative_to(ROOT)
    for path in (*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob(".github/**/*.md"))
)


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_every_link_of_a_page_leads_somewhere(page):
    targets = re.findall(r"\]\(([^)\s]+)\)", text_of(page))
    broken = [target for target in targets if "://" not in target and not leads_somewhere(page, target)]

    assert not broken, f"{page} has broken links"


def leads_somewhere(page, target):
    name, _, anchor = target.partition("#")
    path = (ROOT / page).parent / name if name else ROOT / page
    return path.exists() and (not anchor or anchor in anchors(path))


def anchors(path):
    """Return the anchors that GitHub gives to the headings of a page."""
    headings = re.findall(r"(?m)^#+ (.+)$", path.read_text(encoding="utf-8"))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_every_file_that_a_page_names_exists(page):
    named = re.findall(
        r"`((?:algorithms|processing_provider|tests|benchmarks|scripts)/[\w/.]+)`", text_of(page)
    )
    missing = [name for name in named if not (ROOT / name.rstrip("/.")).exists()]

    assert not missing, f"{page} names files that do not exist"


def test_every_page_can_be_reached_from_the_index():
    index = text_of("docs/index.md")
    pages = {path.name for path in (ROOT / "docs").glob("*.md")} - {"index.md"}

    assert {name for name in pages if f"]({name}" not in index} == set(), "link these pages in docs/index.md"


def test_the_zip_of_the_plugin_holds_nothing_of_the_workshop():
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False
    ).stdout.split("\0")
    if not any(listed):
        pytest.skip("not a git checkout")
    attributes = subprocess.run(
        ["git", "check-attr", "-z", "--stdin", "export-ignore"],
        cwd=ROOT, input="\0".join(folder for name in listed for folder in (name, name.split("/")[0])),
        capture_output=True, text=True, check=True,
    ).stdout.split("\0")  # fmt: skip
    ignored = {path for path, _, state in zip(*[iter(attributes)] * 3) if state == "set"}
    packed = {name for name in listed if name and not {name, name.split("/")[0]} & ignored}

    assert {name.split("/")[0] for name in packed} == {
        *PLUGIN, "__init__.py", "plugin.py", "metadata.txt", "requirements.txt", "docs",
        "README.md", "CHANGELOG.md", "CITATION.cff", "CONTRIBUTING.md", "LICENSE",
    }, "list the others in .gitattributes with export-ignore"  # fmt: skip
