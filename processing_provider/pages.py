"""Pages of the results viewer: tables and other files as a person reads them."""

import csv
import html
from pathlib import Path

STYLE = (
    "body{font-family:sans-serif}td,th{border:1px solid #bbb;padding:2px 6px}table{border-collapse:collapse}"
)


def page_of_table(path: Path, title: str) -> str:
    """Return a CSV file as an HTML table."""
    with path.open(newline="", encoding="utf-8") as stream:
        head, *rows = list(csv.reader(stream)) or [[]]
    lines = [_row("th", head), *(_row("td", row) for row in rows)]
    return _page(path, title, f"<table>{''.join(lines)}</table>")


def page_of_text(path: Path, title: str) -> str:
    """Return a text file as it is."""
    return _page(path, title, f"<pre>{html.escape(path.read_text(encoding='utf-8'))}</pre>")


def _row(tag: str, cells: list[str]) -> str:
    return f"<tr>{''.join(f'<{tag}>{html.escape(cell)}</{tag}>' for cell in cells)}</tr>"


def _page(path: Path, title: str, body: str) -> str:
    head = f'<head><meta charset="utf-8"><title>{html.escape(title)}</title><style>{STYLE}</style></head>'
    link = f'<p><a href="{path.absolute().as_uri()}">{html.escape(str(path))}</a></p>'
    return f"<!DOCTYPE html><html>{head}<body><h2>{html.escape(title)}</h2>{link}{body}</body></html>"
