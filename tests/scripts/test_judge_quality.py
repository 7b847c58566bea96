"""The judge's measures of QUALITY's codes: each has a room that passes and one that fails."""

from __future__ import annotations

import numpy as np
import pytest

from judged_floor import TURNS, Judged, house
from judging.table import MEASURES

DESK, CHAIR, BED = (1.4, 0.7, 0.74), (0.6, 0.6, 1.0), (1.6, 2.0, 0.6)
DOOR = ("d", "door", "door", [("101", 0, 1.0, 1.9)])


def boxes(*places: tuple[float, float, float]) -> Judged:
    made = house("storeroom")
    for x, y, lift in places:
        made.piece("cabinet", x, y, "south", (1.0, 0.4, 0.8), lift)
    return made


def on_table(x: float) -> Judged:
    """A lamp of 0.2 m on a table of 1 m from 1.5 to 2.5."""
    made = house("living_room").piece("coffee_table", 2.0, 2.0, "south", (1.0, 0.6, 0.4))
    return made.piece("table_lamp", x, 2.0, "south", (0.2, 0.2, 0.4), 0.4, on="coffee_table.1")


def at_door(y: float) -> Judged:
    return house("bedroom").opening(*DOOR).piece("dresser", 1.5, y, "north", (1.0, 0.4, 0.8))


def passage(gap: float) -> Judged:
    """Shelves from both walls leave a gap between door and bed."""
    shelf = ((4.0 - gap) / 2, 0.4, 2.0)
    made = house("bedroom", 4.0, 6.0).opening("d", "door", "passage", [("101", 0, 1.5, 2.4)])
    made.piece("shelf", shelf[0] / 2, 2.0, "north", shelf).piece("shelf", 4.0 - shelf[0] / 2, 2.0, "north", shelf)
    return made.piece("double_bed", 2.0, 5.0, "south", BED)


def wardrobe(distance: float) -> Judged:
    """A wardrobe at the north wall and a box at a distance before its front."""
    made = house("bedroom").piece("wardrobe", 2.0, 3.7, "south", (1.2, 0.6, 2.0))
    return made.piece("dresser", 2.0, 3.4 - distance - 0.2, "south", (1.0, 0.4, 0.8))


def talk(gap: float) -> Judged:
    made = house("living_room").piece("sofa", 2.0, 0.5, "north", (2.0, 0.9, 0.8))
    return made.piece("coffee_table", 2.0, 0.95 + gap + 0.3, "north", (1.0, 0.6, 0.4))


def picture(lift: float) -> Judged:
    return house("living_room").piece("picture", 2.0, 3.98, "south", (0.8, 0.04, 0.6), lift)


def watched(distance: float) -> Judged:
    made = house("living_room", 4.0, 8.0).piece("wall_tv", 2.0, 7.95, "south", (1.1, 0.1, 0.65), 1.0)
    return made.piece("sofa", 2.0, 7.9 - distance, "north", (2.0, 0.9, 0.8))


def window(height: float) -> Judged:
    made = house("bedroom").opening("w", "window", "window", [("101", 2, 1.0, 3.0)], sill=0.9, height=1.2)
    return made.piece("wardrobe", 2.0, 3.7, "south", (1.2, 0.6, height))


def desk(facing: str) -> Judged:
    made = house("study").piece("desk", 2.0, 3.0, "south", DESK)
    made.piece("office_chair", 2.0, 2.3, facing, CHAIR)
    made.floor.find("office_chair.1@101")["extras"]["parent"] = "desk.1"
    return made


def bath(x: float) -> Judged:
    made = house("bathroom", 3.0, 3.0).piece("toilet", 0.5, 2.66, "south", (0.38, 0.66, 0.8))
    return made.piece("shower", x, 1.7, "east", (0.9, 0.9, 2.0))


def crowd(*middles: tuple[float, float]) -> Judged:
    made = house("living_room", 8.0, 4.0)
    for x, y in middles:
        made.piece("bookshelf", x, y, "north", (0.8, 0.3, 1.8))
    return made


def turned(degrees: float) -> Judged:
    TURNS["aslant"] = np.pi + np.radians(degrees)
    return house("bedroom").piece("wardrobe", 2.0, 0.36, "aslant", (1.2, 0.6, 2.0))


def sleeper(x: float) -> Judged:
    return house("bedroom").piece("double_bed", x, 1.0, "north", BED)


def laptop() -> Judged:
    made = house("study").piece("desk", 2.0, 2.0, "south", DESK)
    return made.piece("laptop", 2.0, 2.0, "south", (0.3, 0.2, 0.2), 0.74, on="desk.1")


