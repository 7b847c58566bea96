"""The options of a run."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

# The folders that all floors of a run share, as the program's own `shared-textures`.
TEXTURE_FOLDER = "shared-textures"
MODEL_FOLDER = "shared-models"


@dataclass(frozen=True)
class Settings:
    """The options of a run; the same for all of its files."""

    root: Path  # the folder that the shared folders stand in
    ending: str = ".usdc"  # .usdc, .usda or .usdz
    up_axis: str = "Y"
    copies_images: bool = True  # no: images with files of their own are referred to where they are
    is_self_contained: bool = False
    has_physics: bool = False
    lights_lamps: bool = False  # lamps of floors without lights are lights
    has_instances: bool = False  # each model is drawn by USD's own instances, which some importers make objects of
    # Metres: what is smaller in every direction goes into a PointInstancer; none without.
    instanced_below: float | None = None
    movable_up_to: float | None = None  # kilograms of the pieces that are free bodies in MJCF and URDF; none without
    # Seconds since the epoch: shared files older than this are of an earlier run and written anew.
    started: float = 0.0

    def packed(self, folder: Path) -> Settings:
        """The settings for a floor that shares nothing, written into a folder of its own."""
        return replace(self, root=folder, ending=".usdc", copies_images=True, is_self_contained=True)
