"""A copy of a floor's document that holds only the meshes and lights that no earlier floor had.

Blender's importer reads the copy. The importer does not keep their order. Therefore marks in the copy say which is which.
"""

from dataclasses import dataclass
from urllib.parse import quote

from .document import Document, light_key

# Custom properties of the importer's objects and materials: their number in the copy's keys, in the document.
NODE_MARK, MATERIAL_MARK = "roomwright_node", "roomwright_material"
# How the names of images from inside the file begin; their number in the document follows.
IMAGE_MARK = "roomwright-"
KEPT = ("asset", "textures", "samplers", "extensionsUsed", "extensions")


@dataclass(frozen=True)
class Reduced:
    """A document with a node for each key, and its binary chunk."""

    keys: list
    document: dict
    binary: bytes


def reduce_document(document: Document, known_data, known_materials) -> Reduced:
    """The meshes and lights whose keys are not in `known_data`; materials in `known_materials` keep only their names."""
    packer, keys, nodes = _Packer(document), {}, []
    for index, key in enumerate(document.mesh_keys):
        if key not in known_data and key not in keys:
            packer.add(document.json["meshes"][index])
            nodes.append({"mesh": len(keys), "extras": {NODE_MARK: len(keys)}})
            keys[key] = len(keys)
    for index, light in enumerate(document.lights):
        if (key := light_key(light)) not in known_data and key not in keys:
            nodes.append({"extensions": {"KHR_lights_punctual": {"light": index}}, "extras": {NODE_MARK: len(keys)}})
            keys[key] = len(keys)
    whole = {key: value for key, value in document.json.items() if key in KEPT}
    whole |= {"scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": packer.meshes,
              "materials": _marked_materials(document, known_materials),
              "images": [_marked_image(document, index, packer) for index in range(len(document.json.get("images", [])))],
              "accessors": packer.accessors, "bufferViews": packer.views}
    if packer.binary:
        whole["buffers"] = [{"byteLength": len(packer.binary)}]
    return Reduced(list(keys), {key: value for key, value in whole.items() if value != []}, bytes(packer.binary))


def _marked_materials(document: Document, known) -> list[dict]:
    marked = []
    for index, (material, key) in enumerate(zip(document.json.get("materials", []), document.material_keys)):
        whole = {} if key in known else material
        extras = (whole.get("extras") or {}) | {MATERIAL_MARK: index}
        marked.append(whole | {"name": material.get("name", ""), "extras": extras})
    return marked


def _marked_image(document: Document, index: int, packer: "_Packer") -> dict:
    image = document.json["images"][index]
    if "bufferView" not in image:
        return image | {"uri": quote(str(document.resource(image["uri"])))}
    view = packer.view(document.view_bytes(image["bufferView"]))
    return image | {"bufferView": view, "name": f"{IMAGE_MARK}{index}"}


class _Packer:
    """Meshes for the copy, with accessors, buffer views and bytes of their own."""

    def __init__(self, source: Document):
        self._source, self._moved = source, {}
        self.binary, self.views = bytearray(), []
        self.accessors, self.meshes = [], []

    def add(self, mesh: dict) -> None:
        primitives = []
        for primitive in mesh["primitives"]:
            attributes = {name: self._accessor(index) for name, index in primitive["attributes"].items()}
            indices = {"indices": self._accessor(primitive["indices"])} if "indices" in primitive else {}
            primitives.append(primitive | {"attributes": attributes} | indices)
        self.meshes.append(mesh | {"primitives": primitives})

    def _accessor(self, index: int) -> int:
        if index not in self._moved:
            accessor = self._source.json["accessors"][index]
            stride = self._source.json["bufferViews"][accessor["bufferView"]].get("byteStride")
            view = self.view(self._source.accessor_bytes(index), stride)
            self.accessors.append(accessor | {"bufferView": view, "byteOffset": 0})
            self._moved[index] = len(self.accessors) - 1
        return self._moved[index]

    def view(self, data: bytes, stride: int | None = None) -> int:
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        self.views.append(view | ({"byteStride": stride} if stride else {}))
        self.binary += data
        return len(self.views) - 1
