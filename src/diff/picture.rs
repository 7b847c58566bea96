//! Pictures of changed rooms, before and after.

use std::collections::BTreeMap;
use std::path::Path;

use glam::DVec3;

use super::change::Change;
use super::kind::Kind;
use super::read::{Reading, read};
use super::report::{LevelDiff, Presence, RoomDiff};
use crate::catalog::{Catalog, Side, Size};
use crate::contract::ElementId;
use crate::draw::{MarkKind, RoomDrawing, RoomMark, draw_room, room_frame};
use crate::geometry::{Bounds, Point};
use crate::layout::{Furnished, Parent, Placement};
use crate::read_back::ObjectEntry;

/// A room as SVG; a side that does not have it, or cannot draw it, is missing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RoomPictures {
    /// Room id.
    pub room: String,
    /// Before.
    pub old: Option<String>,
    /// After.
    pub new: Option<String>,
}

/// Draws rooms of a level that differ. `old` and `new` are the sides that were compared. Files that cannot be read
/// any more have no pictures: the report has their faults.
#[must_use]
pub fn draw_rooms(
    level: &LevelDiff,
    rooms: &[&RoomDiff],
    old: &Path,
    new: &Path,
    catalog: &Catalog,
) -> Vec<RoomPictures> {
    let open = |root: &Path, file: Option<&String>| {
        let path = if root.is_dir() { root.join(file?) } else { root.to_owned() };
        read(&path, false, catalog).ok()
    };
    let (before, after) = (open(old, level.old_file.as_ref()), open(new, level.new_file.as_ref()));
    rooms.iter().map(|room| draw_pair(room, before.as_ref(), after.as_ref(), catalog)).collect()
}

/// A side of a room, ready to be drawn.
struct View<'a> {
    reading: &'a Reading,
    index: usize,
    objects: &'a [ObjectEntry],
}

fn draw_pair(
    room: &RoomDiff,
    old: Option<&Reading>,
    new: Option<&Reading>,
    catalog: &Catalog,
) -> RoomPictures {
    let old = old.filter(|_| room.state != Presence::Added).and_then(|reading| view(reading, &room.room));
    let new = new.filter(|_| room.state != Presence::Removed).and_then(|reading| view(reading, &room.room));
    let frames = [&old, &new].into_iter().flatten().filter_map(View::frame);
    let Some(frame) = frames.reduce(Bounds::union) else {
        return RoomPictures { room: room.room.clone(), ..RoomPictures::default() };
    };
    let draw = |view: &Option<View<'_>>, title: &str, marks: Vec<RoomMark>| {
        view.as_ref().and_then(|view| view.draw(&marks, title, frame, catalog))
    };
    RoomPictures {
        room: room.room.clone(),
        old: draw(&old, "before", old_marks(room, old.as_ref())),
        new: draw(&new, "after", new_marks(room, new.as_ref())),
    }
}

fn view<'a>(reading: &'a Reading, id: &str) -> Option<View<'a>> {
    let level = &reading.level.as_ref()?.level;
    let index = level.rooms.iter().position(|room| room.id == id)?;
    let objects = reading.inventory.rooms.get(id).map_or(&[][..], |room| &room.objects);
    Some(View { reading, index, objects })
}

impl View<'_> {
    fn frame(&self) -> Option<Bounds> {
        Some(room_frame(&self.reading.level.as_ref()?.level.rooms[self.index]))
    }

    fn draw(&self, marks: &[RoomMark], title: &str, frame: Bounds, catalog: &Catalog) -> Option<String> {
        let level = &self.reading.level.as_ref()?.level;
        let is_known = |object: &&ObjectEntry| catalog.class_index(&object.class).is_some();
        let (known, unknown): (Vec<&ObjectEntry>, Vec<&ObjectEntry>) =
            self.objects.iter().partition(is_known);
        let furnished = Furnished {
            room: 0,
            seed: 0,
            style: catalog.default_style,
            requested: 0,
            placements: known.into_iter().filter_map(|object| placement(object, catalog)).collect(),
            removals: Vec::new(),
        };
        let unknown: Vec<Vec<Point>> = unknown.into_iter().map(outline).collect();
        Some(draw_room(&RoomDrawing {
            level,
            room: self.index,
            furnished: &furnished,
            unknown: &unknown,
            marks,
            catalog,
            title,
            frame,
        }))
    }
}

