"""The formats of point clouds, one a module."""
