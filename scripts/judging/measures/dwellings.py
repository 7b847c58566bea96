"""Dwellings as wholes: one living room, the double bed in the largest bedroom, things that agree with who lives there.

Each measure is asked of one room of a dwelling, its kitchen, for the whole; a dwelling is what doors join (`Floor.flats`).
"""

from __future__ import annotations

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..roles import (BEDROOMS, BEDS, CHAIRS, CHILDRENS_THINGS, DESKS, DOUBLE_BEDS, KITCHENS, LIVING_ROOMS, OPEN_KINDS, PROJECTION,
                     SCREENS, SINGLE_BEDS, SLEEPING_ROOMS, TABLES)
from .living import has_reading_corner

# Square metres from which on a bedroom has room for a double bed.
DOUBLE_AREA = 8.5
FAMILIES = "family"
SHARED = "shared_flat"


def dwelling_of(room: Room) -> list[Room] | None:
    """The rooms of a dwelling, asked at its largest kitchen; none of other rooms, and where nobody is known to live."""
    flats = room.floor.flats
    if room.kind not in KITCHENS or room.id not in flats:
        return None
    rooms = [other for other in room.floor.rooms if flats.get(other.id) == flats[room.id]]
    kitchens = [other for other in rooms if other.kind in KITCHENS]
    first = max(kitchens, key=lambda other: (other.area, other.id))
    return rooms if first is room and household(room) else None


def household(room: Room) -> dict | None:
    return room.extras.get("household")


def is_whole(room: Room, rooms: list[Room]) -> bool:
    """Whether all bedrooms of a dwelling are on this floor: of a house with stairs, some may be on others."""
    return household(room)["bedrooms"] <= sum(other.kind in SLEEPING_ROOMS for other in rooms)


def judge_living(room: Room) -> Answer | None:
    rooms = dwelling_of(room)
    if rooms is None:
        return None
    living = [other for other in rooms if other.kind in LIVING_ROOMS]
    if not living and not any(other.kind in OPEN_KINDS for other in rooms):
        return None  # The plan names every room, and none is a living room.
    with_screen = [other for other in living if other.of(SCREENS | PROJECTION)]
    if len(with_screen) > 1:
        return answer([Fault(f"{len(with_screen)} living rooms have a screen")])
    instead = [other for other in living if has_reading_corner(other)]
    return answer([] if with_screen or instead else [Fault(f"none of {len(living)} living rooms has a screen or a reading corner")])


def judge_double(room: Room) -> Answer | None:
    rooms = dwelling_of(room)
    bedrooms = [other for other in rooms or [] if other.kind in BEDROOMS and other.area >= DOUBLE_AREA]
    if not bedrooms or not is_whole(room, rooms):
        return None
    largest = max(bedrooms, key=lambda other: other.area)
    is_for_two = largest.of(DOUBLE_BEDS) or len(largest.of(SINGLE_BEDS)) > 1
    # Whoever shares a flat has a bed alone; no other room may have the wider one.
    is_shared = household(room)["id"] == SHARED and not any(other.of(DOUBLE_BEDS) for other in bedrooms)
    found = "no bed" if not largest.of(BEDS) else "a single bed"
    return answer([] if is_for_two or is_shared else [Fault(f"the largest bedroom, {largest.id}, has {found}")])


def judge_beds(room: Room) -> Answer | None:
    rooms = dwelling_of(room)
    if rooms is None or not any(other.of(BEDS) for other in rooms) or not is_whole(room, rooms):
        return None
    beds = [piece for other in rooms for piece in other.of(BEDS)]
    places = sum(2 if piece.kind in DOUBLE_BEDS or piece.kind == "bunk_bed" else 1 for piece in beds)
    people = household(room)["persons"]
    return answer([Fault(f"beds for {places} of {people} people")] if places < people else [], places - people)


def judge_children(room: Room) -> Answer | None:
    rooms = dwelling_of(room)
    if rooms is None:
        return None
    is_family = household(room)["id"].startswith(FAMILIES)
    things = [] if is_family else [piece.id for other in rooms for piece in other.of(CHILDRENS_THINGS)]
    return answer([Fault("a household without children has it", (thing,)) for thing in things])


def judge_chairs(room: Room) -> Answer | None:
    rooms = dwelling_of(room)
    tables = [piece for other in rooms or [] for piece in other.of(TABLES)]
    if not tables:
        return None
    chairs = sum(len(other.of(CHAIRS)) for other in rooms if other.of(TABLES))
    people, bedrooms = household(room)["persons"], household(room)["bedrooms"]
    wanted = max(people, bedrooms)
    return answer([Fault(f"{chairs} chairs for {people} people and {bedrooms} bedrooms")] if chairs < wanted else [],
                  chairs - wanted)


def judge_desks(room: Room) -> Answer | None:
    rooms = dwelling_of(room)
    if rooms is None or household(room)["id"] != SHARED:
        return None
    private = [other for other in rooms if other.kind in BEDROOMS]
    return answer([Fault(f"room {other.id} of a shared flat has no desk") for other in private if not other.of(DESKS)])


MEASURES = [
    Measure("dwelling_living_room", "a dwelling has one living room with a screen, or a reading corner instead", "", "1", "project",
            judge_living),
    Measure("dwelling_double_bed", "the largest bedroom of a dwelling has a bed for two", "", "from 8.5 m²", "project", judge_double),
    Measure("dwelling_beds", "everybody in a dwelling has a place to sleep", "places left", "≥ 0", "project", judge_beds),
    Measure("dwelling_children", "toys, cots and bunk beds are in families only", "", "0", "project", judge_children),
    Measure("dwelling_chairs", "people and bedrooms have a chair at a table", "chairs left", "≥ 0", "project", judge_chairs),
    Measure("dwelling_desks", "each room of a shared flat has a desk", "", "", "project", judge_desks),
]
