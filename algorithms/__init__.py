"""The science of the toolbox: arrays in, frozen dataclasses out, without QGIS.

Chapters, with their entry points: `clouds` (`cloud.open_cloud`), `registration`
(`registration.register_scans`), `site_plan` (`site_plan.make_site_plan`), `facade`
(`measurement.measure_facade`) and `evaluation` (`plan.compare_plan`, `lengths.compare_lengths`). They share
`geometry`, `reporting` and the modules here; see docs/architecture.md.

Public names: `errors.IchnographError` and its subclasses, `progress.Progress`, `settings.constants`,
`files.atomic_output`, `raster.write_raster`, `vector.write_vector`, and those of `reference_systems`.
"""
