"""Outlines of rooms, in plan coordinates."""


def is_inside(point: tuple[float, float], ring: list) -> bool:
    """Whether a point lies within a ring of corners."""
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]]):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside
