"""The layers and the report of a site plan."""
