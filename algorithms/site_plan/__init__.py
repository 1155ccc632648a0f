"""From a point cloud to a density image, to wall regions, to polygons (Mueller et al. 2012)."""
