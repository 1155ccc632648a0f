"""Bring the catalogues of all languages up to date with the texts of the source, and compile them.

make translations, or: python3 -m ichnograph.scripts.translations

New texts come in as unfinished, to be translated in the .ts files by hand or with Qt Linguist; then run it
again. It lists what is missing, and fails if anything is.
"""

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from html import escape
from pathlib import Path
from xml.etree import ElementTree

from ichnograph.processing_provider.language import CONTEXT, TRANSLATIONS
from ichnograph.scripts.texts import texts

LANGUAGES = ("de", "fr")

QT5 = "/usr/lib/qt5/bin"
"""Where Debian keeps the tools of Qt, besides PATH."""


def main() -> int:
    """Update and compile all catalogues; return how many translations are missing."""
    sources, missing = texts(), 0
    for language in LANGUAGES:
        path = TRANSLATIONS / f"ichnograph_{language}.ts"
        present = read(path)
        translations = {source: present.get(source, "") for source in sources}
        path.write_text(_catalogue(language, sources, translations), encoding="utf-8")
        compile_catalogue(path)
        for source, translation in translations.items():
            if not translation:
                missing += 1
                print(f"{language} lacks: {source}    ({', '.join(sources[source])})")
    print(f"{len(sources)} texts, {missing} translations are missing.")
    return missing


def read(path: Path) -> dict[str, str]:
    """Return the translations of a .ts file by their source, "" where one is unfinished."""
    if not path.is_file():
        return {}
    messages = ElementTree.parse(path).iter("message")
    return {item.findtext("source", ""): item.findtext("translation", "") for item in messages}


def compile_catalogue(path: Path) -> None:
    """Write the .qm file beside a .ts file."""
    tool = shutil.which("lrelease", path=os.pathsep.join([QT5, os.environ["PATH"]]))
    if tool is None:
        sys.exit("lrelease is missing; install qttools5-dev-tools.")
    subprocess.run([tool, "-silent", str(path)], check=True)


def _catalogue(language: str, sources: Mapping[str, list[str]], translations: Mapping[str, str]) -> str:
    messages = [
        "".join(
            [
                "    <message>\n",
                *(f'        <location filename="../../{place}"/>\n' for place in sources[source]),
                f"        <source>{escape(source)}</source>\n",
                f"        <translation>{escape(text)}</translation>\n"
                if text
                else '        <translation type="unfinished"></translation>\n',
                "    </message>\n",
            ]
        )
        for source, text in translations.items()
    ]
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
        f'<TS version="2.1" language="{language}" sourcelanguage="en">\n'
        f"<context>\n    <name>{CONTEXT}</name>\n{''.join(messages)}</context>\n</TS>\n"
    )


if __name__ == "__main__":
    sys.exit(min(main(), 1))
