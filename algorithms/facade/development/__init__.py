"""Facades that turn: round and polygonal towers, and canted bays, rolled out into a plane.

The line of a wall in plan is a circle (`circles`) or a chain of sides (`sides`). Along it (`curves`), points
are moved into a plane that touches the wall in its middle (`development`), where the facade is measured as
any other.

Public names: `development.develop`, `development.Development`, `settings.DevelopmentSettings`.
"""
