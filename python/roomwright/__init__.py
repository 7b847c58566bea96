"""Furnishes floor plans, and reads what was furnished.

    import roomwright

    bake = roomwright.bake("house.sh3d", "out", seed=7)
    for level in bake.levels:
        for room in level.rooms:
            for piece in room.placements:
                print(level.name, room.id, piece.class_name, piece.position, piece.size)

`bake` runs the program `roomwright`; `Bake.open` reads a finished bake. Both need Python's standard library alone. The other
parts are modules with extras of their own: `roomwright.validate`, `roomwright.convert`, `roomwright.dxf_to_plan`, `roomwright.blender`, and
`roomwright.cluster`.

Places are in the frame of the plan: metres, x east, y north, z up from the level's floor (see `records`).
"""

import sys

# Older Pythons come as far as `environment`, which says what they lack.
if sys.version_info >= (3, 11):
    from .bakes import Bake, BakeError
    from .baking import bake
    from .program import ProgramError, find_program
    from .records import Level, Placement, Removal, Room

__all__ = ["Bake", "BakeError", "Level", "Placement", "ProgramError", "Removal", "Room", "bake", "find_program"]
