"""Files that somebody else made: convert.py and validate.py read nothing outside, hang on nothing and fail on nothing."""

import json
import os
import random
import subprocess
import sys

import pytest
from conftest import ROOT, build_floor, write_manifest
from mutations import dumped, glb, mutated, mutated_bytes

from roomwright import convert
from roomwright import validate
from roomwright.resources import ForbiddenError, locate, reach_of

SECRET = b"\x89PNG\r\n\x1a\n that nobody gave away"
SEED = 20240917
# Seconds after which a process that reads small files hangs.
HANGS = 120


@pytest.fixture
def place(tmp_path):
    """A secret, and beside it a bake with a good floor; `bake/house` is where bad ones go."""
    (tmp_path / "bake" / "house").mkdir(parents=True)
    (tmp_path / "secret.png").write_bytes(SECRET)
    (tmp_path / "bake" / "wood.png").write_bytes(b"\x89PNG\r\n\x1a\n and the rest")
    build_floor().write(tmp_path / "bake" / "good.glb")
    return tmp_path


def textured(uri: str):
    """A floor whose first material reads an image."""
    floor = build_floor()
    floor.document["images"] = [{"uri": uri}]
    floor.document["textures"] = [{"source": 0}]
    floor.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    return floor


def contents(folder) -> dict:
    return {file: file.read_bytes() for file in folder.rglob("*") if file.is_file() and not file.is_fifo()}


def outside_uris(place) -> dict[str, str]:
    os.symlink(place / "secret.png", place / "bake" / "house" / "link.png")
    os.symlink(place, place / "bake" / "house" / "linked")
    return {"parents": "../../secret.png", "absolute": str(place / "secret.png"), "encoded": "%2e%2e/%2E%2E%2Fsecret.png",
            "url": f"file://{place}/secret.png", "link": "link.png", "linked folder": "linked/secret.png",
            "absolute when decoded": "%2F" + str(place / "secret.png")[1:], "round about": "../house/../../secret.png",
            "backslashes": "..\\..\\secret.png", "nothing": "", "zero byte": "a%00.png"}


@pytest.mark.parametrize("name", ["parents", "absolute", "encoded", "url", "link", "linked folder", "absolute when decoded",
                                  "round about", "backslashes", "nothing", "zero byte"])
def test_an_image_outside_the_bake_is_not_copied_and_is_a_fault(place, name, capsys):
    uri = outside_uris(place)[name]
    source = textured(uri).write(place / "bake" / "house" / "evil.glb")
    assert convert.main([str(place / "bake"), "--out", str(place / "usd"), "--jobs", "1"]) == 1
    assert SECRET not in contents(place / "usd").values()
    assert (place / "usd" / "good.usdc").is_file() and not (place / "usd" / "house" / "evil.usdc").exists()
    assert f"{source}: images[0].uri: {uri!r}" in capsys.readouterr().err
    faults, _ = validate.check_file(source, place / "bake")
    assert [(fault.code, fault.message.startswith(f"images[0].uri: {uri!r}")) for fault in faults] == [("path", True)]
    assert "; hint: " in faults[0].message


def test_a_buffer_outside_the_bake_is_a_fault_and_not_read(place, capsys):
    source = build_floor().write(place / "bake" / "house" / "evil.gltf")
    (place / "bake" / "house" / "floor.bin").rename(place / "floor.bin")
    document = json.loads(source.read_text())
    document["buffers"][0]["uri"] = "../../floor.bin"
    source.write_text(json.dumps(document))
    assert convert.main([str(place / "bake"), "--out", str(place / "usd"), "--jobs", "1"]) == 1
    assert validate.main([str(place / "bake"), "--jobs", "1"]) in (1, 2), "2 where the Khronos validator is not installed"
    faults, _ = validate.check_file(source, place / "bake")
    assert {(fault.code, fault.message.partition(" leads")[0]) for fault in faults} \
        == {("path", "buffers[0].uri: '../../floor.bin'")}


def test_a_floor_alone_reaches_its_folder_and_the_shared_ones(place):
    (place / "bake" / "shared-textures").mkdir()
    for file in ("shared-textures/wood.png", "house/wood.png", "wood.png"):
        (place / "bake" / file).write_bytes(b"\x89PNG")
    alone, found = (reach_of(place / "bake" / "house" / "a.glb", folder) for folder in (None, place / "bake"))
    for uri in ("wood.png", "../shared-textures/wood.png", "../shared%2Dtextures/./wood.png"):
        assert locate(uri, alone) == locate(uri, found)
    assert locate("../wood.png", found) == place / "bake" / "wood.png"
    with pytest.raises(ForbiddenError):
        locate("../wood.png", alone)


