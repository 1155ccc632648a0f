"""Geometry in the plane, and statistics, that chapters share; it imports no chapter.

Public names, by module
    curves: Line, Arc, Curve, line_through. circles: fits of circles and arcs. azimuths: of lines.
    robust: standard deviations and weights that gross errors do not move.
    polygons: sound polygons of rings that cross. triangulation: Mesh, triangulate, of points.
    outline_triangles: OutlineMesh, triangulate_outlines, of walls. linked_parts: label_linked.
    motion: Motion, of points in space.
"""
