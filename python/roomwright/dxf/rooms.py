"""Rooms of a level: closed outlines, and the texts in them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field

from ezdxf.entities.insert import Insert
from ezdxf.entities.mtext import MText
from ezdxf.entities.text import Text
from shapely import Point as Location
from shapely import Polygon, STRtree, union_all
from shapely.validation import explain_validity

from .drawing import Drawn, parts_of
from .faults import Place, Report
from .room_types import GENERIC, room_type_of
from .shapes import MARKS, MOST_CORNERS, Point, Scale, Shape, ShapeError, shapes_of

# Square metres under which an outline is a mark and no room.
LEAST_AREA = 0.05
# Metres of the longest side that the program takes (src/plan/limits.rs).
LARGEST_SIDE = 1_000.0
# Square metres that two outlines may share: lines are drawn by hand.
OVERLAP = 0.05
# Share of the smaller outline from which on two are the same, drawn twice.
SAME = 0.98
# Letters of a name that the program takes with ease.
LONGEST_NAME = 100
# Letters of a text, and of a line of it, that are looked at.
LONGEST_TEXT, LONGEST_LINE = 2_000, 200
# A size, or a number alone: "13.5 m2", "NRF: 12,30 m²", "2.04". Such a text is no name.
SIZE = re.compile(r"(?:[A-Za-z]{0,4}\s*[:=]?\s*)?[\d.,'’ ]+\s*(?:m2|m²|m\^2|qm|sq\.?\s?m|sq\.?\s?ft|sf|ft2|ft²|m|cm|mm)\.?",
                  re.IGNORECASE)
# Rooms of a drawing, and pairs of rooms with meeting boxes that are compared.
MOST_ROOMS, MOST_PAIRS = 20_000, 50_000


@dataclass
class Room:
    """A room in metres, in the frame of the drawing."""

    polygon: Polygon
    place: Place
    id: str = ""
    names: list[str] = field(default_factory=list)

    @property
    def name(self) -> str:
        return " ".join(self.names)[:LONGEST_NAME].strip()


@dataclass(frozen=True)
class Label:
    """A line of text and the point where it is written, in metres."""

    text: str
    at: Point
    place: Place


def rooms_of(found: Iterable[Drawn], scale: Scale, report: Report) -> list[Room]:
    """The rooms of all closed outlines. What lies in another outline is cut out of that."""
    rooms: list[Room] = []
    for drawn in found:
        try:
            shapes = shapes_of(drawn, scale)
        except ShapeError as error:
            if drawn.entity.dxftype() not in MARKS:
                report.error(drawn.place(), f"is no outline of a room: {error}")
            continue
        rooms += [room for shape in shapes if (room := room_of(shape, scale, report)) is not None]
    if len(rooms) > MOST_ROOMS:
        report.error(None, f"has {len(rooms)} rooms, of which {MOST_ROOMS} are read")
    kept = without_overlaps(rooms[:MOST_ROOMS], scale, report)
    for room, room_id in zip(kept, distinct_ids([f"room-{room.place.handle}" for room in kept])):
        room.id = room_id
    return kept


def distinct_ids(ids: list[str]) -> list[str]:
    """Ids that stand several times get a number: a block may hold several rooms, and an entity several doors."""
    counts: Counter[str] = Counter()
    distinct = []
    for each in ids:
        counts[each] += 1
        distinct.append(each if counts[each] == 1 else f"{each}.{counts[each]}")
    return distinct


def room_of(shape: Shape, scale: Scale, report: Report) -> Room | None:
    """The room of an outline, or None where it is none, which is reported."""
    if not shape.is_closed:
        report.error(shape.place, f"the outline of a room is open: its ends are {shape.gap:.3g} m apart",
                     "close the polyline, or move what is no room to a layer of its own")
        return None
    if len(shape.points) > MOST_CORNERS:
        report.error(shape.place, f"has {len(shape.points)} corners, of {MOST_CORNERS} that a room may have", "a larger --chord-error")
        return None
    if len(shape.points) < 3:
        report.error(shape.place, "encloses nothing")
        return None
    polygon = Polygon(shape.points)
    west, south, east, north = polygon.bounds
    if max(east - west, north - south) > LARGEST_SIDE:
        report.error(shape.place, f"an outline of {east - west:.6g} by {north - south:.6g} m is no room",
                     "is the unit right? --unit names another")
        return None
    if not polygon.is_valid:
        report.error(shape.place, f"the outline crosses or touches itself{crossing_of(polygon, scale)}")
        return None
    if polygon.area < LEAST_AREA:
        report.warning(shape.place, f"an outline of {polygon.area:.2g} m² is left out: no room is that small",
                       "is the unit right? --unit names another")
        return None
    return Room(polygon, shape.place)


def crossing_of(polygon: Polygon, scale: Scale) -> str:
    """Where an outline crosses itself, in units of the drawing."""
    found = re.search(r"\[(\S+) (\S+)\]", str(explain_validity(polygon)))
    if found is None:
        return ""
    at = scale.drawn_at((float(found[1]), float(found[2])))
    return f" at ({at[0]:.6g}, {at[1]:.6g})"


def without_overlaps(rooms: list[Room], scale: Scale, report: Report) -> list[Room]:
    """Rooms without those that are drawn twice or reach into others; an outline within another is cut out of it."""
    tree = STRtree([room.polygon for room in rooms])
    dropped: set[int] = set()
    cuts: dict[int, list[Polygon]] = {}
    compared = 0
    for index, room in enumerate(rooms):
        for other in sorted(int(found) for found in tree.query(room.polygon)):
            if other <= index or index in dropped or other in dropped:
                continue
            compared += 1
            if compared > MOST_PAIRS:
                report.error(room.place, "too many outlines lie over each other; this one and all after it are left out",
                             "one outline for each room")
                dropped.update(range(index, len(rooms)))
                break
            judge_pair(rooms, (index, other), dropped, cuts, scale, report)
    for index, holes in cuts.items():
        cut = rooms[index].polygon.difference(union_all(holes))
        if isinstance(cut, Polygon) and not cut.is_empty:
            rooms[index].polygon = cut
        else:
            report.error(rooms[index].place, "the outlines in it leave no single room of it")
            dropped.add(index)
    return [room for index, room in enumerate(rooms) if index not in dropped]


def judge_pair(rooms: list[Room], pair: tuple[int, int], dropped: set[int], cuts: dict[int, list[Polygon]], scale: Scale,
               report: Report) -> None:
    """Decides about two outlines whose boxes meet."""
    first, second = (rooms[index] for index in pair)
    shared = first.polygon.intersection(second.polygon)
    smaller, larger = sorted(pair, key=lambda index: rooms[index].polygon.area)
    part, whole = rooms[smaller].polygon.area, rooms[larger].polygon.area
    if shared.area <= OVERLAP and shared.area < part / 2:
        return
    if shared.area >= SAME * whole:
        report.warning(second.place, f"is the same outline as {first.place.kind} {first.place.handle}, and is left out")
        dropped.add(pair[1])
    elif shared.area >= SAME * part:
        cuts.setdefault(larger, []).append(rooms[smaller].polygon)
    else:
        middle = shared.representative_point()
        at = scale.drawn_at((middle.x, middle.y))
        report.error(second.place, f"shares {shared.area:.2f} m² with the room {first.place.kind} {first.place.handle} at "
                                   f"({at[0]:.6g}, {at[1]:.6g}), and is left out", "draw rooms beside each other")
        dropped.add(pair[1])


def labels_of(found: Iterable[Drawn], scale: Scale) -> list[Label]:
    """The lines of all texts, those in attributes of blocks among them, without sizes and numbers."""
    labels = []
    for drawn in found:
        for entity in texts_of(drawn):
            at = entity.dxf.get("insert")
            if at is None:
                continue
            point = scale.point(at.x, at.y)
            lines = [line.strip()[:LONGEST_LINE] for line in plain(entity)[:LONGEST_TEXT].splitlines()]
            labels += [Label(line, point, drawn.place(scale.drawn_at(point))) for line in lines if is_name(line)]
    return labels


def texts_of(drawn: Drawn) -> list[Text | MText]:
    """A text itself, or the attributes and texts of a stamp that is a block."""
    entity = drawn.entity
    if not isinstance(entity, Insert):
        return [entity] if isinstance(entity, (Text, MText)) else []
    inside = [part.entity for part in parts_of(drawn)]
    parts = [part for part in inside if isinstance(part, (Text, MText)) and part.dxftype() != "ATTDEF"]
    return [*(attribute for attribute in entity.attribs if not attribute.is_invisible), *parts]


def plain(entity: Text | MText) -> str:
    """A text without its codes for fonts and colours, and without letters that cannot be printed."""
    text = str(entity.plain_text())
    return "".join(letter if letter.isprintable() or letter == "\n" else " " for letter in text)


def is_name(line: str) -> bool:
    return any(letter.isalpha() for letter in line) and not SIZE.fullmatch(line)


def name_rooms(rooms: list[Room], labels: list[Label], report: Report) -> None:
    """Gives each room the texts in it, from above to below; reports texts that are in none."""
    tree = STRtree([room.polygon for room in rooms])
    in_order = sorted(labels, key=lambda label: (-label.at[1], label.at[0]))
    outside = []
    for label in in_order:
        hits = sorted(int(index) for index in tree.query(Location(label.at), predicate="within"))
        for index in hits[:1]:
            rooms[index].names.append(label.text)
        outside += [label] if not hits else []
    for label in outside:
        report.warning(label.place, f'the text "{label.text[:40]}" is in no room')


def types_of(rooms: list[Room], own: dict[str, str], report: Report) -> dict[str, str]:
    """The room type of each room by its id. Reports unknown names once each, and rooms without a name together."""
    types = {}
    unknown: dict[str, list[Room]] = {}
    for room in rooms:
        found = room_type_of(room.name, own)
        types[room.id] = found or GENERIC
        if found is None:
            unknown.setdefault(room.name, []).append(room)
    for name, unnamed in unknown.items():
        count = "" if len(unnamed) == 1 else f" ({len(unnamed)} rooms)"
        fact = f'the name "{name}" has no room type' if name else "the room has no name"
        hint = (f'`room_types: {{"{name}": bedroom}}` in the layer map' if name
                else "write its name into it, on a layer of the role room_names")
        report.warning(unnamed[0].place, f"{fact}{count}: read as {GENERIC}", hint)
    return types