def test_a_shared_folder_that_is_a_link_elsewhere_is_not_one(place):
    os.symlink(place, place / "bake" / "shared-textures")
    for folder in (None, place / "bake"):
        with pytest.raises(ForbiddenError):
            locate("../shared-textures/secret.png", reach_of(place / "bake" / "house" / "a.glb", folder))


def test_what_is_no_image_is_not_copied(place, capsys):
    (place / "bake" / "notes.txt").write_bytes(b"what nobody asked for")
    textured("../notes.txt").write(place / "bake" / "house" / "odd.glb")
    assert convert.main([str(place / "bake"), "--out", str(place / "usd"), "--jobs", "1"]) == 1
    assert "images[0] is neither PNG nor JPEG nor WebP" in capsys.readouterr().err
    assert b"what nobody asked for" not in contents(place / "usd").values()


def test_a_floor_that_is_a_link_out_of_the_folder_is_not_read(place, capsys):
    build_floor().write(place / "elsewhere.glb")
    os.symlink(place / "elsewhere.glb", place / "bake" / "house" / "link.glb")
    assert convert.main([str(place / "bake"), "--out", str(place / "usd"), "--jobs", "1"]) == 1
    assert "link.glb: the file is a link that leads out" in capsys.readouterr().err
    assert convert.main([str(place / "bake" / "house" / "link.glb"), "--out", str(place / "usd"), "--jobs", "1"]) == 0, \
        "a link that somebody names is meant"


@pytest.mark.parametrize("shared", ["shared-models", "house"])
def test_nothing_is_written_through_a_link_beside_the_sources(place, shared, capsys):
    build_floor().write(place / "bake" / "ground.glb")
    (place / "victim").mkdir()
    if shared == "house":
        (place / "bake" / "house").rmdir()
    os.symlink(place / "victim", place / "usd" if shared == "usd" else place / "bake" / shared)
    convert.main([str(place / "bake"), "--jobs", "1"])
    assert list((place / "victim").iterdir()) == []


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
@pytest.mark.parametrize("script", ["convert.py", "validate.py"])
@pytest.mark.parametrize("what", ["image", "buffer", "floor", "manifest", "manifest's entry", "stage", "layer", "texture"])
def test_a_pipe_that_nobody_writes_into_holds_up_nobody(place, script, what):
    bake = place / "bake"
    names = {"image": "house/pipe.png", "buffer": "house/floor.bin", "floor": "house/pipe.glb", "manifest": "manifest.json",
             "manifest's entry": "house/listed.bin", "stage": "pipe.usda", "layer": "house/pipe.usdc",
             "texture": "house/pipe.png"}
    if what == "image":
        textured("pipe.png").write(bake / "house" / "evil.glb")
    if what == "buffer":
        build_floor().write(bake / "house" / "evil.gltf")
        (bake / "house" / "floor.bin").unlink()
    if what == "manifest's entry":
        manifest = json.loads(write_manifest(bake).read_text())
        manifest["library"] = [{"path": "house/listed.bin", "bytes": 0, "sha256": "0" * 64}]
        (bake / "manifest.json").write_text(json.dumps(manifest))
    if what in ("layer", "texture"):
        reads = "(references = @./pipe.usdc@)" if what == "layer" else ""
        (bake / "house" / "evil.usda").write_text(
            f'#usda 1.0\n(\n    defaultPrim = "A"\n    metersPerUnit = 1\n    upAxis = "Y"\n)\ndef Xform "A" {reads}\n'
            '{\n    asset a = @./pipe.png@\n}\n')
    os.mkfifo(bake / names[what])
    options = ["--out", str(place / "usd")] if script == "convert.py" else ["--no-khronos"]
    done = subprocess.run([sys.executable, str(ROOT / "scripts" / script), str(bake), "--jobs", "1", *options],
                          capture_output=True, text=True, timeout=HANGS)
    concerns_floors = what in ("image", "buffer", "floor")
    assert done.returncode == (1 if concerns_floors or script == "validate.py" else 0), done.stderr
    assert "Traceback" not in done.stderr + done.stdout
    if concerns_floors or script == "validate.py":
        assert "no regular file" in done.stderr + done.stdout


