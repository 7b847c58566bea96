"""The faults that plans can have, and where each stands in the list."""

from __future__ import annotations

from typing import NamedTuple


class Fault(NamedTuple):
    code: str
    building: str
    level: str
    # Ids of rooms, openings or dwellings.
    where: str
    text: str
    # How bad it is beside other faults of the code; larger is worse.
    weight: float = 0.0


FAULTS = {
    "room_not_simple": "the outline of a room crosses or touches itself",
    "rooms_overlap": "two rooms overlap by more than 0.01 m²",
    "not_covered": "rooms cover less than 99.5 % of what the outer walls enclose",
    "area_differs": "the storey with its walls is over 5 % smaller or larger than the building's outline in the report",
    "storey_differs": "a storey has less than 75 % of the floor of all storeys together",
    "too_narrow": "no disc of the least width fits: 0.85 m, corridors 1.0 m, habitable rooms 2.2 m",
    "sliver": "a part of a room is narrower than 0.3 m",
    "balcony_inside": "a balcony lies within the outer walls by more than 0.05 m²",
    "opening_misplaced": "an opening is not in a wall of its rooms",
    "openings_overlap": "two openings are in the same place of a wall",
    "no_door": "a habitable room has no door or open boundary",
    "no_window": "a habitable room has no window, nor an open boundary to a room with one",
    "window_inside": "a window looks into a room of its own building",
    "window_blocked": "a window is less than 2 m in front of another building's rooms",
    "buildings_overlap": "rooms of two buildings overlap by more than 0.5 m²",
    "no_entrance": "no outer door on the ground floor",
    "unreached": "no way leads from an outer door to a room",
    "through_private": "the only way to a room leads through a bathroom, toilet or bedroom",
    "through_dwelling": "the only way to a room leads through a dwelling that it is not part of",
    "way_out_long": "over 35 m from the middle of a room to stairs or an outer door",
    "core_differs": "stairs, a lift or a shaft are not the same on all levels within 1 cm",
    "dwelling_entrance": "a flat has not exactly one entrance door, or a house none",
    "dwelling_joined": "a door joins two dwellings",
    "dwelling_bathroom": "a dwelling without a bathroom",
    "dwelling_kitchen": "a dwelling without a kitchen",
}