def shelves(requested: int) -> Judged:
    return house("storeroom", requested=requested).piece("shelf", 1.0, 0.2, "north", (0.8, 0.4, 1.8))


def filled(width: float) -> Judged:
    return house("living_room").piece("sofa", 2.0, 0.6, "north", (width, 1.0, 0.8))


def galley(aisle: float) -> Judged:
    made = house("kitchen").piece("sink_unit", 2.0, 0.3, "north", (0.6, 0.6, 0.9))
    return made.piece("cooker", 2.0, 0.9 + aisle, "south", (0.6, 0.6, 0.9))


def stacks(aisle: float) -> Judged:
    made = house("library").piece("library_shelf", 2.0, 0.2, "north", (2.0, 0.4, 2.0))
    return made.piece("library_shelf", 2.0, 0.6 + aisle, "south", (2.0, 0.4, 2.0))


def seat(space: float) -> Judged:
    """A chair half under its table, and a sideboard at a distance from the table's edge."""
    made = house("dining_room").piece("dining_table", 2.0, 3.0, "south", (1.6, 0.8, 0.75))
    made.piece("dining_chair", 2.0, 2.6, "north", (0.45, 0.5, 0.9))
    made.floor.find("dining_chair.1@101")["extras"]["parent"] = "dining_table.1"
    return made.piece("sideboard", 2.0, 2.6 - space - 0.2, "north", (1.6, 0.4, 0.8))


def chairs(distance: float) -> Judged:
    made = house("living_room", 4.0, 6.0).piece("sofa", 2.0, 0.5, "north", (2.0, 0.9, 0.8))
    return made.piece("armchair", 2.0, 0.5 + distance, "south", (0.8, 0.8, 0.8))


# Measures that tell how often something is so, and which no room fails.
DISTRIBUTIONS = {"kitchen_length", "hall_middling", "living_without_screen", "walkable_rate"}
# By code: a room that passes, and one that fails.
CASES = {
    "collision": (boxes((1.0, 1.0, 0), (2.0, 1.0, 0)), boxes((1.0, 1.0, 0), (1.5, 1.0, 0))),
    "out_of_room": (boxes((0.5, 1.0, 0)), boxes((0.4, 1.0, 0))),
    "floating": (boxes((1.0, 1.0, 0), (1.0, 1.0, 0.8)), boxes((1.0, 1.0, 0), (1.0, 1.0, 0.9))),
    "unsupported": (on_table(2.0), on_table(2.45)),
    "door_blocked": (at_door(2.0), at_door(0.8)),
    "unreachable": (passage(0.42), passage(0.25)),
    "way_narrow": (passage(0.5), passage(0.42)),
    "blocked_use": (wardrobe(0.7), wardrobe(0.5)),
    "tight_use": (wardrobe(1.0), wardrobe(0.7)),
    "kitchen_aisle": (galley(1.1), galley(0.8)),
    "library_aisle": (stacks(1.0), stacks(0.7)),
    "behind_seat": (seat(0.9), seat(0.5)),
    "talk": (chairs(2.0), chairs(4.0)),
    "sofa_to_table": (talk(0.45), talk(0.7)),
    "art_height": (picture(1.2), picture(1.6)),
    "tv_position": (watched(3.0), watched(6.0)),
    "window_blocked": (window(0.9), window(2.0)),
    "facing": (desk("north"), desk("south")),
    "wet_room": (bath(2.5), bath(0.5)),
    "bedside": (sleeper(2.0), sleeper(0.8)),
    "crowded_half": (crowd((1.0, 0.2), (7.0, 3.8)), crowd((1.0, 0.2), (2.0, 3.8))),
    "crooked": (turned(0.0), turned(8.0)),
    "missing_required": (house("toilet", 1.0, 2.0).piece("toilet", 0.5, 1.66, "south", (0.38, 0.66, 0.8)),
                         house("toilet", 1.0, 2.0).piece("mirror", 0.5, 1.97, "south", (0.5, 0.04, 0.5), 1.3)),
    "unfulfilled": (shelves(1), shelves(4)),
    "sparse": (filled(3.0), filled(1.0)),
    "empty_surfaces": (laptop(), house("study").piece("desk", 2.0, 2.0, "south", DESK)),
}


@pytest.mark.parametrize("code", CASES)
def test_a_measure_tells_the_room_that_passes_from_the_one_that_fails(code, tmp_path):
    passing, failing = (made.read(tmp_path) for made in CASES[code])
    judge = MEASURES[code].judge
    assert judge(passing).faults == ()
    assert judge(failing).faults != ()


