"""All measures."""

from __future__ import annotations

from .measure import Measure
from .measures import (aisles, bedrooms, bodies, clearances, corners, drawn_walls, dwellings, kitchens, living, order, screens, seats,
                       walls, ways)

SUBJECTS = {"Kitchens": kitchens, "Drawn fixtures": drawn_walls, "Living rooms": living, "Bedrooms": bedrooms, "Dwellings": dwellings, "Corners": corners,
            "Walls and halls": walls, "Seats": seats, "Bodies": bodies, "Ways": ways,
            "Clearances": clearances, "Aisles": aisles, "Screens and windows": screens, "Order and density": order}
MEASURES: dict[str, Measure] = {measure.code: measure for subject in SUBJECTS.values() for measure in subject.MEASURES}
