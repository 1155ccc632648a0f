"""Geometry in the plane, and statistics, that chapters share; it imports no chapter.

Fits of circles and arcs are in `circles`; standard deviations and weights that gross errors do not move are
in `robust`.

Public names: `curves.Line`, `curves.Arc`, `curves.Curve`, `curves.line_through`, `triangulation.Mesh`,
`triangulation.triangulate`, `outline_triangles.OutlineMesh`, `outline_triangles.triangulate_outlines`,
`linked_parts.label_linked`, `linked_parts.label_near`, `motion.Motion`; and the functions of `azimuths`,
`circles`, `packed_cells`, `polygons`, `robust` and `weighted_fit`.
"""