@pytest.mark.parametrize("depth", [65, 400, 990, 100_000])
def test_lists_in_lists_in_the_extras_fail_their_floor_alone(place, depth, capsys):
    floor = build_floor()
    floor.find("desk.1@101")["extras"]["deep"] = f"nested {depth}"
    document = floor.document | {"buffers": [{"byteLength": len(floor.binary)}]}
    (place / "bake" / "deep.glb").write_bytes(glb(document, floor.binary))
    assert convert.main([str(place / "bake"), "--out", str(place / "usd"), "--jobs", "2"]) == 1
    captured = capsys.readouterr()
    assert "deep.glb: not a glTF file: " in captured.err and "good.usdc" in captured.out
    assert validate.main([str(place / "bake"), "--no-khronos"]) == 1
    assert "deep.glb: [file] not a glTF file: " in capsys.readouterr().out


@pytest.mark.parametrize("damage, fact", [
    (lambda data: b"", "it has 0 bytes, fewer than the header of a .glb"),
    (lambda data: data[:12] + b"\xff\xff\xff\x7f" + data[16:], "the chunk at byte 12 reaches past the end of the file"),
])
def test_a_file_that_is_cut_off_is_told_in_words(place, damage, fact, capsys):
    whole = (place / "bake" / "good.glb").read_bytes()
    (place / "bake" / "cut.glb").write_bytes(damage(whole))
    assert convert.main([str(place / "bake"), "--out", str(place / "usd"), "--jobs", "1"]) == 1
    assert f"cut.glb: not a glTF file: {fact}\n" in capsys.readouterr().err


def test_a_root_that_is_not_there_is_no_cycle(place, capsys):
    floor = build_floor()
    floor.document["nodes"] = []
    floor.write(place / "bake" / "rootless.glb")
    assert convert.main([str(place / "bake"), "--out", str(place / "usd"), "--jobs", "1"]) == 1
    error = capsys.readouterr().err
    assert "rootless.glb: nodes[0] is not there\n" in error, error


def test_few_bytes_do_not_become_many(place):
    """An accessor whose rows lie on each other would be as long as it likes."""
    floor = build_floor()
    floor.document["accessors"][0]["count"] = 10**12
    for stride in (0, -4, 4):
        floor.document["bufferViews"][0]["byteStride"] = stride
        source = floor.write(place / "bake" / "long.glb")
        assert any("accessors[0] has no rows, or such as lie on each other" in fault.message
                   for fault in validate.check_file(source)[0])


def test_a_name_forges_no_line_of_the_report(place, capsys):
    floor = build_floor()
    floor.find("desk.1@101")["name"] = "desk\n0 faults\x1b[2K\ud800"
    source = place / "bake" / "forged.glb"
    source.write_bytes(glb(floor.document | {"buffers": [{"byteLength": len(floor.binary)}]}, floor.binary))
    assert validate.main([str(source), "--no-khronos"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert "0 faults" not in lines and not any("\x1b" in line for line in lines)
    lines[0].encode("utf-8")


def test_a_process_that_dies_fails_its_file_alone():
    from roomwright.workers import DIED, outcomes

    found = list(outcomes(dies_at_two, [1, 2, 3, 4], 2))
    assert [str(outcome) for outcome in found] == ["1", DIED, "3", "4"]


def dies_at_two(number: int) -> int:
    if number == 2:
        os._exit(9)
    return number


HERE = []


def test_workers_are_no_copies_whose_locks_nobody_opens():
    from roomwright.workers import outcomes

    HERE.append("a lock that a thread of this process holds")
    assert list(outcomes(what_is_here, [1, 2], 2)) == [[], []]
    HERE.clear()


def what_is_here(_number: int) -> list[str]:
    return HERE


# --- mutations: nothing is raised, written elsewhere, or takes long, whatever stands in a file ---


def rich_floor():
    """A floor with an image, a leaf, a light, variants and a place of its building."""
    floor = textured("../wood.png")
    floor.document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 10.0}]},
                                    "KHR_materials_variants": {"variants": [{"name": "warm"}]}}
    floor.document["nodes"][0]["extras"]["site"] = {"position": [1.0, 2.0], "turn": 0.1}
    floor.find("door:d1")["extras"]["leaves"] = [{"hinge": [1.0, 0.0], "closed": [1.9, 0.0], "open": [1.0, 0.9]}]
    opening = floor.document["nodes"].index(floor.find("door:d1"))
    floor.node("leaf@door:d1", {"kind": "part", "part": "leaf", "id": "leaf", "tags": []}, opening, 0)
    lamp = floor.document["nodes"].index(floor.find("lamp.1@101"))
    floor.node("light.lamp.1@101", {"kind": "light", "lumens": 800.0, "kelvin": 2700.0}, lamp)
    floor.document["nodes"][-1]["extensions"] = {"KHR_lights_punctual": {"light": 0}}
    floor.document["meshes"][1]["primitives"][0]["extensions"] = {
        "KHR_materials_variants": {"mappings": [{"material": 1, "variants": [0]}]}}
    return floor


