"""The algorithms as QGIS Processing shows them. Nothing here computes."""
