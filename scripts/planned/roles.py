"""The roles that types of rooms play in the checks, by their names alone: no table of Roomwright is read."""

from __future__ import annotations

# Rooms that people stay in, and so want daylight in.
HABITABLE = {"bedroom", "room", "studio", "kitchen_dining", "office", "classroom", "ward", "hotel_room", "study",
             "childrens_room", "kindergarten"}
CORRIDORS = {"corridor", "walkway"}
BATHS = {"bathroom", "toilet", "hotel_bathroom", "restroom"}
# Nobody passes through them to another room.
PRIVATE = BATHS | {"bedroom", "childrens_room"}
# They may belong to one bedroom and lead off it.
ENSUITE = {"bathroom", "toilet", "dressing_room", "storeroom"}
KITCHENS = {"kitchen", "kitchen_dining", "living_kitchen", "studio"}
STAIRS, LIFT = "stairs", "elevator"
CORES = {STAIRS, LIFT, "shaft"}
# They stand before the outer walls.
OUTSIDE = {"balcony", "terrace"}
# Nobody walks in them.
CLOSED = {"shaft", "void"}


def is_habitable(room_type: str) -> bool:
    return room_type in HABITABLE or room_type.startswith("living_") or room_type.endswith("_bedroom")


def is_private(room_type: str) -> bool:
    return room_type in PRIVATE or room_type.endswith("_bedroom")


def is_of_a_dwelling(room_type: str) -> bool:
    """Whether a building with such a room is a dwelling."""
    return room_type == "studio" or room_type == "bedroom" or room_type.startswith("living_")


def least_width(room_type: str) -> float:
    """Metres, from the middle of a wall to the middle of the other."""
    if is_habitable(room_type):
        return 2.2
    return 1.0 if room_type in CORRIDORS else 0.85
