"""The check of planned buildings finds each kind of fault, and none in a building without any."""

from __future__ import annotations

import json

import pytest

from check_plans import main
from planned.check import Task, check_plan
from planned.neighbours import neighbour_faults
from planned.plan import plans_in
from planned.table import FAULTS
from planned_building import flats, named, opening, rectangle, room, shed, write_project


def codes_of(folder, area: float | None = None) -> set[str]:
    """Codes of the faults of a project, found in this process."""
    checked = [check_plan(Task(placed, area)) for placed in plans_in(folder)]
    return {fault.code for building in checked for fault in building.faults} | {fault.code for fault in neighbour_faults(checked)}


def test_good_buildings_have_no_fault(tmp_path, capsys):
    folder = write_project(tmp_path / "plans", (flats(), (100, 50), 30), (shed(), (120, 50), 0))
    assert main([str(folder), "--quiet"]) == 0
    assert "2 buildings, 3 levels, 19 rooms, 4 dwellings; 2 buildings without a fault" in capsys.readouterr().out


def rooms_of(plan, level=0):
    return plan["levels"][level]["rooms"]


def openings_of(plan, level=0):
    return plan["levels"][level]["openings"]


def remove(entries, *ids):
    entries[:] = [entry for entry in entries if entry["id"] not in ids]


def cross(plan):
    named(rooms_of(plan), "west-bath")["outline"] = [[0.06, 3.06], [1.94, 4.94], [1.94, 3.06], [0.06, 4.94]]


def overlap(plan):
    named(rooms_of(plan), "west-bath")["outline"] = rectangle(0, 3, 2.5, 2)


def leave_a_gap(plan):
    named(rooms_of(plan), "west-hall")["outline"] = rectangle(3.5, 3, 1.5, 2)


def lose_a_flat_above(plan):
    remove(rooms_of(plan, 1), *[f"west-{name}" for name in ("living", "hall", "bath", "bedroom")])
    plan["levels"][1]["openings"] = [entry for entry in openings_of(plan, 1) if not entry["id"].startswith("west")]


def make_narrow(plan):
    named(rooms_of(plan), "west-bath")["outline"] = rectangle(0, 3, 0.8, 2)
    named(rooms_of(plan), "west-hall")["outline"] = rectangle(0.8, 3, 4.2, 2)


def add_a_sliver(plan):
    named(rooms_of(plan), "west-bath")["outline"] = [[0.06, 3.06], [1.94, 3.06], [1.94, 4.94], [0.26, 4.94], [0.26, 7], [0.06, 7]]


def move_a_door(plan):
    named(openings_of(plan), "west-door-2")["at"] = [3.5, 4]


def put_a_window_on_a_door(plan):
    openings_of(plan).append(opening("twin", "window", (5.9, -0.09), (1, 0), ["stairs"]))


def wall_up(plan):
    remove(openings_of(plan), "west-door-3")


def brick_up(plan):
    remove(openings_of(plan), "west-window-2")


def look_inside(plan):
    openings_of(plan).append(opening("peep", "window", (2.0, 4.0), (0, 1), ["west-bath"], 0.5))


def close_the_house(plan):
    remove(openings_of(plan), "way-in")


def close_the_flat(plan):
    remove(openings_of(plan), "west-entrance")


def pass_the_bedroom(plan):
    named(openings_of(plan), "west-door-2").update({"at": [1, 5], "along": [1, 0], "rooms": ["west-bath", "west-bedroom"]})
    rooms_of(plan).append(room("west-room", "room", (-5, 5, 5, 3), "west"))
    openings_of(plan).append(opening("west-door-4", "door", (0, 6.5), (0, 1), ["west-room", "west-bedroom"]))


def pass_a_flat(plan):
    named(openings_of(plan), "east-entrance").update({"rooms": ["east-hall", "stairs"]})
    rooms_of(plan).append(room("common", "storeroom", (5, 8, 2, 2)))
    openings_of(plan).append(opening("back", "door", (4.94, 8), (0, 1), ["common", "west-bedroom"]))


def stretch(plan):
    for number in (0, 1):
        named(rooms_of(plan, number), "west-living")["outline"] = rectangle(-100, 0, 105, 3)


def shift_the_stairs(plan):
    named(rooms_of(plan, 1), "stairs")["outline"] = rectangle(5, 0, 2, 7.9)


def add_an_entrance(plan):
    openings_of(plan).append(opening("second", "door", (5, 1.5), (0, 1), ["west-living", "stairs"]))


def join_the_flats(plan):
    openings_of(plan).append(opening("between", "door", (6, 4), (0, 1), ["west-hall", "east-hall"]))


def lose_the_bath(plan):
    named(rooms_of(plan), "west-bath")["type"] = "storeroom"


def lose_the_kitchen(plan):
    named(rooms_of(plan), "west-living")["type"] = "living_room"


