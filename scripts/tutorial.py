"""Run the commands of docs/tutorial.md in a folder, and draw the pictures of that page.

make tutorial, or: python3 -m ichnograph.scripts.tutorial build/tutorial docs/pictures
"""

import argparse
import os
import subprocess
from pathlib import Path

from osgeo import gdal

from .house import ROOT

PAGE = ROOT / "docs" / "tutorial.md"
SHEETS = ("plan", "elevation")
DPI = 80
INDENT = "    "


def commands(page: str) -> str:
    """Return the indented lines of a page, which are a script."""
    return "\n".join(line[len(INDENT) :] for line in page.splitlines() if line.startswith(INDENT))


def run(folder: Path) -> None:
    """Run the commands of the tutorial in an empty folder, with the `qgis_process` of this checkout."""
    folder.mkdir(parents=True)
    environment = {**os.environ, "PATH": f"{ROOT / 'scripts'}{os.pathsep}{os.environ['PATH']}"}
    script = commands(PAGE.read_text(encoding="utf-8"))
    subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=folder, env=environment, check=True)


def draw(folder: Path, pictures: Path) -> None:
    """Write the printed sheets as pictures."""
    gdal.UseExceptions()
    gdal.SetConfigOption("GDAL_PDF_DPI", str(DPI))
    gdal.SetConfigOption("GDAL_PAM_ENABLED", "NO")
    for name in SHEETS:
        gdal.Translate(str(pictures / f"tutorial_{name}.png"), str(folder / f"{name}.pdf"), format="PNG")


def main() -> None:
    """Run the tutorial and draw its pictures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path, help="a folder that does not exist yet")
    parser.add_argument("pictures", type=Path)
    arguments = parser.parse_args()
    run(arguments.folder)
    draw(arguments.folder, arguments.pictures)


if __name__ == "__main__":
    main()
