//! Drafts the openings of a level or of a placed prototype.

use super::check::edge_hint;
use super::file::{HandWord, OpeningAt, OpeningFile, OpeningWord};
use super::level_parts::LevelParts;
use super::pattern::expand;
use super::report::{Report, item, step};
use super::scope::Scope;
use crate::document::PathStep;
use crate::geometry::Point;
use crate::plan::{LeafDraft, OpeningDraft, OpeningKind, OpeningPlace};

/// The value of `opens_into` for doors that open to the open air.
const OUTSIDE: &str = "outside";
/// Metres of openings where nothing is said: width, sill, head.
const USUAL_DOOR: (f64, f64, f64) = (0.9, 0.0, 2.0);
const USUAL_WINDOW: (f64, f64, f64) = (1.2, 0.9, 2.1);
/// Longer and higher than any: an open boundary is as long as its rooms' common edge and as high as they are.
const USUAL_BOUNDARY: (f64, f64, f64) = (1000.0, 0.0, 100.0);
/// Degrees that a leaf opens where nothing is said.
const USUAL_SWING: f64 = 90.0;

/// Reads one opening; its rooms are among the parts already.
pub(super) struct OpeningReader<'a, 'b> {
    pub(super) scope: &'a Scope<'a>,
    pub(super) opening: &'a OpeningFile,
    pub(super) path: &'a [PathStep],
    pub(super) parts: &'a LevelParts,
    pub(super) report: &'a mut Report<'b>,
}

impl OpeningReader<'_, '_> {
    /// The opening, unless something is wrong with it.
    pub(super) fn draft(mut self, id: String) -> Option<OpeningDraft> {
        let opening = self.opening;
        let mut rooms = Vec::new();
        if let Some(room) = &opening.room {
            rooms.push(self.room_named(room, &step(self.path, "room"))?);
        }
        for (index, room) in opening.rooms.iter().enumerate() {
            let room = self.room_named(room, &item(self.path, "rooms", index))?;
            if !rooms.contains(&room) {
                rooms.push(room);
            }
        }
        let place = self.place(rooms.first())?;
        let metres = |length: f64| self.scope.units.to_metres(length);
        let (width, sill, head) = match opening.kind {
            OpeningWord::Window => USUAL_WINDOW,
            OpeningWord::OpenBoundary => USUAL_BOUNDARY,
            _ => USUAL_DOOR,
        };
        let width = opening.width.map_or(width, metres);
        let bottom = opening.sill.map_or(sill, metres);
        let above_sill = opening.height.map(|height| bottom + metres(height));
        let top = above_sill.or(opening.head.map(metres)).unwrap_or(head);
        if top <= bottom {
            let message = format!("the opening ends at {top} m, below its sill at {bottom} m");
            self.report.error(self.path, message, Some("give it a `head`".to_owned()));
            return None;
        }
        let leaf = self.leaf(&rooms)?;
        Some(OpeningDraft { id, kind: kind(opening.kind), place, rooms, width, bottom, top, leaf })
    }

    /// The id in the level of a room that an opening names: of the same copy, or of the level.
    fn room_named(&mut self, name: &str, path: &[PathStep]) -> Option<String> {
        let scope = self.scope;
        let id = match scope.rooms.iter().find(|room| room.id == name) {
            Some(room) => scope.full_id(&room.id, scope.rooms.len() == 1),
            None => expand(name, &scope.values()),
        };
        let id = id.ok();
        let is_left_out = id.as_ref().is_some_and(|id| self.parts.left_out.contains(id));
        let found = id.filter(|id| self.parts.names.contains_key(id));
        if is_left_out {
            let message = format!("the opening names room \"{name}\", which was left out");
            self.report.warning(path, message, Some("it was left out too".to_owned()));
        } else if found.is_none() {
            let own = scope.rooms.iter().map(|room| &room.id);
            let hint = self.report.did_you_mean(name, self.parts.names.keys().chain(own));
            self.report.error(path, format!("unknown room \"{name}\""), hint);
        }
        found
    }

    fn place(&mut self, room: Option<&String>) -> Option<OpeningPlace> {
        let (scope, opening) = (self.scope, self.opening);
        let Some(edge) = opening.edge else {
            let Some(OpeningAt::Point(at)) = opening.at else { return None };
            let along = opening.along.map(|along| scope.motion.turn_only(Point::from(along)));
            return Some(OpeningPlace::Points { center: scope.motion.apply(scope.point(at)), along });
        };
        let room = &self.parts.draft.rooms[*self.parts.names.get(room?)?];
        let corner_count = room.outline.len();
        if edge >= corner_count {
            let message = format!("room \"{}\" has no edge {edge}", room.id);
            self.report.error(&step(self.path, "edge"), message, Some(edge_hint(corner_count)));
            return None;
        }
        let length = room.outline[edge].distance(room.outline[(edge + 1) % corner_count]);
        let at = match opening.at {
            Some(OpeningAt::Distance(at)) => scope.units.to_metres(at),
            _ => length / 2.0,
        };
        if !(0.0..=length).contains(&at) {
            let message = format!("{at} m along an edge that is {length:.3} m long");
            let hint = Some("`at` is measured from corner to middle".to_owned());
            self.report.error(&step(self.path, "at"), message, hint);
            return None;
        }
        Some(OpeningPlace::Edge { edge, at })
    }

    fn leaf(&mut self, rooms: &[String]) -> Option<LeafDraft> {
        let opening = self.opening;
        let said = (opening.hinge, &opening.opens_into, opening.leaves, opening.swing);
        if matches!(said, (None, None, None, None)) {
            return Some(LeafDraft::Automatic);
        }
        if opening.leaves == Some(0) {
            return Some(LeafDraft::None);
        }
        let into = match &opening.opens_into {
            Some(room) if room == OUTSIDE => None,
            Some(room) => Some(self.room_named(room, &step(self.path, "opens_into"))?),
            None if rooms.is_empty() => {
                let hint = "name the room with `opens_into`, or the rooms that it joins with `rooms`";
                self.report.error(self.path, "the door opens into which room?", Some(hint.to_owned()));
                return None;
            }
            None => rooms.first().cloned(),
        };
        // Seen in a mirror, left is right.
        let hinge_left = (opening.hinge != Some(HandWord::Right)) != self.scope.motion.is_mirrored;
        let angle = opening.swing.unwrap_or(USUAL_SWING).to_radians();
        Some(LeafDraft::Swing { hinge_left, into, count: opening.leaves.unwrap_or(1), angle })
    }
}

fn kind(word: OpeningWord) -> OpeningKind {
    match word {
        OpeningWord::Door => OpeningKind::Door,
        OpeningWord::SlidingDoor => OpeningKind::SlidingDoor,
        OpeningWord::Passage => OpeningKind::Passage,
        OpeningWord::OpenBoundary => OpeningKind::OpenBoundary,
        OpeningWord::Window => OpeningKind::Window,
    }
}
