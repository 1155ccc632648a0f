"""The density image of a cloud, and the heights that come with it (Mueller et al. 2012, section 2.1).

Public names, by module
    density_image: density_image, sort_and_image, DensityImage. density_raster: the raster as a file.
    grid: Grid, the pixels of a site. height_range: HeightRange, a storey or a slice.
    ground, ceiling, spread: the surfaces below and above, and how far points spread.
    settings: DensitySettings.
"""
