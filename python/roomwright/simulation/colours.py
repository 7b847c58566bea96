"""Materials as plain colours, for simulators show few textures and glTF's not at all."""

from __future__ import annotations

import io

import numpy as np
from PIL import Image

from ..gltf_file import GltfFile

# In the names of materials whose texture is a table of plain colours. Of other textures, the mean is shown.
SWATCHES = ".swatches"
# Steps of a channel between which colours are told apart.
STEPS = 16
Rgba = tuple[float, float, float, float]


class Colours:
    """The colours of one file's primitives."""

    def __init__(self, gltf: GltfFile):
        self.gltf = gltf
        self.pixels: dict[int, np.ndarray] = {}

    def groups(self, primitive: dict) -> list[tuple[np.ndarray, Rgba]]:
        """The triangles of a primitive by colour."""
        triangles = primitive["triangles"]
        number = primitive["material"]
        material = self.gltf.entry("materials", number) if number is not None else {}
        surface = material.get("pbrMetallicRoughness", {})
        factor = np.array(surface.get("baseColorFactor", (1.0, 1.0, 1.0, 1.0)), float)
        texture = surface.get("baseColorTexture")
        if texture is None or texture.get("texCoord", 0) >= len(primitive["coordinates"]):
            return [(triangles, shown(factor))]
        coordinates = primitive["coordinates"][texture.get("texCoord", 0)]
        samples = self.samples(texture["index"], coordinates[triangles].mean(axis=1)) * factor
        if SWATCHES not in str(material.get("name")):
            return [(triangles, shown(samples.mean(axis=0)))]
        colours, member = np.unique(np.round(samples * STEPS).astype(int), axis=0, return_inverse=True)
        member = member.reshape(-1)
        return [(triangles[member == i], shown(samples[member == i].mean(axis=0))) for i in range(len(colours))]

    def samples(self, texture: int, coordinates: np.ndarray) -> np.ndarray:
        """The linear colours of an image at some coordinates; images repeat."""
        image = self.gltf.entry("textures", texture)["source"]
        if image not in self.pixels:
            data, _ = self.gltf.image(image)
            with Image.open(io.BytesIO(data)) as opened:
                self.pixels[image] = np.asarray(opened.convert("RGBA"), float) / 255.0
        pixels = self.pixels[image]
        height, width = pixels.shape[:2]
        columns = np.floor(coordinates[:, 0] % 1.0 * width).astype(int).clip(0, width - 1)
        rows = np.floor(coordinates[:, 1] % 1.0 * height).astype(int).clip(0, height - 1)
        found = pixels[rows, columns].copy()
        found[:, :3] = linear(found[:, :3])
        return found


def linear(values: np.ndarray) -> np.ndarray:
    """Of sRGB (IEC 61966-2-1)."""
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def shown(colour: np.ndarray) -> Rgba:
    """A linear colour as simulators show it, in sRGB, to a thousandth."""
    values = colour[:3].clip(0.0, 1.0)
    encoded = np.where(values <= 0.0031308, values * 12.92, 1.055 * values ** (1 / 2.4) - 0.055)
    return tuple(round(float(value), 3) for value in (*encoded, min(max(float(colour[3]), 0.0), 1.0)))
