"""The facade chapter: from the points of a scan to an elevation with measured details.

Planes are found first (`planes`), then regions of one colour on the main plane (`colour`), then the borders
of all details (`outlines`), and the results are written (`output`). After Aitelkadi, Tahiri, Simonetto,
Sebari and Boulaassal (2014).

Public names: `measurement.measure_facade`, `points.read_points`, `settings.FacadeSettings`, and the results
in `elevation`: `Elevation`, `Detail`, `Frame`, `Points`, `Segmentation`.
"""
