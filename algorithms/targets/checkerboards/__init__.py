"""Black and white targets: where they may be, their plane, their two edges, how far they reach.

Public names: `candidates.checkerboard_candidates`, `checkerboard.checkerboard_at`, `plane.fit_plane`,
`pattern.fit_pattern`, `extent.extent_of`.
"""
