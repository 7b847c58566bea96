"""Ways through a building: which rooms are reached from outside, through which others, and how far it is out."""

from __future__ import annotations

import heapq
from collections import defaultdict, deque
from math import dist
from typing import NamedTuple

from shapely.geometry.base import BaseGeometry

from .plan import Building, Opening
from .roles import BATHS, CLOSED, CORES, ENSUITE, LIFT, OUTSIDE, STAIRS, is_private
from .table import Fault

LONGEST_WAY_OUT = 35.0
SAME_CORE = 0.01
# Share of the smaller one that stairs of two levels have in common.
STACKED = 0.5


class Place(NamedTuple):
    """A room of a level, by the level's number."""

    level: int
    room: str


class Ways:
    """The rooms of a building as a graph."""

    def __init__(self, building: Building):
        self.building = building
        self.rooms = {Place(number, room.id): room for number, level in enumerate(building.levels) for room in level.rooms.values()}
        self.openings: dict[Place, list[Opening]] = defaultdict(list)
        self.next: dict[Place, set[Place]] = defaultdict(set)
        self.entrances: set[Place] = set()
        for number, level in enumerate(building.levels):
            for opening in level.openings:
                if opening.is_way:
                    self.add(number, opening)
        self.stack()

    def add(self, number: int, opening: Opening) -> None:
        places = [Place(number, room) for room in opening.rooms if Place(number, room) in self.rooms]
        for place in places:
            self.openings[place].append(opening)
        if len(places) == 2:
            self.next[places[0]].add(places[1])
            self.next[places[1]].add(places[0])
        elif places and number == 0 and opening.is_outer:
            self.entrances.add(places[0])

    def stack(self) -> None:
        """Joins stairs and lifts with those above them."""
        for below, room in self.rooms.items():
            if room.type not in (STAIRS, LIFT):
                continue
            for above, other in self.rooms.items():
                if above.level == below.level + 1 and other.type == room.type and are_stacked(room.shape, other.shape):
                    self.next[below].add(above)
                    self.next[above].add(below)

    def dwelling(self, place: Place) -> str | None:
        return self.rooms[place].dwelling

    def reached(self, may_pass) -> set[Place]:
        """The rooms that can be reached from outside where `may_pass(from, to)` allows it."""
        seen, queue = set(self.entrances), deque(sorted(self.entrances))
        while queue:
            here = queue.popleft()
            for there in sorted(self.next[here]):
                if there not in seen and may_pass(here, there):
                    seen.add(there)
                    queue.append(there)
        return seen

    def leaves_dwelling(self, here: Place, there: Place) -> bool:
        return self.dwelling(here) is not None and self.dwelling(there) != self.dwelling(here)


def are_stacked(first: BaseGeometry, second: BaseGeometry) -> bool:
    if not first.is_valid or not second.is_valid or not first.intersects(second):
        return False
    return first.intersection(second).area >= STACKED * min(first.area, second.area)


def way_faults(building: Building, ways: Ways) -> list[Fault]:
    if not ways.entrances:
        rooms = sum(len(level.rooms) for level in building.levels)
        return [Fault("no_entrance", building.id, building.levels[0].id, "", f"{rooms} rooms", rooms)]
    return reach_faults(building, ways) + way_out_faults(building, ways)


def reach_faults(building: Building, ways: Ways) -> list[Fault]:
    at_all = ways.reached(lambda here, there: True)
    in_public = ways.reached(lambda here, there: not is_private(ways.rooms[here].type))
    by_right = ways.reached(lambda here, there: not ways.leaves_dwelling(here, there))
    walked = {place for place, room in ways.rooms.items() if room.type not in CLOSED}
    behind_private = {place for place in walked & at_all - in_public if not is_ensuite(ways, place, in_public)}
    return (first_faults("unreached", building, ways, walked - at_all, set())
            + first_faults("through_private", building, ways, behind_private, in_public)
            + first_faults("through_dwelling", building, ways, walked & at_all - by_right, by_right))