/// An object as drawings take it: of its parent they ask only whether that is the ceiling.
fn placement(object: &ObjectEntry, catalog: &Catalog) -> Option<Placement> {
    let east = object.rotation * DVec3::X;
    let [width, depth, height] = object.size;
    Some(Placement {
        class: catalog.class_index(&object.class)?,
        number: object.id.number,
        parent: if object.parent == ElementId::Ceiling { Parent::Ceiling } else { Parent::Floor },
        side: Side::ALL[0],
        position: object.position.truncate(),
        elevation: object.position.z,
        angle: libm::atan2(east.y, east.x),
        variant: object.variant,
        size: Size { width, depth, height },
    })
}

/// The corners of its box from above.
fn outline(object: &ObjectEntry) -> Vec<Point> {
    let [width, depth, _] = object.size;
    let corner = |x: f64, y: f64| {
        let at = object.rotation * DVec3::new(x * width / 2.0, y * depth / 2.0, 0.0);
        object.position.truncate() + at.truncate()
    };
    vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)]
}

/// Kinds that are marked on an object of both sides.
fn is_marked(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::Moved
            | Kind::Turned
            | Kind::Resized
            | Kind::Class
            | Kind::Variant
            | Kind::Material
            | Kind::Parent
    )
}

/// Marks at objects that were removed, moved or swapped.
fn old_marks(room: &RoomDiff, view: Option<&View<'_>>) -> Vec<RoomMark> {
    let kind_of = |change: &Change| match change.kind {
        Kind::Removed => Some((change.id.clone(), MarkKind::Removed)),
        kind if is_marked(kind) => {
            Some((change.old_id.clone().unwrap_or_else(|| change.id.clone()), MarkKind::Changed))
        }
        _ => None,
    };
    let kinds: BTreeMap<String, MarkKind> = room.changes.iter().filter_map(kind_of).collect();
    marks(view, &kinds, |_| None)
}

/// Marks at objects that were added, moved or swapped; moved ones have an arrow from their old place.
fn new_marks(room: &RoomDiff, view: Option<&View<'_>>) -> Vec<RoomMark> {
    let kind_of = |change: &Change| match change.kind {
        Kind::Added => Some((change.id.clone(), MarkKind::Added)),
        kind if is_marked(kind) => Some((change.id.clone(), MarkKind::Changed)),
        _ => None,
    };
    let kinds: BTreeMap<String, MarkKind> = room.changes.iter().filter_map(kind_of).collect();
    let from = |id: &str| {
        // Objects that were carried along have no arrow of their own.
        let is_move =
            |change: &&Change| change.kind == Kind::Moved && change.with.is_none() && change.id == id;
        match room.changes.iter().find(is_move)?.old.as_ref()? {
            super::change::Worth::Numbers(place) => Some(Point::new(*place.first()?, *place.get(1)?)),
            _ => None,
        }
    };
    marks(view, &kinds, from)
}

fn marks(
    view: Option<&View<'_>>,
    kinds: &BTreeMap<String, MarkKind>,
    from: impl Fn(&str) -> Option<Point>,
) -> Vec<RoomMark> {
    let objects = view.map_or(&[][..], |view| view.objects);
    let marked = objects.iter().filter_map(|object| Some((object, *kinds.get(&object.id.to_string())?)));
    marked
        .map(|(object, kind)| RoomMark { outline: outline(object), kind, from: from(&object.id.to_string()) })
        .collect()
}
