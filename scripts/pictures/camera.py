"""A camera in plan coordinates (floor_view.py): what the choosers return and the stage places."""

from __future__ import annotations

from dataclasses import dataclass, field

# Millimetres of the sensor's width; Blender's default.
SENSOR = 36.0
# Share of a picture's half that the scene fills.
FILLED = 0.94
# Metres of walls around the outline that a picture shows too.
WALLS = 0.3


@dataclass(frozen=True)
class Camera:
    """A camera in plan coordinates, and the walls (room, number) that it looks through."""

    view: str
    position: tuple[float, float, float]
    forward: tuple[float, float, float]
    up: tuple[float, float, float]
    lens: float = 50.0
    # Metres of a parallel picture's longer side; zero for a perspective.
    scale: float = 0.0
    # Share of the picture's longer side by which the horizon moves up.
    shift: float = 0.0
    # Metres at which a wall ends; walls that are not listed stand whole.
    cuts: dict[tuple[str, int], float] = field(default_factory=dict)
