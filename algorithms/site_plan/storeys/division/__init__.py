"""The division of a storey into what is room and what is solid.

The lines of the sheets and the outline of the footprint divide the storey into cells (`arrangement`), which
are room or solid by the cheapest cut (`division`, `minimum_cut`); furniture before walls is given back to the
rooms (`explaining`). `outlines` unites cells and tidies what comes of them.

Public names: `division.divide`, `division.Division`, `outlines.united`, `outlines.parts_of`,
`outlines.tidy`, `outlines.sound`.
"""
