"""The menu of the desktop."""

import pytest
from ichnograph.processing_provider.menu import DIALOGS, Menu


class Interface:
    """The part of QGIS's interface that a menu uses."""

    def __init__(self):
        self.menus = {}

    def mainWindow(self):  # noqa: N802 - QGIS's name
        return None

    def addPluginToMenu(self, menu, action):  # noqa: N802 - QGIS's name
        self.menus.setdefault(menu, []).append(action)

    def removePluginMenu(self, menu, action):  # noqa: N802 - QGIS's name
        self.menus[menu].remove(action)


@pytest.fixture
def interface(plugin):
    return Interface()


def test_it_opens_dialogs_and_the_manual(interface, provider):
    Menu(interface).show()

    texts = [action.text() for action in interface.menus["Ichnograph"]]
    assert texts[-1] == "Manual"
    assert set(DIALOGS.values()) < set(texts)
    assert all(provider.algorithm(key) for key in DIALOGS)
    assert not any(action.icon().isNull() for action in interface.menus["Ichnograph"])


def test_it_leaves_with_the_plugin(interface):
    menu = Menu(interface)
    menu.show()
    menu.remove()

    assert interface.menus["Ichnograph"] == []


def test_a_desktop_shows_it(interface, qgis_application):
    import ichnograph

    plugin = ichnograph.classFactory(interface)
    plugin._menu.show()
    assert interface.menus["Ichnograph"]
