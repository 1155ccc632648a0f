"""How far the sheets of `planlayout` are off on paper: lengths in the PDF against those of a building.

make sheet, or: python3 -m ichnograph.benchmarks.sheet
"""

import tempfile
from pathlib import Path

import numpy as np
from ichnograph.processing_provider.algorithms.plan_layout import SHEETS
from ichnograph.processing_provider.layouts.sheet import SIZES, scale_bar_segment
from ichnograph.processing_provider.provider import Provider
from ichnograph.scripts.provider import run_with_provider
from ichnograph.tests.processing_provider.pdf import size_of
from ichnograph.tests.processing_provider.sheets import error_of_scale_bar, errors_of_outline, write_building

MADE = ((50, "A3"), (100, "A3"), (100, "A4"), (20, "A1"))
"""Scales and papers."""


def print_errors(provider: Provider) -> None:
    """Print the errors of each sheet."""
    import processing

    print("| scale | sheet | paper (mm) | outline (mm) | scale bar (mm) |")
    print("|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        walls, pdf = write_building(Path(folder) / "walls.gpkg"), Path(folder) / "sheet.pdf"
        for scale, paper in MADE:
            sheet = {"WALLS": walls, "SCALE": scale, "SHEET": SHEETS.index(paper), "PDF": str(pdf)}
            processing.run(provider.algorithm("planlayout"), sheet)
            size = np.abs(np.subtract(size_of(pdf), SIZES[paper])).max()
            outline = np.abs(errors_of_outline(pdf, scale)).max()
            bar = abs(error_of_scale_bar(pdf, 1000 * scale_bar_segment(scale) / scale))
            print(f"| 1:{scale} | {paper} | {size:.3f} | {outline:.3f} | {bar:.3f} |")


if __name__ == "__main__":
    run_with_provider(print_errors)
