"""Lists of points: surveyed control points, and targets of a scan.

Public names: `point_list.PointList`, `point_list.read_point_list`, `point_list.points_of_features`,
`scan_names.scan_of_cloud`.
"""
