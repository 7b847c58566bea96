"""All measures."""

from __future__ import annotations

from .measure import Measure
from .measures import bedrooms, drawn_walls, kitchens, living, seats, walls

SUBJECTS = {"Kitchens": kitchens, "Drawn fixtures": drawn_walls, "Living rooms": living, "Bedrooms": bedrooms,
            "Walls and halls": walls, "Seats": seats}
MEASURES: dict[str, Measure] = {measure.code: measure for subject in SUBJECTS.values() for measure in subject.MEASURES}
