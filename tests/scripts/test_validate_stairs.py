"""Stairs as validate.py measures them: faults beside their smallest neighbours."""

import numpy as np
import pytest
from stairs_house import (CEILING, DEPTH, EAST, FOOT, GOING, HEAD, RISES, STOREY, WHOLE, Storey, around, balustrade, block, ground,
                          sloped, steps, upper, write_house)

from roomwright import validate
from roomwright.checks.bodies import solids_of
from roomwright.checks.stairs import check_stairs
from roomwright.checks.storeys import check_storeys
from roomwright.checks.undersides import Undersides, area_above
from roomwright.gltf_file import GltfFile


def faults(storey: Storey, folder) -> list[str]:
    notes = list(check_stairs(GltfFile(storey.write(folder / "level.glb"))))
    assert all((note.code, note.node) == ("stairs", "stairs@hall") for note in notes)
    return [note.message for note in notes]


def faults_of_house(folder, *storeys: Storey) -> list[str]:
    found = check_storeys(write_house(folder, *storeys))
    assert all((fault.code, fault.node) == ("stairs", "stairs@hall") for fault in found), found
    return [fault.message for fault in found]


def test_a_house_with_a_flight_has_no_fault(tmp_path):
    assert faults(ground(), tmp_path) == [] and faults(upper(), tmp_path) == []
    assert faults_of_house(tmp_path, ground(), upper()) == []


class TestSteps:
    """Steps against each other and the floor."""

    @pytest.mark.parametrize(("rise", "is_sound"), [(0.21, True), (0.213, False)])
    def test_no_step_is_higher_than_21_centimetres(self, tmp_path, rise, is_sound):
        found = faults(ground(steps(rise), height=rise * RISES), tmp_path)
        assert found == ([] if is_sound else ["step 1 of 14 is 213 mm high"])

    def test_the_floor_above_is_the_last_step(self, tmp_path):
        found = faults(ground(height=STOREY + 0.2), tmp_path)
        assert found == ["step 14 of 14 is 400 mm high", "its steps are from 200 to 400 mm high"]

    @pytest.mark.parametrize(("lower", "is_sound"), [(0.002, True), (0.01, False)])
    def test_steps_are_equally_high(self, tmp_path, lower, is_sound):
        bodies = steps()
        bodies[4][4:, 2] -= lower
        assert faults(ground(bodies), tmp_path) == ([] if is_sound else ["its steps are from 190 to 210 mm high"])

    @pytest.mark.parametrize(("aside", "is_sound"), [(0.01, True), (0.1, False)])
    def test_steps_follow_each_other_without_gaps(self, tmp_path, aside, is_sound):
        bodies = [body + ((0.0, aside, 0.0) if number >= 6 else 0.0) for number, body in enumerate(steps())]
        assert faults(ground(bodies), tmp_path) == ([] if is_sound else ["step 7 is 0.100 m beside the one before it"])

    def test_a_landing_of_two_pieces_is_one_step(self, tmp_path):
        bodies = steps()
        landing = bodies.pop(6)
        bodies += [landing * (0.49, 1.0, 1.0), landing * (0.5, 1.0, 1.0) + (EAST / 2, 0.0, 0.0)]
        assert faults(ground(bodies), tmp_path) == []

    def test_a_floor_is_before_the_first_step(self, tmp_path):
        found = faults(ground(floor=around(FOOT - 0.5)), tmp_path)
        assert len(found) == 1 and found[0].startswith("no floor is before its first step")

    def test_what_is_as_high_as_a_storey_has_steps(self, tmp_path):
        rail = block((0.9, FOOT, 0.0), (0.95, HEAD, 1.0))
        assert faults(ground([rail]), tmp_path) == ["it is 2.800 m high and has no steps"]
        assert faults(ground([rail], height=1.0), tmp_path) == []


