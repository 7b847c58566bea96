"""Finds the room types of names: the longest known words in them, as the program does for names in other formats.

The words are those of names in many languages, `formats.ifc` in `configs/room_words.yaml` (src/plan/read/room_names.rs reads the same).
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import yaml

WORDS_FILE = Path(__file__).with_name("room_words.yaml")
FORMAT = "ifc"
# The type of rooms of which nothing is known.
GENERIC = "generic"
# Names of rooms are short; what goes on for long is a remark.
MOST_WORDS = 12


def plain_words(text: str) -> list[str]:
    """The words of a text in lower case, without numbers: "Bedroom 2.04" is a bedroom."""
    words = "".join(letter if letter.isalnum() else " " for letter in text).split()
    return [word.lower() for word in words if not any(letter.isnumeric() for letter in word)]


def key_of(name: str) -> str:
    """By which a name of the layer map is compared."""
    return " ".join(plain_words(name))


@cache
def published_words() -> dict[str, str]:
    """The room types of names in many languages."""
    table = yaml.load(WORDS_FILE.read_text(encoding="utf-8"), Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    return {str(word).lower(): str(room_type) for word, room_type in table["formats"][FORMAT].items()}


def room_type_of(name: str, own: dict[str, str]) -> str | None:
    """The room type of the longest run of words that a table knows, `own` before the published ones.

    Of equal runs the last counts, which mostly carries the sense ("kitchen store"); a generic room only if nothing else is known.
    """
    words = plain_words(name)[:MOST_WORDS]
    runs = [" ".join(words[start:start + length]) for length in range(len(words), 0, -1)
            for start in range(len(words) - length, -1, -1)]
    for table in (own, published_words()):
        found = [table[run] for run in runs if run in table]
        telling = [room_type for room_type in found if room_type != GENERIC]
        if found:
            return (telling or found)[0]
    return None
