"""The density image of a cloud, and the heights that come with it (Mueller et al. 2012, section 2.1).

Its pixels are in `grid`. The surfaces below and above a wall are in `ground` and `ceiling`. How far points
spread over a pixel is in `spread`. Tiles fill the bands in `bands`.

Public names: `density_image.density_image`, `density_image.sort_and_image`, `density_image.DensityImage`,
`density_raster.DensityRaster`, `density_raster.read_density`, `density_raster.write_density`,
`height_range.HeightRange`, `settings.DensitySettings`.
"""
