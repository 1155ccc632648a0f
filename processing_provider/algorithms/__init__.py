"""The algorithms of the toolbox, one class a module, named after it: `site_plan.SitePlanAlgorithm`.

Each declares its parameters and outputs, and its `compute` makes one call into the core.
"""
