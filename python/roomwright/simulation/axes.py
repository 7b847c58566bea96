"""The crossing from glTF's axes (Y up) to those of simulators (Z up), and the numbers that simulators read.

A point (x, y, z) of the file lies at (x, -z, y): x east, y north, z up, as in the plan.
"""

from __future__ import annotations

import math

import numpy as np

# Rows of a rotation by 90° about x.
UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
# Digits after the point: micrometres, so that noise of the last bits of a sum does not reach the files.
DIGITS = 6


def points_up(points: np.ndarray) -> np.ndarray:
    """Rows of points in Z-up axes."""
    return points @ UP.T


def pose_up(matrix: np.ndarray) -> np.ndarray:
    """A node's place in Z-up axes; the frame of the node turns with it."""
    turned = np.identity(4)
    turned[:3, :3] = UP @ matrix[:3, :3] @ UP.T
    turned[:3, 3] = UP @ matrix[:3, 3]
    return turned


def split_scale(matrix: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A place without scale or shear, and the 3 x 3 matrix that the shapes at this place take over.

    Simulators have no scaled frames. The files of a bake have neither; edited ones may have.
    """
    left, stretches, right = np.linalg.svd(matrix[:3, :3])
    turn = left @ right
    if np.linalg.det(turn) < 0:
        turn = left @ np.diag([1.0, 1.0, -1.0]) @ right
    rigid = matrix.copy()
    if np.abs(stretches - 1.0).max() < 1e-6 and np.linalg.det(matrix[:3, :3]) > 0:
        return rigid, np.identity(3)
    rigid[:3, :3] = turn
    return rigid, turn.T @ matrix[:3, :3]


def quaternion(turn: np.ndarray) -> np.ndarray:
    """w, x, y, z of a rotation, w not negative (S. W. Shepperd, 1978: the largest component first)."""
    trace = turn.trace()
    squares = np.array([trace, *np.diag(turn)])
    first = int(squares.argmax())
    if first == 0:
        found = np.array([1.0 + trace, turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    else:
        i = first - 1
        j, k = (i + 1) % 3, (i + 2) % 3
        found = np.zeros(4)
        found[0] = turn[k, j] - turn[j, k]
        found[1 + i] = 1.0 + 2.0 * turn[i, i] - trace
        found[1 + j] = turn[j, i] + turn[i, j]
        found[1 + k] = turn[k, i] + turn[i, k]
    found /= np.linalg.norm(found)
    # A half turn has w = 0, give or take the last bit, and either sign.
    return -found if found[0] < -1e-9 else found


def roll_pitch_yaw(turn: np.ndarray) -> tuple[float, float, float]:
    """The angles of URDF: about the fixed x, y and z, in this order."""
    pitch = math.asin(max(-1.0, min(1.0, -turn[2, 0])))
    if abs(turn[2, 0]) > 1.0 - 1e-9:
        return 0.0, pitch, math.atan2(-turn[0, 1], turn[1, 1])
    return math.atan2(turn[2, 1], turn[2, 2]), pitch, math.atan2(turn[1, 0], turn[0, 0])


def about_up(radians: float) -> np.ndarray:
    """The rotation about z, counter-clockwise from above."""
    sine, cosine = math.sin(radians), math.cos(radians)
    return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])


def number(value: float) -> str:
    """A number as text: rounded, without a minus before zero."""
    text = f"{value:.{DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def numbers(values) -> str:
    return " ".join(number(float(value)) for value in values)


def small_numbers(values) -> str:
    """Numbers that may be far below one, such as the inertia of a cup, with as many digits."""
    return " ".join(f"{float(value):.{DIGITS}g}" for value in values)
