"""The faces of walls, fitted to the points, and outlines along them (beyond the paper).

The points near walls are in `face_points`. From an outline of pixels to the faces along it: `ridges`,
`ridge_segments`, `face_fit`, `face`, `ring_faces`. From faces to outlines and measures: `hidden_faces`,
`face_outline`, `wall_measures`.

Public names: `refinement.refine_on_points`, `refinement.refine_walls`, `settings.FaceSettings`.
"""
