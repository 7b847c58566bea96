"""The cells of a contact sheet, and which model is in which."""

from __future__ import annotations

import re

# Cells for looks in a row of the sheet, pixels of a cell, pixels below it for the name.
ACROSS, CELL, LABEL = 18, 84, 14
# Share of a cell that a model fills.
FILLED = 0.92


def group_cells(count: int, looks: int) -> list[tuple[int, int]]:
    """Column and row of each model's first look; a model's looks stay in one row."""
    in_row = max(1, ACROSS // looks)
    return [(index % in_row * looks, index // in_row) for index in range(count)]


def names_of(nodes: list[str]) -> list[str]:
    """The models among nodes called item-NAME-LOOK, in their order."""
    found = (re.fullmatch(r"item-(.+)-\d+", name) for name in nodes)
    return list(dict.fromkeys(match[1] for match in found if match))
