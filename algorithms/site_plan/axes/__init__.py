"""The centrelines of walls."""
