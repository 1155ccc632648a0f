"""The language of QGIS, into which every text that leaves the provider is translated.

The core formats English sentences and does not know of languages. The catalogues are of Qt:
`translations/ichnograph_de.ts` is what translators edit, and lists the patterns of the sentences;
`ichnograph_de.qm` is compiled from it.
"""

import html
import re
from functools import cache
from pathlib import Path
from typing import Optional

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QTranslator
from qgis.PyQt.QtXml import QDomDocument

from .catalogue import WORD, Catalogue

TRANSLATIONS = Path(__file__).parent / "translations"

CONTEXT = "Ichnograph"
"""Of all messages of the catalogues."""

TAG = re.compile(r"(<style.*?</style>|<[^>]*>)", re.DOTALL)

ALT = re.compile(r'(?<= alt=")[^"]+')


def translated(text: str) -> str:
    """Return a text in the language of QGIS, or as it is where the catalogue does not know it."""
    catalogue = catalogue_of(language())
    return catalogue.translate(text) if catalogue else text


def translated_page(page: str) -> str:
    """Return an HTML page with its texts in the language of QGIS; all else is as it was."""
    catalogue = catalogue_of(language())
    if not catalogue:
        return page
    parts = TAG.split(page)
    for place, part in enumerate(parts):
        if place % 2:
            parts[place] = ALT.sub(lambda found: _escaped(found[0], catalogue), part)
        elif WORD.search(part):
            parts[place] = _escaped(part, catalogue)
    return "".join(parts).replace('<html lang="en">', f'<html lang="{language()}">', 1)


def language() -> str:
    """Return the language that QGIS shows, as two letters."""
    # The desktop knows it, which --lang may have chosen; headless, the settings or the system say it.
    chosen = QgsApplication.instance().translation() or QgsApplication.locale()
    return str(chosen)[:2].lower()


@cache
def catalogue_of(name: str) -> Optional[Catalogue]:
    """Return the catalogue of a language; None of English, and of a language without one."""
    path = TRANSLATIONS / f"ichnograph_{name}.ts"
    if not path.is_file():
        return None
    compiled = QTranslator()
    compiled.load(str(path.with_suffix(".qm")))
    document = QDomDocument()
    document.setContent(path.read_text(encoding="utf-8"))
    elements = document.elementsByTagName("source")
    sources = [elements.at(number).toElement().text() for number in range(elements.count())]
    return Catalogue({source: compiled.translate(CONTEXT, source.encode()) or source for source in sources})


def _escaped(text: str, catalogue: Catalogue) -> str:
    """Return a text between tags in the other language, with one blank for all white space."""
    before, after = (" " if text[end].isspace() else "" for end in (0, -1))
    inner = " ".join(html.unescape(text).split())
    return f"{before}{html.escape(catalogue.translate(inner), quote=False)}{after}"
