#!/usr/bin/env python3
"""Shows a floor in Blender at its default settings: render_in_blender.py FLOOR PICTURE [options]

FLOOR is a .glb or .gltf (glTF importer) or a .usd, .usda, .usdc, .usdz (USD importer), each with the importer's
defaults, into the factory scene without its cube, light and camera: a grey world, AgX, exposure 0. The engine is Cycles
on the processor, for no other draws without a graphics card. Needs Blender's Python module, see scripts/README.md.

Prints a JSON line like that of render_in_viewers.mjs. Exit 0: there is a picture. 1: there is none.
"""

from __future__ import annotations

import argparse
import json
import logging
import math
import sys
import time
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix, Vector

BLACK, WHITE = 0.02, 0.98


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("floor", type=Path)
    parser.add_argument("picture", type=Path)
    parser.add_argument("--eye", type=point, required=True, metavar="X,Y,Z", help="glTF metres, Y up")
    parser.add_argument("--target", type=point, required=True, metavar="X,Y,Z")
    parser.add_argument("--fov", type=float, default=60.0, help="vertical degrees (default: 60)")
    parser.add_argument("--size", default="800x500", metavar="WxH")
    parser.add_argument("--samples", type=int, default=32, help="per pixel, denoised (default: 32)")
    parser.add_argument("--engine", choices=("CYCLES", "BLENDER_EEVEE"), default="CYCLES")
    return parser.parse_args()


def point(text: str) -> Vector:
    """A point of glTF in Blender, whose Z is up; the USD importer turns the file alike."""
    x, y, z = (float(part) for part in text.split(","))
    return Vector((x, -z, y))


def load(path: Path) -> str:
    """Imports a floor into an otherwise empty factory scene; the importer's name."""
    logging.disable(logging.INFO)
    bpy.ops.wm.read_factory_settings()
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    if path.suffix.startswith(".usd"):
        bpy.ops.wm.usd_import(filepath=str(path.resolve()))
        return "usd"
    bpy.ops.import_scene.gltf(filepath=str(path.resolve()), loglevel=50)
    return "gltf"


def place_camera(options: argparse.Namespace) -> None:
    lens = bpy.data.cameras.new("eye")
    lens.sensor_fit, lens.angle = "VERTICAL", math.radians(options.fov)
    lens.clip_start = 0.05
    camera = bpy.data.objects.new("eye", lens)
    turn = (options.target - options.eye).to_track_quat("-Z", "Y").to_matrix().to_4x4()
    camera.matrix_world = Matrix.Translation(options.eye) @ turn
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def render(options: argparse.Namespace) -> None:
    scene = bpy.context.scene
    settings = scene.render
    settings.engine = options.engine
    settings.resolution_x, settings.resolution_y = (int(side) for side in options.size.split("x"))
    settings.filepath = str(options.picture.resolve())
    settings.image_settings.file_format = "PNG"
    if options.engine == "CYCLES":
        scene.cycles.device, scene.cycles.samples = "CPU", options.samples
        scene.cycles.use_denoising, scene.cycles.denoiser = True, "OPENIMAGEDENOISE"
    bpy.ops.render.render(write_still=True)


def measure(path: Path) -> dict[str, float]:
    """Luminance as displayed, 0 to 1, and shares of pixels that are as good as black or white."""
    image = bpy.data.images.load(str(path.resolve()))
    image.colorspace_settings.name = "Non-Color"
    luminance = np.array(image.pixels[:]).reshape(-1, 4)[:, :3] @ (0.2126, 0.7152, 0.0722)
    dark, middle, bright = np.percentile(luminance, (5, 50, 95))
    figures = {
        "mean": luminance.mean(), "dark": dark, "middle": middle, "bright": bright,
        "black": (luminance < BLACK).mean(), "white": (luminance > WHITE).mean(),
    }
    return {name: round(float(value), 3) for name, value in figures.items()}


def main() -> int:
    options = parse()
    started = time.monotonic()
    importer = load(options.floor)
    loaded = time.monotonic()
    place_camera(options)
    kinds = [thing.type for thing in bpy.data.objects]
    render(options)
    report = {
        "client": f"blender_{importer}", "is_loaded": True, "version": bpy.app.version_string,
        "load_ms": round((loaded - started) * 1000), "frame_ms": round((time.monotonic() - loaded) * 1000),
        "nodes": len(kinds) - 1, "mesh_nodes": kinds.count("MESH"), "lights": kinds.count("LIGHT"),
        "picture": str(options.picture), **measure(options.picture),
    }
    print(json.dumps(report))
    return 0


if __name__ == "__main__":
    sys.exit(main())
