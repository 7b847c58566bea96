//! Finds the object or room part that an id in a finding names: `bed.1`, `door:2`, `wall.0`, `column.3`.

use crate::draw::Drawing;
use crate::draw::canvas::Canvas;
use crate::geometry::{Convex, Point, direction};
use crate::layout::Placement;

/// Metres that the outline of an object stands off it.
const OFFSET: f64 = 0.02;

/// An object or room part that a finding names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Thing {
    /// An object, by index into the placements of its room.
    Object(usize),
    /// By index into the level's openings.
    Opening(usize),
    /// By index into the room's walls.
    Wall(usize),
    /// By index into the room's obstacles.
    Column(usize),
}

/// The objects and room parts that words name; those that are not in the plan, such as missing pieces, are left out.
pub(super) fn find_all(drawing: &Drawing<'_>, room: usize, words: &[String]) -> Vec<Thing> {
    words.iter().filter_map(|word| find(drawing, room, word)).collect()
}

fn find(drawing: &Drawing<'_>, room: usize, word: &str) -> Option<Thing> {
    let placements = &drawing.furnished[room].placements;
    let id = |object: &Placement| format!("{}.{}", drawing.catalog.classes[object.class].id, object.number);
    if let Some(object) = placements.iter().position(|object| id(object) == word) {
        return Some(Thing::Object(object));
    }
    if let Some((_, id)) = word.split_once(':') {
        return drawing.level.openings.iter().position(|opening| opening.id == id).map(Thing::Opening);
    }
    let (part, number) = word.split_once('.')?;
    let number = number.parse().ok()?;
    let room = &drawing.level.rooms[room];
    match part {
        "wall" => room.walls.get(number).map(|_| Thing::Wall(number)),
        "column" => room.obstacles.get(number).map(|_| Thing::Column(number)),
        _ => None,
    }
}

impl Thing {
    /// Its outline in the plan; two points for what is a line.
    pub(super) fn outline(self, drawing: &Drawing<'_>, room: usize) -> Vec<Point> {
        let plan = &drawing.level.rooms[room];
        match self {
            Self::Object(index) => {
                let object = &drawing.furnished[room].placements[index];
                let half = Point::new(object.size.width, object.size.depth) / 2.0 + Point::splat(OFFSET);
                Convex::rectangle(object.position, half, direction(object.angle)).corners().to_vec()
            }
            Self::Opening(index) => {
                let opening = &drawing.level.openings[index];
                let half = opening.along * (opening.width / 2.0);
                vec![opening.center - half, opening.center + half]
            }
            Self::Wall(index) => vec![plan.walls[index].start, plan.walls[index].end],
            Self::Column(index) => plan.obstacles[index].outline.corners().to_vec(),
        }
    }

    /// Outlines it in a colour.
    pub(super) fn draw(self, canvas: &mut Canvas, drawing: &Drawing<'_>, room: usize, color: &str) {
        let outline = self.outline(drawing, room);
        // A wall is long and concerned in one place; as bold as the others it would be all one sees.
        let width = if matches!(self, Self::Wall(_)) { 1.2 } else { 2.4 };
        let stroke = format!("fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"");
        match outline.as_slice() {
            &[from, to] => canvas.line(from, to, &stroke),
            corners => canvas.polygon(corners, &format!("{stroke} stroke-linejoin=\"round\"")),
        }
    }
}
