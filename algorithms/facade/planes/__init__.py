"""The planes of a facade: the main one, and those on it.

Points are thinned to voxels (`voxels`). Planes are found among them (`ransac`), with their extent
(`patches`), and points are assigned to them (`segmentation`).

Public names: `segmentation.find_planes`, `voxels.square_means`, `settings.PlaneSettings`.
"""
