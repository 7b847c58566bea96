"""What a run of convert.py takes away: what an earlier run wrote and it does not, and nothing else."""

import json
import os

import pytest
from conftest import build_floor
from test_usd_assembly import write_level

from roomwright import convert

RECORD = "converted.json"


@pytest.fixture
def bake(tmp_path):
    """Two buildings of two floors."""
    for building in ("house", "tower"):
        for number, level in enumerate(("ground", "upper")):
            write_level(tmp_path / "out", building, level, 3.0 * number)
    return tmp_path / "out"


def converted(bake, *options, code=0) -> set[str]:
    """Runs convert.py into `usd` beside the bake; what is there then, but for the record."""
    usd = bake.parent / "usd"
    assert convert.main([str(bake), "--out", str(usd), "--jobs", "1", *options]) == code
    return files_in(usd)


def files_in(usd) -> set[str]:
    return {file.relative_to(usd).as_posix() for file in usd.rglob("*") if not file.is_dir()} - {RECORD}


def plain(files) -> set[str]:
    return {file for file in files if not file.startswith("shared-")}


FLOORS = {f"{building}/{level}" for building in ("house", "tower") for level in ("ground", "upper")}
STAGES = {"house/building.usda", "tower/building.usda", "city.usda"}


def test_another_format_leaves_none_of_the_first(bake, capsys):
    assert plain(converted(bake)) == {f"{floor}.usdc" for floor in FLOORS} | STAGES
    assert plain(converted(bake, "--format", "usda")) == {f"{floor}.usda" for floor in FLOORS} | STAGES
    error = capsys.readouterr().err
    assert error.count("convert: removed ") == 4
    assert "convert: removed house/ground.usdc, which an earlier run wrote and this one does not" in error
    assert converted(bake, "--format", "usdz") == {f"{floor}.usdz" for floor in FLOORS}, "packages share nothing"


def test_a_floor_that_left_the_bake_goes(bake, capsys):
    converted(bake)
    (bake / "house" / "upper.glb").unlink()
    assert plain(converted(bake)) == {f"{floor}.usdc" for floor in FLOORS - {"house/upper"}} | STAGES
    (bake / "house" / "ground.glb").unlink()
    assert plain(converted(bake)) == {"tower/ground.usdc", "tower/upper.usdc", "tower/building.usda"}, "one is no city"
    assert not (bake.parent / "usd" / "house").exists(), "nor is an empty folder left"
    assert "removed house/building.usda" in capsys.readouterr().err


def test_models_that_nothing_uses_any_more_go(bake, capsys):
    before = converted(bake)
    for file in bake.rglob("*.glb"):
        floor = build_floor()
        floor.document["nodes"][0]["name"] = "/".join(file.with_suffix("").parts[-2:])
        floor.document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = [0.1, 0.2, 0.3, 1.0]
        floor.write(file)
    after = converted(bake)
    assert len(before) == len(after) and len(before - after) == 2, "a desk and a lamp of another colour"
    assert "convert: removed 2 models, meshes and images that nothing uses any more" in capsys.readouterr().err


def test_a_run_for_one_floor_takes_no_other_away(bake):
    before = converted(bake)
    ground = bake / "house" / "ground.glb"
    assert convert.main([str(ground), "--out", str(bake.parent / "usd" / "house"), "--jobs", "1"]) == 0
    assert plain(before) <= plain(files_in(bake.parent / "usd"))
    (bake / "house" / "upper.glb").unlink()
    usd = bake.parent / "usd"
    assert convert.main([str(bake / "tower"), "--out", str(usd), "--format", "usda", "--jobs", "1"]) == 0
    assert (usd / "house" / "upper.usdc").is_file(), "nobody asked for the house"


def test_a_floor_that_fails_keeps_what_it_was(bake):
    converted(bake)
    (bake / "house" / "upper.glb").write_bytes(b"cut")
    after = converted(bake, "--format", "usda", code=1)
    assert "house/upper.usdc" in after and "house/ground.usdc" not in after
    assert {file for file in after if file.startswith("shared-models/")}, "it still needs its models"


def test_a_file_that_somebody_changed_stays(bake, capsys):
    converted(bake)
    changed = bake.parent / "usd" / "house" / "ground.usdc"
    changed.write_bytes(changed.read_bytes() + b"\n")
    foreign = bake.parent / "usd" / "house" / "notes.usdc"
    foreign.write_bytes(b"mine")
    after = converted(bake, "--format", "usda")
    assert {"house/ground.usdc", "house/notes.usdc"} <= after and "house/upper.usdc" not in after
    assert "convert: left house/ground.usdc: it was changed since it was written" in capsys.readouterr().err


def test_no_link_is_followed(bake, tmp_path, capsys):
    converted(bake)
    usd = bake.parent / "usd"
    elsewhere = tmp_path / "elsewhere"
    (usd / "tower").rename(elsewhere)
    os.symlink(elsewhere, usd / "tower")
    (usd / "house" / "ground.usdc").rename(tmp_path / "kept.usdc")
    os.symlink(tmp_path / "kept.usdc", usd / "house" / "ground.usdc")
    (bake / "tower" / "upper.glb").unlink()
    (bake / "tower" / "ground.glb").unlink()
    converted(bake, "--format", "usda")
    assert {file.name for file in elsewhere.iterdir()} == {"ground.usdc", "upper.usdc", "building.usda"}
    assert (tmp_path / "kept.usdc").is_file() and (usd / "house" / "ground.usdc").is_symlink()


@pytest.mark.parametrize("path", ["../victim.txt", "/tmp/victim.txt", "house/../../victim.txt", "..", "", "a\0b", 7])
def test_a_record_that_names_files_elsewhere_takes_none_away(bake, path):
    converted(bake)
    victim, record = bake.parent / "victim.txt", bake.parent / "usd" / RECORD
    victim.write_text("precious")
    document = json.loads(record.read_text())
    document["files"].append({"path": path, "digest": convert.digest_of(victim), "source": "../out/gone.glb"})
    record.write_text(json.dumps(document))
    converted(bake)
    assert victim.read_text() == "precious"


@pytest.mark.parametrize("content", ["", "[]", "{}", '{"converted": 9}', '{"converted": 1, "files": 3}',
                                     '{"converted": 1, "files": [{"path": "house/ground.usdc", "what": 1}]}', "[" * 5000])
def test_a_record_that_nobody_can_read_takes_nothing_away(bake, content):
    converted(bake)
    (bake.parent / "usd" / RECORD).write_text(content)
    after = converted(bake, "--format", "usda")
    assert "house/ground.usdc" in after and "house/ground.usda" in after


def test_beside_the_sources_too(bake):
    assert convert.main([str(bake), "--jobs", "1"]) == 0
    assert convert.main([str(bake), "--jobs", "1", "--format", "usda"]) == 0
    assert {file.suffix for file in (bake / "house").iterdir()} == {".glb", ".usda"}
    assert {path.name for path in bake.glob("house/*.glb")} == {"ground.glb", "upper.glb"}
