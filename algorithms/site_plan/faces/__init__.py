"""The faces of walls, fitted to the points, and outlines along them (beyond the paper).

Public names, by module
    refinement: refine_on_points, refine_walls. face_points: the voxels near walls.
    ridges, ridge_segments, face_fit, face, ring_faces: from an outline of pixels to the faces along it.
    hidden_faces, face_outline, wall_measures: from faces to outlines and measures.
    settings: FaceSettings.
"""
