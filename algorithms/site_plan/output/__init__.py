"""The layers and the report of a site plan.

Public names: `layers.write_plan`, `layers.write_walls`, `layers.write_axes`, `layers.write_rooms`,
`plan_report.write_report`.
"""
