"""Rooms: what is room, cut at openings and necks, as far as it is wide enough.

`openings` are where the line of a wall continues above or below open space; `necks` are narrow; what is wide
enough is in `spaces`; `outdoors` is where rooms run out of the building.

Public names: `room_cells.find_rooms`, `room_cells.Room`.
"""
