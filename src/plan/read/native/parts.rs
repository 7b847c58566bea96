//! Drafts the rooms and columns of a level or of a placed prototype.

use std::collections::BTreeSet;

use super::file::{ColumnFile, OpeningFile, OpeningWord, RoomFile};
use super::ids::{NODE_NAME_FORBIDDEN, id_fault};
use super::level_parts::LevelParts;
use super::openings::OpeningReader;
use super::origins::Origin;
use super::pattern::{PatternValues, expand, names_value};
use super::report::{Report, item, step};
use super::scope::Scope;
use crate::document::PathStep;
use crate::geometry::Point;
use crate::plan::{ObstacleDraft, RoomDraft};

/// Corners of the polygon that a round column becomes; it lies around the circle, so that nothing that keeps
/// off the polygon touches the column.
const DISC_CORNERS: usize = 16;
/// Metres across a railing, half of them on either side of its edge.
const RAILING_THICKNESS: f64 = 0.08;

impl Scope<'_> {
    pub(super) fn add_rooms(&self, rooms: &[RoomFile], parts: &mut LevelParts, report: &mut Report<'_>) {
        for (index, room) in rooms.iter().enumerate() {
            let path = item(&self.path, "rooms", index);
            let only_one = rooms.len() == 1;
            let Some(id) = self.id(&room.id, only_one, &step(&path, "id"), report) else { continue };
            if self.left_out.contains(&path) {
                parts.left_out.insert(id);
                continue;
            }
            if let Some(first) = parts.room_origin(&id) {
                let first = report.line_of(&step(&first.path, "id")).unwrap_or_default();
                let message = format!("room id \"{id}\" is used twice, first in line {first}");
                // A copy's id is made where it is placed.
                let place = self.instance.as_ref().map_or(&path, |(_, place)| place);
                let hint = Some("ids of rooms are unique in a level".to_owned());
                report.error(&step(place, "id"), message, hint);
                continue;
            }
            parts.names.insert(id.clone(), parts.draft.rooms.len());
            let shape_key = if room.outline.is_some() { "outline" } else { "rectangle" };
            parts.origins.rooms.push(Origin { path, shape_key });
            let draft = self.room(id, room);
            parts.draft.railings.extend(railings(room, &draft.outline));
            parts.draft.rooms.push(draft);
        }
    }

    fn room(&self, id: String, room: &RoomFile) -> RoomDraft {
        let tags = room.walls.iter().flat_map(|walls| {
            let edges = walls.edge.as_slice().iter();
            edges.flat_map(|edge| walls.tags.as_slice().iter().map(|tag| (*edge, tag.clone())))
        });
        RoomDraft {
            id,
            number: room.number,
            name: room.name.clone(),
            room_type: room.room_type.clone(),
            unknown_word: None,
            fixtures: BTreeSet::new(),
            style: room.style.as_ref().or(self.style).cloned(),
            dwelling: room.dwelling.as_deref().or(self.instance_id()).map(str::to_owned),
            household: room.household.as_ref().or(self.household).cloned(),
            outline: self.outline(room.outline.as_deref(), room.rectangle),
            holes: room.holes.iter().map(|hole| self.moved(hole)).collect(),
            height: room.height.map(|height| self.units.to_metres(height)),
            edge_tags: tags.collect(),
        }
    }

    fn outline(&self, outline: Option<&[[f64; 2]]>, rectangle: Option<[f64; 4]>) -> Vec<Point> {
        match (outline, rectangle) {
            (Some(outline), _) => self.moved(outline),
            (None, Some([x, y, width, depth])) => {
                let (right, top) = (x + width, y + depth);
                self.moved(&[[x, y], [right, y], [right, top], [x, top]])
            }
            (None, None) => Vec::new(),
        }
    }

    fn moved(&self, points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().map(|point| self.motion.apply(self.point(*point))).collect()
    }

    pub(super) fn values(&self) -> PatternValues<'_> {
        PatternValues { n: None, level: Some(self.level), id: self.instance_id() }
    }

    /// The id of a part in the level: parts of a copy carry the copy's id, and the only room of a copy has
    /// just that.
    pub(super) fn full_id(&self, pattern: &str, is_only: bool) -> Result<String, (String, String)> {
        let id = expand(pattern, &self.values())?;
        let id = match self.instance_id() {
            Some(instance) if !names_value(pattern, "id") && is_only => instance.to_owned(),
            Some(instance) if !names_value(pattern, "id") => format!("{instance}-{id}"),
            _ => id,
        };
        let hint = "letters, digits, - and _ are safe";
        id_fault(&id, NODE_NAME_FORBIDDEN).map_or(Ok(id), |fault| Err((fault, hint.to_owned())))
    }

    fn id(&self, pattern: &str, is_only: bool, path: &[PathStep], report: &mut Report<'_>) -> Option<String> {
        let id = self.full_id(pattern, is_only);
        id.map_err(|(message, hint)| report.error(path, message, Some(hint))).ok()
    }

    pub(super) fn add_openings(
        &self,
        openings: &[OpeningFile],
        parts: &mut LevelParts,
        report: &mut Report<'_>,
    ) {
        for (index, opening) in openings.iter().enumerate() {
            let path = item(&self.path, "openings", index);
            let id = match &opening.id {
                Some(pattern) => self.id(pattern, false, &step(&path, "id"), report),
                None => Some(self.made_id(opening.kind, index)),
            };
            let Some(id) = id else { continue };
            if let Some(first) = parts.opening_ids.insert(id.clone(), path.clone()) {
                let first = report.line_of(&first).unwrap_or_default();
                let message = format!("opening id \"{id}\" is used twice, first in line {first}");
                let hint = Some("ids of openings are unique in a level".to_owned());
                report.error(&step(&path, "id"), message, hint);
                continue;
            }
            if let Some(draft) =
                (OpeningReader { scope: self, opening, path: &path, parts, report }).draft(id)
            {
                parts.origins.openings.push(Origin { path, shape_key: "at" });
                parts.draft.openings.push(draft);
            }
        }
    }

    /// The id of an opening without one: its kind's letter and its place in the list.
    fn made_id(&self, kind: OpeningWord, index: usize) -> String {
        let letter = match kind {
            OpeningWord::Door => "d",
            OpeningWord::SlidingDoor => "s",
            OpeningWord::Passage => "p",
            OpeningWord::OpenBoundary => "o",
            OpeningWord::Window => "w",
        };
        let number = index + 1;
        self.instance_id().map_or_else(|| format!("{letter}{number}"), |id| format!("{id}-{letter}{number}"))
    }

    pub(super) fn add_columns(&self, columns: &[ColumnFile], parts: &mut LevelParts) {
        for (index, column) in columns.iter().enumerate() {
            let disc = column.disc.as_ref().map(|disc| circle(disc.center, disc.diameter / 2.0));
            let outline = column.outline.as_deref().or(disc.as_deref());
            let draft = ObstacleDraft {
                outline: self.outline(outline, column.rectangle),
                height: column.height.map(|height| self.units.to_metres(height)),
            };
            let shape_key = if column.outline.is_some() { "outline" } else { "rectangle" };
            let path = item(&self.path, "columns", index);
            parts.origins.obstacles.push(Origin { path, shape_key });
            parts.draft.obstacles.push(draft);
        }
    }
}

/// A narrow outline along each edge that is a railing.
fn railings(room: &RoomFile, outline: &[Point]) -> Vec<Vec<Point>> {
    let edges = room.walls.iter().filter(|wall| wall.railing).flat_map(|wall| wall.edge.as_slice());
    let railing = |edge: &usize| {
        let (start, end) = (*outline.get(*edge)?, outline[(edge + 1) % outline.len()]);
        let aside = (end - start).perp().try_normalize()? * RAILING_THICKNESS / 2.0;
        Some(vec![start - aside, end - aside, end + aside, start + aside])
    };
    edges.filter_map(railing).collect()
}

/// A regular polygon around a circle.
fn circle([x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let sector = std::f64::consts::TAU / DISC_CORNERS as f64;
    let outer = radius / libm::cos(sector / 2.0);
    let corner = |index: usize| {
        let (sine, cosine) = libm::sincos(sector * index as f64);
        [x + outer * cosine, y + outer * sine]
    };
    (0..DISC_CORNERS).map(corner).collect()
}
