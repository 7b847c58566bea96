//! Draws one room by itself, with marks on its differences from another state of it.

use crate::catalog::Catalog;
use crate::geometry::{Bounds, Point, Segment};
use crate::layout::{Furnished, Parent};
use crate::plan::{Level, OpeningSide, Room, SitePlacement, Stairs};

use super::canvas::{Canvas, MARGIN_LEFT, TextStyle};
use super::{Drawing, MARGIN, furniture, shell};

/// The input of a drawing.
#[derive(Clone, Copy, Debug)]
pub struct RoomDrawing<'a> {
    /// The level that has the room.
    pub level: &'a Level,
    /// Index of the room in it.
    pub room: usize,
    /// Its furniture.
    pub furnished: &'a Furnished,
    /// Outlines of what stands in it and has no class in the catalogue.
    pub unknown: &'a [Vec<Point>],
    /// The marks.
    pub marks: &'a [RoomMark],
    /// Classes and room types.
    pub catalog: &'a Catalog,
    /// The line above the plan.
    pub title: &'a str,
    /// The part of the plan that is shown: equal for pictures that are compared.
    pub frame: Bounds,
}

/// A mark on an object.
#[derive(Clone, Debug, PartialEq)]
pub struct RoomMark {
    /// Its corners, in plan metres.
    pub outline: Vec<Point>,
    /// The kind of the mark.
    pub kind: MarkKind,
    /// Where the object was, for an arrow from there.
    pub from: Option<Point>,
}

/// The kind of a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// It came.
    Added,
    /// It went.
    Removed,
    /// It stands elsewhere, or is another one.
    Changed,
}

impl MarkKind {
    /// Its colour as CSS.
    #[must_use]
    pub fn color(self) -> &'static str {
        match self {
            Self::Added => "#2b8a3e",
            Self::Removed => "#c92a2a",
            Self::Changed => "#d9770a",
        }
    }
}

const UNKNOWN: &str =
    "fill=\"#ddd\" fill-opacity=\"0.9\" stroke=\"#333\" stroke-width=\"0.9\" stroke-dasharray=\"3 2\"";

/// Metres of thickness of a wall whose thickness is not known.
const USUAL_THICKNESS: f64 = 0.1;

/// Metres around a room that its picture shows.
#[must_use]
pub fn room_frame(room: &Room) -> Bounds {
    room.region.outline.bounds().inflated(MARGIN)
}

/// Draws a room.
///
/// # Panics
/// If an index in `furnished` points nowhere.
#[must_use]
pub fn draw_room(picture: &RoomDrawing<'_>) -> String {
    let level = alone(picture.level, picture.room);
    let mut furnished = picture.furnished.clone();
    for placement in &mut furnished.placements {
        // Openings have other numbers in the level of one room; drawings ask for ceilings and objects only.
        if matches!(placement.parent, Parent::Opening(_)) {
            placement.parent = Parent::Floor;
        }
    }
    let drawing = Drawing {
        building: "",
        site: SitePlacement::default(),
        level: &level,
        furnished: &[furnished],
        findings: &[],
        catalog: picture.catalog,
        seed: 0,
        has_clearances: false,
        has_findings: false,
        has_legend: false,
    };
    let mut canvas = Canvas::new(centered(picture.frame));
    shell::draw_walls(&mut canvas, &level);
    shell::draw_floors(&mut canvas, &drawing);
    shell::draw_obstacles(&mut canvas, &level);
    shell::draw_openings(&mut canvas, &level);
    furniture::draw_furniture(&mut canvas, &drawing);
    for outline in picture.unknown {
        canvas.polygon(outline, UNKNOWN);
    }
    picture.marks.iter().for_each(|mark| draw_mark(&mut canvas, mark));
    furniture::draw_names(&mut canvas, &drawing);
    let style = TextStyle { size: 15.0, is_bold: true, ..TextStyle::default() };
    canvas.text_at(Point::new(MARGIN_LEFT, 26.0), picture.title, style);
    canvas.finish()
}

/// A frame as wide as the narrowest sheet, so that a small room stands in its middle.
fn centered(frame: Bounds) -> Bounds {
    let canvas = Canvas::new(frame);
    let spare = canvas.width() / canvas.scale() - frame.size().x;
    let aside = Point::new(spare.max(0.0) / 2.0, 0.0);
    Bounds::new(frame.low - aside, frame.high + aside)
}

/// The room with walls as thick as its openings are deep: files have the middle of an opening, which is
/// halfway through the wall.
fn with_thickness(level: &Level, room: usize) -> Room {
    let mut alone = Room { openings: Vec::new(), ..level.rooms[room].clone() };
    for wall in &mut alone.walls {
        wall.thickness = wall.thickness.max(USUAL_THICKNESS);
    }
    for opening in &level.openings {
        for side in opening.sides.iter().filter(|side| side.room == room) {
            let wall = &mut alone.walls[side.wall];
            let behind = (wall.start - opening.center).dot(wall.normal());
            wall.thickness = (2.0 * behind).clamp(USUAL_THICKNESS, MARGIN);
        }
    }
    alone
}

/// The level with one of its rooms only, and the openings of that.
fn alone(level: &Level, room: usize) -> Level {
    let openings = level.openings.iter().filter_map(|opening| {
        let sides: Vec<OpeningSide> = opening
            .sides
            .iter()
            .filter(|side| side.room == room)
            .map(|side| OpeningSide { room: 0, ..*side })
            .collect();
        (!sides.is_empty()).then(|| crate::plan::Opening { sides, ..opening.clone() })
    });
    Level {
        id: level.id.clone(),
        name: level.name.clone(),
        elevation: level.elevation,
        height: level.height,
        rooms: vec![with_thickness(level, room)].into(),
        openings: openings.collect(),
        stairs: level
            .stairs_of(room)
            .map(|stairs| Stairs { room: 0, ..stairs.clone() })
            .into_iter()
            .collect(),
        left_out: Vec::new(),
        digest: level.digest,
    }
}

/// An outline in the mark's colour, and an arrow from where the object was.
fn draw_mark(canvas: &mut Canvas, mark: &RoomMark) {
    let color = mark.kind.color();
    let attributes = format!(
        "fill=\"{color}\" fill-opacity=\"0.18\" stroke=\"{color}\" stroke-width=\"2.2\" stroke-linejoin=\"round\""
    );
    canvas.polygon(&mark.outline, &attributes);
    let Some(from) = mark.from else { return };
    let to =
        mark.outline.iter().fold(Point::ZERO, |sum, &corner| sum + corner) / mark.outline.len().max(1) as f64;
    draw_arrow(canvas, Segment::new(from, to), color);
}

/// A line with a head; nothing where it would be shorter than the head.
fn draw_arrow(canvas: &mut Canvas, way: Segment, color: &str) {
    /// Pixels of the head's length, and of half its width.
    const HEAD: (f64, f64) = (9.0, 3.5);
    let (length, half) = (HEAD.0 / canvas.scale(), HEAD.1 / canvas.scale());
    if way.length() <= length {
        return;
    }
    let (to, along) = (way.end, way.direction());
    let neck = to - along * length;
    canvas.line(way.start, neck, &format!("stroke=\"{color}\" stroke-width=\"1.6\""));
    let across = along.perp() * half;
    canvas.polygon(&[to, neck + across, neck - across], &format!("fill=\"{color}\""));
}
