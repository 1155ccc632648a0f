"""Spheres: where they may be, and their fit.

Public names: `candidates.sphere_candidates`, `sphere.sphere_at`, `sphere_fit.fit_sphere`.
"""
