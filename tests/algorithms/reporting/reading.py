"""How tests read the markup of reports."""

from html.parser import HTMLParser
from xml.etree import ElementTree


def parsed(markup):
    """Return an element; it must be well formed without any namespace."""
    return ElementTree.fromstring(markup)


def texts(svg):
    """Return the texts of a drawing."""
    return [node.text for node in parsed(svg).iter("text")]


def of_colour(svg, colour, kind="path"):
    """Return the elements of a kind whose style names a colour."""
    return [node for node in parsed(svg).iter(kind) if colour in (node.get("style") or "")]


def text_of(page):
    """Return what a reader sees of a page."""

    class Reader(HTMLParser):
        def __init__(self):
            super().__init__()
            self.data = []

        def handle_data(self, data):
            self.data.append(data)

    reader = Reader()
    reader.feed(page)
    return "".join(reader.data)
