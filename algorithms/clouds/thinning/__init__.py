"""Points chosen so that no two are closer than a minimum distance.

Public names: `thinning.thin_cloud`, `thinning.thin_tiles`, `thinning.deciding`, `thinning.tile_edge`,
`thinning.ThinnedCloud`.
"""
