"""The science: arrays in, frozen dataclasses out. Nothing here imports QGIS."""
