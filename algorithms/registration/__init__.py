"""From unlabelled targets of scans to the transformation of each scan into the control frame.

Public names: `registration.register_scans`, `settings.Settings`, `settings.Model`, `settings.Matching`,
`results.Registration`, `lists.point_list.read_point_list`, `simulation.simulation.simulate`; and the
writers of `output`.

The way of a scan: `lists` -> `matching` -> `sequential_registration` and `densification`, scan after scan ->
`adjustment`, all scans in one block -> `results` -> `output`.
"""
