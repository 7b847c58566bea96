"""Blender's extension: its sources, its zip, and, where Blender's module is installed, its installation."""

from __future__ import annotations

import ast
import json
import os
import shutil
import subprocess
import sys
import tomllib
import zipfile

import pack_blender_extension
import pytest
from blender_scene import needs_blender, write_bake

MOST_LINES = 250
# Installs the zip as `blender --command extension install-file --enable` does, uses it and disables it.
USE = """
import json, sys
import bpy  # before the modules that it brings
import addon_utils
archive, folder, target = sys.argv[1:]
def registered():
    return [name for name in dir(bpy.types) if "roomwright" in name.lower()]
def menus():
    return [len(menu._dyn_ui_initialize()) for menu in (bpy.types.TOPBAR_MT_file_import, bpy.types.TOPBAR_MT_file_export)]
before = registered(), menus()
bpy.ops.extensions.package_install_files(filepath=archive, repo="user_default", enable_on_install=True)
during = registered()
bpy.ops.import_scene.roomwright(directory=folder)
collections = sorted(bpy.data.collections.keys())
bpy.ops.export_scene.roomwright(filepath=target, level="house/upper")
addon_utils.disable("bl_ext.user_default.roomwright", default_set=True)
after = registered(), menus()
print("\\n" + json.dumps([before, during, collections, after]))
"""


@pytest.fixture
def archive(tmp_path):
    path = tmp_path / "roomwright.zip"
    assert pack_blender_extension.main(["--out", str(path)]) == 0
    return path


def test_the_manifest_has_what_blender_asks_for(archive):
    with zipfile.ZipFile(archive) as opened:
        manifest = tomllib.loads(opened.read("blender_manifest.toml").decode())
    assert (manifest["schema_version"], manifest["id"], manifest["type"]) == ("1.0.0", "roomwright", "add-on")
    assert manifest["blender_version_min"] == "4.2.0" and manifest["license"] == ["SPDX:MIT", "SPDX:Apache-2.0"]
    assert manifest["name"] and manifest["maintainer"] and list(manifest["permissions"]) == ["files"]
    # Blender's limit, and its rule on the last letter.
    assert len(manifest["tagline"]) <= 64 and manifest["tagline"][-1].isalnum()


def test_the_zip_holds_the_package_and_the_licences_and_nothing_else(archive):
    package = {file.name for file in pack_blender_extension.PACKAGE.iterdir() if file.is_file()}
    with zipfile.ZipFile(archive) as opened:
        assert opened.testzip() is None
        assert opened.namelist() == sorted(package | {"LICENSE-APACHE", "LICENSE-MIT"})


def test_the_same_sources_give_the_same_bytes_at_any_time(archive, tmp_path, monkeypatch):
    copy, again = tmp_path / "roomwright", tmp_path / "again.zip"
    shutil.copytree(pack_blender_extension.PACKAGE, copy, copy_function=shutil.copyfile)
    os.utime(copy / "__init__.py", (0, 1_000_000_000))
    monkeypatch.setattr(pack_blender_extension, "PACKAGE", copy)
    assert pack_blender_extension.main(["--out", str(again)]) == 0
    assert archive.read_bytes() == again.read_bytes()


def test_modules_are_small_and_need_nothing_outside_of_the_package_and_blender():
    known = sys.stdlib_module_names | {"bpy", "bpy_extras", "mathutils"}
    for module in pack_blender_extension.PACKAGE.glob("*.py"):
        text = module.read_text(encoding="utf-8")
        assert text.count("\n") <= MOST_LINES, module.name
        imports = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Import | ast.ImportFrom)]
        names = {alias.name for node in imports if isinstance(node, ast.Import) for alias in node.names}
        names |= {node.module for node in imports if isinstance(node, ast.ImportFrom) and node.level == 0}
        assert {name.partition(".")[0] for name in names} <= known, module.name
        assert all(node.level <= 1 for node in imports if isinstance(node, ast.ImportFrom)), module.name


@needs_blender
def test_blender_installs_it_imports_and_exports_by_it_and_keeps_nothing_of_it(archive, tmp_path):
    bake = write_bake(tmp_path)
    script, target = tmp_path / "use.py", tmp_path / "upper.glb"
    script.write_text(USE)
    done = subprocess.run(
        [sys.executable, str(script), str(archive), str(bake / "house") + os.sep, str(target)], cwd=tmp_path,
        env=os.environ | {"BLENDER_USER_RESOURCES": str(tmp_path / "blender")}, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    before, during, collections, after = json.loads(done.stdout.strip().splitlines()[-1])
    assert during == ["EXPORT_SCENE_OT_roomwright", "IMPORT_SCENE_OT_roomwright", "ROOMWRIGHT_OT_show_part",
                      "ROOMWRIGHT_PT_parts"]
    assert {"house", "house/ground", "house/upper", "house/upper/101 ceiling"} <= set(collections)
    assert target.read_bytes()[:4] == b"glTF"
    assert after == before and before[0] == []
