"""Which target of a scan is which control point."""
