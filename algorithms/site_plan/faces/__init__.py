"""The faces of walls, fitted to the points (beyond the paper)."""
