"""Draw the packages of the plugin, the rooms in them, and the imports between them, as they are in the code.

make house-picture, or: python3 -m ichnograph.scripts.house_picture docs/pictures/house.svg
"""

import argparse
import textwrap
from collections import Counter
from pathlib import Path

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyBboxPatch

from .house import ROOT, modules, room_of

PROVIDER = "processing_provider"
ROOT_MODULES = "root"

GUTTER = 3.1
"""Between the first two chapters; the imports of clouds by the provider pass through it."""

BOXES = {
    PROVIDER: (0.0, 8.2, 16.0, 1.1, "#dfe7f1"),
    "targets": (0.0, 4.6, 2.9, 2.8, "#e9efe0"),
    "registration": (3.3, 4.6, 2.9, 2.8, "#e9efe0"),
    "site_plan": (6.6, 4.6, 2.9, 2.8, "#e9efe0"),
    "facade": (9.9, 4.6, 2.9, 2.8, "#e9efe0"),
    "evaluation": (13.2, 4.6, 2.8, 2.8, "#e9efe0"),
    "clouds": (0.0, 2.0, 5.0, 1.5, "#f3ecdc"),
    "geometry": (5.5, 2.0, 5.0, 1.5, "#f3ecdc"),
    "reporting": (11.0, 2.0, 5.0, 1.5, "#f3ecdc"),
    ROOT_MODULES: (0.0, 0.6, 16.0, 1.0, "#f1e3e0"),
}
"""Left, bottom, width, height and colour of each package."""

TITLES = {
    PROVIDER: "processing_provider: parameters, files, styles; it computes nothing",
    "clouds": "clouds: files to points and back",
    "geometry": "geometry: curves, polygons, robust fits",
    "reporting": "reporting: pages and figures",
    ROOT_MODULES: "modules of algorithms, which all may import",
}

WIDTH = 0.1
"""Of a letter, about; names are wrapped by it in wide boxes."""


def draw(out: Path) -> None:
    """Write the picture."""
    # The same code gives the same file.
    matplotlib.rcParams.update({"svg.hashsalt": "ichnograph", "svg.fonttype": "none", "font.size": 9})
    figure = Figure(figsize=(11, 6.5), layout="constrained")
    axes = figure.add_subplot()
    for package, (left, bottom, width, height, colour) in BOXES.items():
        shape = "round,pad=0,rounding_size=0.12"
        axes.add_patch(
            FancyBboxPatch((left, bottom), width, height, shape, fc=colour, ec="#555555", zorder=2)
        )
        title = TITLES.get(package, package)
        axes.text(left + 0.15, bottom + height - 0.12, title, va="top", weight="bold", zorder=3)
        axes.text(left + 0.15, bottom + height - 0.47, "\n".join(_content(package)), va="top", zorder=3)
    for (importer, imported), count in sorted(imports().items()):
        _arrow(axes, importer, imported, count)
    axes.text(0.0, 0.4, "Arrows point to what a package imports; numbers count the imports.", va="top")
    axes.set(xlim=(-0.1, 16.1), ylim=(0.1, 9.4))
    axes.axis("off")
    figure.savefig(out, metadata={"Date": None})


def imports() -> Counter[tuple[str, str]]:
    """Return the number of imports between packages."""
    found: Counter[tuple[str, str]] = Counter()
    for module in modules():
        importer = _package(module.name)
        for item in module.imports():
            imported = _package(item.module)
            if imported in BOXES and imported not in (importer, ROOT_MODULES) and not item.for_types:
                found[importer, imported] += 1
    return found


def _package(name: str) -> str:
    first = name.split(".")[0]
    return room_of(name) if first == "algorithms" else first


def _content(package: str) -> list[str]:
    """Return the rooms of a package with the numbers of their modules, and its own modules."""
    folder = {PROVIDER: Path(PROVIDER), ROOT_MODULES: Path("algorithms")}.get(
        package, Path("algorithms", package)
    )
    rooms = [] if package == ROOT_MODULES else sorted((ROOT / folder).glob("*/__init__.py"))
    names = [f"{path.parent.name}/ {_size(path.parent)}" for path in rooms]
    names += [path.stem for path in sorted((ROOT / folder).glob("*.py")) if path.stem != "__init__"]
    width = BOXES[package][2]
    return names if width < 5 else textwrap.wrap(", ".join(names), int(width / WIDTH))


def _size(folder: Path) -> int:
    return sum(not module.is_package for module in modules(str(folder.relative_to(ROOT))))


def _arrow(axes: Axes, importer: str, imported: str, count: int) -> None:
    left, bottom, width, height, _ = BOXES[importer]
    to_left, to_bottom, to_width, to_height, _ = BOXES[imported]
    if bottom == to_bottom:
        start, end = (left + width, bottom + height / 2), (to_left, to_bottom + to_height / 2)
    elif importer == PROVIDER and imported == "clouds":
        start, end = (GUTTER, bottom), (GUTTER, to_bottom + to_height)
    elif importer == PROVIDER:
        middle = to_left + to_width / 2
        start, end = (middle, bottom), (middle, to_bottom + to_height)
    else:
        # Arrows leave and arrive beside each other, in the order of the boxes.
        order = list(BOXES)
        leave, arrive = (order.index(name) / len(order) for name in (imported, importer))
        start, end = (left + width * leave, bottom), (to_left + to_width * arrive, to_bottom + to_height)
    style = {"arrowstyle": "-|>", "color": "#7a7a7a", "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", end, start, arrowprops=style, zorder=1)
    near = [0.86 * a + 0.14 * b for a, b in zip(start, end)]
    axes.text(*near, str(count), fontsize=7, color="#555555", ha="center", va="center", zorder=4)


def main() -> None:
    """Read the name of the file."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=Path)
    draw(parser.parse_args().out)


if __name__ == "__main__":
    main()
