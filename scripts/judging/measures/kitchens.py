"""Kitchens: units in runs, the way from sink to cooker, appliances beside units.

Figures: worktop between sink and hob and beside a dishwasher from the NKBA's Kitchen Planning Guidelines; the shares that are
wanted are the project's.
"""

from __future__ import annotations

import heapq

import shapely

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import APPLIANCES, COOKERS, DISHWASHERS, FRIDGES, ISLANDS, KITCHEN_UNITS, KITCHENS, SINKS, WORKTOPS

# Square metres below which a kitchen is a niche.
LEAST_AREA = 5.0
# Metres between units that touch: a joint between two carcasses.
TOUCH = 0.02
# Metres that two units share at least; less is corner to corner.
SIDE_BY_SIDE = 0.1
MOST_RUNS = 2
LOOSE_UNITS = 3
DISHWASHER_REACH = 0.1
WORKTOP = (0.6, 1.8)
# Coordinates are single precision numbers.
ROUNDING = 0.002
# Metres above the floor under which a unit stands; wall cabinets and hoods hang.
STANDING = 1.0


def units_of(room: Room) -> list[Piece]:
    """Units that stand in a kitchen."""
    if room.kind not in KITCHENS or room.area <= LEAST_AREA:
        return []
    return [piece for piece in room.of(KITCHEN_UNITS) if piece.carrier is None and piece.low < STANDING]


def neighbours(units: list[Piece]) -> list[list[int]]:
    """The units that each unit touches. Corner to corner is no touch: a unit around a corner shares a stretch with it."""
    shapes = [unit.footprint for unit in units]
    near: list[list[int]] = [[] for _ in units]
    for number, shape in enumerate(shapes):
        for other in range(number):
            if shapely.dwithin(shape, shapes[other], TOUCH) and shared_edge(shape, shapes[other]) > SIDE_BY_SIDE:
                near[number].append(other)
                near[other].append(number)
    return near


def shared_edge(one: shapely.Geometry, other: shapely.Geometry) -> float:
    """Metres along which two units stand side by side."""
    return shapely.length(shapely.intersection(one.boundary, other.buffer(TOUCH + ROUNDING, join_style="mitre")))


def runs_of(units: list[Piece]) -> list[list[Piece]]:
    """Units that hold together."""
    near, seen, runs = neighbours(units), set(), []
    for first in range(len(units)):
        stack, run = [first], []
        while stack:
            number = stack.pop()
            if number not in seen:
                seen.add(number)
                run.append(units[number])
                stack += near[number]
        if run:
            runs.append(run)
    return runs


def judge_runs(room: Room) -> Answer | None:
    runs = runs_of(units_of(room))
    if not runs:
        return None
    faults = []
    if len(runs) > MOST_RUNS:
        first = tuple(run[0].id for run in runs)
        faults.append(Fault(f"{len(runs)} runs of units that do not touch", first, len(runs)))
    return answer(faults, len(runs))


def judge_loose(room: Room) -> Answer | None:
    units = units_of(room)
    if not units:
        return None
    loose = [unit.id for unit, near in zip(units, neighbours(units)) if not near and unit.kind not in ISLANDS]
    faults = [Fault(f"{len(loose)} units touch no other", tuple(loose), len(loose))] if len(loose) >= LOOSE_UNITS else []
    return answer(faults, len(loose))


def judge_alone(room: Room) -> Answer | None:
    units = units_of(room)
    if not any(unit.kind in APPLIANCES for unit in units):
        return None
    alone = [unit for unit, near in zip(units, neighbours(units)) if not near and unit.kind in APPLIANCES]
    return answer([Fault(f"the {unit.kind} touches no unit", (unit.id,)) for unit in alone], len(alone))


def judge_dishwasher(room: Room) -> Answer | None:
    units = units_of(room)
    sinks = [unit for unit in units if unit.kind in SINKS]
    washers = [unit for unit in units if unit.kind in DISHWASHERS]
    if not sinks or not washers:
        return None
    faults, farthest = [], 0.0
    for washer in washers:
        metres = min(washer.footprint.distance(sink.footprint) for sink in sinks)
        farthest = max(farthest, metres)
        if metres > DISHWASHER_REACH + ROUNDING:
            faults.append(Fault(f"the sink is {metres:.2f} m away", (washer.id,), metres))
    return answer(faults, farthest)


def judge_worktop(room: Room) -> Answer | None:
    units = units_of(room)
    sinks = {number for number, unit in enumerate(units) if unit.kind in SINKS}
    cookers = {number for number, unit in enumerate(units) if unit.kind in COOKERS}
    if not sinks or not cookers:
        return None
    metres = worktop_between(units, sinks, cookers)
    low, high = WORKTOP
    ids = tuple(units[number].id for number in sorted(sinks | cookers))
    if metres is None:
        return answer([Fault("no worktop leads from the sink to the cooker", ids)])
    if low - ROUNDING <= metres <= high + ROUNDING:
        return answer([], metres)
    return answer([Fault(f"{metres:.2f} m of worktop between sink and cooker", ids, metres)], metres)


def worktop_between(units: list[Piece], starts: set[int], ends: set[int]) -> float | None:
    """Metres of worktop on the shortest way along touching units, or None where no worktop leads there."""
    near = neighbours(units)
    queue = [(0.0, start) for start in sorted(starts)]
    done: set[int] = set()
    while queue:
        metres, number = heapq.heappop(queue)
        if number in ends:
            return metres
        if number in done:
            continue
        done.add(number)
        for other in near[number]:
            if other in ends:
                heapq.heappush(queue, (metres, other))
            elif units[other].kind in WORKTOPS:
                heapq.heappush(queue, (metres + float(units[other].size[0]), other))
    return None


def judge_fridge_at_cooker(room: Room) -> Answer | None:
    units = units_of(room)
    cookers = [number for number, unit in enumerate(units) if unit.kind in COOKERS]
    fridges = {number for number, unit in enumerate(units) if unit.kind in FRIDGES}
    if not cookers or not fridges:
        return None
    near = neighbours(units)
    warmed = [units[other].id for cooker in cookers for other in near[cooker] if other in fridges]
    return answer([Fault("it stands right beside the cooker", (fridge,)) for fridge in warmed])


def judge_length(room: Room) -> Answer | None:
    units = units_of(room)
    if not units:
        return None
    return answer([], sum(float(unit.size[0]) for unit in units) / room.area)


GUIDE = "NKBA, Kitchen Planning Guidelines"
MEASURES = [
    Measure("kitchen_runs", "units stand in at most two runs of touching units; an island counts as one", "runs", "≤ 2",
            "project", judge_runs),
    Measure("kitchen_loose_units", "fewer than three units touch no other", "units", "< 3", "project", judge_loose),
    Measure("kitchen_appliance_alone", "a fridge, cooker or dishwasher touches a unit", "appliances", "0", "project",
            judge_alone),
    Measure("kitchen_dishwasher", "the dishwasher is at the sink", "m", "≤ 0.1", GUIDE, judge_dishwasher, 0.95),
    Measure("kitchen_worktop", "worktop lies between sink and cooker", "m", "0.6–1.8", GUIDE, judge_worktop, 0.9),
    Measure("kitchen_fridge_at_cooker", "a unit is between fridge and cooker", "", "apart", GUIDE, judge_fridge_at_cooker),
    Measure("kitchen_length", "units by floor area (a distribution, no limit)", "m/m²", "", "project", judge_length),
]
