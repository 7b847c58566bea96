"""The rooms of the gallery as plans: one room of each type, one of each style. Pure: catalogue in, plans out.

Sizes follow the samples of docs/catalogue.md: the geometric mean of a type's usual areas, a door, a window where
people sit or lie, two doors where people pass, railings in the open, a gate for cars.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

# Square metres of a room whose type has no usual area, and of the largest room.
USUAL, LARGEST = 20.0, 60.0
PROPORTION, WAY_PROPORTION = 1.3, 4.0
HEIGHT = 3.0
# Styles for the room types of one file of configuration, where a type is made in them.
STYLES_OF_FILES = {"homes": "home_modern", "hotels": "hotel", "offices": "office_modern", "restaurants": "restaurant_simple",
                   "schools": "university", "shops": "retail_bright", "health": "clinic", "service": "workshop_industrial",
                   "leisure": "gym_industrial"}
# Room types that show a style best, by the first word of its name; types that a style is not made for are skipped.
ROOMS_OF_STYLES = {"home": "living_room", "hotel": "hotel_room", "office": "office", "restaurant": "restaurant",
                   "library": "library", "gym": "gym", "retail": "shop", "workshop": "workshop", "clinic": "examination_room",
                   "university": "classroom", "paper": "restaurant", "default": "living_room"}


@dataclass(frozen=True)
class Catalog:
    """Room types, styles and the groups of classes."""

    room_types: dict[str, dict]
    styles: dict[str, dict]
    groups: dict[str, set[str]]
    ceiling_classes: set[str]

    @staticmethod
    def read(documents: dict[str, dict]) -> Catalog:
        """From the answers of `roomwright catalog rooms|styles|classes --json`."""
        classes = documents["classes"]["classes"]
        hang = {one["id"] for one in classes if any("ceiling" in rule["on"] for rule in one["parents"])}
        return Catalog({one["id"]: one for one in documents["rooms"]["room_types"]},
                       {one["id"]: one for one in documents["styles"]["styles"]},
                       {one["id"]: set(one["groups"]) for one in classes}, hang)

    def furnished(self) -> list[dict]:
        return [one for one in self.room_types.values() if one["furnish"]]

    def classes_of(self, room_type: dict) -> set[str]:
        return {name for request in room_type["programme"] for name in request["class"]}

    def holds(self, room_type: dict, *groups: str) -> bool:
        return any(self.groups.get(name, set()) & set(groups) for name in self.classes_of(room_type))


def room_style(room_type: dict) -> str:
    """The style that a type is shown in."""
    file = room_type["file"].rsplit("/", 1)[-1].removesuffix(".yaml")
    style = STYLES_OF_FILES.get(file, "default")
    return style if style in room_type["styles"] else "default"


def style_room(catalog: Catalog, style: str) -> dict:
    """The room type that shows a style: the usual one for its name, else the first that is made in it."""
    usual = catalog.room_types.get(ROOMS_OF_STYLES.get(style.split("_")[0], ""))
    made = [one for one in catalog.furnished() if style in one["styles"]]
    return usual if usual in made or not made else made[0]


def rooms_plan(catalog: Catalog, wanted: set[str]) -> dict:
    """A building whose levels are the room types."""
    levels = [level(catalog, one, one["id"], room_style(one)) for one in catalog.furnished()
              if not wanted or one["id"] in wanted]
    return {"version": 1, "id": "rooms", "levels": levels}


def styles_plan(catalog: Catalog, wanted: set[str]) -> dict:
    """A building whose levels are the styles."""
    levels = [level(catalog, style_room(catalog, style), style, style) for style in catalog.styles
              if not wanted or style in wanted]
    return {"version": 1, "id": "styles", "levels": levels}


def level(catalog: Catalog, room_type: dict, name: str, style: str) -> dict:
    """A level with one room."""
    is_outdoors = not catalog.classes_of(room_type) & catalog.ceiling_classes
    is_way = not is_outdoors and "work" in room_type["excludes"] and room_type["density"][1] <= 0.2
    width, depth = size(room_type, is_way)
    room = {"id": "room", "type": room_type["id"], "style": style, "rectangle": [0, 0, width, depth]}
    if is_outdoors:
        room["walls"] = [{"edge": [1, 2, 3], "railing": True}]
    openings = _openings(catalog, room_type, (width, depth), is_outdoors, is_way)
    return {"id": name, "height": HEIGHT, "rooms": [room], "openings": openings}


def size(room_type: dict, is_way: bool) -> tuple[float, float]:
    """Metres from west to east and from south to north."""
    least, most = room_type["area"]
    mean = math.sqrt(least * most) if least > 0 else USUAL
    area = max(least, min(mean, LARGEST, most))
    proportion = WAY_PROPORTION if is_way else PROPORTION if area >= 4.0 else 1 / PROPORTION
    depth = math.sqrt(area / proportion)
    return round(area / depth, 1), round(depth, 1)


def _openings(catalog: Catalog, room_type: dict, extent: tuple[float, float], is_outdoors: bool,
              is_way: bool) -> list[dict]:
    width, depth = extent
    area = width * depth
    leaf, leaves = (1.6, 2) if area >= 60.0 else (0.9, 1)
    door = {"kind": "door", "room": "room", "width": min(leaf, width - 0.2, depth - 0.2), "leaves": leaves,
            "opens_into": "room" if area >= 4.0 else "outside"}
    if is_way:
        return [door | {"edge": 3, "at": depth / 2}, door | {"edge": 1, "at": depth / 2}]
    openings = [door | {"edge": 0, "at": min(0.35 + leaf / 2, width / 2)}]
    if catalog.holds(room_type, "vehicle"):
        openings.append({"kind": "sliding_door", "room": "room", "edge": 1, "width": 2.5, "head": 2.2})
    is_filled = any("fill" in str(request["count"]) and catalog.holds({"programme": [request]}, "seat")
                    for request in room_type["programme"])
    if not is_outdoors and not is_filled and catalog.holds(room_type, "seat", "bed"):
        openings.append({"kind": "window", "room": "room", "edge": 2, "width": round(width * 0.45, 2), "sill": 0.9,
                         "head": 2.2})
    return openings
