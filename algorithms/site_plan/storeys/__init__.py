"""Plans of storeys: faces and seen floor first."""
