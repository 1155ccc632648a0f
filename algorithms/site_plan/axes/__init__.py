"""The centrelines of walls: pieces that meet at junctions, each with its thickness.

Public names, by module
    axes: find_axes, Axis. skeleton: skeleton_of, from which the axes are drawn. settings: AxisSettings.
"""
