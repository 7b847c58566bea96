//! The things of a finding in the plan: objects, openings, walls and columns.

use crate::audit::Thing;
use crate::draw::Drawing;
use crate::draw::canvas::Canvas;
use crate::geometry::{Convex, Point, direction};

/// Metres that the outline of an object stands off it.
const OFFSET: f64 = 0.02;

/// The outline of a thing in the plan; two points for what is a line, none for what is not there.
pub(super) fn outline(thing: Thing, drawing: &Drawing<'_>, room: usize) -> Vec<Point> {
    let plan = &drawing.level.rooms[room];
    match thing {
        Thing::Object(index) => {
            let object = &drawing.furnished[room].placements[index];
            let half = Point::new(object.size.width, object.size.depth) / 2.0 + Point::splat(OFFSET);
            Convex::rectangle(object.position, half, direction(object.angle)).corners().to_vec()
        }
        Thing::Opening(index) => {
            let opening = &drawing.level.openings[index];
            let half = opening.along * (opening.width / 2.0);
            vec![opening.center - half, opening.center + half]
        }
        Thing::Wall(index) => vec![plan.walls[index].start, plan.walls[index].end],
        Thing::Column(index) => plan.obstacles[index].outline.corners().to_vec(),
        Thing::Class(_) => Vec::new(),
    }
}

/// Outlines a thing in a colour.
pub(super) fn draw(thing: Thing, outline: &[Point], canvas: &mut Canvas, color: &str) {
    // A wall is long and concerned in one place; as bold as the others it would be all one sees.
    let width = if matches!(thing, Thing::Wall(_)) { 1.2 } else { 2.4 };
    let stroke = format!("fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"");
    match outline {
        [] => {}
        &[from, to] => canvas.line(from, to, &stroke),
        corners => canvas.polygon(corners, &format!("{stroke} stroke-linejoin=\"round\"")),
    }
}
