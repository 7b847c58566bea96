//! The region of the floor that a finding is about, where it is simple to derive.

use crate::audit::{Code, Finding};
use crate::catalog::{Clearance, Side};
use crate::draw::Drawing;
use crate::geometry::{Point, Solid};
use crate::layout::{clearance_solids, solids};

use super::thing::Thing;

/// Metres within which a clearance is the one of a finding's threshold.
const ROUNDING: f64 = 1e-6;

/// Regions to hatch.
pub(super) fn find_all(
    drawing: &Drawing<'_>,
    (room, finding): (usize, &Finding),
    things: &[Thing],
) -> Vec<Vec<Point>> {
    let subject = Subject { drawing, room, things };
    let is_threshold = |depth: f64| (depth - finding.threshold).abs() < ROUNDING;
    match finding.code {
        Code::BlockedUse => subject.taken(false, |clearance| is_threshold(clearance.minimum)),
        Code::TightUse => subject.taken(true, |clearance| is_threshold(clearance.good)),
        Code::Unreachable => subject.clearances(false, |clearance| clearance.minimum > 0.0),
        Code::Bedside => {
            subject.clearances(false, |clearance| matches!(clearance.side, Side::Left | Side::Right))
        }
        Code::DoorBlocked => subject.strips(drawing.catalog.audit.doors.approach_depth, true),
        Code::WindowBlocked | Code::TvPosition => subject.strips(drawing.catalog.audit.windows.depth, false),
        _ => Vec::new(),
    }
}

struct Subject<'a> {
    drawing: &'a Drawing<'a>,
    room: usize,
    things: &'a [Thing],
}

impl Subject<'_> {
    /// Clearances of a kind, of the objects of a finding, that another object of the finding reaches into.
    fn taken(&self, is_good: bool, is_meant: impl Fn(&Clearance) -> bool) -> Vec<Vec<Point>> {
        let owned = self.owned(is_good, is_meant);
        let taken = owned.iter().filter(|(owner, solid)| {
            self.things.iter().any(|thing| thing != owner && self.reaches_into(*thing, solid))
        });
        taken.map(|(_, solid)| solid.base.corners().to_vec()).collect()
    }

    /// Clearances of some kind of the objects concerned.
    fn clearances(&self, is_good: bool, is_meant: impl Fn(&Clearance) -> bool) -> Vec<Vec<Point>> {
        self.owned(is_good, is_meant).iter().map(|(_, solid)| solid.base.corners().to_vec()).collect()
    }

    fn owned(&self, is_good: bool, is_meant: impl Fn(&Clearance) -> bool) -> Vec<(Thing, Solid)> {
        let mut owned = Vec::new();
        for &thing in self.things {
            let Thing::Object(index) = thing else { continue };
            let object = &self.drawing.furnished[self.room].placements[index];
            let class = &self.drawing.catalog.classes[object.class];
            let clearances = clearance_solids(class, object, is_good).into_iter();
            owned.extend(
                clearances.filter(|(clearance, _)| is_meant(clearance)).map(|(_, solid)| (thing, solid)),
            );
        }
        owned
    }

    fn reaches_into(&self, thing: Thing, zone: &Solid) -> bool {
        let room = &self.drawing.level.rooms[self.room];
        match thing {
            Thing::Object(index) => {
                let object = &self.drawing.furnished[self.room].placements[index];
                let class = &self.drawing.catalog.classes[object.class];
                solids(class, object).iter().any(|solid| solid.overlaps(zone, 0.0))
            }
            Thing::Wall(wall) => {
                let wall = &room.walls[wall];
                zone.base.is_entered_by(wall.start, wall.end, ROUNDING)
            }
            Thing::Column(column) => {
                let mut edges = room.obstacles[column].outline.edges();
                edges.any(|(start, end)| zone.base.is_entered_by(start, end, ROUNDING))
            }
            Thing::Opening(_) => false,
        }
    }

    /// Strips of floor before the openings concerned, on this room's side; those before doors are at most as
    /// deep as the door is wide.
    fn strips(&self, depth: f64, is_door: bool) -> Vec<Vec<Point>> {
        let room = &self.drawing.level.rooms[self.room];
        let places =
            room.openings.iter().filter(|place| self.things.contains(&Thing::Opening(place.opening)));
        let strip = |place: &crate::plan::RoomOpening| {
            let wall = &room.walls[place.wall];
            let depth = if is_door { depth.min(place.to - place.from) } else { depth };
            let inward = wall.normal() * depth;
            let at = |along: f64| wall.start + wall.direction() * along;
            vec![at(place.from), at(place.to), at(place.to) + inward, at(place.from) + inward]
        };
        places.map(strip).collect()
    }
}
