"""The faults of many buildings as text and as JSON: a row for each kind, the worst first."""

from __future__ import annotations

import json
from collections import Counter, defaultdict

from .check import Checked
from .table import FAULTS, Fault


def by_code(faults: list[Fault]) -> dict[str, list[Fault]]:
    """Faults of each kind in the order of the table, the worst first."""
    found = defaultdict(list)
    for fault in sorted(faults, key=lambda fault: (-fault.weight, *fault[:4])):
        found[fault.code].append(fault)
    return {code: found[code] for code in FAULTS if code in found}


def summary(checked: list[Checked], faults: list[Fault]) -> dict:
    return {
        "buildings": len(checked),
        "flawless": len(checked) - len({fault.building for fault in faults}),
        "levels": sum(building.levels for building in checked),
        "rooms": sum(building.rooms for building in checked),
        "dwellings": sum(building.dwellings for building in checked),
        "least_share_of_a_storey": round(min((building.least_share for building in checked), default=1.0), 3),
    }


def as_json(checked: list[Checked], faults: list[Fault], reported: dict[str, dict]) -> str:
    groups = by_code(faults)
    codes = [{"code": code, "meaning": FAULTS[code], "faults": len(group), "buildings": len({fault.building for fault in group}),
              "kinds": dict(kinds_of(group, reported))} for code, group in groups.items()]
    rows = [fault._asdict() for group in groups.values() for fault in group]
    return json.dumps({**summary(checked, faults), "codes": codes, "faults": rows}, indent=1)


def kinds_of(faults: list[Fault], reported: dict[str, dict]) -> Counter:
    """Buildings by their kind and way of planning, as the report has them."""
    buildings = [reported[building] for building in sorted({fault.building for fault in faults}) if building in reported]
    return Counter(f"{building['typology']}/{building['rung']}" for building in buildings)


def as_text(checked: list[Checked], faults: list[Fault], reported: dict[str, dict], worst: int) -> str:
    head = summary(checked, faults)
    lines = [f"{head['buildings']:,} buildings, {head['levels']:,} levels, {head['rooms']:,} rooms, {head['dwellings']:,} dwellings; "
             f"{head['flawless']:,} buildings without a fault; the least storey has "
             f"{100 * head['least_share_of_a_storey']:.0f} % of its building's largest"]
    if faults:
        lines += ["", f"{'faults':>7} {'buildings':>9}  code"]
    for code, group in by_code(faults).items():
        lines.append(f"{len(group):7} {len({fault.building for fault in group}):9}  {code}: {FAULTS[code]}")
        kinds = kinds_of(group, reported).most_common(6)
        if kinds:
            lines.append(f"{'':19}kinds/rungs: {', '.join(f'{kind} {count}' for kind, count in kinds)}")
        lines += [f"{'':19}- {place_of(fault)}: {fault.text}" for fault in worst_of(group, worst)]
    return "\n".join(lines)


def worst_of(group: list[Fault], most: int) -> list[Fault]:
    """The worst fault of each of the worst buildings."""
    found: dict[str, Fault] = {}
    for fault in group:
        found.setdefault(fault.building, fault)
    return list(found.values())[:most]


def place_of(fault: Fault) -> str:
    return " ".join(part for part in (fault.building, fault.level, fault.where) if part)
