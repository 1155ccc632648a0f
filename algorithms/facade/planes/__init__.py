"""The planes of a facade and their points."""
