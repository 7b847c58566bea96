"""The tree of objects and collections that the nodes of floors become."""

import math

import bpy
from mathutils import Matrix, Quaternion

from .assets import make_asset
from .datablocks import Datablocks
from .document import Document, light_key
from .errors import damage_of
from .floors import Floor
from .options import Options
from .parts import PARTS, shown_nodes, sort_nodes
from .visibility import ROLE, collections_of, show

# Lights shine along -Z in Blender and along -Y after a node's axes were turned.
LIGHT_TURN = Quaternion((math.sqrt(0.5), math.sqrt(0.5), 0.0, 0.0))


class Builder:
    """One import: the datablocks that it has read, and the collections and objects that it has made."""

    def __init__(self, options: Options, scene):
        self.options, self.scene = options, scene
        self.datablocks = Datablocks(bpy.data.scenes.new("roomwright import"))
        self.unit = 1.0 / scene.unit_settings.scale_length
        self.datablocks.scene.unit_settings.scale_length = scene.unit_settings.scale_length
        self.collections, self.models = {}, {}
        self.object_count = 0

    def create(self, documents: list[Document]) -> list[list]:
        """The objects of all nodes, without places, properties and collections.

        In the order of their names, in which Blender keeps them: it looks for the place of a new one from the end.
        """
        names, objects = [], []
        for number, document in enumerate(documents):
            nodes = document.json.get("nodes", [])
            with damage_of(document.path):
                names += [(nodes[index].get("name") or "node", number, index) for index in shown_nodes(document.json)]
            objects.append([None] * len(nodes))
        for name, number, index in sorted(names, key=lambda one: (one[0].casefold(), *one)):
            document = documents[number]
            with damage_of(document.path):
                data = self._data(document, document.json["nodes"][index])
            objects[number][index] = bpy.data.objects.new(name, data)
        self.object_count = len(names)
        return objects

    def build(self, floor: Floor, document: Document, objects: list) -> None:
        """Gives a floor's objects the properties, places and parents of their nodes, in the floor's collections."""
        nodes = document.json.get("nodes", [])
        for node, thing, (room, part) in zip(nodes, objects, sort_nodes(nodes)):
            if thing is None:
                continue
            if thing.data is None:
                thing.empty_display_size = 0.1
            _set_extras(thing, node.get("extras") or {})
            self._set_transform(thing, node)
            self._collection_of(floor, room, part).objects.link(thing)
            if part == "furniture" and thing.type == "MESH" and "class" in thing:
                self.models.setdefault(thing.data, thing)
        for node, thing in zip(nodes, objects):
            for child in node.get("children", []) if thing else []:
                objects[child].parent = thing
        if self.options.place:
            self._place(floor, [thing for thing in objects if thing and thing.parent is None])

    def finish(self) -> None:
        """Links the buildings into the scene, hides ceilings and marks assets as asked, removes the importer's scene."""
        for key, building in self.collections.items():
            if len(key) == 1 and building.name not in self.scene.collection.children:
                self.scene.collection.children.link(building)
        if not self.options.ceilings:
            own = set(self.collections.values())
            show([one for one in collections_of("ceiling") if one.collection in own], False)
        if self.options.assets:
            for mesh, model in self.models.items():
                make_asset(mesh, model)
        bpy.data.scenes.remove(self.datablocks.scene)

    def _data(self, document: Document, node: dict):
        light = node.get("extensions", {}).get("KHR_lights_punctual", {}).get("light")
        if light is not None:
            return self.datablocks.lights[light_key(document.lights[light])]
        return self.datablocks.meshes[document.mesh_keys[node["mesh"]]] if "mesh" in node else None

    def _set_transform(self, thing, node: dict) -> None:
        """Blender's axes from glTF's: x, y, z become x, -z, y, as in Blender's own importer."""
        x, y, z = node.get("translation", (0.0, 0.0, 0.0))
        thing.location = (x * self.unit, -z * self.unit, y * self.unit)
        x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
        turn = Quaternion((w, x, -z, y))
        thing.rotation_mode = "QUATERNION"
        thing.rotation_quaternion = turn @ LIGHT_TURN if thing.type == "LIGHT" else turn
        x, y, z = node.get("scale", (1.0, 1.0, 1.0))
        thing.scale = (x, z, y)

    def _place(self, floor: Floor, roots: list) -> None:
        level = next(thing for thing in roots if thing.get("kind") == "level")
        place = Matrix.Rotation(floor.turn, 4, "Z")
        place.translation = [metres * self.unit for metres in (*floor.position, floor.elevation)]
        # A level that was exported from its place has that place in its node.
        move = place @ level.matrix_basis.inverted_safe()
        for thing in roots:
            thing.matrix_basis = move @ thing.matrix_basis

    def _collection_of(self, floor: Floor, room: str | None, part: str):
        """The collection building / level / room / part."""
        key, name = (floor.building, floor.path), floor.name
        found = self._collection(key[:1], "building", floor.building)
        found = self._collection(key, "level", name, found)
        if room is not None:
            key, name = (*key, room), f"{name}/{room}"
            found = self._collection(key, "room", name, found)
        return self._collection((*key, part), part, f"{name} {part}", found) if part in PARTS else found

    def _collection(self, key: tuple, role: str, name: str, above=None):
        if key in self.collections:
            return self.collections[key]
        found = bpy.data.collections.get(name) if role == "building" else None
        if found is None or found.get(ROLE) != role:
            found = bpy.data.collections.new(name)
            found[ROLE] = role
        if above is not None:
            above.children.link(found)
        self.collections[key] = found
        return found


def _set_extras(thing, extras: dict) -> None:
    """Custom properties, as Blender's importer makes them: a value that they cannot hold becomes text."""
    for name, value in extras.items():
        try:
            thing[name] = value
        except (OverflowError, TypeError, ValueError):
            thing[name] = str(value)
