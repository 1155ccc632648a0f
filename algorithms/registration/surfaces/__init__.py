"""The surfaces that several scans see, as observations of the block adjustment.

The way of a surface: `cells` -> `patches` -> `pairing` -> `tie`, an observation of `adjustment`, which
`refinement` repeats until neither pairs nor poses change.

Public names: `patches.Surfaces`, `patches.read_surfaces`, `tie.Tie`, `refinement.refine`.
"""
