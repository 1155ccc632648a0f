"""The layers, the schedule and the drawing of a facade."""
