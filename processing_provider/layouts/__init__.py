"""The printed sheet: a print layout of a plan or an elevation, true to scale.

Public names: `sheet.Sheet` and `sheet.choose_sheet`, where things are on paper; `composition.compose`, which
makes the layout; `export.write_pdf` and `export.write_svg`.
"""
