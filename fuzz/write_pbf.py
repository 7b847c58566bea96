"""Writes the cases of the target `pbf`: the map of corpus/osm/town.osm in protocol buffers, in three ways of packing.

    python fuzz/write_pbf.py

The format: wiki.openstreetmap.org/wiki/PBF_Format. Blocks that are not compressed let damage reach the elements in them.
"""

import struct
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

CORPUS = Path(__file__).parent / "corpus"
KINDS = ["node", "way", "relation"]


def number(value: int) -> bytes:
    """A whole number, seven bits a byte."""
    value &= (1 << 64) - 1
    found = bytearray()
    while value > 0x7F:
        found.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes(found) + bytes([value])


def signed(value: int) -> int:
    """A number with its sign in the lowest bit."""
    return (value << 1) ^ (value >> 63)


def integer(field: int, value: int) -> bytes:
    return number(field << 3) + number(value)


def message(field: int, content: bytes) -> bytes:
    return number(field << 3 | 2) + number(len(content)) + content


def packed(field: int, values: list[int]) -> bytes:
    return message(field, b"".join(map(number, values)))


def differences(values: list[int]) -> list[int]:
    return [signed(value - before) for before, value in zip([0, *values], values)]


def block(name: bytes, content: bytes, is_compressed: bool) -> bytes:
    blob = message(1, content)
    if is_compressed:
        blob = integer(2, len(content)) + message(3, zlib.compress(content))
    header = message(1, name) + integer(3, len(blob))
    return struct.pack(">I", len(header)) + header + blob


def units(element: ElementTree.Element, key: str) -> int:
    """Latitude or longitude in ten-millionths of a degree."""
    return round(float(element.attrib[key]) * 1e7)


class Strings(list):
    """The texts of a block, to which its elements refer by number."""

    def at(self, text: str) -> int:
        if text not in self:
            self.append(text)
        return self.index(text)

    def tags(self, element: ElementTree.Element) -> bytes:
        tags = element.findall("tag")
        return packed(2, [self.at(tag.attrib["k"]) for tag in tags]) + packed(3, [self.at(tag.attrib["v"]) for tag in tags])


def node(element: ElementTree.Element, strings: Strings) -> bytes:
    place = integer(8, signed(units(element, "lat"))) + integer(9, signed(units(element, "lon")))
    return message(1, integer(1, signed(int(element.attrib["id"]))) + strings.tags(element) + place)


def dense_nodes(elements: list[ElementTree.Element], strings: Strings) -> bytes:
    ids = packed(1, differences([int(element.attrib["id"]) for element in elements]))
    places = b"".join(
        packed(field, differences([units(element, key) for element in elements])) for field, key in [(8, "lat"), (9, "lon")]
    )
    tags: list[int] = []
    for element in elements:
        for tag in element.findall("tag"):
            tags += [strings.at(tag.attrib["k"]), strings.at(tag.attrib["v"])]
        tags.append(0)
    return message(2, ids + places + packed(10, tags))


def way(element: ElementTree.Element, strings: Strings) -> bytes:
    nodes = [int(found.attrib["ref"]) for found in element.findall("nd")]
    return message(3, integer(1, int(element.attrib["id"])) + strings.tags(element) + packed(8, differences(nodes)))


def relation(element: ElementTree.Element, strings: Strings) -> bytes:
    members = element.findall("member")
    roles = packed(8, [strings.at(member.attrib["role"]) for member in members])
    ids = packed(9, differences([int(member.attrib["ref"]) for member in members]))
    kinds = packed(10, [KINDS.index(member.attrib["type"]) for member in members])
    return message(4, integer(1, int(element.attrib["id"])) + strings.tags(element) + roles + ids + kinds)


def map_of(root: ElementTree.Element, is_dense: bool, is_compressed: bool) -> bytes:
    strings = Strings([""])
    nodes = root.findall("node")
    groups = [
        dense_nodes(nodes, strings) if is_dense else b"".join(node(element, strings) for element in nodes),
        b"".join(way(element, strings) for element in root.findall("way")),
        b"".join(relation(element, strings) for element in root.findall("relation")),
    ]
    texts = message(1, b"".join(message(1, text.encode()) for text in strings))
    data = texts + b"".join(message(2, group) for group in groups)
    header = message(4, b"OsmSchema-V0.6") + message(4, b"DenseNodes")
    return block(b"OSMHeader", header, is_compressed) + block(b"OSMData", data, is_compressed)


def main() -> None:
    root = ElementTree.parse(CORPUS / "osm" / "town.osm").getroot()
    for name, is_dense, is_compressed in [("dense", True, False), ("plain", False, False), ("compressed", True, True)]:
        (CORPUS / "pbf" / f"{name}.osm.pbf").write_bytes(map_of(root, is_dense, is_compressed))


if __name__ == "__main__":
    main()
