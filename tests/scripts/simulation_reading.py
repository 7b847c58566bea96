"""Reads what convert.py wrote for simulators, with nothing of the writer: places, shapes, meshes."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import shapely

from roomwright import convert


def run(*arguments) -> int:
    return convert.main([str(argument) for argument in (*arguments, "--quiet", "--jobs", 1)])


def document(file: Path) -> ElementTree.Element:
    return ElementTree.parse(file).getroot()


def vector(element: ElementTree.Element, key: str, default: str = "0 0 0") -> np.ndarray:
    return np.array(element.get(key, default).split(), float)


def bodies(root: ElementTree.Element) -> dict[str, ElementTree.Element]:
    found = {body.get("name"): body for body in root.find("worldbody")}
    assert len(found) == len(root.find("worldbody")), "names are unique"
    return found


def turn_of(element: ElementTree.Element) -> np.ndarray:
    w, x, y, z = vector(element, "quat", "1 0 0 0")
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def at(element: ElementTree.Element, points: np.ndarray) -> np.ndarray:
    """Points of an element's frame in the frame around it."""
    return points @ turn_of(element).T + vector(element, "pos")


def mesh_points(file: Path) -> np.ndarray:
    lines = file.read_text().splitlines()
    return np.array([line.split()[1:] for line in lines if line.startswith("v ")], float)


def shapes(file: Path, root: ElementTree.Element, body: ElementTree.Element, kind: str = "collision") -> list[np.ndarray]:
    """The corners of each shape of a body, in the world."""
    folder = file.parent / root.find("compiler").get("meshdir")
    files = {mesh.get("name"): folder / mesh.get("file") for mesh in root.find("asset")}
    found = []
    for geom in body.iter("geom"):
        if geom.get("class") == kind:
            own = mesh_points(files[geom.get("mesh")]) if geom.get("mesh") else box_points(vector(geom, "size"))
            found.append(at(body, at(geom, own)))
    return found


def box_points(half: np.ndarray) -> np.ndarray:
    signs = np.stack(np.meshgrid(*[(-1.0, 1.0)] * 3), axis=-1).reshape(-1, 3)
    return signs * half


def extent(parts: list[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    points = np.concatenate(parts)
    return points.min(axis=0), points.max(axis=0)


def is_in_convex(point: np.ndarray, corners: np.ndarray) -> bool:
    """Whether a point lies in an upright prism, by its corners."""
    return bool(corners[:, 2].min() < point[2] < corners[:, 2].max()
                and shapely.convex_hull(shapely.multipoints(corners[:, :2])).contains(shapely.Point(point[:2])))
