"""Photograph the dialogs of the algorithms, without a screen.

python3 -m ichnograph.scripts.dialogs build/dialogs [siteplan facadedetails]
"""

import argparse
from pathlib import Path

from ichnograph.processing_provider.provider import Provider
from qgis.core import QgsApplication

from .provider import own_algorithms, run_with_provider

SIZE = (1150, 900)
"""Pixels; about as a desktop opens it."""


def photograph(provider: Provider, folder: Path, names: list[str]) -> None:
    """Save the dialog of each algorithm, of all that are not models if no names are given."""
    from processing.gui.AlgorithmDialog import AlgorithmDialog

    folder.mkdir(parents=True, exist_ok=True)
    for algorithm in own_algorithms(provider):
        if names and algorithm.name() not in names:
            continue
        dialog = AlgorithmDialog(algorithm.create(), False, None)
        dialog.resize(*SIZE)
        dialog.show()
        QgsApplication.processEvents()
        dialog.grab().save(str(folder / f"{algorithm.name()}.png"))
        dialog.hide()


def main() -> None:
    """Save the pictures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="*", help="of algorithms")
    arguments = parser.parse_args()
    run_with_provider(lambda provider: photograph(provider, arguments.folder, arguments.names))


if __name__ == "__main__":
    main()
