"""How a bake is imported."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Options:
    """Choices of an import; the defaults import everything, visible and at its place."""

    levels: tuple[str, ...] = ()  # patterns of level, building/level or building; none is all
    ceilings: bool = True         # False: hidden in the viewport and in renderings
    place: bool = True            # levels at their elevation, buildings at their site; False: all at the origin
    assets: bool = False          # furniture as assets, a catalogue for each class
