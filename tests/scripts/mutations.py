"""Documents and bytes with something wrong in them, drawn from a seed."""

from __future__ import annotations

import copy
import json
import random
import re
import struct
from collections.abc import Iterator

NAMES = ["", "..", "../../secret.txt", "/etc/hostname", "%2e%2e/%2e%2e/secret.txt", "file:///etc/hostname", "a\0b",
         "\ud800", "a\nb: [file] forged", "data:application/octet-stream;base64,AAAA", "data:,", "x" * 5000, "desk.1"]
NUMBERS = [-1, 0, 1, 3, 255, 2**31, 2**63, 10**30, -0.5, 1e-300, 1e300, float("inf"), float("nan")]
SHAPES = [None, True, False, [], {}, [[]], [None], {"": {}}, [[0, 0], [1, 1]], {"kind": "room"}, [1, "a", None]]


def mutated(document, draw: random.Random, changes: int):
    """A copy of a JSON document with values replaced, removed, or put where others were."""
    document = copy.deepcopy(document)
    for _ in range(changes):
        places = list(places_of(document))
        owner, key = draw.choice(places)
        action = draw.randrange(8)
        if action == 0:
            del owner[key]
        elif action == 1:
            other, other_key = draw.choice(places)
            owner[key] = copy.deepcopy(other[other_key])
        elif action == 2:
            owner[key] = f"nested {draw.choice([50, 70, 500, 5000, 200000])}"
        else:
            owner[key] = copy.deepcopy(draw.choice(draw.choice([NAMES, NUMBERS, SHAPES])))
    return document


def dumped(document) -> bytes:
    """JSON text; lists in each other are written past the module for it, which stops at some 900."""
    text = json.dumps(document).encode("utf-8", "surrogatepass")
    return re.sub(rb'"nested (\d+)"', lambda found: b"[" * int(found[1]) + b"]" * int(found[1]), text)


def places_of(document) -> Iterator[tuple]:
    """Every place of a value: its owner and its key there."""
    stack = [document]
    while stack:
        owner = stack.pop()
        if isinstance(owner, dict | list):
            for key in owner if isinstance(owner, dict) else range(len(owner)):
                yield owner, key
                stack.append(owner[key])


def mutated_bytes(data: bytes, draw: random.Random) -> bytes:
    """Some bytes with others in their places, cut, or longer."""
    changed = bytearray(data)
    for _ in range(draw.choice([1, 4, 64])):
        changed[draw.randrange(len(changed))] = draw.randrange(256)
    action = draw.randrange(4)
    if action == 0:
        return bytes(changed[:draw.randrange(len(changed))])
    if action == 1:
        # A length in the head: of the file or of its first chunk.
        struct.pack_into("<I", changed, draw.choice([8, 12]), draw.choice([0, 1, 2**31, 2**32 - 1, len(changed)]))
    return bytes(changed)


def glb(document, binary: bytes) -> bytes:
    text = dumped(document)
    text += b" " * (-len(text) % 4)
    length = 12 + 8 + len(text) + 8 + len(binary)
    return (struct.pack("<5I", 0x46546C67, 2, length, len(text), 0x4E4F534A) + text
            + struct.pack("<2I", len(binary), 0x004E4942) + binary)
