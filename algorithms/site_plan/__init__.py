"""The site plan: from laser scans to walls, axes and rooms (Mueller, Kohoutek and Theiler 2012).

Public names: `make_site_plan` and `extract_walls` (site_plan), `SitePlanSettings` (settings), `SitePlan` and
`WallPlan` (results), `density_image` (density.density_image), `read_density` and `write_density`
(density.density_raster), and the writers of `output`.
"""
