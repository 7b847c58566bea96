"""One floor's document: its bytes, and keys by which equal meshes and materials of all floors are found."""

import hashlib
import json
from pathlib import Path

from .errors import BakeError
from .glb import binary_chunk, read_document
from .resources import locate

COMPONENT_SIZES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
COMPONENT_COUNTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}


class Document:
    """A floor's document. Equal keys mean equal content, in this file and in others."""

    def __init__(self, path: Path, buffers: dict):
        """`buffers` holds the bytes of files by path, for all floors of an import."""
        self.path, self.json = path, read_document(path)
        self._buffers = buffers
        self._digests: dict[int, bytes] = {}
        self.material_keys = [self._material_key(material) for material in self.json.get("materials", [])]
        self.mesh_keys = [self._mesh_key(mesh) for mesh in self.json.get("meshes", [])]

    @property
    def lights(self) -> list[dict]:
        return self.json.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])

    def forget(self) -> None:
        """Lets the file's own bytes go; those of shared files stay."""
        self._buffers.pop(self.path, None)

    def resource(self, uri: object) -> Path:
        """The file of a URI. Raises BakeError where the floor may not name it."""
        return locate(uri, self.path)

    def view_bytes(self, index: int) -> bytes:
        """The bytes of a buffer view."""
        view = self.json["bufferViews"][index]
        start = view.get("byteOffset", 0)
        return self._buffer(view["buffer"])[start:start + view["byteLength"]]

    def accessor_bytes(self, index: int) -> bytes:
        """The bytes of an accessor from its first row to its last, with what lies between rows."""
        accessor = self.json["accessors"][index]
        if "sparse" in accessor or "bufferView" not in accessor:
            raise BakeError(f"{self.path}: accessor {index} is sparse or compressed; export without compression, or use "
                            "File > Import > glTF")
        view = self.json["bufferViews"][accessor["bufferView"]]
        size = COMPONENT_SIZES[accessor["componentType"]] * COMPONENT_COUNTS[accessor["type"]]
        length = view.get("byteStride", size) * (accessor["count"] - 1) + size
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        data = self._buffer(view["buffer"])[start:start + length]
        if len(data) < length:
            raise BakeError(f"{self.path}: is cut off: accessor {index} reaches past its end")
        return data

    def image_key(self, index: int) -> str:
        """The path of an image, or the hash of one inside the file."""
        image = self.json["images"][index]
        if "bufferView" in image:
            return digest(self.view_bytes(image["bufferView"])).hex()
        path = self.resource(image["uri"])
        if not path.is_file():
            raise BakeError(f"{self.path}: its texture {path} is missing\n"
                            "  hint: keep shared-textures/ beside the floor, or bake without --shared-textures")
        return str(path)

    def _buffer(self, index: int) -> memoryview:
        uri = self.json["buffers"][index].get("uri")
        if isinstance(uri, str) and uri.startswith("data:"):
            raise BakeError(f"{self.path}: has a buffer in its text, which roomwright does not write; open it with "
                            "File > Import > glTF")
        path = self.path if uri is None else self.resource(uri)
        if path not in self._buffers:
            data = path.read_bytes()
            self._buffers[path] = binary_chunk(data) if uri is None else memoryview(data)
        return self._buffers[path]

    def _accessor_digest(self, index: int) -> bytes:
        if index not in self._digests:
            accessor = self.json["accessors"][index]
            view = self.json["bufferViews"][accessor.get("bufferView", 0)]
            form = (accessor["componentType"], accessor["type"], accessor["count"], accessor.get("normalized"),
                    view.get("byteStride"))
            self._digests[index] = digest(repr(form).encode(), self.accessor_bytes(index))
        return self._digests[index]

    def _mesh_key(self, mesh: dict) -> bytes:
        words = []
        for primitive in mesh["primitives"]:
            words.append(str(primitive.get("mode", 4)).encode())
            for name, index in sorted(primitive["attributes"].items()):
                words += [name.encode(), self._accessor_digest(index)]
            if "indices" in primitive:
                words.append(self._accessor_digest(primitive["indices"]))
            if "material" in primitive:
                words.append(self.material_keys[primitive["material"]])
            words.append(json.dumps(primitive.get("extensions"), sort_keys=True).encode())
        return digest(*words)

    def _material_key(self, material: dict) -> bytes:
        return digest(json.dumps(self._with_images(material), sort_keys=True).encode())

    def _with_images(self, value, key: str = ""):
        """A part of a material in which each texture's number is replaced by its image and sampler."""
        if isinstance(value, list):
            return [self._with_images(one) for one in value]
        if not isinstance(value, dict):
            return value
        copy = {name: self._with_images(one, name) for name, one in value.items()}
        if key.endswith("Texture") and "index" in copy:
            texture = self.json["textures"][copy["index"]]
            sampler = self.json["samplers"][texture["sampler"]] if "sampler" in texture else None
            copy["index"] = [self.image_key(texture["source"]), sampler]
        return copy


def light_key(light: dict) -> str:
    return json.dumps(light, sort_keys=True)


def digest(*words: bytes) -> bytes:
    state = hashlib.blake2b(digest_size=16)
    for word in words:
        state.update(len(word).to_bytes(8, "little"))
        state.update(word)
    return state.digest()
