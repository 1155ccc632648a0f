"""Points sorted into square tiles, in memory and on disk, on a lattice of 10 micrometres.

Public names: `lattice.LATTICE`, `lattice.to_lattice`, `tile_store.TileStore`, `tile_store.Tile`,
`tile_store.fill`, `tile_store.stray_warning`.
"""
