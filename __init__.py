"""Ichnograph: terrestrial laser scans of buildings and sites as GIS layers."""

from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from qgis.gui import QgisInterface

    from .plugin import Plugin


def classFactory(iface: Optional["QgisInterface"]) -> "Plugin":  # noqa: N802 - QGIS's name
    """Return the plugin object; QGIS calls this when it loads the plugin."""
    from .plugin import Plugin

    return Plugin(iface)
