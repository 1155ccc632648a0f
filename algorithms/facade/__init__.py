"""The facade chapter: from the points of a scan to an elevation with measured details.

The facades of a building or a street are found first (`buildings`). One that turns is rolled out
(`development`). Then follow the planes of a facade and the side from which it is seen (`planes`), its
openings (`openings`), regions of one colour on its main plane (`colour`), and the borders of all details
(`outlines`). The results are written (`output`). After Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal
(2014).

Public names: `measurement.measure_facade`, `points.read_points`, `settings.FacadeSettings`,
`elevation.Elevation`, `elevation.Detail`, `elevation.Frame`, `elevation.Points`, `elevation.Segmentation`;
and the writers of `output`.
"""
