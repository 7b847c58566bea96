"""A level as a simulator knows it: bodies with shapes and joints. Metres, kilograms, radians, Z up."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True, eq=False)
class Box:
    """A collision shape with six sides."""

    centre: np.ndarray
    turn: np.ndarray  # 3 x 3, from the box's axes to the body's
    half: np.ndarray  # half of its lengths

    @property
    def volume(self) -> float:
        return float(8.0 * self.half.prod())

    @property
    def corners(self) -> np.ndarray:
        signs = np.stack(np.meshgrid(*[(-1.0, 1.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
        return self.centre + (signs * self.half) @ self.turn.T


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles: what is seen, or a collision shape of which simulators take the convex hull."""

    corners: np.ndarray  # n x 3
    triangles: np.ndarray  # m x 3, counter-clockwise from outside

    @property
    def volume(self) -> float:
        ring = self.corners[self.triangles] - self.corners.mean(axis=0)
        return abs(float(np.einsum("ij,ij->i", ring[:, 0], np.cross(ring[:, 1], ring[:, 2])).sum()) / 6.0)

    @property
    def centre(self) -> np.ndarray:
        return (self.corners.min(axis=0) + self.corners.max(axis=0)) / 2.0


Collider = Box | Surface


@dataclass(frozen=True)
class Visual:
    """A surface of one colour."""

    name: str  # of the model, for the mesh's file
    surface: Surface
    rgba: tuple[float, float, float, float]


@dataclass(frozen=True)
class Joint:
    """How a leaf moves against the building: `now` is where the file has it, 0 is shut."""

    kind: str  # hinge or slide
    axis: tuple[float, float, float]
    low: float  # radians or metres
    high: float
    now: float


@dataclass(frozen=True)
class Inertia:
    """Of a body that moves."""

    mass: float
    centre: np.ndarray
    diagonal: np.ndarray  # about the centre, along the body's axes


@dataclass(eq=False)
class Body:
    """A node with shapes, where it stands."""

    name: str
    pose: np.ndarray  # 4 x 4, rigid
    colliders: list[Collider]
    visuals: list[Visual]
    joint: Joint | None = None
    is_free: bool = False
    inertia: Inertia | None = None  # of bodies that move
    apart: list[str] = field(default_factory=list)  # bodies that it does not collide with


@dataclass(frozen=True)
class LevelModel:
    """All bodies of a level."""

    name: str
    bodies: list[Body]
