"""The centrelines of walls: pieces that meet at junctions, each with its thickness.

Public names: `axes.find_axes`, `axes.Axis`, `skeleton.skeleton_of`, `settings.AxisSettings`.
"""
