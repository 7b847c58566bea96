"""Measures of the judge for homes: each has a room that passes and one that fails."""

from __future__ import annotations

import numpy as np
import pytest

from judged_floor import Judged, house
from judging.drawn import Drawn, fixture_of
from judging.ifc import read_ifc
from judging.table import MEASURES

UNIT = (0.6, 0.6, 0.9)
TALL = (0.6, 0.6, 1.85)


def kitchen(*units: tuple[str, float, float], width: float = 4.0, depth: float = 3.0) -> Judged:
    """A kitchen with units at its south wall, their middles at the given metres along it; or elsewhere, facing north."""
    made = house("kitchen", width, depth)
    for kind, x, y in units:
        made.piece(kind, x, y, "north", TALL if kind == "fridge" else UNIT)
    return made


RUN = [("fridge", 0.3, 0.3), ("worktop", 0.9, 0.3), ("sink_unit", 1.5, 0.3), ("dishwasher", 2.1, 0.3), ("cooker", 2.7, 0.3)]


def bedroom(width: float, depth: float, bed: str = "double_bed", size=(1.6, 2.0, 0.6)) -> Judged:
    return house("bedroom", width, depth).piece(bed, width / 2, size[1] / 2, "north", size)


def flat(bed: str, other: str) -> Judged:
    """A bedroom of 16 m² and a smaller one of 12 m², joined by a door."""
    made = house("bedroom", 4.0, 4.0).room("102", "bedroom", 3.0, 4.0, west=4.2)
    made.opening("d", "door", "passage", [("101", 1, 1.0, 1.9), ("102", 3, 1.0, 1.9)])
    return made.piece(bed, 1.0, 1.0, "north", (1.0, 2.0, 0.6)).piece(other, 6.0, 1.0, "north", (1.6, 2.0, 0.6), room="102")


def swinging(bed_y: float) -> Judged:
    """A leaf of 0.9 m that swings in from the south wall; a bed north of it."""
    made = house("bedroom", 4.0, 5.0).piece("double_bed", 1.5, bed_y, "south", (1.6, 2.0, 0.6))
    return made.opening("d", "door", "door", [("101", 0, 1.0, 1.9)], leaf=((1.0, 0.0), (1.9, 0.0), (1.0, 0.9)))


def living(*pieces: tuple) -> Judged:
    made = house("living_room", 5.0, 5.0).piece("sofa", 2.5, 0.5, "north", (2.0, 0.9, 0.8))
    for piece in pieces:
        made.piece(*piece)
    return made


def stand(*pieces: tuple) -> Judged:
    made = house("living_room", 5.0, 5.0).piece("tv_stand", 2.5, 4.7, "south", (1.6, 0.45, 0.5))
    for piece in pieces:
        made.piece(*piece)
    return made


TV = (1.1, 0.2, 0.7)
CORNER = [("armchair", 1.0, 4.0, "south", (0.8, 0.8, 0.8)), ("floor_lamp", 1.8, 4.5, "south", (0.3, 0.3, 1.6)),
          ("bookshelf", 4.0, 4.8, "south", (0.8, 0.3, 1.8))]


def table(chair_y: float, facing: str) -> Judged:
    made = house("dining_room").piece("dining_table", 2.0, 2.0, "south", (1.6, 0.9, 0.75))
    return made.piece("dining_chair", 2.0, chair_y, facing, (0.45, 0.5, 0.9))


def rows(gap: float) -> Judged:
    seat = (0.5, 0.6, 0.9)
    made = house("auditorium").piece("auditorium_seat", 1.0, 2.0, "north", seat)
    return made.piece("auditorium_seat", 1.5 + gap, 2.0, "north", seat)


def hall(width: float, cabinets: int) -> Judged:
    made = house("corridor", 6.0, width)
    for number in range(cabinets):
        made.piece("shoe_cabinet", 1.0 + 2 * number, 0.2, "north", (0.8, 0.35, 1.0))
    return made


HOUSEHOLDS = {"couple": 2, "single": 1, "family_2": 4, "shared_flat": 2}
DOUBLE, SINGLE = ("double_bed", (1.6, 2.0, 0.6)), ("single_bed", (0.9, 2.0, 0.6))


