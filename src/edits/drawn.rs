//! Turns furniture that a plan draws into locked objects, so that rooms are furnished around it.

use std::collections::BTreeMap;

use super::file::{EditsFile, ObjectEntry, RoomEntry, VERSION};
use crate::catalog::{Catalog, ClassIndex, Size};
use crate::geometry::{Convex, Point};
use crate::plan::{DrawnPiece, Level, PlacedBuilding, Room};

/// Metres that a class may be wider or deeper than the piece that it stands for: more would stand in its neighbours.
const LARGER: f64 = 0.15;
/// Metres between the back of a piece and the wall that it stands against.
const AT_WALL: f64 = 0.15;
/// Cosine of the largest angle between its back and that wall.
const FACING_COSINE: f64 = 0.98;
/// Metres above the floor below which a piece stands on it.
const ON_FLOOR: f64 = 0.05;
/// Metres by which two kept pieces may overlap.
const OVERLAP: f64 = 0.02;
/// The group of classes that are kept first where two pieces claim a place: pipes and cables fix theirs, in kitchens and baths.
const FIRST_GROUP: &str = "fixed";

/// The furniture of a building that is kept, and why the rest is not.
#[derive(Clone, Debug)]
pub struct KeptFurniture {
    /// The locked objects, room by room.
    pub file: EditsFile,
    /// How many they are.
    pub kept: usize,
    /// Reason → how many pieces are left out for it.
    pub left_out: BTreeMap<&'static str, usize>,
    /// Words for pieces that no class has → how many pieces have them.
    pub unknown: BTreeMap<String, usize>,
}

/// Keeps the furniture that the catalogue has a class for, where it stands: kitchens and baths first.
#[must_use]
pub fn keep_drawn(pieces: &[DrawnPiece], placed: &PlacedBuilding, catalog: &Catalog) -> KeptFurniture {
    let mut keeping = Keeping { placed, catalog, rooms: BTreeMap::new(), kept: 0, left_out: BTreeMap::new() };
    let mut unknown: BTreeMap<String, usize> = BTreeMap::new();
    let mut known: Vec<(bool, &DrawnPiece, ClassIndex)> = Vec::new();
    for piece in pieces.iter().filter(|piece| piece.building == placed.id) {
        let words = [piece.kind.as_str(), piece.name.trim()];
        let class = catalog.room_words.class_of_piece(piece.format, &words);
        match class.and_then(|class| catalog.class_index(class)) {
            Some(class) => known.push((!is_first(catalog, class), piece, class)),
            None => {
                let word = if piece.name.is_empty() { &piece.kind } else { &piece.name };
                *unknown.entry(word.clone()).or_default() += 1;
            }
        }
    }
    // In the order of the file otherwise.
    known.sort_by_key(|(is_later, ..)| *is_later);
    for (_, piece, class) in known {
        if let Err(reason) = keeping.keep(piece, class) {
            *keeping.left_out.entry(reason).or_default() += 1;
        }
    }
    let Keeping { rooms, kept, left_out, .. } = keeping;
    let edits = rooms.into_values().map(|room| room.entry).collect();
    KeptFurniture { file: EditsFile { version: VERSION, edits }, kept, left_out, unknown }
}

fn is_first(catalog: &Catalog, class: ClassIndex) -> bool {
    catalog.classes[class].groups.iter().any(|group| group == FIRST_GROUP)
}

struct Keeping<'a> {
    placed: &'a PlacedBuilding,
    catalog: &'a Catalog,
    /// Level and room, as indices → what is kept in it.
    rooms: BTreeMap<(usize, usize), KeptRoom>,
    kept: usize,
    left_out: BTreeMap<&'static str, usize>,
}

struct KeptRoom {
    entry: RoomEntry,
    /// The floor under each object, and the metres between which it stands.
    bodies: Vec<(Convex, [f64; 2])>,
    /// Class → the last number of its objects.
    numbers: BTreeMap<ClassIndex, u32>,
}

