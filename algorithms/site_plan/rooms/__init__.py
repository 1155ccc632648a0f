"""Rooms: the closed spaces between walls.

Public names: `rooms.find_rooms`, `rooms.with_floors`, `rooms.Room`, `doors.trim`, `settings.RoomSettings`.
"""
