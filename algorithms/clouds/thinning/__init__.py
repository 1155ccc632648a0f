"""Points sorted into tiles, and thinned."""