def first_faults(code: str, building: Building, ways: Ways, missed: set[Place], known: set[Place]) -> list[Fault]:
    """A fault for each group of joined rooms, at its first room behind one that is known: the others follow from it."""
    faults = []
    left = set(missed)
    while left:
        group, queue = set(), [min(left)]
        while queue:
            here = queue.pop()
            if here not in group:
                group.add(here)
                queue += ways.next[here] & left
        left -= group
        first = min(group, key=lambda place: (not ways.next[place] & known, place))
        before = sorted(ways.rooms[place].type for place in ways.next[first] & known)
        text = ways.rooms[first].type + (f" behind {', '.join(before)}" if before else "")
        text += f", and {len(group) - 1} rooms behind it" if len(group) > 1 else ""
        faults.append(Fault(code, building.id, building.levels[first.level].id, first.room, text, len(group)))
    return faults


def is_ensuite(ways: Ways, place: Place, in_public: set[Place]) -> bool:
    """Whether a small room leads off one bedroom, and none lacks it: its dwelling has another bath or one bedroom only."""
    room = ways.rooms[place]
    doors = ways.next[place]
    if room.type not in ENSUITE or len(doors) != 1 or ways.rooms[next(iter(doors))].type in BATHS:
        return False
    if room.type not in BATHS:
        return True
    own = [other for other in ways.rooms if ways.dwelling(other) == room.dwelling and (room.dwelling is None or is_near(other, place))]
    bedrooms = sum(is_private(ways.rooms[other].type) and ways.rooms[other].type not in BATHS for other in own)
    others = [other for other in own if ways.rooms[other].type == "bathroom" and other in in_public]
    return bool(others) or bedrooms == 1


def is_near(first: Place, second: Place) -> bool:
    """Whether rooms may be of one flat: flats of different levels may have the same name."""
    return first.level == second.level


def way_out_faults(building: Building, ways: Ways) -> list[Fault]:
    metres = ways_out(building, ways)
    faults = []
    for place, room in ways.rooms.items():
        if room.type in CORES | CLOSED | OUTSIDE:
            continue
        middle = room.shape.representative_point().coords[0]
        options = [dist(middle, opening.at) + metres[place.level, opening.id] for opening in ways.openings[place]
                   if (place.level, opening.id) in metres]
        if options and min(options) > LONGEST_WAY_OUT:
            text = f"{room.type} {min(options):.1f} m"
            faults.append(Fault("way_out_long", building.id, building.levels[place.level].id, room.id, text, min(options)))
    return faults


def ways_out(building: Building, ways: Ways) -> dict[tuple[int, str], float]:
    """Metres from each door to stairs or an outer door, in straight lines from door to door (Dijkstra's algorithm)."""
    queue = []
    for place, openings in ways.openings.items():
        for opening in openings:
            is_out = ways.rooms[place].type == STAIRS or (opening.is_outer and place.level == 0)
            if is_out:
                queue.append((0.0, (place.level, opening.id), opening))
    heapq.heapify(queue)
    metres: dict[tuple[int, str], float] = {}
    while queue:
        far, key, opening = heapq.heappop(queue)
        if key in metres:
            continue
        metres[key] = far
        for room in opening.rooms:
            for other in ways.openings[Place(key[0], room)]:
                there = (key[0], other.id)
                if there not in metres:
                    heapq.heappush(queue, (far + dist(opening.at, other.at), there, other))
    return metres


def core_faults(building: Building, ways: Ways) -> list[Fault]:
    """Each core of the ground floor is looked for on all levels, and those above on the ground floor."""
    faults = []
    by_level = [[room for room in level.rooms.values() if room.type in CORES] for level in building.levels]
    for level, cores in zip(building.levels[1:], by_level[1:]):
        for room, others, where in [(room, cores, level.id) for room in by_level[0]] + [(room, by_level[0], level.id) for room in cores]:
            same = [other.shape for other in others if other.type == room.type]
            nearest = min((room.shape.hausdorff_distance(other) for other in same), default=None)
            if nearest is None or nearest > SAME_CORE:
                text = f"{room.type}: none" if nearest is None else f"{room.type}: {nearest:.3f} m away"
                faults.append(Fault("core_differs", building.id, where, room.id, text, nearest or 99.0))
    return faults
