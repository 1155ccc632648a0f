"""Lists of points: surveyed control points, and targets of a scan."""
