"""The files of a registration.

Public names: `transforms.write_transforms`, `read_transforms` and `match_clouds`, `layers.write_residuals`
and `write_control`, `report.write_report`.
"""
