"""The surfaces that several scans see, as observations of the block adjustment, and to place scans by.

The way of a surface: `cells` -> `patches` -> `pairing` -> `tie`, an observation of `adjustment`, which
`refinement` repeats until neither pairs nor poses change.

The way of a scan without targets: `rotations` and `motions` -> `evidence`, by the `view` of each scan ->
`placement` -> `refinement`.

Public names: `patches.Surfaces`, `patches.read_surfaces`, `tie.Tie`, `adjustment.adjust_with_surfaces`.
"""
