"""Points sorted into square tiles, in memory and on disk, on a lattice of 10 micrometres.

Public names: `lattice.LATTICE`, `lattice.to_lattice`, `tiles.Key`, `tiles.Tile`, `tiles.Tiles`,
`tiles.SortedTiles`, `tiles.Sorter`, `tiles.by_block`, `tile_store.TileStore`, `tile_store.fill`,
`tile_store.sort_here`, `tile_store.refuse_strays`, `tile_store.stray_warning`.
"""
