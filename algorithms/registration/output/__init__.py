"""The files of a registration.

Public names: `transforms.write_transforms`, `transforms.read_transforms`, `transforms.match_clouds`,
`layers.write_residuals`, `layers.write_control`, `report.write_report`.
"""