class TestDoors:
    """Steps and holes before doors."""

    # The western wall runs from north to south.
    @pytest.mark.parametrize(("south", "north", "count"), [(0.1, 0.9, 0), (0.2, 1.1, 1), (1.3, 2.2, 4)])
    def test_steps_keep_away_from_doors(self, tmp_path, south, north, count):
        storey = ground()
        storey.door("west", 3, DEPTH - north, DEPTH - south)
        found = faults(storey, tmp_path)
        assert len(found) == (count > 0) and all(message.startswith(f"{count} of its steps lie within") for message in found)

    def test_a_door_may_be_under_the_upper_steps(self, tmp_path):
        storey = ground()
        storey.door("west", 3, DEPTH - HEAD, DEPTH - HEAD + GOING)
        assert faults(storey, tmp_path) == []

    # The flight begins at the southern wall, from 0 to 1 m.
    @pytest.mark.parametrize(("start", "is_sound"), [(0.1, True), (0.5, False)])
    def test_a_flight_may_begin_in_a_doorway(self, tmp_path, start, is_sound):
        storey = self.at_the_wall()
        storey.door("foot", 0, start, start + 0.9)
        found = faults(storey, tmp_path)
        assert (found == []) is is_sound and all("of its steps lie within 0.6 m of door:foot" in message for message in found)

    def test_no_leaf_opens_over_the_first_step(self, tmp_path):
        storey = self.at_the_wall()
        storey.door("foot", 0, 0.1, 0.9)
        storey.floor.find("door:foot")["extras"] |= {
            "closure": "door", "leaves": [{"hinge": [0.1, 0.0], "closed": [0.9, 0.0], "open": [0.1, 0.8]}]}
        assert ["door:foot" in message for message in faults(storey, tmp_path)] == [True]

    def at_the_wall(self) -> Storey:
        return ground([body - (0.0, FOOT - 0.05, 0.0) for body in steps()], ceiling=around(0.05, HEAD - FOOT + 0.05))

    def test_a_flight_may_end_in_a_doorway(self, tmp_path):
        """Of a level whose room ends there: no floor is behind the last step."""
        storey = upper(around(north=DEPTH))
        storey.floor.find("room:hall")["extras"]["outline"][2:] = [[3.0, HEAD], [0.0, HEAD]]
        assert len(faults_of_house(tmp_path, ground(), storey)) == 1
        storey.door("north", 2, 2.0, 3.0)
        assert faults_of_house(tmp_path, ground(), storey) == []

    @pytest.mark.parametrize(("south", "north", "count"), [(0.1, 0.9, 0), (2.0, 3.0, 1)])
    def test_holes_keep_away_from_doors(self, tmp_path, south, north, count):
        storey = upper()
        storey.door("west", 3, DEPTH - north, DEPTH - south)
        found = faults_of_house(tmp_path, ground(), storey)
        assert len(found) == count and all("a hole within 0.6 m of door:west" in message for message in found)


class TestHeadroom:
    """The height that is open over steps."""

    def test_the_ceiling_is_open_over_steps(self, tmp_path):
        found = faults(ground(ceiling=WHOLE), tmp_path)
        # A thing that is too low over many steps is one fault, at the step over which it is lowest.
        assert len(found) == 1 and found[0].startswith("ceiling@hall is 0.100 m above step 12")

    # The ceiling is 2 m above a step at 0.5 m: the second may lie under it, the third not.
    @pytest.mark.parametrize(("covered", "is_sound"), [(2, True), (3, False)])
    def test_two_metres_are_open(self, tmp_path, covered, is_sound):
        found = faults(ground(ceiling=around(FOOT + covered * GOING)), tmp_path)
        assert (found == []) is is_sound and all("is 1.900 m above step 3" in message for message in found)

    @pytest.mark.parametrize(("height", "is_sound"), [(CEILING, True), (2.3, False)])
    def test_no_lamp_hangs_in_the_way(self, tmp_path, height, is_sound):
        storey = ground()
        storey.lamp((0.5, FOOT + 1.5 * GOING, height))
        found = faults(storey, tmp_path)
        assert (found == []) is is_sound and all("lamp.1@hall is 1.900 m above step 2 at (0.5" in message for message in found)

    def test_steps_are_not_too_low_over_other_steps(self, tmp_path):
        storey = ground()
        storey.part("stairs", [block((0.0, FOOT, 1.5), (EAST, FOOT + GOING, 1.7))], outline=[[0, 1], [1, 1], [1, 2]], height=1.0)
        found = faults(storey, tmp_path)
        assert found[0].startswith("stairs@hall is 1.300 m above step 1")

    def test_a_sloped_underside_is_measured_where_it_is(self):
        body = sloped((0, 0, 0), (1, 2, 3), 1.0, 2.0)
        storey = Storey("ground")
        storey.part("floor", [body])
        rings = storey_rings(storey)
        under = Undersides([("slope", rings)])
        place = area_above(rings).intersection(area_above(rings + (0.0, 0.0, -1.0)))
        assert min(height for _, height, _ in under.over(place, 0.0)) == pytest.approx(1.5)
        assert list(under.over(place, 2.5)) == []


class TestStoreys:
    """Flights and the level above."""

    def test_the_floor_above_is_open(self, tmp_path):
        found = faults_of_house(tmp_path, ground(), upper(WHOLE))
        assert len(found) == 1 and found[0].startswith("floor@hall of 1 is 0.180 m above step 13")

    def test_the_flight_ends_at_a_floor(self, tmp_path):
        found = faults_of_house(tmp_path, ground(), upper(around(north=HEAD + 0.1)))
        assert any(message.startswith("no floor of 1 is at its last step") for message in found)
        assert any("and no steps come up there" in message for message in found)

    def test_the_flight_ends_as_high_as_the_floor(self, tmp_path):
        found = faults_of_house(tmp_path, ground(), upper(elevation=STOREY - 0.1))
        assert found[0] == "it ends at 2.800 m, the floor of 1 is at 2.700 m"

    def test_a_bake_may_lack_the_level_above(self, tmp_path):
        found = faults_of_house(tmp_path, ground(), upper(elevation=2 * STOREY))
        assert found[0] == f"the floor has a hole at ({EAST / 2:.3f}, {(FOOT + HEAD) / 2:.3f}), and no steps come up there"
        # Nothing is said of the flight itself.
        assert len(found) == 2 and "have no balustrade" in found[1]
        assert faults_of_house(tmp_path, ground()) == []

    def test_nothing_stands_over_the_flight(self, tmp_path):
        storey = upper()
        storey.lamp((0.5, HEAD - GOING, 0.0))
        found = faults_of_house(tmp_path, ground(), storey)
        assert len(found) == 1 and found[0].startswith("lamp.1@hall of 1 is 0.200 m above step 13")

    def test_a_hole_has_steps(self, tmp_path):
        found = faults_of_house(tmp_path, ground(), upper(around(FOOT - 0.1)))
        assert len(found) == 1 and "and no steps come up there" in found[0]

    @pytest.mark.parametrize(("kept", "length"), [((0, 1), 0.0), ((0,), 0.69), ((1,), 2.58)])
    def test_a_well_has_a_balustrade(self, tmp_path, kept, length):
        found = faults_of_house(tmp_path, ground(), upper(rails=[balustrade()[number] for number in kept]))
        assert len(found) == (length > 0.0)
        assert all(f"{length:.2f} m of the edge of its well have no balustrade" in message for message in found)

    def test_a_low_rail_is_no_balustrade(self, tmp_path):
        low = [rail - np.where(rail[:, 2:] > 0.5, (0.0, 0.0, 0.2), 0.0) for rail in balustrade()]
        assert len(faults_of_house(tmp_path, ground(), upper(rails=low))) == 1

    def test_a_file_that_cannot_be_read_is_the_task_of_others(self, tmp_path):
        manifest = write_house(tmp_path, ground(), upper(WHOLE))
        (tmp_path / "0.glb").write_bytes(b"glTF")
        assert check_storeys(manifest) == []
        manifest.write_text("{")
        assert check_storeys(manifest) == []


class TestSolids:
    """Bodies that meet along edges."""

    def test_faces_look_outwards(self, tmp_path):
        rail = block((0.9, FOOT, 0.9), (0.95, HEAD, 1.0))
        assert faults(ground([*steps(), rail]), tmp_path) == []
        inverted = rail[[4, 5, 6, 7, 0, 1, 2, 3]]
        assert faults(ground([*steps(), inverted]), tmp_path) == [
            "the faces of 1 of its steps, posts and handrails look inwards"]

    def test_each_step_is_one(self, tmp_path):
        storey = ground()
        gltf = GltfFile(storey.write(tmp_path / "level.glb"))
        node = next(node for node in gltf.nodes if node.name == "stairs@hall")
        found = solids_of(gltf.primitives(node.mesh)[0])
        assert len(found) == RISES - 1 and all(part.is_convex and len(part.corners) == 8 for part in found)

    def test_bodies_in_the_same_place_stay_together(self):
        storey = Storey("ground")
        storey.part("stairs", [block((0, 0, 0), (1, 1, 1))] * 2 + [block((2, 0, 0), (3, 1, 1))])
        rings = storey_rings(storey)
        found = solids_of({"positions": rings.reshape(-1, 3), "triangles": np.arange(len(rings) * 3).reshape(-1, 3)})
        assert sorted(len(part.triangles) for part in found) == [12, 24]


def storey_rings(storey: Storey) -> np.ndarray:
    """The triangles of the last mesh, n x 3 x 3."""
    view = storey.floor.document["bufferViews"][-3]
    data = storey.floor.binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
    return np.frombuffer(data, "<f4").reshape(-1, 3, 3).astype(float)


def test_validate_measures_stairs(tmp_path, capsys):
    manifest = write_house(tmp_path, ground(ceiling=WHOLE), upper(WHOLE))
    assert validate.main([str(manifest.parent), "--no-khronos", "--quiet", "--jobs", "1"]) == 1
    lines = [line for line in capsys.readouterr().out.splitlines() if "[stairs]" in line]
    assert len(lines) == 2 and "ceiling@hall" in lines[0] + lines[1] and "floor@hall of 1" in lines[0] + lines[1]