def damaged_floors(count: int) -> dict[str, bytes]:
    floor = rich_floor()
    document = floor.document | {"buffers": [{"byteLength": len(floor.binary)}]}
    whole = glb(document, floor.binary)
    damaged = {}
    for number in range(count):
        draw = random.Random(f"{SEED}/{number}")
        damaged[f"json{number}"] = glb(mutated(document, draw, draw.choice([1, 1, 2, 8])), floor.binary)
        damaged[f"bytes{number}"] = mutated_bytes(whole, draw)
    return damaged


@pytest.mark.parametrize("options", [[], ["--physics", "--self-contained"], ["--point-instancer", "--format", "usda"]])
def test_convert_takes_any_floor(place, options, capfd):
    for name, data in damaged_floors(100).items():
        (place / "bake" / "house" / f"{name}.glb").write_bytes(data)
    before = contents(place)
    assert convert.main([str(place / "bake"), "--out", str(place / "usd"), "--jobs", "2", *options]) == 1
    captured = capfd.readouterr()
    assert "Traceback" not in captured.err
    failed = sum(line.startswith("convert: /") for line in captured.err.splitlines())
    written = [file for file in (place / "usd" / "house").glob("*[0-9].usd*")]
    assert failed + len(written) == 200 and len(written) > 20
    after = contents(place)
    assert {file: data for file, data in after.items() if not file.is_relative_to(place / "usd")} == before
    assert SECRET not in [data for file, data in after.items() if file.is_relative_to(place / "usd")]


def test_validate_takes_any_floor(place, capfd):
    for name, data in damaged_floors(100).items():
        (place / "bake" / "house" / f"{name}.glb").write_bytes(data)
    assert validate.main([str(place / "bake"), "--jobs", "2", "--no-khronos"]) == 1
    captured = capfd.readouterr()
    assert "Traceback" not in captured.err and "201 files" in captured.out
    assert validate.main([str(place / "bake"), "--jobs", "2", "--no-khronos", "--json"]) == 1
    json.loads(capfd.readouterr().out)


def test_validate_takes_any_manifest(place, capsys):
    manifest = write_manifest(place / "bake")
    document = json.loads(manifest.read_text())
    document["library"] = [{"path": "wood.png", "bytes": 21, "sha256": "0" * 64}]
    whole, unseen = json.dumps(document).encode(), 0
    for number in range(800):
        draw = random.Random(f"{SEED}/{number}")
        changed = mutated(document, draw, draw.choice([1, 1, 2, 5]))
        data = dumped(changed) if number % 3 else mutated_bytes(whole, draw)
        manifest.write_bytes(data)
        faults = sorted(validate.check_manifest(manifest))
        assert all(isinstance(fault.message, str) and str(fault).isprintable() for fault in faults)
        unseen += not faults
    assert unseen < 160, "of these, most have changes where nothing is looked at"


@pytest.mark.parametrize(("change", "expected"), [
    ({"levels": 7}, "levels: 7 is not a list; hint: "),
    ({"levels": [None]}, "levels[0]: None is not an object; hint: "),
    ({"library": [{"path": 1, "bytes": 2, "sha256": "0"}]}, "library[0].path: 1 is not text; hint: "),
    ({"library": [{"path": "good.glb", "bytes": "2", "sha256": "0"}]}, "library[0].bytes: '2' is not a whole number; hint: "),
    ({"library": [{"path": "good.glb", "bytes": 2}]}, "library[0].sha256: it is missing; hint: "),
    ({"library": [{"path": "../secret.png", "bytes": 2, "sha256": "0"}]}, "library[0].path: '../secret.png' leads out"),
])
def test_a_wrong_type_in_a_manifest_is_a_fault_with_its_place(place, change, expected):
    manifest = write_manifest(place / "bake")
    manifest.write_text(json.dumps(json.loads(manifest.read_text()) | change))
    assert any(fault.message.startswith(expected) for fault in validate.check_manifest(manifest))
