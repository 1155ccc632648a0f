"""Targets in scans: black and white ones, and spheres.

Public names: `search.find_targets`; `settings.TargetSettings`, `settings.Wanted`; `results.Target`,
`results.TargetSearch`; `output`.
"""
