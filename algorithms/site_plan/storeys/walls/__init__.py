"""Walls: what stands behind faces that bound rooms, and behind those that bound none.

Faces that bound no room are found in `free_faces`. `wall_bodies` stand behind faces, `wall_pieces` lie
between junctions and openings, and `walls` measures them. What stands in rooms and is not a wall is
`left_out`, with the reason.

Public names: `free_faces.free_faces`, `free_faces.screens`, `free_faces.clear_before`,
`left_out.find_left_out`, `left_out.LeftOut`, `wall_bodies.wall_bodies`, `wall_bodies.behind`,
`walls.describe_walls`, `walls.Wall`.
"""
