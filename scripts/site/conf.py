"""Sphinx makes the site from the pages that `pages.py` writes; `make docs` runs both."""

project = "Ichnograph"
extensions = ["myst_parser"]
root_doc = "README"
myst_heading_anchors = 4
html_theme = "furo"
html_title = "Ichnograph"
html_theme_options = {
    "source_repository": "https://github.com/ichnograph/ichnograph",
    "source_branch": "main",
}
# A page may begin with a heading of the second level where Markdown has a title in bold.
suppress_warnings = ["myst.header"]
