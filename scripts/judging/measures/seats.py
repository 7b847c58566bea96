"""Seats that belong to something: chairs at tables, seats in rows."""

from __future__ import annotations

import shapely

from ..floors import Room
from ..measure import Answer, Fault, Measure, answer
from ..pieces import Piece
from ..roles import CHAIRS, ROW_SEATS, TABLES
from ..shapes import angle_between

# Metres between a chair and the table it is at, and the degrees by which it may be turned from the table.
AT_TABLE = 0.3
TURNED = 45.0
# Metres between the edges of seats of one row.
IN_ROW = 0.15


def judge_chairs(room: Room) -> Answer | None:
    tables = [piece for piece in room.of(TABLES) if piece.stands]
    chairs = [piece for piece in room.of(CHAIRS) if piece.stands]
    if not tables or not chairs:
        return None
    away = [chair for chair in chairs if not any(is_at(chair, table) for table in tables)]
    return answer([Fault("it is at no table", (chair.id,)) for chair in away], len(away))


def is_at(chair: Piece, table: Piece) -> bool:
    """Whether a chair is at a table and looks to it."""
    if not shapely.dwithin(chair.footprint, table.footprint, AT_TABLE):
        return False
    nearest = shapely.shortest_line(shapely.Point(chair.center), table.footprint)
    end = shapely.get_coordinates(nearest)[1]
    return table.footprint.covers(shapely.Point(chair.center)) or angle_between(chair.front, end - chair.center) <= TURNED


def judge_row_seats(room: Room) -> Answer | None:
    seats = room.of(ROW_SEATS)
    if not seats:
        return None
    tree = shapely.STRtree([seat.footprint for seat in seats])
    ones, others = tree.query([seat.footprint for seat in seats], "dwithin", IN_ROW)
    beside: set[int] = set()
    for one, other in zip(ones, others):
        if one != other and is_in_row(seats[one], seats[other]):
            beside.add(int(one))
    alone = [seat.id for number, seat in enumerate(seats) if number not in beside]
    return answer([Fault("no seat is beside it", (seat,)) for seat in alone], len(alone))


def is_in_row(seat: Piece, other: Piece) -> bool:
    """Whether another seat is to the left or right, and looks the same way."""
    offset = other.center - seat.center
    return angle_between(seat.front, other.front) < 30.0 and abs(offset @ seat.front) < abs(offset @ seat.right)


MEASURES = [
    Measure("chair_away", "every dining chair is at a table, and looks to it", "chairs", "0; ≤ 0.3 m, ≤ 45°", "project",
            judge_chairs),
    Measure("row_seat_alone", "every seat of a row has another beside it", "seats", "0", "project", judge_row_seats),
]
