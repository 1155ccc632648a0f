"""Lists of points: surveyed control points, and targets of a scan.

Public names: `point_list.PointList`, `read_point_list` for files, `points_of_features` for open layers.
"""