def dwelling(household: str, beds: tuple, *pieces: tuple, other: str = "living_room", bedrooms: int = 1) -> Judged:
    """A kitchen (101), a bedroom of 16 m² (102) with beds and a living room (103), joined by doors."""
    who = {"household": {"id": household, "persons": HOUSEHOLDS[household], "bedrooms": bedrooms}}
    made = house("kitchen", 4.0, 3.0, **who).room("102", "main_bedroom", 4.0, 4.0, 4.2, **who).room("103", other, 5.0, 4.0, 8.4, **who)
    made.opening("d", "door", "passage", [("101", 1, 1.0, 1.9), ("102", 3, 1.0, 1.9)])
    made.opening("e", "door", "passage", [("102", 1, 1.0, 1.9), ("103", 3, 1.0, 1.9)])
    for number, (kind, size) in enumerate(beds):
        made.piece(kind, 5.0 + 2 * number, 1.0, "north", size, room="102")
    for kind, room, size in pieces:
        made.piece(kind, {"101": 2.0, "102": 5.0, "103": 10.0}[room], 3.5, "south", size, room=room)
    return made


def seated(chairs: int) -> Judged:
    chair = ("dining_chair", "103", (0.45, 0.5, 0.9))
    return dwelling("couple", [DOUBLE], ("dining_table", "103", (1.6, 0.9, 0.75)), *[chair] * chairs)


def bath(kind: str, x: float, size: tuple, width: float) -> Judged:
    """A bathroom with a tub or shower at its north wall."""
    return house("bathroom", width, 3.0).piece(kind, x, 3.0 - size[1] / 2, "south", size)


TUB, SHOWER = (1.7, 0.75, 0.6), (0.9, 0.9, 2.0)

# By code: a room that passes, and one that fails.
CASES = {
    "kitchen_runs": (kitchen(*RUN), kitchen(("fridge", 0.3, 0.3), ("sink_unit", 2.0, 0.3), ("cooker", 3.7, 0.3))),
    "kitchen_loose_units": (kitchen(*RUN, ("worktop", 3.7, 2.5)),
                            kitchen(("worktop", 0.3, 0.3), ("sink_unit", 2.0, 0.3), ("cooker", 3.7, 0.3))),
    "kitchen_appliance_alone": (kitchen(*RUN), kitchen(*RUN[1:], ("fridge", 0.3, 2.6))),
    "kitchen_dishwasher": (kitchen(*RUN), kitchen(("sink_unit", 0.3, 0.3), ("worktop", 0.9, 0.3), ("dishwasher", 1.5, 0.3))),
    "kitchen_worktop": (kitchen(*RUN), kitchen(("sink_unit", 0.3, 0.3), ("cooker", 0.9, 0.3))),
    "kitchen_fridge_at_cooker": (kitchen(*RUN), kitchen(("fridge", 0.3, 0.3), ("cooker", 0.9, 0.3))),
    "kitchen_end_gap": (kitchen(*RUN, width=3.0), kitchen(*RUN, width=3.3)),
    "bath_corner": (bath("shower", 0.45, SHOWER, 3.0), bath("shower", 1.0, SHOWER, 3.0)),
    "bath_niche": (bath("bathtub", 0.85, TUB, 1.8), bath("bathtub", 0.85, TUB, 2.0)),
    "bed_along_wall": (house("bedroom", 3.0, 4.0).piece("single_bed", 0.45, 1.0, "north", SINGLE[1]), bedroom(3.0, 4.0, *SINGLE)),
    "before_screen": (stand(("club_chair", 2.5, 3.0, "north", (0.8, 0.8, 0.8))), stand(("club_chair", 2.5, 3.9, "north", (0.8, 0.8, 0.8)))),
    "living_without_screen_or_corner": (living(*CORNER), living()),
    "empty_tv_stand": (stand(("tv", 2.5, 4.7, "south", TV, 0.5, "101", "tv_stand.1")), stand()),
    "sofa_past_screen": (living(("wall_tv", 2.5, 4.9, "south", TV, 1.0)), living(("wall_tv", 0.1, 0.5, "east", TV, 1.0))),
    "single_in_larger_bedroom": (flat("double_bed", "single_bed"), flat("single_bed", "double_bed")),
    "bedroom_without_wardrobe": (bedroom(3.0, 4.0).piece("wardrobe", 0.6, 3.7, "south", (1.2, 0.6, 2.0)), bedroom(3.0, 4.0)),
    "bedroom_without_bed": (bedroom(3.0, 4.0), house("bedroom", 3.0, 4.0)),
    "dwelling_living_room": (dwelling("couple", [DOUBLE], ("tv", "103", TV)), dwelling("couple", [DOUBLE])),
    "dwelling_double_bed": (dwelling("single", [DOUBLE]), dwelling("single", [SINGLE])),
    "dwelling_beds": (dwelling("couple", [SINGLE, SINGLE]), dwelling("family_2", [SINGLE, SINGLE])),
    "dwelling_children": (dwelling("family_2", [DOUBLE], ("toy", "103", UNIT)), dwelling("couple", [DOUBLE], ("toy", "103", UNIT))),
    "dwelling_chairs": (seated(2), seated(1)),
    "dwelling_desks": (dwelling("shared_flat", [SINGLE], ("small_desk", "102", UNIT)), dwelling("shared_flat", [SINGLE])),
    "bed_at_swing": (swinging(3.0), swinging(2.2)),
    "bed_before_door": (swinging(2.0), swinging(1.5)),
    "bare_wall": (house("bedroom", 2.9, 2.9), house("bedroom", 3.5, 2.0)),
    "bare_hall_wall": (house("corridor", 6.0, 1.5).piece("picture", 3.1, 0.02, "north", (0.5, 0.03, 0.5), 1.4)
                       .piece("hall_mirror", 3.0, 1.48, "south", (0.5, 0.03, 1.5)), house("corridor", 6.0, 1.5)),
    "hall_narrow": (house("corridor", 4.0, 1.0), hall(1.0, 1)),
    "hall_wide": (hall(1.8, 1), hall(1.8, 0)),
    "hall_room": (hall(3.0, 2), hall(3.0, 1)),
    "chair_away": (table(1.2, "north"), table(1.2, "south")),
    "row_seat_alone": (rows(0.02), rows(0.5)),
}


