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
"""The modules that are imported, and the packages that contain them."""

FOR_TABLES = ("numpy", "pandas", "rasterio", "pyproj")
"""The modules that tables of lengths need."""

FOR_LAYERS = ("numpy", "scipy", "shapely", "fiona", "rasterio", "pyproj")
"""The modules that layers of points and outlines need."""

FOR_CLOUDS = ("numpy", "scipy", "pandas", "numba", "rasterio", "pyproj", "laspy", "lazrs")
"""The modules that clouds need."""

FOR_WALLS = (*FOR_LAYERS, "numba", "skimage")
"""The modules that walls need."""

ALL = tuple(PYPI_NAMES)

NOT_IN_DEBIAN = ("laspy", "lazrs", "pye57", "pyquaternion")
"""Packages that must come from PyPI on Debian and Ubuntu too."""


WITH_QGIS = ("rasterio", "fiona", "pyproj", "shapely")
"""Packages whose wheels bring another GDAL, PROJ or GEOS than that of QGIS."""


def lacking(modules: Iterable[str]) -> list[str]:
    """Return which of `modules` the interpreter of QGIS cannot find."""
    return [module for module in modules if find_spec(module) is None]


def explain_missing(modules: Iterable[str]) -> str:
    """Return one sentence: which packages are missing from which Python, and how to install them."""
    packages = [PYPI_NAMES.get(module, module) for module in modules]
    return (
        f"The Python {_version()} of QGIS lacks {', '.join(packages)}; {_how_to_install(packages)}, "
        "then start QGIS again."
    )


def explain_broken(error: ImportError) -> str:
    """Return one sentence about a package that is installed but cannot be imported."""
    return (
        f"A package of the Python {_version()} of QGIS cannot be loaded ({error}); "
        "install a version of it that fits the others."
    )


def _version() -> str:
    return "{}.{}".format(*sys.version_info)


def _how_to_install(packages: list[str]) -> str:
    if _is_managed_by_distribution():
        return f"run `{_command_of_debian(packages)}`"
    from_pip = [package for package in packages if package not in WITH_QGIS]
    others = [package for package in packages if package in WITH_QGIS]
    on_windows = sys.platform == "win32"
    steps = []
    if from_pip:
        where = " in the OSGeo4W Shell" if on_windows else ""
        steps.append(f"run `{_interpreter()} -m pip install --user {' '.join(from_pip)}`{where}")
    if others and on_windows:
        steps.append(f"add {', '.join(f'python3-{name}' for name in others)} with the OSGeo4W installer")
    elif others:
        steps.append(f"install {', '.join(others)} from the source of QGIS, not by pip")
    return ", ".join(steps)


def _command_of_debian(packages: list[str]) -> str:
    from_apt = [f"python3-{package.replace('scikit-image', 'skimage')}" for package in packages]
    from_apt = [name for name in from_apt if name[len("python3-") :] not in NOT_IN_DEBIAN]
    from_pip = [package for package in packages if package in NOT_IN_DEBIAN]
    commands = [f"sudo apt install {' '.join(from_apt)}"] if from_apt else []
    if from_pip:
        # Without dependencies, because a second numpy would hide that of the distribution.
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
