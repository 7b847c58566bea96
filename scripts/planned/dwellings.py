"""Dwellings: flats by the key `dwelling` of their rooms, and buildings without it that people live in."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field

from .plan import Building
from .roles import KITCHENS, STAIRS, is_of_a_dwelling
from .table import Fault
from .ways import Place, Ways

WHOLE = "house"


@dataclass
class Dwelling:
    id: str
    level: str
    places: set[Place] = field(default_factory=set)
    # Whether it is the only one of its building: a house may have several doors.
    is_alone: bool = False


def dwellings_of(building: Building, ways: Ways) -> list[Dwelling]:
    """Flats of one name on two levels are one where stairs of theirs join them."""
    groups: dict[tuple[int, str], set[Place]] = defaultdict(set)
    for place, room in ways.rooms.items():
        if room.dwelling is not None:
            groups[place.level, room.dwelling].add(place)
    if not groups:
        return house_of(building, ways)
    found: list[Dwelling] = []
    above: dict[tuple[int, str], Dwelling] = {}
    for (level, name), places in sorted(groups.items()):
        below = above.get((level - 1, name))
        if below is None or not are_joined(ways, below.places, places):
            below = Dwelling(name, building.levels[level].id)
            found.append(below)
        below.places |= places
        above[level, name] = below
    if len(found) == 1:
        found[0].is_alone = True
    return found


def are_joined(ways: Ways, first: set[Place], second: set[Place]) -> bool:
    stairs = [place for place in first if ways.rooms[place].type == STAIRS]
    return any(ways.next[place] & second for place in stairs)


def house_of(building: Building, ways: Ways) -> list[Dwelling]:
    if not any(is_of_a_dwelling(room.type) for room in ways.rooms.values()):
        return []
    return [Dwelling(WHOLE, building.levels[0].id, set(ways.rooms), is_alone=True)]


def dwelling_faults(building: Building, ways: Ways, dwellings: list[Dwelling]) -> list[Fault]:
    faults = []
    for dwelling in dwellings:
        types = {ways.rooms[place].type for place in dwelling.places}
        area = sum(ways.rooms[place].shape.area for place in dwelling.places)
        size = f"{len(dwelling.places)} rooms, {area:.0f} m²"
        place = (building.id, dwelling.level, dwelling.id)
        if "bathroom" not in types:
            faults.append(Fault("dwelling_bathroom", *place, size, area))
        if not types & KITCHENS:
            faults.append(Fault("dwelling_kitchen", *place, size, area))
        doors, joins = entrances_of(ways, dwelling)
        if doors != 1 and not (dwelling.is_alone and doors > 1):
            faults.append(Fault("dwelling_entrance", *place, f"{doors} doors, {size}", abs(doors - 1)))
        if joins:
            faults.append(Fault("dwelling_joined", *place, f"{', '.join(sorted(joins))}", len(joins)))
    return faults


def entrances_of(ways: Ways, dwelling: Dwelling) -> tuple[int, set[str]]:
    """Doors from outside or common rooms, and doors to other dwellings; glazed doors to gardens are no entrances."""
    doors, joins = set(), set()
    for place in dwelling.places:
        for opening in ways.openings[place]:
            key = (place.level, opening.id)
            others = [Place(place.level, room) for room in opening.rooms if room != place.room]
            if opening.is_outer:
                doors |= {key} if opening.kind != "sliding_door" else set()
            elif any(other in ways.rooms and other not in dwelling.places for other in others):
                if any(ways.dwelling(other) is not None for other in others if other in ways.rooms):
                    joins.add(opening.id)
                else:
                    doors.add(key)
    return len(doors), joins
