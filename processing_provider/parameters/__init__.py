"""The parameters and destinations of the algorithms."""
