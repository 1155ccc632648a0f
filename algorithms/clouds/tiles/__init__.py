"""Points sorted into square tiles on disk, on a lattice of 10 micrometres."""
