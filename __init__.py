"""Ichnograph: terrestrial laser scans of buildings and sites as GIS layers."""


def classFactory(iface):  # noqa: N802 - the name QGIS looks for
    """Return the plugin object; QGIS calls this when it loads the plugin."""
    from .plugin import Plugin

    return Plugin(iface)