@pytest.mark.parametrize("code", CASES)
def test_a_measure_tells_the_room_that_passes_from_the_one_that_fails(code, tmp_path):
    passing, failing = (made.read(tmp_path) for made in CASES[code])
    judge = MEASURES[code].judge
    assert judge(passing).faults == ()
    assert judge(failing).faults != ()


def test_a_bed_is_closed_by_a_jog_and_by_its_twin_at_the_wall(tmp_path):
    judge = MEASURES["bed_along_wall"].judge
    alone = ("single_bed", 2.0, 1.0, "north", SINGLE[1])
    assert judge(house("bedroom").piece(*alone).read(tmp_path)).faults != ()
    for depth, is_closed in ((0.6, True), (0.4, False)):
        jog = house("bedroom").piece(*alone).piece("wardrobe", 2.9, depth / 2, "north", (0.9, depth, 2.0)).read(tmp_path)
        assert (judge(jog).faults == ()) == is_closed
    for between, is_closed in ((1.07, True), (1.4, False)):
        twins = house("bedroom").piece("single_bed", 0.45, 1.0, "north", SINGLE[1])
        twins.piece("single_bed", 1.35 + between, 1.0, "north", SINGLE[1])
        assert (judge(twins.read(tmp_path)).faults == ()) == is_closed


def test_a_bed_is_no_nearer_to_a_leaf_than_it_must_be(tmp_path):
    """A leaf of 0.9 m swings into a room with a double bed: only where there is another place for it, that is a fault."""
    def fails(depth: float) -> bool:
        made = house("bedroom", 2.6, depth).piece("double_bed", 1.8, depth - 1.0, "south", (1.6, 2.0, 0.6))
        made.opening("d", "door", "door", [("101", 0, 1.0, 1.9)], leaf=((1.0, 0.0), (1.9, 0.0), (1.0, 0.9)))
        return MEASURES["bed_at_swing"].judge(made.read(tmp_path)).faults != ()

    # Across the room a bed of 1.6 m is clear of the leaf from 0.9 + 0.75 + 1.6 = 3.25 m on.
    assert not fails(3.2)
    assert fails(3.3)


def test_a_bed_for_one_stands_along_a_wall_where_doors_leave_one(tmp_path):
    def fails(door: tuple[float, float]) -> bool:
        made = house("bedroom", 2.5, 3.2).piece("single_bed", 1.2, 1.0, "north", SINGLE[1])
        made.opening("w", "door", "door", [("101", 3, 0.7, 1.7)]).opening("e", "door", "door", [("101", 1, *door)])
        return MEASURES["bed_along_wall"].judge(made.opening("n", "door", "door", [("101", 2, 0.8, 1.7)]).read(tmp_path)).faults != ()

    assert fails((0.0, 0.3)), "at the east wall"
    assert not fails((0.7, 1.7)), "doors in the middles of three walls, and of the fourth 1 m is left"


