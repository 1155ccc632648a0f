"""The layers, the transformations and the report of a registration."""
