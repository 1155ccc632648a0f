"""The algorithm `exampledata`."""

import shutil
from functools import partial
from pathlib import Path
from typing import Any

from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.folders import FolderDestination

EXAMPLE = Path(__file__).parents[1] / "example"


class ExampleDataAlgorithm(Algorithm):
    """Copy the example into a folder."""

    key = "exampledata"
    title = "Example data"
    chapter = "Example"
    summary = "Copies simulated scans of a house and of a facade into a folder, to try the toolbox."
    about = (
        "Eight scans of a house (house_01.laz to house_08.laz), each in the frame of its scanner and with "
        "the list of its targets (house_01.txt to house_08.txt); the surveyed control points (control.txt, "
        "EPSG:25833); and a scan of a facade (facade.laz). The manual says what to do with them."
    )
    words = ("example", "sample", "demo", "tutorial", "test data")
    inputs = ()
    destinations = (
        FolderDestination("OUTPUT_FOLDER", "Example", "Folder for 18 files, 3.5 MB.", listing="FILES"),
    )
    numbers = ()
    needs = ()

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Return what copies the files."""
        files = sorted(EXAMPLE.iterdir())
        log.info(f"Files: {', '.join(file.name for file in files)}.")
        return Outcome({"OUTPUT_FOLDER": {file.name: partial(shutil.copyfile, file) for file in files}}, {})
