"""The algorithms of the toolbox, one class a module.

Each declares its parameters and outputs, and its `compute` makes one call into the core.

Public names: the class of each module, such as `site_plan.SitePlanAlgorithm`.
"""
