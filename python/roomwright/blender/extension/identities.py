"""Ids, parents and names of an exported document, as roomwright gives them: docs/output.md, "Nodes"."""

import re
from pathlib import Path

from .glb import rewrite_document

# Blender's name for the copy of a piece, whether or not the piece still exists.
COPY = re.compile(r".+@.+\.\d{3,}")
# A parent that is no object has one of these names, or one of them with a number or an id.
ROOM_PARTS = ("floor", "ceiling", "wall", "column", "door", "window")


def renew_identities(path: Path) -> list[str]:
    """Renews ids, parents and names in the document of a .glb; a line for each that was not as baked."""
    notes: list[str] = []

    def change(document: dict) -> None:
        identities = Identities(document)
        identities.renew()
        notes.extend(identities.notes)

    rewrite_document(path, change)
    return notes


class Identities:
    """The ids, parents and names of a document's nodes; `notes` says which of them were not as baked."""

    def __init__(self, document: dict):
        self.nodes = document["nodes"]
        self.parents = {child: number for number, node in enumerate(self.nodes) for child in node.get("children", [])}
        self.notes: list[str] = []
        self._names: set[str] = set()

    def renew(self) -> None:
        """Seeds and ids, then parents, then names, each of which may use those before."""
        for number in self._of_kind("level"):
            _renew_seed(self._extras(number))
        for number in self._of_kind("room"):
            self._renew_ids(number)
        for number in self._of_kind("furniture"):
            self._renew_parent(number)
        # A node that has its name already keeps it, whatever comes before it in the file.
        wanted = [(self._name(number), number) for number in range(len(self.nodes))]
        for name, number in sorted(wanted, key=lambda one: one[0] != self.nodes[one[1]].get("name")):
            self._rename(number, name)

    def _of_kind(self, kind: str) -> list[int]:
        return [number for number in range(len(self.nodes)) if self._extras(number).get("kind") == kind]

    def _extras(self, number: int) -> dict:
        return self.nodes[number].get("extras") or {}

    def _above(self, number: int, *kinds: str) -> int | None:
        """The nearest ancestor of one of the kinds."""
        above = self.parents.get(number)
        while above is not None and self._extras(above).get("kind") not in kinds:
            above = self.parents.get(above)
        return above

    def _below(self, number: int) -> list[int]:
        found = list(self.nodes[number].get("children", []))
        for one in found:  # grows as it goes
            found += self.nodes[one].get("children", [])
        return found

    def _renew_ids(self, room: int) -> None:
        """Gives each piece of a room an id of its own; of equal ones that with the baked name keeps it."""
        room_id = self._extras(room).get("room")
        # In a scene with two rooms of one name, Blender has numbered everything in the second.
        has_own_names = self.nodes[room].get("name") == f"room:{room_id}"
        pieces = self._pieces_of(room)
        last = _last_numbers(self._extras(number) for number in pieces)
        taken = set()
        for number in pieces:
            extras = self._extras(number)
            is_copy = has_own_names and COPY.fullmatch(self.nodes[number].get("name", ""))
            if is_copy or extras.get("id") in taken or "id" not in extras:
                class_ = str(extras.get("id", "")).rpartition(".")[0] or str(extras.get("class", "piece"))
                last[class_] = last.get(class_, 0) + 1
                extras["id"] = f"{class_}.{last[class_]}"
                self.notes.append(f"{self.nodes[number].get('name')} is a new piece: {extras['id']}@{room_id}")
            taken.add(extras["id"])

    def _pieces_of(self, room: int) -> list[int]:
        """The furniture below a room, that with its baked name first."""
        room_id = self._extras(room).get("room")
        pieces = [number for number in self._below(room) if self._extras(number).get("kind") == "furniture"]
        return sorted(pieces, key=lambda number: (not self._has_baked_name(number, room_id),
                                                  self.nodes[number].get("name", "")))

    def _has_baked_name(self, number: int, room_id) -> bool:
        return self.nodes[number].get("name") == f"{self._extras(number).get('id')}@{room_id}"

    def _renew_parent(self, number: int) -> None:
        extras, above = self._extras(number), self._above(number, "furniture", "room")
        if self._is_arranged_by_one_above(number, above):
            pass
        elif above is not None and self._extras(above).get("kind") == "furniture":
            extras["parent"] = self._extras(above)["id"]
        elif str(extras.get("parent", "")).partition(".")[0].partition(":")[0] not in ROOM_PARTS:
            # Its parent was an object, or it had none.
            extras["parent"], extras["side"] = "floor", "above"
        extras.setdefault("side", "above")

    def _is_arranged_by_one_above(self, number: int, above: int | None) -> bool:
        """Whether a piece names a piece of its room, and is below that piece, below its carrier, or in the room alone."""
        room = self._above(number, "room")
        if room is None:
            return False
        pieces = {extras.get("id"): extras for extras in map(self._extras, self._below(room))
                  if extras.get("kind") == "furniture"}
        chain, parent = [], pieces.get(self._extras(number).get("parent"))
        while parent is not None and parent["id"] not in chain:
            chain.append(parent["id"])
            parent = pieces.get(parent.get("parent"))
        return bool(chain) and (above == room or self._extras(above).get("id") in chain)

    def _name(self, number: int) -> str:
        extras, name = self._extras(number), self.nodes[number].get("name", "")
        kind, room = extras.get("kind"), self._above(number, "room")
        room_id = self._extras(room).get("room") if room is not None else None
        if kind == "level":
            return f"{extras.get('building')}/{extras.get('level')}"
        if kind == "room":
            return f"room:{extras.get('room')}"
        if kind == "opening":
            return f"{extras.get('opening')}:{extras.get('id')}"
        if kind == "light" and (lamp := self._above(number, "furniture")) is not None:
            return f"light.{self._extras(lamp)['id']}@{room_id}"
        if kind == "part" and (opening := self._above(number, "opening")) is not None:
            return f"{extras.get('id', extras.get('part'))}@{self._name(opening)}"
        if kind in ("part", "furniture") and room is not None:
            return f"{extras.get('id', extras.get('part'))}@{room_id}"
        return name

    def _rename(self, number: int, name: str) -> None:
        if name in self._names:
            name = self.nodes[number].get("name", "")
            self.notes.append(f"{name} exists twice; roomwright reads the other one")
        self._names.add(name)
        self.nodes[number]["name"] = name


def _renew_seed(level: dict) -> None:
    """Blender keeps a large number as text."""
    seed = level.get("seed")
    if isinstance(seed, str) and seed.lstrip("-").isdigit():
        level["seed"] = int(seed)


def _last_numbers(pieces) -> dict[str, int]:
    """The highest number of each class among the ids of pieces."""
    last: dict[str, int] = {}
    for extras in pieces:
        class_, _, count = str(extras.get("id", "")).rpartition(".")
        last[class_] = max(last.get(class_, 0), int(count) if count.isdigit() else 0)
    return last
