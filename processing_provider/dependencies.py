"""The packages that the algorithms need, and what to do when one is missing."""

import sys
import sysconfig
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path

PYPI_NAMES = {
    "numpy": "numpy",
    "scipy": "scipy",
    "skimage": "scikit-image",
    "pandas": "pandas",
    "numba": "numba",
    "shapely": "shapely",
    "fiona": "fiona",
    "rasterio": "rasterio",
    "pyproj": "pyproj",
    "laspy": "laspy",
    "lazrs": "lazrs",
}
"""The modules that are imported, and the packages that bring them."""

NOT_IN_DEBIAN = ("laspy", "lazrs", "pye57", "pyquaternion")
"""Packages that come from PyPI also where Debian's or Ubuntu's Python is used."""


def missing_modules() -> list:
    """Return the modules that the interpreter of QGIS cannot find."""
    return lacking(PYPI_NAMES)


def lacking(modules: Iterable) -> list:
    """Return which of `modules` the interpreter of QGIS cannot find."""
    return [module for module in modules if find_spec(module) is None]


def explain_missing(modules: list) -> str:
    """Return one sentence: which packages, for which interpreter, and the command that installs them."""
    packages = [PYPI_NAMES.get(module, module) for module in modules]
    where = " in the OSGeo4W Shell" if sys.platform == "win32" else ""
    return (
        f"The Python {_version()} of QGIS lacks {', '.join(packages)}; run "
        f"`{_install_command(packages)}`{where}, then start QGIS again."
    )


def explain_broken(error: ImportError) -> str:
    """Return one sentence about a package that is there but cannot be imported."""
    return (
        f"A package of the Python {_version()} of QGIS cannot be loaded ({error}); "
        "install a version of it that fits the others."
    )


def _version() -> str:
    return "{}.{}".format(*sys.version_info)


def _install_command(packages: list) -> str:
    if not _is_managed_by_distribution():
        return f"{_interpreter()} -m pip install --user {' '.join(packages)}"
    from_apt = [f"python3-{package.replace('scikit-image', 'skimage')}" for package in packages]
    from_apt = [name for name in from_apt if name[len("python3-") :] not in NOT_IN_DEBIAN]
    from_pip = [package for package in packages if package in NOT_IN_DEBIAN]
    commands = [f"sudo apt install {' '.join(from_apt)}"] if from_apt else []
    if from_pip:
        # No dependencies: the distribution has numpy, and a second one would hide it.
        options = "--user --break-system-packages --no-deps"
        commands.append(f"{_interpreter()} -m pip install {options} {' '.join(from_pip)}")
    return " && ".join(commands)


def _is_managed_by_distribution() -> bool:
    return Path(sysconfig.get_path("stdlib"), "EXTERNALLY-MANAGED").exists()


def _interpreter() -> str:
    """Return the interpreter to type; `sys.executable` may be QGIS itself, or another Python on PATH."""
    if sys.platform == "win32":
        return "python"  # the one that the OSGeo4W Shell finds
    python = Path(sys.base_prefix, "bin", "python3")
    return str(python) if python.exists() else "python3"