impl Keeping<'_> {
    fn keep(&mut self, piece: &DrawnPiece, class: ClassIndex) -> Result<(), &'static str> {
        let levels = &self.placed.building.levels;
        let level_index =
            levels.iter().position(|level| level.id == piece.level).ok_or("outside of all rooms")?;
        let level = &levels[level_index];
        let is_inside = |room: &Room| room.region.contains(piece.center);
        let room_index = level.rooms.iter().position(is_inside).ok_or("outside of all rooms")?;
        let room = &level.rooms[room_index];
        let (variant, size) =
            nearest_size(self.catalog, class, piece.size).ok_or("smaller than its class")?;
        let stand = Stand::of(piece, size, room);
        let is_on_floor = piece.bottom <= ON_FLOOR;
        if !is_on_floor && stand.wall.is_none() {
            return Err("on other furniture or at the ceiling");
        }
        let body = Convex::rectangle(stand.center, Point::new(size.width, size.depth) / 2.0, piece.axis);
        let heights = [piece.bottom, piece.bottom + size.height];
        let kept = self
            .rooms
            .entry((level_index, room_index))
            .or_insert_with(|| KeptRoom::of(level, room, &self.placed.id));
        let collides = |(other, span): &(Convex, [f64; 2])| {
            span[0] < heights[1] && heights[0] < span[1] && other.overlaps(&body, OVERLAP)
        };
        if kept.bodies.iter().any(collides) {
            return Err("in the place of another piece");
        }
        kept.bodies.push((body, heights));
        let number = kept.numbers.entry(class).or_default();
        *number += 1;
        let id = format!("{}.{number}", self.catalog.classes[class].id);
        kept.entry.objects.insert(id, stand.entry(piece, variant, is_on_floor));
        self.kept += 1;
        Ok(())
    }
}

impl KeptRoom {
    fn of(level: &Level, room: &Room, building: &str) -> Self {
        let (building, level) = (Some(building.to_owned()), level.id.clone());
        let entry = RoomEntry { building, level, room: room.id.clone(), ..RoomEntry::default() };
        Self { entry, bodies: Vec::new(), numbers: BTreeMap::new() }
    }
}

/// The variant whose size is nearest to a piece and not much larger.
fn nearest_size(catalog: &Catalog, class: ClassIndex, piece: Point) -> Option<(u32, Size)> {
    let class = &catalog.classes[class];
    let sizes = (0..class.variant_count()).map(|variant| (variant, class.size(variant)));
    let off = |size: &Size| (size.width - piece.x).abs() + (size.depth - piece.y).abs();
    sizes
        .filter(|(_, size)| size.width <= piece.x + LARGER && size.depth <= piece.y + LARGER)
        .min_by(|a, b| off(&a.1).total_cmp(&off(&b.1)).then(a.0.cmp(&b.0)))
}

/// Where an object stands that takes the place of a piece.
struct Stand {
    center: Point,
    /// The wall behind it.
    wall: Option<usize>,
}

impl Stand {
    /// The back of the object is that of the piece, and at the wall if the piece stands there.
    fn of(piece: &DrawnPiece, size: Size, room: &Room) -> Self {
        let back = piece.axis.perp();
        let middle = piece.center + back * (piece.size.y / 2.0);
        let behind = room.walls.iter().enumerate().filter_map(|(number, wall)| {
            let along = (middle - wall.start).dot(wall.direction());
            // Metres from the back to the wall; below zero where the piece stands in it.
            let gap = (middle - wall.start).dot(wall.normal());
            let is_behind = wall.normal().dot(back) < -FACING_COSINE
                && gap.abs() <= AT_WALL
                && (0.0..=wall.length()).contains(&along);
            is_behind.then_some((number, gap))
        });
        let nearest = behind.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        let gap = nearest.map_or(0.0, |(_, gap)| gap);
        let center = middle + back * (gap - size.depth / 2.0);
        Self { center, wall: nearest.map(|(number, _)| number) }
    }

    fn entry(&self, piece: &DrawnPiece, variant: u32, is_on_floor: bool) -> ObjectEntry {
        // What people read, to a tenth of a millimetre.
        let rounded = |metres: f64| (metres * 1e4).round() / 1e4 + 0.0;
        let mut at = vec![rounded(self.center.x), rounded(self.center.y)];
        if !is_on_floor {
            at.push(rounded(piece.bottom));
        }
        let turn = libm::atan2(piece.axis.y, piece.axis.x).to_degrees();
        ObjectEntry {
            add: true,
            lock: true,
            variant: Some(variant),
            parent: Some(self.wall.map_or_else(|| "floor".to_owned(), |wall| format!("wall.{wall}"))),
            at: Some(at),
            turn: Some((turn * 100.0).round() / 100.0 + 0.0),
            ..ObjectEntry::default()
        }
    }
}
