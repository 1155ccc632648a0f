"""Which scan a cloud is named after."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Optional

LISTS = (".txt", ".csv", ".gpkg", ".shp", ".geojson")
"""Extensions of lists that may lie beside a cloud."""

SEVERAL = (".e57", ".ptx")
"""Extensions of files that may hold several scans, which are numbered."""


def scan_name(cloud: Path) -> str:
    """Return the name of the scan that a cloud without a list is; `.copc.laz` is one extension."""
    return Path(cloud.stem).stem if cloud.stem.lower().endswith(".copc") else cloud.stem


def scan_of_cloud(names: Sequence[str], cloud: Path) -> Optional[int]:
    """Return the number of the scan that a cloud is named after, None if there is none, or more than one.

    Upper and lower case count only if they decide, and `.copc.laz` is one extension.

    Parameters
    ----------
    names : sequence of str
        Of the scans.
    cloud : Path
    """
    stems = [cloud.stem]
    if cloud.stem.lower().endswith(".copc"):
        stems.append(Path(cloud.stem).stem)
    for stem in stems:
        for spelt in (str, str.lower):
            found = [number for number, name in enumerate(names) if spelt(name) == spelt(stem)]
            if len(found) == 1:
                return found[0]
    return None


def has_list(names: Sequence[str], cloud: Path) -> bool:
    """Return whether a list of one of these names is that of a cloud, or of a scan in it."""
    if scan_of_cloud(names, cloud) is not None:
        return True
    numbered = re.compile(rf"{re.escape(cloud.stem)}_\d+", re.IGNORECASE)
    return cloud.suffix.lower() in SEVERAL and any(numbered.fullmatch(name) for name in names)


def lists_beside(clouds: Sequence[str]) -> list[str]:
    """Return the lists in the folder of the clouds that are named after one of them, by name."""
    paths = [Path(cloud) for cloud in clouds]
    files = [path for folder in {path.parent for path in paths} for path in folder.iterdir()]
    lists = [path for path in files if path.suffix.lower() in LISTS and path not in paths]
    found = [path for path in lists if any(has_list([path.stem], cloud) for cloud in paths)]
    return sorted(map(str, found))
