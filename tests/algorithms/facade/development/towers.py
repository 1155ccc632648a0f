"""Points on towers and bays."""

import numpy as np

STEP = 0.04


def round_wall(centre, radius, first_deg, last_deg, top=5.0, noise=0.002):
    """Return points on a round wall between two azimuths, shape (n, 3)."""
    turns = np.radians(np.arange(first_deg, last_deg, np.degrees(STEP / radius)))
    turn, height = (part.ravel() for part in np.meshgrid(turns, np.arange(0, top, STEP)))
    away = radius + np.random.default_rng(0).normal(0, noise, len(turn))
    return np.column_stack([centre[0] + away * np.sin(turn), centre[1] + away * np.cos(turn), height])


def sides(corners, top=5.0, noise=0.002):
    """Return points on upright walls between corners in plan, shape (n, 3)."""
    parts = []
    for start, stop in zip(np.array(corners[:-1], float), np.array(corners[1:], float)):
        length = np.linalg.norm(stop - start)
        along, height = np.meshgrid(np.arange(STEP / 2, length, STEP), np.arange(0, top, STEP))
        along, height = along.ravel(), height.ravel()
        out = np.array([stop[1] - start[1], start[0] - stop[0]]) / length
        away = np.random.default_rng(1).normal(0, noise, len(along))
        plan = start + np.outer(along / length, stop - start) + np.outer(away, out)
        parts.append(np.column_stack([plan, height]))
    return np.concatenate(parts)


BAY = [(0, 0), (3, 0), (3.8, -0.8), (5.8, -0.8), (6.6, 0), (9.6, 0)]
"""A wall seen from the south, with a canted bay."""


def ground(left, bottom, right, top, z=0.0):
    """Return points on the ground, shape (n, 3)."""
    x, y = (part.ravel() for part in np.meshgrid(np.arange(left, right, 0.1), np.arange(bottom, top, 0.1)))
    return np.column_stack([x, y, np.full(len(x), z)])
