"""Checks one building by itself, and keeps what its neighbours need to know of it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from .dwellings import dwelling_faults, dwellings_of
from .openings import VIEW, leads_out, opening_faults, room_behind, view_of
from .plan import Building, Placed, read_plan
from .shapes import floors_of, shape_faults
from .table import Fault
from .ways import Ways, core_faults, way_faults


class Task(NamedTuple):
    placed: Placed
    # Square metres of the building's outline, where a report says so.
    area: float | None = None


class Sight(NamedTuple):
    """The view of a window, on the plane of the site."""

    window: str
    level: str
    shape: Polygon
    bottom: float
    top: float


class Storey(NamedTuple):
    """The floor of a level within its outer walls, on the plane of the site."""

    shape: BaseGeometry
    bottom: float
    top: float


@dataclass
class Checked:
    id: str
    site: str
    rooms: int = 0
    levels: int = 0
    dwellings: int = 0
    # The least share of all storeys' floor that a storey has.
    least_share: float = 1.0
    faults: list[Fault] = field(default_factory=list)
    storeys: list[Storey] = field(default_factory=list)
    sights: list[Sight] = field(default_factory=list)


def check_plan(task: Task) -> Checked:
    """Reads and checks a plan; an error of reading is the caller's."""
    building = read_plan(task.placed.file)
    checked = Checked(building.id, task.placed.site, sum(len(level.rooms) for level in building.levels), len(building.levels))
    if not checked.rooms:
        checked.faults = [Fault("no_entrance", building.id, "", "", "no rooms")]
        return checked
    floors = floors_of(building)
    ways = Ways(building)
    dwellings = dwellings_of(building, ways)
    checked.dwellings = len(dwellings)
    checked.faults = (shape_faults(building, floors, task.area) + opening_faults(building) + way_faults(building, ways)
                      + core_faults(building, ways) + dwelling_faults(building, ways, dwellings))
    largest = max(floor.area for floor in floors)
    checked.least_share = min(floor.area for floor in floors) / largest if largest else 0.0
    checked.storeys = [Storey(task.placed.on_site(floor), level.elevation, level.elevation + level.height)
                       for floor, level in zip(floors, building.levels)]
    checked.sights = sights_of(building, task.placed)
    return checked


def sights_of(building: Building, placed: Placed) -> list[Sight]:
    sights = []
    for level in building.levels:
        for window in level.openings:
            room = room_behind(window, level) if window.kind == "window" and leads_out(window, level) else None
            view = room and view_of(window, room.shape, building.exterior, VIEW)
            if view is not None:
                heights = (level.elevation + window.sill, level.elevation + window.head)
                sights.append(Sight(f"{window.id} of {room.id}", level.id, placed.on_site(view), *heights))
    return sights