def add_a_balcony(plan, y=-1.74):
    """Before the living room of the upper western flat; its wall ends at -0.24."""
    rooms_of(plan, 1).append(room("west-balcony", "balcony", (0.5, y - 0.06, 4, 1.62), "west"))
    openings_of(plan, 1).append(opening("out", "sliding_door", (1.1, -0.09), (1, 0), ["west-living", "west-balcony"]))
    named(openings_of(plan, 1), "west-window-1")["rooms"].append("west-balcony")


def push_the_balcony_in(plan):
    add_a_balcony(plan, y=-1.5)


BROKEN = {
    "room_not_simple": cross, "rooms_overlap": overlap, "not_covered": leave_a_gap, "storey_differs": lose_a_flat_above,
    "too_narrow": make_narrow, "sliver": add_a_sliver, "opening_misplaced": move_a_door, "openings_overlap": put_a_window_on_a_door,
    "no_door": wall_up, "no_window": brick_up, "window_inside": look_inside, "no_entrance": close_the_house,
    "unreached": close_the_flat, "through_private": pass_the_bedroom, "through_dwelling": pass_a_flat, "way_out_long": stretch,
    "core_differs": shift_the_stairs, "dwelling_entrance": add_an_entrance, "dwelling_joined": join_the_flats,
    "dwelling_bathroom": lose_the_bath, "dwelling_kitchen": lose_the_kitchen,
    "balcony_inside": push_the_balcony_in,
}


@pytest.mark.parametrize("code", BROKEN)
def test_a_broken_building_is_found(code, tmp_path):
    plan = flats()
    BROKEN[code](plan)
    assert code in codes_of(write_project(tmp_path / "plans", (plan, (0, 0), 0)))


def test_a_balcony_is_no_fault(tmp_path):
    plan = flats()
    add_a_balcony(plan)
    assert codes_of(write_project(tmp_path / "plans", (plan, (0, 0), 0))) == set()


def test_a_neighbour_in_front_of_a_window_is_found(tmp_path):
    # Turned by half a circle: the window of the living room, in the south of the plan, looks north on the site.
    near = write_project(tmp_path / "near", (flats(), (0, 0), 180), (shed(), (-5, 1.5), 0))
    far = write_project(tmp_path / "far", (flats(), (0, 0), 180), (shed(), (-5, 3), 0))
    assert codes_of(near) == {"window_blocked"}
    assert codes_of(far) == set()


def test_buildings_in_each_other_are_found(tmp_path):
    assert "buildings_overlap" in codes_of(write_project(tmp_path / "plans", (flats(), (0, 0), 0), (shed(), (10, 5), 0)))


def test_the_outline_of_the_report_is_compared(tmp_path, capsys):
    folder = write_project(tmp_path / "plans", (shed(), (0, 0), 0))
    assert codes_of(folder, area=4.5 * 3.5) == set()
    assert codes_of(folder, area=20.0) == {"area_differs"}
    report = tmp_path / "report.json"
    report.write_text(json.dumps({"buildings": [{"id": "shed", "typology": "shed", "rung": 0, "area": 20}]}))
    assert main([str(folder), "--quiet", "--json", "--report", str(report)]) == 1
    (row,) = json.loads(capsys.readouterr().out)["codes"]
    assert (row["code"], row["faults"], row["kinds"]) == ("area_differs", 1, {"shed/0": 1})


def test_each_kind_of_fault_has_a_test():
    assert set(FAULTS) == set(BROKEN) | {"window_blocked", "buildings_overlap", "area_differs"}


def test_a_bath_of_the_only_bedroom_is_no_fault(tmp_path):
    plan = flats()
    named(openings_of(plan), "west-door-2").update({"at": [1, 5], "along": [1, 0], "rooms": ["west-bath", "west-bedroom"]})
    assert codes_of(write_project(tmp_path / "plans", (plan, (0, 0), 0))) == set()


def test_the_worst_fault_is_first(tmp_path, capsys):
    folder = write_project(tmp_path / "plans", (shed("thin"), (0, 0), 0), (shed("thinner"), (50, 0), 0))
    for name, depth in (("thin", 0.7), ("thinner", 0.5)):
        plan = shed(name)
        named(rooms_of(plan), "store")["outline"] = rectangle(0, 0, 4, depth)
        write_project(tmp_path / name, (plan, (0, 0), 0))
        (tmp_path / name / f"{name}.yaml").rename(folder / f"{name}.yaml")
    assert main([str(folder), "--quiet"]) == 1
    out = capsys.readouterr().out
    assert out.index("thinner ground store: storeroom 0.3") < out.index("thin ground store: storeroom 0.5")


def test_a_plan_that_cannot_be_read_is_named_and_the_others_are_checked(tmp_path, capsys):
    folder = write_project(tmp_path / "plans", (shed("good"), (0, 0), 0), (shed("bad"), (50, 0), 0))
    (folder / "bad.yaml").write_text("levels: 3")
    assert main([str(folder), "--quiet"]) == 1
    captured = capsys.readouterr()
    assert "bad.yaml: TypeError" in captured.err and "1 buildings, 1 levels" in captured.out


def test_nothing_to_check(tmp_path, capsys):
    assert main([str(tmp_path)]) == 2
    assert main([str(tmp_path / "absent")]) == 2