def test_a_row_of_units_that_ends_at_a_jog_loses_no_wall(tmp_path):
    """A post of 0.2 m beside the row closes its back; one that stands off does not."""
    def fails(gap: float) -> bool:
        made = kitchen(*RUN, width=3.5)
        made.piece("cabinet", 3.0 + gap + 0.05, 0.1, "north", (0.1, 0.2, 2.0))
        return MEASURES["kitchen_end_gap"].judge(made.read(tmp_path)).faults != ()

    assert fails(0.3)
    assert not fails(0.02)


def test_a_larger_bedroom_with_two_single_beds_is_for_two(tmp_path):
    judge = MEASURES["single_in_larger_bedroom"].judge
    twin = flat("single_bed", "double_bed").piece("single_bed", 3.0, 1.0, "north", (1.0, 2.0, 0.6))
    assert judge(flat("single_bed", "double_bed").read(tmp_path)).faults != ()
    assert judge(twin.read(tmp_path)).faults == ()


@pytest.mark.parametrize("code", ["dwelling_beds", "dwelling_double_bed"])
def test_who_sleeps_on_other_floors_has_beds_there(code, tmp_path):
    judge = MEASURES[code].judge
    assert judge(dwelling("couple", [SINGLE]).read(tmp_path)).faults != ()
    assert judge(dwelling("couple", [SINGLE], bedrooms=3).read(tmp_path)) is None


@pytest.mark.parametrize("code", ["kitchen_runs", "living_without_screen", "bedroom_without_bed", "chair_away"])
def test_a_measure_leaves_out_rooms_that_it_is_not_for(code, tmp_path):
    assert MEASURES[code].judge(house("storeroom").read(tmp_path)) is None


def test_worktop_between_sink_and_cooker_is_measured_around_a_corner(tmp_path):
    made = kitchen(("sink_unit", 0.9, 0.3), ("corner_unit", 0.3, 0.3)).piece("worktop", 0.3, 0.9, "east", UNIT)
    room = made.piece("cooker", 0.3, 1.5, "east", UNIT).read(tmp_path)
    assert MEASURES["kitchen_worktop"].judge(room).value == pytest.approx(1.2)


def test_a_dwelling_whose_plan_names_no_living_room_is_not_asked_for_one(tmp_path):
    judge = MEASURES["dwelling_living_room"].judge
    assert judge(dwelling("couple", [DOUBLE], other="bedroom").read(tmp_path)) is None
    assert judge(dwelling("couple", [DOUBLE], other="room").read(tmp_path)).faults != ()
    two = dwelling("couple", [DOUBLE], ("tv", "103", TV)).room("104", "living_room", 4.0, 4.0, 13.6)
    two.opening("f", "door", "passage", [("103", 1, 1.0, 1.9), ("104", 3, 1.0, 1.9)]).piece("tv", 15.0, 3.5, "south", TV, room="104")
    assert judge(two.read(tmp_path)).faults != ()


def test_a_hall_is_judged_by_its_width(tmp_path):
    room = hall(1.4, 1).read(tmp_path)
    assert MEASURES["hall_middling"].judge(room).value == pytest.approx(0.8 * 0.35 / (6.0 * 1.4))
    assert all(MEASURES[code].judge(room) is None for code in ("hall_wide", "hall_room"))


def test_a_piece_may_stand_at_the_end_of_a_narrow_hall_and_not_at_its_side(tmp_path):
    judge, cabinet = MEASURES["hall_narrow"].judge, (0.8, 0.35, 1.0)
    at_the_end = judge(house("corridor", 6.0, 1.0).piece("shoe_cabinet", 0.2, 0.5, "east", cabinet).read(tmp_path))
    assert at_the_end.faults == () and at_the_end.value == pytest.approx(6.0, abs=0.01)
    at_the_side = judge(house("corridor", 6.0, 1.0).piece("shoe_cabinet", 3.0, 0.2, "north", cabinet).read(tmp_path))
    assert [fault.measured for fault in at_the_side.faults] == [pytest.approx(1.0, abs=0.01)]


@pytest.mark.parametrize(("beyond", "faults"), [("kitchen", 0), ("stairs", 1)])
def test_a_hall_goes_on_past_an_open_side_and_not_onto_stairs(tmp_path, beyond, faults):
    made = house("corridor", 1.0, 6.0).room("102", beyond, 4.0, 6.0, west=1.0)
    made.opening("o", "door", "open", [("101", 1, 0.0, 6.0), ("102", 3, 0.0, 6.0)])
    room = made.piece("shoe_cabinet", 0.2, 3.0, "east", (0.8, 0.35, 1.0)).read(tmp_path)
    assert len(MEASURES["hall_narrow"].judge(room).faults) == faults


