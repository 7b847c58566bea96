"""How a picture is made: engine, size, samples and exposure. Needs bpy."""

from __future__ import annotations

import math
import tempfile
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np

ENGINES = {"cycles": "CYCLES", "eevee": "BLENDER_EEVEE", "workbench": "BLENDER_WORKBENCH"}
# Luminance that the pictures' mean is brought to, and how many stops that may take.
MIDDLE_GREY, LEAST_STOPS, MOST_STOPS = 0.30, -4.0, 6.0


@dataclass(frozen=True)
class Quality:
    """The user's choices: pixels, samples for each pixel, engine."""

    width: int = 960
    height: int = 720
    samples: int = 64
    engine: str = "cycles"


def set_quality(scene, quality: Quality, is_transparent: bool) -> None:
    render = scene.render
    render.engine = ENGINES[quality.engine]
    render.resolution_x, render.resolution_y, render.resolution_percentage = quality.width, quality.height, 100
    render.film_transparent = is_transparent
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGBA"
    if quality.engine == "cycles":
        set_cycles(scene.cycles, quality.samples)
    elif quality.engine == "eevee":
        scene.eevee.taa_render_samples = quality.samples
    else:
        _set_workbench(scene.display)
    view = scene.view_settings
    view.view_transform = "Standard" if quality.engine == "workbench" else "AgX"
    view.look = "None" if quality.engine == "workbench" else "AgX - Medium High Contrast"
    view.exposure = 0.0


def set_cycles(cycles, samples: int) -> None:
    cycles.device, cycles.seed, cycles.samples = "CPU", 0, samples
    cycles.use_adaptive_sampling = False
    cycles.use_denoising, cycles.denoiser = True, "OPENIMAGEDENOISE"
    cycles.denoising_input_passes, cycles.denoising_prefilter = "RGB_ALBEDO_NORMAL", "FAST"
    cycles.max_bounces, cycles.diffuse_bounces, cycles.glossy_bounces = 5, 3, 2
    cycles.transmission_bounces, cycles.transparent_max_bounces = 4, 8
    cycles.caustics_reflective = cycles.caustics_refractive = False
    cycles.sample_clamp_indirect = 6.0


def _set_workbench(display) -> None:
    display.shading.light, display.shading.color_type = "STUDIO", "TEXTURE"
    display.shading.show_cavity, display.shading.show_shadows = True, True
    display.render_aa = "8"


def expose(scene) -> None:
    """Brings the middle of a small picture's brightness to a usual one, as a camera does."""
    render, settings = scene.render, scene.render.image_settings
    size, samples = (render.resolution_x, render.resolution_y), scene.cycles.samples
    largest = max(size)
    render.resolution_x, render.resolution_y = (max(8, round(side * 96 / largest)) for side in size)
    settings.file_format, scene.cycles.samples = "OPEN_EXR", 8
    with tempfile.TemporaryDirectory() as folder:
        render.filepath = str(Path(folder) / "small.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(render.filepath)
        pixels = np.array(image.pixels[:]).reshape(-1, 4)
        bpy.data.images.remove(image)
    render.resolution_x, render.resolution_y = size
    settings.file_format, scene.cycles.samples = "PNG", samples
    scene.view_settings.exposure = stops(pixels)


def stops(pixels: np.ndarray) -> float:
    """Stops of exposure for linear pixels, rows of red, green, blue and cover."""
    seen = pixels[pixels[:, 3] > 0.5]
    if not len(seen):
        return 0.0
    luminance = np.clip(seen[:, :3] @ (0.2126, 0.7152, 0.0722), 1e-4, 8.0)
    # The geometric mean lets a bright window and a dark corner weigh alike.
    mean = math.exp(float(np.log(luminance).mean()))
    return min(max(math.log2(MIDDLE_GREY / mean), LEAST_STOPS), MOST_STOPS)
