"""Meshes, materials, images and lights of all floors of an import, each read once by Blender's own importer."""

import logging
import tempfile
from pathlib import Path

import bpy

from .document import Document
from .errors import BakeError
from .glb import write_glb
from .reduced import IMAGE_MARK, MATERIAL_MARK, NODE_MARK, reduce_document

# Options of Blender's importer; older versions lack some of them.
IMPORT_OPTIONS = {"import_select_created_objects": False, "import_scene_as_collection": False, "loglevel": 50}


class Datablocks:
    """The datablocks that have been read, by the keys of document.py."""

    def __init__(self, scene):
        self.meshes, self.materials, self.images, self.lights = {}, {}, {}, {}
        self.buffers = {}  # bytes of files that several floors use, by path
        self.scene = scene  # the importer's own

    def read(self, document: Document) -> None:
        """Reads the meshes, materials, images and lights that no earlier file had. Raises BakeError."""
        reduced = reduce_document(document, self.meshes.keys() | self.lights.keys(), self.materials)
        if not reduced.keys:
            return
        with tempfile.TemporaryDirectory(prefix="roomwright-") as folder:
            path = Path(folder) / "floor.glb"
            write_glb(path, reduced.document, reduced.binary)
            _import_gltf(path, document.path)
        carriers = list(self.scene.collection.all_objects)
        garbage, marked = set(carriers), set()
        for carrier in carriers:
            if carrier.type == "MESH":
                self._adopt_materials(document, carrier.data, marked, garbage)
            known = self.meshes if carrier.type == "MESH" else self.lights
            known[reduced.keys[carrier[NODE_MARK]]] = carrier.data
        for material in marked:
            del material[MATERIAL_MARK]
        bpy.data.batch_remove(garbage)

    def _adopt_materials(self, document: Document, mesh, marked: set, garbage: set) -> None:
        for slot, material in enumerate(mesh.materials):
            if material is None:
                continue
            known = self.materials.setdefault(document.material_keys[material[MATERIAL_MARK]], material)
            if known == material:
                marked.add(material)
                self._adopt_images(document, material, garbage)
            else:
                mesh.materials[slot] = known
                garbage.add(material)

    def _adopt_images(self, document: Document, material, garbage: set) -> None:
        """Images from inside the file. Blender's importer shares images that have files of their own."""
        for node in material.node_tree.nodes if material.node_tree else []:
            image = getattr(node, "image", None)
            if image is None or not image.name.startswith(IMAGE_MARK):
                continue
            index = int(image.name[len(IMAGE_MARK):].partition(".")[0])
            known = self.images.setdefault(document.image_key(index), image)
            if known == image:
                image.name = document.json["images"][index].get("name") or "image"
            else:
                node.image = known
                garbage.add(image)


def _import_gltf(path: Path, source: Path) -> None:
    """Blender's importer, with its defaults, into the scene of the window."""
    known = bpy.ops.import_scene.gltf.get_rna_type().properties.keys()
    silenced = logging.root.manager.disable
    logging.disable(logging.ERROR)  # it has a line for each mesh
    try:
        bpy.ops.import_scene.gltf(filepath=str(path),
                                  **{name: value for name, value in IMPORT_OPTIONS.items() if name in known})
    except RuntimeError as error:
        raise BakeError(f"{source}: Blender cannot read it: {error}") from error
    finally:
        logging.disable(silenced)
