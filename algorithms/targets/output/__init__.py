"""What is written of a search: a list for each scan, the layer, the report. They only write.

Public names: `lists.list_writers`, `layer.write_targets`, `report.write_report`.
"""
