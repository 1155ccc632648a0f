"""The outlines of details."""
