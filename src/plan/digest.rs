//! The fingerprint of a level: equal for equal levels, whatever file they came from.

use sha2::{Digest, Sha256};

use super::{Level, Obstacle, Opening, Room, Stairs, Wall, WallKind};
use crate::geometry::{Point, Polygon};

/// Changes whenever the byte form below does, so that old fingerprints never match by chance.
const FORM: &str = "roomwright level 4";

/// SHA-256 of everything in the level but its `digest` and what was left out of it.
///
/// The byte form: numbers as little-endian IEEE 754 with one zero, lists and texts with their length before them.
pub(super) fn level_digest(level: &Level) -> [u8; 32] {
    let mut form = Form(Sha256::new());
    form.text(FORM);
    form.text(&level.id);
    form.text(&level.name);
    form.number(level.elevation);
    form.number(level.height);
    form.list(&level.rooms, Form::room);
    form.list(&level.openings, Form::opening);
    form.list(&level.stairs, Form::stairs);
    form.0.finalize().into()
}

struct Form(Sha256);

impl Form {
    fn count(&mut self, count: usize) {
        self.0.update((count as u64).to_le_bytes());
    }

    fn number(&mut self, number: f64) {
        // Adding zero turns the negative zero into the positive one.
        self.0.update((number + 0.0).to_le_bytes());
    }

    fn text(&mut self, text: &str) {
        self.count(text.len());
        self.0.update(text.as_bytes());
    }

    fn optional(&mut self, text: Option<&str>) {
        self.count(usize::from(text.is_some()));
        self.text(text.unwrap_or_default());
    }

    fn point(&mut self, point: Point) {
        self.number(point.x);
        self.number(point.y);
    }

    fn list<T>(&mut self, items: &[T], write: impl Fn(&mut Self, &T)) {
        self.count(items.len());
        for item in items {
            write(self, item);
        }
    }

    fn polygon(&mut self, polygon: &Polygon) {
        self.list(polygon.corners(), |form, &corner| form.point(corner));
    }

    fn room(&mut self, room: &Room) {
        self.text(&room.id);
        self.count(room.number as usize);
        self.optional(room.name.as_deref());
        self.text(&room.room_type);
        self.optional(room.style.as_deref());
        self.optional(room.dwelling.as_deref());
        self.optional(room.household.as_deref());
        self.polygon(&room.region.outline);
        self.list(&room.region.holes, Self::polygon);
        self.number(room.height);
        self.list(&room.walls, Self::wall);
        self.list(&room.obstacles, Self::obstacle);
        self.list(&room.openings, |form, opening| {
            form.count(opening.opening);
            form.count(opening.wall);
            form.number(opening.from);
            form.number(opening.to);
        });
    }

    fn wall(&mut self, wall: &Wall) {
        self.point(wall.start);
        self.point(wall.end);
        self.number(wall.thickness);
        self.count(usize::from(wall.is_exterior));
        match wall.kind {
            WallKind::Solid => self.count(0),
            WallKind::Railing(height) => {
                self.count(1);
                self.number(height);
            }
        }
        self.list(&wall.tags, |form, tag| form.text(tag));
    }

    fn obstacle(&mut self, obstacle: &Obstacle) {
        self.polygon(&obstacle.outline);
        self.number(obstacle.height);
    }

    fn stairs(&mut self, stairs: &Stairs) {
        self.count(stairs.room);
        self.list(stairs.up.as_slice(), |form, flight| {
            form.list(&flight.steps, |form, step| {
                form.list(&step.corners, |form, &corner| form.point(corner));
                form.number(step.top);
                form.number(step.rise);
                form.count(usize::from(step.is_landing));
            });
            form.polygon(&flight.opening);
            form.list(&flight.handrails, |form, rail| {
                form.list(rail, |form, point| {
                    form.point(point.at);
                    form.number(point.foot);
                });
            });
        });
        self.list(stairs.well.as_slice(), |form, well| {
            form.polygon(&well.opening);
            for edges in [&well.guards, &well.nosings] {
                form.list(edges, |form, edge| {
                    form.point(edge.start);
                    form.point(edge.end);
                });
            }
        });
    }

    fn opening(&mut self, opening: &Opening) {
        self.text(&opening.id);
        self.count(opening.kind as usize);
        self.point(opening.center);
        self.point(opening.along);
        for number in [opening.width, opening.bottom, opening.top] {
            self.number(number);
        }
        self.list(&opening.leaves, |form, leaf| {
            form.point(leaf.hinge);
            form.point(leaf.closed_tip);
            form.point(leaf.open_tip);
        });
        self.list(&opening.sides, |form, side| {
            form.count(side.room);
            form.count(side.wall);
            form.number(side.from);
            form.number(side.to);
        });
    }
}
