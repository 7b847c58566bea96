"""What is measured of planned and real buildings alike, and how far two samples are apart."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path

import numpy as np

from .dwellings import dwellings_of
from .plan import Building, read_plan
from .roles import CLOSED, CORES, CORRIDORS, is_habitable
from .ways import Place, Ways

# Outside, or nobody's floor: no part of a flat's area.
NO_FLOOR = CLOSED | {"balcony", "loggia", "terrace", "elevator"}
BEDROOMS = {"bedroom", "room", "childrens_room"}
# Of the smallest turned rectangle around a room.
RECTANGULAR = 0.95

MEASURES = {
    "area_living": "m² of a living room, with or without its kitchen",
    "area_kitchen": "m² of a kitchen",
    "area_bedroom": "m² of a bedroom or other room of a flat",
    "area_bathroom": "m² of a bathroom",
    "area_corridor": "m² of a corridor",
    "area_classroom": "m² of a classroom",
    "rooms_of_flat": "rooms a flat, without shafts and balconies",
    "area_of_flat": "m² a flat",
    "corridor_share": "share of corridors in a flat",
    "doors_of_corridor": "doors and open sides a corridor",
    "doors_of_room": "doors and open sides a room",
    "windows": "windows a habitable room",
    "rectangularity": f"area of a room by its smallest turned rectangle; from {RECTANGULAR} on it counts as a rectangle",
    "flats_at_landing": "flats at a landing or common corridor",
}

Samples = dict[str, list[float]]


def samples_of_file(path: Path) -> Samples:
    return samples_of(read_plan(path))


def samples_of(building: Building) -> Samples:
    """The values of each measure, a value for each room, flat or landing."""
    found: Samples = defaultdict(list)
    ways = Ways(building)
    for place, room in ways.rooms.items():
        if room.type not in NO_FLOOR and room.shape.is_valid and room.shape.area > 0:
            add_room(found, building, ways, place)
    flats = dwellings_of(building, ways)
    for flat in flats:
        add_flat(found, ways, flat.places)
    add_landings(found, ways)
    return dict(found)


def area_measure(room_type: str) -> str | None:
    if room_type.startswith("living_"):
        return "area_living"
    if room_type in BEDROOMS or room_type.endswith("_bedroom"):
        return "area_bedroom"
    if room_type in CORRIDORS:
        return "area_corridor"
    name = f"area_{'kitchen' if room_type == 'kitchen_dining' else room_type}"
    return name if name in MEASURES else None


def add_room(found: Samples, building: Building, ways: Ways, place: Place) -> None:
    room = ways.rooms[place]
    measure = area_measure(room.type)
    if measure:
        found[measure].append(room.shape.area)
    if room.type not in CORES:
        doors = len(ways.openings[place])
        found["doors_of_corridor" if room.type in CORRIDORS else "doors_of_room"].append(doors)
        found["rectangularity"].append(room.shape.area / room.shape.minimum_rotated_rectangle.area)
    if is_habitable(room.type):
        openings = building.levels[place.level].openings
        found["windows"].append(sum(opening.kind == "window" and room.id in opening.rooms for opening in openings))


def add_flat(found: Samples, ways: Ways, places: set[Place]) -> None:
    rooms = [ways.rooms[place] for place in places if ways.rooms[place].type not in NO_FLOOR]
    area = sum(room.shape.area for room in rooms)
    if area <= 0:
        return
    found["rooms_of_flat"].append(len(rooms))
    found["area_of_flat"].append(area)
    found["corridor_share"].append(sum(room.shape.area for room in rooms if room.type in CORRIDORS) / area)


def add_landings(found: Samples, ways: Ways) -> None:
    """Common rooms of a level that doors join are one landing."""
    common = {place for place, room in ways.rooms.items() if room.dwelling is None and room.type not in NO_FLOOR}
    while common:
        landing, flats, queue = set(), set(), [min(common)]
        while queue:
            here = queue.pop()
            landing.add(here)
            for there in ways.next[here]:
                if there.level == here.level and there in common and there not in landing:
                    queue.append(there)
                elif there.level == here.level and ways.dwelling(there) is not None:
                    flats.add(ways.dwelling(there))
        common -= landing
        if flats:
            found["flats_at_landing"].append(len(flats))


def together(samples: list[Samples]) -> Samples:
    found: Samples = defaultdict(list)
    for sample in samples:
        for measure, values in sample.items():
            found[measure] += values
    return dict(found)


def distance(first: list[float], second: list[float]) -> float | None:
    """The statistic of Kolmogorov and Smirnov for two samples: the largest difference of their distribution functions."""
    if not first or not second:
        return None
    ours, theirs = np.sort(first), np.sort(second)
    values = np.concatenate([ours, theirs])
    below = np.searchsorted(ours, values, side="right") / len(ours)
    return float(np.abs(below - np.searchsorted(theirs, values, side="right") / len(theirs)).max())


def compare(planned: Samples, real: Samples) -> list[dict]:
    """A row for each measure: counts, 5 %, 50 % and 95 % quantiles of both, and how far they are apart."""
    rows = []
    for measure, meaning in MEASURES.items():
        ours, theirs = planned.get(measure, []), real.get(measure, [])
        row = {"measure": measure, "meaning": meaning, "planned": spread(ours), "real": spread(theirs),
               "distance": distance(ours, theirs)}
        if measure == "rectangularity":
            row |= {"planned_rectangles": share_of_rectangles(ours), "real_rectangles": share_of_rectangles(theirs)}
        rows.append(row)
    return rows


def spread(values: list[float]) -> dict:
    if not values:
        return {"count": 0, "quantiles": None}
    return {"count": len(values), "quantiles": [round(float(value), 3) for value in np.quantile(values, (0.05, 0.5, 0.95))]}


def share_of_rectangles(values: list[float]) -> float | None:
    return float(np.mean(np.array(values) >= RECTANGULAR)) if values else None
