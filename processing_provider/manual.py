"""The manual: the pages that are installed with the plugin, as a browser shows them without a network."""

import re
from pathlib import Path

from qgis.core import QgsProcessingUtils
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtGui import QTextDocument

from .desktop import on_desktop

DOCS = Path(__file__).parents[1] / "docs"
ONLINE = "https://github.com/ichnograph/ichnograph/blob/main/docs"
STYLE = (
    "<style>body{max-width:50em;margin:2em auto;font-family:sans-serif!important}td{padding:2px 8px}</style>"
)


def page_url(name: str) -> str:
    """Return the address of a page: on the desktop a file that needs no network, else the page online."""
    if not on_desktop() or not (DOCS / f"{name}.md").is_file():
        return f"{ONLINE}/{name}.md"
    folder = Path(QgsProcessingUtils.tempFolder()) / "ichnograph_manual"
    if not folder.is_dir():
        folder.mkdir(parents=True)
        for page in DOCS.glob("*.md"):
            (folder / f"{page.stem}.html").write_text(_html(page), encoding="utf-8")
    return QUrl.fromLocalFile(str(folder / f"{name}.html")).toString()


def _html(page: Path) -> str:
    """Return a page as HTML, with links to the other pages, and without pictures, which are online only."""
    text = re.sub(r"!\[([^]]*)\]\([^)]*\)", r"*\1*", page.read_text(encoding="utf-8"))
    document = QTextDocument()
    document.setMarkdown(re.sub(r"\]\(([\w-]+)\.md(#[\w-]+)?\)", r"](\1.html\2)", text))
    return document.toHtml().replace("<head>", f'<head><meta charset="utf-8">{STYLE}', 1)
