"""The house in MuJoCo: it loads, stands still for 1,000 steps, and its doors hinge.

Needs scripts/requirements-simulation.txt in the environment of the other tests, and the program.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT
from simulation_reading import run

from roomwright.checks.stairs import StairsOfLevel
from roomwright.gltf_file import GltfFile

mujoco = pytest.importorskip("mujoco", reason="mujoco is not installed (pip install -r scripts/requirements-simulation.txt)")

PROGRAM = os.environ.get("ROOMWRIGHT_PROGRAM") or shutil.which("roomwright") or str(ROOT / "target/release/roomwright")
pytestmark = pytest.mark.skipif(not Path(PROGRAM).is_file(), reason=f"there is no program {PROGRAM}")
STEPS = 1000
# Metres per second: a piece that falls a hand's breadth is faster, and one that another pushes out far faster.
FASTEST = 0.5
# Metres that a piece may settle: bodies of some models begin a little over or under their boxes.
FARTHEST = 0.01
# Metres of overlap of two shapes, where a leaf's handle touches a wall.
DEEPEST = 0.006
# Newtons, at the middle of a leaf.
PUSH = 15.0
LEVELS = ("ground", "upper", "building")


@pytest.fixture(scope="module")
def converted(tmp_path_factory):
    """The folder of the house in a format."""
    folder = tmp_path_factory.mktemp("house")
    subprocess.run([PROGRAM, "bake", str(ROOT / "configs/plans/house.yaml"), "--out", str(folder / "out"), "--quiet"],
                   check=True, env={**os.environ, "ROOMWRIGHT_CACHE": "none"})
    written = {}

    def convert(format_name: str, *options: str) -> Path:
        key = format_name, *options
        if key not in written:
            target = folder / "-".join(key).replace("--", "")
            assert run(folder / "out", "--out", target, "--format", format_name, *options) == 0
            written[key] = target / "house"
        return written[key]

    return convert


def loaded(file: Path):
    """A model and its state before the first step."""
    model = mujoco.MjModel.from_xml_path(str(file))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def names_of(model, contact) -> tuple[str, str]:
    return tuple(model.body(model.geom_bodyid[geom]).name for geom in (contact.geom1, contact.geom2))


def assert_calm(model, data) -> None:
    """Steps a model: nothing warns, nothing is far from where it was, nothing was fast, nothing overlaps."""
    free = [joint for joint in range(model.njnt) if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE]
    speeds = model.jnt_dofadr[free][:, None] + np.arange(3)
    before, fastest = data.xpos.copy(), np.zeros(len(free))
    for _ in range(STEPS):
        mujoco.mj_step(model, data)
        fastest = np.maximum(fastest, np.linalg.norm(data.qvel[speeds], axis=1))
    assert np.isfinite(data.qpos).all() and np.isfinite(data.qvel).all()
    assert [warning.number for warning in data.warning] == [0] * len(data.warning)
    fast = {model.body(model.jnt_bodyid[joint]).name: speed for joint, speed in zip(free, fastest) if speed > FASTEST}
    assert fast == {}
    moved = np.linalg.norm(data.xpos - before, axis=1)
    assert {model.body(body).name: moved[body] for body in np.flatnonzero(moved > FARTHEST)} == {}
    deep = {names_of(model, contact): contact.dist for contact in data.contact[:data.ncon] if contact.dist < -DEEPEST}
    assert deep == {}


@pytest.mark.parametrize("level", LEVELS)
def test_the_house_stands_still(converted, level):
    model, data = loaded(converted("mjcf") / f"{level}.xml")
    assert model.nv == model.njnt > 0, "every joint is a door's"
    assert_calm(model, data)


@pytest.mark.parametrize("level", LEVELS)
def test_free_pieces_rest(converted, level):
    model, data = loaded(converted("mjcf", "--movable") / f"{level}.xml")
    free = [joint for joint in range(model.njnt) if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE]
    assert len(free) > 30
    assert (model.body_mass[model.jnt_bodyid[free]] > 0.01).all() and (model.body_mass[model.jnt_bodyid[free]] <= 20.0).all()
    assert_calm(model, data)


def test_a_free_chair_is_pushed_and_a_static_one_is_not(converted):
    model, data = loaded(converted("mjcf", "--movable") / "ground.xml")
    chair = model.body("house/ground/study/office_chair.1").id
    before = data.xpos[chair].copy()
    for _ in range(500):
        data.xfrc_applied[chair, 2] = 2 * 9.81 * model.body_mass[chair]
        mujoco.mj_step(model, data)
    assert data.xpos[chair][2] - before[2] > 0.1, "lifted by twice its weight"
    static, _ = loaded(converted("mjcf") / "ground.xml")
    assert static.body("house/ground/study/office_chair.1").dofnum == 0


def doors_of(model, kind) -> list[int]:
    return [joint for joint in range(model.njnt) if model.jnt_type[joint] == kind]


def pushed(model, data, joint: int, sign: float, steps: int = 2000) -> set[tuple[str, str]]:
    """Pushes a leaf at its middle, across its hinge or along its way; the bodies that met its shapes."""
    body, met = model.jnt_bodyid[joint], set()
    for _ in range(steps):
        way = data.xaxis[joint]
        if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_HINGE:
            way = np.cross(way, data.xipos[body] - data.xanchor[joint])
            way /= np.linalg.norm(way)
        data.xfrc_applied[body, :3] = sign * PUSH * way
        mujoco.mj_step(model, data)
        met |= {names_of(model, contact) for contact in data.contact[:data.ncon]}
    data.xfrc_applied[:] = 0.0
    return {pair for pair in met if model.body(body).name in pair}


@pytest.mark.parametrize("has_excluded_pairs", [True, False])
@pytest.mark.parametrize("level", ["ground", "upper"])
def test_pushed_leaves_open_and_shut_about_their_hinges(converted, level, has_excluded_pairs):
    spec = mujoco.MjSpec.from_file(str(converted("mjcf") / f"{level}.xml"))
    if not has_excluded_pairs:
        for pair in list(spec.excludes):
            spec.delete(pair)
    model = spec.compile()
    hinges = doors_of(model, mujoco.mjtJoint.mjJNT_HINGE)
    assert len(hinges) == 6
    for joint in hinges:
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        name = model.joint(joint).name
        value, (low, high) = model.jnt_qposadr[joint], model.jnt_range[joint]
        edge = data.xpos[model.jnt_bodyid[joint]].copy()
        wide_open = low if abs(low) > abs(high) else high
        assert data.qpos[value] == pytest.approx(wide_open, abs=1e-6), "the bake has its doors open"
        met = pushed(model, data, joint, -np.sign(wide_open))
        assert abs(data.qpos[value]) < 0.02, f"{name} shuts"
        met |= pushed(model, data, joint, np.sign(wide_open))
        assert data.qpos[value] == pytest.approx(wide_open, abs=0.05), f"{name} opens"
        np.testing.assert_allclose(data.xpos[model.jnt_bodyid[joint]], edge, atol=1e-6, err_msg="the hinge stays")
        opening = name.rsplit("/", 1)[0]
        assert not [pair for pair in met if all(body.startswith(opening) for body in pair)], "its frame is in its way"


def test_sliding_leaves_slide(converted):
    model, _ = loaded(converted("mjcf") / "ground.xml")
    slides = doors_of(model, mujoco.mjtJoint.mjJNT_SLIDE)
    assert len(slides) == 2
    for joint in slides:
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        pushed(model, data, joint, 1.0)
        assert data.qpos[model.jnt_qposadr[joint]] == pytest.approx(model.jnt_range[joint][1], abs=0.01)
        assert model.jnt_range[joint][1] > 1.0


def test_a_door_that_is_let_go_stops(converted):
    model, data = loaded(converted("mjcf") / "ground.xml")
    joint = model.joint("house/ground/door:d3/leaf")
    pushed(model, data, joint.id, -1.0, 200)
    for _ in range(STEPS * 4):
        mujoco.mj_step(model, data)
    between = data.qpos[joint.qposadr[0]]
    assert 0.05 < between < 1.5 and abs(data.qvel[joint.dofadr[0]]) < 1e-3


def test_a_ball_passes_an_open_door_and_no_shut_one(converted):
    """A ball of a robot's width rolls through a doorway where its door is open, and meets the leaf where it is shut."""
    for angle, is_through in ((None, True), (0.0, False)):
        spec = mujoco.MjSpec.from_file(str(converted("mjcf") / "ground.xml"))
        ball = spec.worldbody.add_body(name="ball", pos=[5.2, 4.5, 0.3])
        ball.add_freejoint()
        ball.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.3, 0, 0], mass=20.0)
        model = spec.compile()
        data = mujoco.MjData(model)
        if angle is not None:
            data.qpos[model.joint("house/ground/door:d3/leaf").qposadr[0]] = angle
        body = model.body("ball").id
        for _ in range(2000):
            # Through the doorway of d3, northwards, at a walking pace.
            data.xfrc_applied[body, 1] = 20.0 * (0.5 - data.cvel[body, 4])
            mujoco.mj_step(model, data)
            if data.xpos[body][1] > 5.6:
                break
        assert bool(data.xpos[body][1] > 5.5) is is_through, data.xpos[body]


