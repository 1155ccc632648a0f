"""The site plan: from laser scans to walls, axes and rooms (Mueller, Kohoutek and Theiler 2012).

Public names: `site_plan.make_site_plan`, `site_plan.extract_walls`, `settings.SitePlanSettings`,
`results.SitePlan`, `results.WallPlan`, `density.density_image.density_image`,
`density.density_raster.read_density`, `density.density_raster.write_density`; and the writers of `output`.
"""
