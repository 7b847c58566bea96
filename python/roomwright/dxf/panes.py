"""Joins what lies beside each other across one wall: the lines of the panes and the sill of a window are one window."""

from __future__ import annotations

from dataclasses import replace

from shapely import LineString, Polygon, STRtree, union_all

from .openings import Opening, ends_of, extent, place_of

# Metres between lines of one opening: the thickest walls that openings go through (src/plan/attach.rs).
ACROSS = 0.7
# Sine of the largest angle between them.
PARALLEL_SINE = 0.1
# Share of the shorter that lies beside the longer.
BESIDE = 0.5


def joined_panes(openings: list[Opening]) -> list[Opening]:
    """Openings without a leaf as one each where they lie beside each other, in the order of their first."""
    plain = [opening for opening in openings if opening.hinge is None and opening.leaves is None]
    if not plain:
        return openings
    strips = [strip_of(opening) for opening in plain]
    union = union_all(strips)
    tree = STRtree(list(getattr(union, "geoms", [union])))
    clusters: dict[int, list[list[int]]] = {}
    for index, strip in enumerate(strips):
        near = clusters.setdefault(int(tree.nearest(strip.representative_point())), [])
        own = next((cluster for cluster in near if are_beside(plain[cluster[0]], plain[index], strips[cluster[0]], strip)), None)
        if own is None:
            near.append([index])
        else:
            own.append(index)
    whole = {id(plain[cluster[0]]): joined([plain[index] for index in cluster]) for near in clusters.values() for cluster in near}
    of_leaves = [opening for opening in openings if opening.hinge is not None or opening.leaves is not None]
    kept = [whole[id(opening)] for opening in plain if id(opening) in whole]
    return of_leaves + kept


def strip_of(opening: Opening) -> Polygon:
    """Half of the thickest wall at both sides of an opening."""
    return LineString(ends_of(opening)).buffer(ACROSS / 2, cap_style="flat")


def are_beside(first: Opening, second: Opening, first_strip: Polygon, second_strip: Polygon) -> bool:
    sine = first.along[0] * second.along[1] - first.along[1] * second.along[0]
    if abs(sine) > PARALLEL_SINE:
        return False
    across = (-first.along[1], first.along[0])
    apart = abs((second.middle[0] - first.middle[0]) * across[0] + (second.middle[1] - first.middle[1]) * across[1])
    low, high = (extent(ends_of(opening), first.along) for opening in (first, second))
    beside = min(low[1], high[1]) - max(low[0], high[0])
    return apart <= ACROSS and beside >= BESIDE * min(first.width, second.width) and bool(first_strip.intersects(second_strip))


def joined(openings: list[Opening]) -> Opening:
    """One opening for several, in the middle of all."""
    first = openings[0]
    if len(openings) == 1:
        return first
    ends = [end for opening in openings for end in ends_of(opening)]
    low, high = extent(ends, first.along)
    deep_low, deep_high = extent(ends, (-first.along[1], first.along[0]))
    return replace(first, middle=place_of((low + high) / 2, (deep_low + deep_high) / 2, first.along), width=high - low)