def test_a_box_rests_on_each_step(converted):
    """A box of 10 cm, put down over the middle of each step of the house's flight, comes to lie on it."""
    gltf = GltfFile(converted("mjcf").parents[1] / "out" / "house" / "ground.glb")
    (stairs,) = StairsOfLevel(gltf).stairs
    spec = mujoco.MjSpec.from_file(str(converted("mjcf") / "ground.xml"))
    for number, step in enumerate(stairs.steps):
        middle = step.tread.centroid
        box = spec.worldbody.add_body(name=f"box {number}", pos=[middle.x, middle.y, step.top + 0.06])
        box.add_freejoint()
        box.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[0.05, 0.05, 0.05], mass=1.0)
    model = spec.compile()
    data = mujoco.MjData(model)
    for _ in range(STEPS):
        mujoco.mj_step(model, data)
    found = [data.xpos[model.body(f"box {number}").id][2] for number in range(len(stairs.steps))]
    assert found == pytest.approx([step.top + 0.05 for step in stairs.steps], abs=2e-3)


@pytest.mark.parametrize("options", [(), ("--movable",)])
@pytest.mark.parametrize("level", ["ground", "upper"])
def test_urdf_is_the_same_level(converted, level, options):
    model, data = loaded(converted("urdf", *options) / f"{level}.urdf")
    other, _ = loaded(converted("mjcf", *options) / f"{level}.xml")
    names = {model.body(body).name for body in range(model.nbody)}
    assert names == {other.body(body).name for body in range(other.nbody)}
    assert model.nv == other.nv
    for joint in doors_of(other, mujoco.mjtJoint.mjJNT_HINGE):
        same = model.joint(f"{other.joint(joint).name}/joint")
        np.testing.assert_allclose(same.range, other.jnt_range[joint], atol=1e-5)
        assert same.qpos0[0] == 0.0, "shut at zero"
    assert_calm(model, data)
