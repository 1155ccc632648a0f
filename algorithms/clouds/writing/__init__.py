"""Clouds written to files: chosen, labelled or transformed points."""