def test_every_measure_of_the_table_has_cases():
    import test_judge_homes

    walls = {code for code in MEASURES if code.endswith("_wall") and code not in ("bare_wall", "bare_hall_wall")}
    assert MEASURES.keys() == CASES.keys() | test_judge_homes.CASES.keys() | walls | DISTRIBUTIONS


def test_a_chair_under_its_table_collides_with_nothing_of_it(tmp_path):
    made = house("dining_room").piece("dining_table", 2.0, 2.0, "south", (1.6, 0.9, 0.75))
    made.piece("dining_chair", 2.0, 1.7, "north", (0.45, 0.5, 0.9))
    # Two solid boxes do collide: that the measure looks at triangles is what makes the real chair pass.
    assert MEASURES["collision"].judge(made.read(tmp_path)).faults


def test_an_open_boundary_that_ends_at_another_is_walked_around(tmp_path):
    """Furniture near the corner of two open boundaries closes no way: people come around it through the next room."""
    made = house("living_dining").piece("sofa", 2.0, 0.5, "north", (2.0, 0.9, 0.8))
    for name, wall in (("s", 1), ("t", 2)):
        made.opening(name, "door", "open", [("101", wall, 0.01, 3.99)])
    made.piece("bookshelf", 3.5, 3.5, "west", (0.8, 0.8, 1.8))
    assert MEASURES["way_narrow"].judge(made.read(tmp_path)).faults == ()


def test_a_lamp_of_the_ceiling_takes_no_light(tmp_path):
    made = window(0.9).piece("pendant", 2.0, 3.7, "south", (0.8, 0.4, 0.6), 1.9)
    assert MEASURES["window_blocked"].judge(made.read(tmp_path)).faults == ()


def test_a_seat_with_a_lamp_and_books_of_its_own_is_in_no_talk(tmp_path):
    made = chairs(4.0).piece("floor_lamp", 2.8, 4.5, "south", (0.3, 0.3, 1.5))
    assert MEASURES["talk"].judge(made.read(tmp_path)).faults != ()
    made.piece("bookshelf", 3.0, 5.8, "south", (0.8, 0.3, 1.8))
    assert MEASURES["talk"].judge(made.read(tmp_path)) is None


def test_who_sits_behind_the_sofa_is_in_no_talk(tmp_path):
    made = house("living_room", 4.0, 8.0).piece("sofa", 2.0, 4.0, "south", (2.0, 0.9, 0.8))
    assert MEASURES["talk"].judge(made.piece("armchair", 2.0, 7.5, "south", (0.8, 0.8, 0.8)).read(tmp_path)) is None


def test_the_tap_of_a_low_piece_takes_no_light_and_a_wide_one_does(tmp_path):
    for width, count in ((0.12, 0), (0.4, 1)):
        made = window(0.9).piece("washbasin", 2.0, 3.7, "south", (width, 0.15, 0.3), 0.9)
        assert len(MEASURES["window_blocked"].judge(made.read(tmp_path)).faults) == count


def test_a_hall_where_nothing_should_stand_is_not_sparse(tmp_path):
    judged = [MEASURES["sparse"].judge(house("corridor", width, 5.0).read(tmp_path)) for width in (1.1, 1.3)]
    assert judged[0] is None and judged[1].faults != ()


def test_the_floor_behind_a_closed_way_is_not_walkable(tmp_path):
    # Free floor: 2 m of 6 before the shelves and nearly all of the rest behind them.
    assert MEASURES["walkable_rate"].judge(passage(1.0).read(tmp_path)).value == pytest.approx(1.0)
    assert 0.2 < MEASURES["walkable_rate"].judge(passage(0.2).read(tmp_path)).value < 0.5


def test_what_hangs_flat_on_a_wall_is_in_nobodys_way(tmp_path):
    made = wardrobe(1.5).piece("towel_rail", 2.0, 3.0, "south", (0.6, 0.1, 0.4), 0.9)
    assert MEASURES["blocked_use"].judge(made.read(tmp_path)).faults != ()
    hung = house("bedroom", 4.0, 1.25).piece("wardrobe", 2.0, 0.95, "south", (1.2, 0.6, 2.0))
    hung.piece("towel_rail", 2.0, 0.05, "north", (0.6, 0.1, 0.4), 0.9)
    assert MEASURES["blocked_use"].judge(hung.read(tmp_path)).faults == ()
