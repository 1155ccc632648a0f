"""Regions of one colour and one intensity in the plane of a wall."""
