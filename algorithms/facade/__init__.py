"""The facade chapter: from the points of a scan to an elevation with measured details.

The facades of a building or a street are found first (`buildings`), then the planes of one and the side from
which it is seen (`planes`), then its openings (`openings`) and regions of one colour on the main plane
(`colour`), then the borders of all details (`outlines`), and the results are written (`output`). After
Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal (2014).

Public names: `measurement.measure_facade`, `points.read_points`, `settings.FacadeSettings`,
`elevation.Elevation`, `elevation.Detail`, `elevation.Frame`, `elevation.Points`, `elevation.Segmentation`;
and the writers of `output`.
"""
