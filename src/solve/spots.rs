//! The places where a piece is tried.

use core::f64::consts::FRAC_PI_2;

use crate::audit::ROUNDING;
use crate::catalog::{Class, ParentName, Size};
use crate::geometry::{Bounds, Point};
use crate::plan::FRAME_WIDTH;

use super::constants::{FIT_STEP, SAME_DIRECTION};
use super::footprint::{Part, Turned};
use super::space::Space;

/// Where a piece may be tried.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    /// The middle of the piece.
    pub(crate) position: Point,
    /// Its angle, as a placement's.
    pub(crate) angle: f64,
    /// The wall that it has its back to, by index into the room's walls.
    pub(crate) wall: Option<usize>,
}

/// A piece to try, in one size.
pub(super) struct Trial<'t> {
    pub(super) class: &'t Class,
    pub(super) size: Size,
    /// Its body, then its clearances.
    pub(super) boxes: &'t [Bounds],
    /// Metres between places.
    pub(super) step: f64,
}

impl Space<'_, '_> {
    /// Calls `is_it` with the free places, those along the walls first, until it answers yes or the budget is spent.
    pub(super) fn any_free(&self, trial: &Trial<'_>, mut is_it: impl FnMut(Spot, &[Part]) -> bool) -> bool {
        let mut turned = Turned::new(trial.boxes);
        let walls = self.empty.at.room.walls.iter().enumerate();
        for (wall, _) in walls.filter(|(_, wall)| wall.length() > ROUNDING) {
            for spot in self.spots_at_wall(trial, wall) {
                if self.empty.budget.is_overdrawn() {
                    return false;
                }
                let parts = turned.to(spot.angle);
                if self.blocked_around(parts, spot.position).is_none() && is_it(spot, parts) {
                    return true;
                }
            }
        }
        if needs_wall(trial.class) {
            return false;
        }
        // Pieces stand square to some wall: each direction of the walls, by quarter turns.
        let turns = |angle: f64| (0..4).map(move |quarter| angle + FRAC_PI_2 * f64::from(quarter));
        let mut angles = self.directions().into_iter().flat_map(turns);
        angles.any(|angle| self.any_free_inside(trial.step, angle, turned.to(angle), &mut is_it))
    }

    /// Anywhere, at one angle.
    fn any_free_inside(
        &self,
        step: f64,
        angle: f64,
        parts: &[Part],
        mut is_it: impl FnMut(Spot, &[Part]) -> bool,
    ) -> bool {
        let Bounds { low, high } = self.empty.at.room.region.outline.bounds();
        for x in steps(low.x, high.x, step) {
            let mut number = 0_u32;
            loop {
                let position = Point::new(x, low.y + f64::from(number) * step);
                if position.y > high.y {
                    break;
                }
                if self.empty.budget.is_overdrawn() {
                    return false;
                }
                number += 1;
                // With this place all others are refused that are as near as the answer says.
                if let Some(metres) = self.blocked_around(parts, position) {
                    number += (metres / step) as u32;
                } else if is_it(Spot { position, angle, wall: None }, parts) {
                    return true;
                }
            }
        }
        false
    }

    /// How many places [`Space::any_free`] asks for at most, at [`FIT_STEP`].
    pub(super) fn spot_count(&self, class: &Class) -> f64 {
        let size = self.empty.at.room.region.outline.bounds().size();
        // Four quarter turns of each direction.
        let inside = (size / FIT_STEP).element_product() * 4.0 * self.directions().len() as f64;
        let along_walls: f64 = self.empty.at.room.walls.iter().map(|wall| wall.length() / FIT_STEP).sum();
        if needs_wall(class) { along_walls } else { inside + along_walls }
    }

    /// The directions of the walls that are no quarter turns of each other, nearly parallel ones once.
    fn directions(&self) -> Vec<f64> {
        let mut directions: Vec<Point> = Vec::new();
        for wall in self.empty.at.room.walls.iter().filter(|wall| wall.length() > ROUNDING) {
            let along = wall.direction();
            let is_known =
                |known: &Point| known.perp_dot(along).abs().min(known.dot(along).abs()) < SAME_DIRECTION;
            if !directions.iter().any(is_known) {
                directions.push(along);
            }
        }
        directions.into_iter().map(|along| libm::atan2(along.y, along.x)).collect()
    }

    /// Along a wall, the back of the piece to it, before solid wall.
    fn spots_at_wall(&self, trial: &Trial<'_>, number: usize) -> impl Iterator<Item = Spot> {
        let (size, empty) = (trial.size, self.empty);
        let wall = &empty.at.room.walls[number];
        // Walls run counter-clockwise around the room: a piece whose x axis runs the other way has its back to the wall.
        let angle = libm::atan2(wall.direction().y, wall.direction().x) + core::f64::consts::PI;
        // As far off the wall as the audit rounds off: contact is then no overlap on either side of rounding.
        let off_wall = wall.normal() * (size.depth / 2.0 + ROUNDING);
        let (start, along) = (wall.start, wall.direction());
        let is_solid = move |&along: &f64| {
            let mut here = empty.at.room.openings.iter().filter(|place| place.wall == number);
            let (from, to) = (along - size.width / 2.0, along + size.width / 2.0);
            !here.any(|place| {
                let is_framed = empty.at.level.openings[place.opening].kind.has_frame();
                let frame = if is_framed { FRAME_WIDTH } else { 0.0 };
                place.from - frame < to && from < place.to + frame
            })
        };
        steps(size.width / 2.0 + ROUNDING, wall.length() - size.width / 2.0, trial.step).filter(is_solid).map(
            move |metres| Spot { position: start + along * metres + off_wall, angle, wall: Some(number) },
        )
    }
}

/// Whether a piece stands at walls only.
fn needs_wall(class: &Class) -> bool {
    let hangs = |wanted: &ParentName| class.parents.iter().any(|rule| rule.parent == *wanted);
    hangs(&ParentName::Wall) && !hangs(&ParentName::Floor)
}

/// `from`, then on by `step` up to `to`.
fn steps(from: f64, to: f64, step: f64) -> impl Iterator<Item = f64> {
    let mut number = 0_u32;
    core::iter::from_fn(move || {
        let value = from + f64::from(number) * step;
        number += 1;
        (value <= to).then_some(value)
    })
}
