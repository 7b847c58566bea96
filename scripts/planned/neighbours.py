"""What needs two buildings: windows in front of another one, and buildings that stand in each other."""

from __future__ import annotations

from collections import defaultdict

from shapely import STRtree

from .check import Checked
from .openings import area_of_overlap
from .table import Fault

MOST_SEEN = 0.01
MOST_OVERLAP = 0.5


def neighbour_faults(checked: list[Checked]) -> list[Fault]:
    faults = []
    sites: dict[str, list[Checked]] = defaultdict(list)
    for building in checked:
        sites[building.site].append(building)
    for buildings in sites.values():
        if len(buildings) > 1:
            faults += faults_of_site(buildings)
    return faults


def faults_of_site(buildings: list[Checked]) -> list[Fault]:
    storeys = [(building, storey) for building in buildings for storey in building.storeys]
    tree = STRtree([storey.shape for _, storey in storeys])
    faults = []
    for building in buildings:
        faults += blocked_windows(building, storeys, tree)
        faults += overlaps(building, storeys, tree)
    return faults


def blocked_windows(building: Checked, storeys: list, tree: STRtree) -> list[Fault]:
    faults = []
    if not building.sights:
        return []
    shapes = [sight.shape for sight in building.sights]
    seen: dict[int, set[int]] = defaultdict(set)
    for sight, storey in tree.query(shapes, predicate="intersects").T:
        seen[sight].add(storey)
    for number, others in sorted(seen.items()):
        sight = building.sights[number]
        blocking = []
        for other, storey in (storeys[index] for index in sorted(others)):
            is_beside = other is not building and storey.bottom < sight.top and storey.top > sight.bottom
            if is_beside and (area := area_of_overlap(sight.shape, storey.shape)) > MOST_SEEN:
                blocking.append((area / sight.shape.area, other.id))
        if blocking:
            share, other = max(blocking)
            faults.append(Fault("window_blocked", building.id, sight.level, sight.window, f"by {other}, {share:.0%} of its view", share))
    return faults


def overlaps(building: Checked, storeys: list, tree: STRtree) -> list[Fault]:
    """The largest overlap with each other building, told once."""
    largest: dict[str, float] = {}
    for storey in building.storeys:
        for index in tree.query(storey.shape, predicate="intersects"):
            other, theirs = storeys[index]
            if other.id > building.id and storey.bottom < theirs.top and storey.top > theirs.bottom:
                largest[other.id] = max(largest.get(other.id, 0.0), storey.shape.intersection(theirs.shape).area)
    return [Fault("buildings_overlap", building.id, "", other, f"{area:.1f} m²", area)
            for other, area in sorted(largest.items()) if area > MOST_OVERLAP]