def test_living_rooms_without_a_screen_are_counted_and_no_fault(tmp_path):
    judge = MEASURES["living_without_screen"].judge
    answers = [judge(living(*pieces).read(tmp_path)) for pieces in ([("tv", 2.5, 4.5, "south", TV)], CORNER)]
    assert [(answer.value, answer.faults) for answer in answers] == [(0.0, ()), (1.0, ())]


def test_units_by_area(tmp_path):
    assert MEASURES["kitchen_length"].judge(kitchen(*RUN).read(tmp_path)).value == pytest.approx(3.0 / 12.0)


# --- architects' drawings ---


def drawn_toilet(x: float, y: float, rotation: float) -> Drawn:
    size = {"width": {"value": 70.0}, "length": {"value": 40.0}}
    return fixture_of({"type": "toilet", "x": x * 100, "y": y * 100, "rotation": rotation, "properties": size}, 0.01)


@pytest.mark.parametrize("drawn, agrees", [(drawn_toilet(0.35, 1.0, 0.0), True), (drawn_toilet(1.0, 0.35, 90.0), False)])
def test_the_wall_of_a_fixture_is_compared_with_the_architects(drawn, agrees, tmp_path):
    room = house("bathroom", 2.0, 3.0).piece("toilet", 0.35, 2.0, "east", (0.4, 0.7, 0.8)).read(tmp_path)
    room.drawn.append(drawn)
    answer = MEASURES["toilet_wall"].judge(room)
    assert (not answer.faults) == agrees
    # A wall of 2 or 3 m of 10 m.
    assert answer.value == pytest.approx(0.3 if agrees else 0.2)


def test_drawings_are_in_metres(tmp_path):
    assert np.allclose(drawn_toilet(0.35, 1.0, 90.0).center, (0.35, 1.0))
    assert drawn_toilet(0.35, 1.0, 90.0).shape.bounds == pytest.approx((0.15, 0.65, 0.55, 1.35))


def test_the_furniture_of_an_ifc_file_has_its_place_and_box(tmp_path):
    """A cabinet of 1 x 0.6 m, turned by a right angle, on a storey; and one that hangs."""
    def product(first: int, name: str, lift: float) -> str:
        return f"""#{first}= IFCFURNISHINGELEMENT('x',#1,'{name}',$,'',#{first + 1},#{first + 4},'');
#{first + 1}= IFCLOCALPLACEMENT(#10,#{first + 2});
#{first + 2}= IFCAXIS2PLACEMENT3D(#{first + 3},#21,#22);
#{first + 3}= IFCCARTESIANPOINT((2.,3.,{lift}));
#{first + 4}= IFCPRODUCTDEFINITIONSHAPE($,$,(#30));
"""
    (tmp_path / "house.ifc").write_text("""#5= IFCBUILDINGSTOREY('x',#1,'Level 1',$,$,#10,$,$,.ELEMENT.,0.);
#10= IFCLOCALPLACEMENT($,#11);
#11= IFCAXIS2PLACEMENT3D(#12,$,$);
#12= IFCCARTESIANPOINT((10.,0.,0.));
#21= IFCDIRECTION((0.,0.,1.));
#22= IFCDIRECTION((0.,1.,0.));
#30= IFCSHAPEREPRESENTATION(#31,'Body','MappedRepresentation',(#32));
#31= IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#11,$);
#32= IFCMAPPEDITEM(#33,#36);
#33= IFCREPRESENTATIONMAP(#11,#34);
#34= IFCSHAPEREPRESENTATION(#31,'Body','Brep',(#35));
#35= IFCPOLYLOOP((#38,#39));
#36= IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#37,1.,$);
#37= IFCCARTESIANPOINT((0.,0.,0.));
#38= IFCCARTESIANPOINT((-0.5,-0.3,0.));
#39= IFCCARTESIANPOINT((0.5,0.3,0.9));
""" + product(50, "M_Base Cabinet", 0.0) + product(60, "M_Upper Cabinet", 1.4) + product(70, "M_Base Cabinet on a wall", 1.4))
    [(place, pieces)] = read_ifc(tmp_path / "house.ifc").items()
    assert place == ("house", "level_1") and [piece.name for piece in pieces] == ["kitchen"]
    assert pieces[0].center == pytest.approx((12.0, 3.0)) and pieces[0].size == pytest.approx((1.0, 0.6))
    assert pieces[0].shape.bounds == pytest.approx((11.7, 2.5, 12.3, 3.5))
