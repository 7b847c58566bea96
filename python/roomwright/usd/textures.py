"""Images of textures: copied once a run into the folder that all levels share."""

from __future__ import annotations

import hashlib
from pathlib import Path

from ..gltf_file import GltfFile

from .settings import TEXTURE_FOLDER, Settings
from .writing import is_of_this_run, relative_path, write_bytes

HASH_LENGTH = 12


class Textures:
    """The images of one glTF file as the layers of a folder name them."""

    def __init__(self, gltf: GltfFile, settings: Settings, target: Path):
        self.gltf = gltf
        self.settings = settings
        shared = settings.root / TEXTURE_FOLDER
        self.folder = target.with_suffix(".textures") if settings.is_self_contained else shared
        self.files: dict[int, Path] = {}
        self.copies: set[Path] = set()
        self.paths: dict[tuple[int, Path], str] = {}

    def path(self, texture: int, layer_folder: Path) -> str:
        """The path of a texture's image, relative to a layer in a folder."""
        image = self.gltf.entry("textures", texture)["source"]
        if image not in self.files:
            self.files[image] = self.own_file(image) or self.copy(image)
        if (image, layer_folder) not in self.paths:
            self.paths[image, layer_folder] = relative_path(self.files[image], layer_folder)
        return self.paths[image, layer_folder]

    def own_file(self, image: int) -> Path | None:
        """The image's file, where it can stay."""
        return None if self.settings.copies_images else self.gltf.image_file(image)

    def copy(self, image: int) -> Path:
        """Equal content has one file, whatever it was called: floors call one image by many names."""
        data, ending = self.gltf.image(image)
        file = self.folder / f"{hashlib.sha256(data).hexdigest()[:HASH_LENGTH]}{ending}"
        self.copies.add(file)
        if not is_of_this_run(file, self.settings.started):
            write_bytes(data, file, self.settings.root)
        return file
