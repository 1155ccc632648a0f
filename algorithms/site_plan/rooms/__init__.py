"""Rooms: the closed spaces between walls.

Public names, by module
    rooms: find_rooms, with_floors, Room. doors: trim, where a room ends at a door. settings: RoomSettings.
"""
