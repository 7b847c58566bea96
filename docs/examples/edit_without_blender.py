"""Makes the edits of edit_in_blender.py in a glTF file, where there is no Blender: docs/walkthrough.sh.

    python docs/examples/edit_without_blender.py before/house/ground.glb edited.glb

Also shows what an edit is in the file: a node has its place as `translation` (metres: east, up, south) and `rotation`
(a quaternion x, y, z, w), both in the frame of the node that it hangs below.
"""

import copy
import math
import os
import sys
from pathlib import Path
from urllib.parse import quote, unquote

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))
from roomwright.blender.extension.glb import write_glb  # noqa: E402
from roomwright.blender.extension.identities import renew_identities  # noqa: E402
from roomwright.gltf_file import GltfFile  # noqa: E402


class Floor:
    """The nodes of a document, by name."""

    def __init__(self, document: dict):
        self.document, self.nodes = document, document["nodes"]

    def find(self, name: str) -> dict:
        for node in self.nodes:
            if node.get("name") == name:
                return node
        room = name.partition("@")[2]
        others = sorted(node["name"] for node in self.nodes if node["name"].endswith(f"@{room}")
                        and node.get("extras", {}).get("kind") == "furniture")
        sys.exit(f"there is no {name} in the file\n  hint: in {room} there are {', '.join(others) or 'no pieces'}")

    def above(self, node: dict) -> dict:
        """The node that a node hangs below."""
        number = self.nodes.index(node)
        return next(one for one in self.nodes if number in one.get("children", []))

    def move(self, node: dict, east: float = 0.0, north: float = 0.0) -> None:
        x, y, z = node.get("translation", (0.0, 0.0, 0.0))
        node["translation"] = [x + east, y, z - north]

    def turn(self, node: dict, degrees: float) -> None:
        """Counter-clockwise seen from above, of a node that stands upright."""
        _, y, _, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
        half = math.atan2(y, w) + math.radians(degrees) / 2.0
        node["rotation"] = [0.0, math.sin(half), 0.0, math.cos(half)]

    def duplicate(self, node: dict) -> dict:
        """A copy with the same mesh beside a node on which nothing stands, named as Blender names copies."""
        copied = copy.deepcopy(node)
        copied["name"] += ".001"
        self.above(node)["children"].append(len(self.nodes))
        self.nodes.append(copied)
        return copied

    def delete(self, node: dict) -> None:
        """Takes out a node and all below it; what comes after it in the list gets lower numbers."""
        self.above(node)["children"].remove(self.nodes.index(node))
        gone = [self.nodes.index(node)]
        for number in gone:  # grows as it goes
            gone += self.nodes[number].get("children", [])
        kept = [number for number in range(len(self.nodes)) if number not in gone]
        renumbered = {old: new for new, old in enumerate(kept)}
        self.nodes[:] = [self.nodes[number] for number in kept]
        for one in (*self.nodes, *self.document["scenes"]):
            for key in {"children", "nodes"} & one.keys():
                one[key] = [renumbered[number] for number in one[key]]


def edit(floor: Floor) -> None:
    # The side table goes along with the armchair that it hangs below, and the chairs with their table.
    floor.move(floor.find("armchair.1@study"), north=0.25)
    floor.turn(floor.find("dining_table.1@living"), -10.0)
    floor.delete(floor.find("cabinet.1@study"))
    floor.move(floor.duplicate(floor.find("plant.1@study")), east=1.1)


def refer_from(folder: Path, document: dict, old_folder: Path) -> None:
    """Images and buffers beside the old file, as paths from another folder."""
    for entry in (*document.get("images", []), *document.get("buffers", [])):
        uri = entry.get("uri", "data:")
        if not uri.startswith("data:"):
            entry["uri"] = quote(Path(os.path.relpath(old_folder / unquote(uri), folder)).as_posix())


def main(old: Path, edited: Path) -> None:
    file = GltfFile(old)
    edit(Floor(file.document))
    refer_from(edited.resolve().parent, file.document, old.resolve().parent)
    write_glb(edited, file.document, file.buffer(0))
    # What blender_export.py does with what Blender wrote: copies get the next free number.
    for note in renew_identities(edited):
        print(note)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]))
