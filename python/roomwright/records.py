"""What a bake holds, as data: levels, their rooms, and the furniture in them.

Everything is in the frame of the plan: metres and radians; x points east, y north, z up, and z = 0 is the floor of the level.
A .glb of the same bake has its points at (x, z, -y). Values are those of the extras (docs/output.md).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Point = tuple[float, float]
Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]


@dataclass(frozen=True)
class Placement:
    """One piece of furniture in its place."""

    class_name: str  # such as `desk`
    id: str  # such as `desk.1`, unique in its room
    room: str  # id of the room
    parent: str  # the piece or part of the room that it was arranged by
    side: str  # of the parent
    carrier: str | None  # id of the piece that it stands or hangs on; None for its room
    position: Vector  # the middle of its underside
    rotation: Quaternion  # x, y, z, w; without it, the front faces south and the top up
    size: Vector  # width, depth and height
    variant: int

    @property
    def angle(self) -> float:
        """Radians about the vertical, counter-clockwise from above; 0 faces south."""
        x, y, z, w = self.rotation
        return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


@dataclass(frozen=True)
class Removal:
    """A piece that was wanted and found no place."""

    class_name: str
    reason: str
    is_required: bool


@dataclass(frozen=True)
class Room:
    """One room with what stands in it."""

    id: str
    type: str
    style: str
    seed: int  # 64 bits
    outline: tuple[Point, ...]  # the inner faces of its walls
    holes: tuple[tuple[Point, ...], ...]
    height: float
    requested: int  # pieces that were wanted
    removed: tuple[Removal, ...]
    grade: str  # the verdict of the audit: `none`, `minor` or `failed`; empty if nobody judged it
    score: float | None
    findings: tuple[dict[str, Any], ...]
    placements: tuple[Placement, ...]


@dataclass(frozen=True)
class Level:
    """One level of a building, which is one file."""

    building: str
    id: str
    file: Path
    elevation: float  # of its floor, above the building's zero
    height: float  # from floor to floor
    rooms: tuple[Room, ...]

    @property
    def name(self) -> str:
        """`building/level`, unique in a bake."""
        return f"{self.building}/{self.id}"

    @property
    def placements(self) -> Iterator[Placement]:
        """The furniture of all its rooms."""
        return (placement for room in self.rooms for placement in room.placements)
