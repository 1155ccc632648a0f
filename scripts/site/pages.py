"""Write the pages of the documentation as a site: those of the repository, and what the dialogs say.

python3 -m ichnograph.scripts.site.pages build/site/pages

The page of an algorithm gets the picture of its dialog, and a table of its parameters and outputs from the
provider. Sphinx makes the site of them, and checks every link.
"""

import argparse
import shutil
from collections.abc import Iterable, Sequence
from pathlib import Path

from ichnograph.processing_provider.algorithm import Algorithm
from ichnograph.processing_provider.provider import Provider

from ..dialogs import photograph
from ..house import ROOT
from ..provider import own_algorithms, run_with_provider

PAGES = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "CITATION.cff", "LICENSE")
DIALOGS = "docs/pictures/dialogs"

CONTENTS = {
    "Begin": ("docs/index", "docs/installing", "docs/tutorial", "docs/exampledata", "docs/models"),
    "Registration": (
        "docs/findtargets",
        "docs/registerscans",
        "docs/simulateregistration",
        "docs/transformcloud",
    ),
    "Site plan": (
        "docs/siteplan",
        "docs/thincloud",
        "docs/densityimage",
        "docs/extractwalls",
        "docs/compareplan",
        "docs/planlayout",
    ),
    "Facade": ("docs/facadedetails", "docs/facadeplanes", "docs/comparelengths"),
    "Reference": (
        "docs/method",
        "docs/accuracy",
        "docs/performance",
        "docs/cluster",
        "docs/inputs",
        "docs/robustness",
        "docs/releases",
        "docs/constants",
        "docs/sensitivity",
        "docs/glossary",
    ),
    "Development": ("docs/architecture", "CONTRIBUTING", "CHANGELOG"),
}
"""The pages in the margin of the site; one that is missing here makes Sphinx warn, and fail."""


def write_pages(provider: Provider, folder: Path) -> None:
    """Copy the pages into a folder, and complete those of the algorithms."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "docs", folder / "docs")
    for name in PAGES:
        shutil.copy(ROOT / name, folder / name)
    with (folder / "README.md").open("a", encoding="utf-8") as readme:
        readme.write("".join(_contents(title, pages) for title, pages in CONTENTS.items()))
    photograph(provider, folder / DIALOGS, [])
    for algorithm in own_algorithms(provider):
        page = folder / "docs" / f"{algorithm.name()}.md"
        page.write_text(f"{page.read_text(encoding='utf-8')}\n{dialog_of(algorithm)}", encoding="utf-8")


def dialog_of(algorithm: Algorithm) -> str:
    """Return the section of a page about the dialog of an algorithm, as Markdown."""
    inputs = [(item.name, item.description, item.explanation) for item in algorithm.inputs]
    outputs = [(item.name, item.description, item.explanation) for item in algorithm.destinations]
    numbers = [(name, label, "") for name, label in algorithm.numbers]
    picture = f"![Dialog of {algorithm.displayName()}](pictures/dialogs/{algorithm.name()}.png)"
    parts = ["## In the dialog", picture, _table("parameter", inputs)]
    if outputs or numbers:
        parts.append(_table("output", [*outputs, *numbers]))
    return "\n\n".join(parts) + "\n"


def _contents(title: str, pages: Sequence[str]) -> str:
    lines = "\n".join(pages)
    return f"\n```{{toctree}}\n:hidden:\n:caption: {title}\n\n{lines}\n```\n"


def _table(first: str, rows: Iterable[Sequence[str]]) -> str:
    lines = [f"| {first} | label | what the help says |", "|---|---|---|"]
    lines += [f"| {' | '.join(_cell(text) for text in row)} |" for row in rows]
    return "\n".join(lines)


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ").replace("<", "&lt;")


def main() -> None:
    """Write the pages."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    run_with_provider(lambda provider: write_pages(provider, folder))


if __name__ == "__main__":
    main()
