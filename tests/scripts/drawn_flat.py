"""An invented flat as a DXF drawing, for the tests of dxf_to_plan.py: six rooms in millimetres.

           0        5.1      7.6     10
      5.6  +--------------------------+
           |           hall           |     front door in the west, with two leaves
      4.1  +--------+--------+--------+
           |        |        |  study  )    a round bay in the east
    kitchen| living |  bath  |         )    no wall between kitchen and living room
      0    +--------+--------+--------+
"""

from __future__ import annotations

from pathlib import Path

import ezdxf
from ezdxf.document import Drawing

LAYERS = """\
version: 1
layers:
  rooms: A-AREA
  room_names: A-AREA-IDEN
  doors: A-DOOR*
  windows: a-glaz
  walls: [A-WALL, A-WALL-*]
  columns: S-COLS
  railings: A-FLOR-HRAL
"""


def rectangle(x: float, y: float, width: float, depth: float) -> list[tuple[float, float]]:
    return [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)]


def closed(space, corners, layer: str):
    return space.add_lwpolyline(corners, close=True, dxfattribs={"layer": layer})


def flat(unit: int = 4) -> Drawing:
    """The drawing, with `$INSUNITS` as given."""
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = unit
    space = document.modelspace()
    document.rooms = {
        "kitchen": closed(space, rectangle(-3000, 0, 3000, 4000), "A-AREA"),
        "living": closed(space, rectangle(0, 0, 5000, 4000), "A-AREA"),
        "bath": closed(space, rectangle(5100, 0, 2400, 4000), "A-AREA"),
        "hall": closed(space, rectangle(0, 4100, 10000, 1500), "A-AREA"),
        # The third corner begins a half circle of 2 m to the fourth.
        "study": space.add_lwpolyline([(7600, 0, 0), (10000, 0, 1), (10000, 4000, 0), (7600, 4000, 0)], format="xyb", close=True,
                                      dxfattribs={"layer": "A-AREA"}),
    }
    names(document)
    doors(document)
    windows(document)
    for corners in (rectangle(5000, 0, 100, 4000), rectangle(7500, 0, 100, 4000), rectangle(-3000, 4000, 13000, 100),
                    rectangle(4000, 1000, 100, 1000)):
        closed(space, corners, "A-WALL")
    # The contour of the building is no wall in its rooms.
    closed(space, rectangle(-3300, -300, 15900, 6200), "A-WALL-FULL")
    # Around the hall's end in the east.
    closed(space, rectangle(9980, 4100, 40, 1500), "A-FLOR-HRAL")
    space.add_line((9000, 5610), (10_000, 5610), dxfattribs={"layer": "A-FLOR-HRAL"})
    space.add_circle((2500, 2000), 150, dxfattribs={"layer": "S-COLS"})
    return document


def names(document: Drawing) -> None:
    space = document.modelspace()
    layer = {"layer": "A-AREA-IDEN"}
    space.add_mtext("{\\fArial|b1;Living room}\\P20.00 m²", dxfattribs=layer).set_location((500, 3500))
    space.add_text("Küche", dxfattribs=layer | {"insert": (-2500, 3500)})
    space.add_text("12,00 m2", dxfattribs=layer | {"insert": (-2500, 3200)})
    space.add_text("Hall 0.03", dxfattribs=layer | {"insert": (4000, 5000)})
    space.add_text("Study", dxfattribs=layer | {"insert": (8000, 2000)})
    stamp = document.blocks.new("STAMP")
    stamp.add_circle((0, 0), 300)
    stamp.add_attdef("NAME", (0, 0))
    space.add_blockref("STAMP", (6000, 1000), dxfattribs=layer).add_auto_attribs({"NAME": "BATH"})


def doors(document: Drawing) -> None:
    space = document.modelspace()
    layer = {"layer": "A-DOOR"}
    # Living room and hall: the leaf opens to the south, its hinge in the west.
    space.add_arc((1000, 4000), 900, 270, 360, dxfattribs=layer)
    space.add_line((1000, 4000), (1000, 3100), dxfattribs=layer)
    # Bath and hall: a mirrored block on layer 0, which opens to the north, its hinge in the east.
    block = document.blocks.new("DOOR")
    block.add_arc((0, 0), 800, 0, 90)
    block.add_lwpolyline(rectangle(-40, 0, 40, 800), close=True)
    space.add_blockref("DOOR", (7000, 4100), dxfattribs={"layer": "A-DOOR", "xscale": -1})
    # The front door: two leaves, which open into the hall.
    space.add_arc((0, 4300), 600, 0, 90, dxfattribs=layer)
    space.add_arc((0, 5500), 600, 270, 360, dxfattribs=layer)
    # Study and hall: a frame without a leaf.
    closed(space, rectangle(8000, 4000, 900, 100), "A-DOOR-FRAM")


def windows(document: Drawing) -> None:
    space = document.modelspace()
    for y in (-300, -150, 0):
        space.add_line((1000, y), (3000, y), dxfattribs={"layer": "A-GLAZ"})
    block = document.blocks.new("WINDOW")
    block.add_lwpolyline(rectangle(-500, 0, 1000, 300), close=True)
    space.add_blockref("WINDOW", (6300, -300), dxfattribs={"layer": "A-GLAZ"})


def save(document: Drawing, path: Path) -> Path:
    document.saveas(path)
    return path
