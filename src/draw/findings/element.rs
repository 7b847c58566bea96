//! The elements of a finding in the plan: objects, openings, walls and columns.

use crate::audit::Element;
use crate::draw::Drawing;
use crate::draw::canvas::Canvas;
use crate::geometry::{Convex, Point, direction};

/// Metres that the outline of an object stands off it.
const OFFSET: f64 = 0.02;

/// The outline of an element in the plan; two points for what is a line, none for what is not there.
pub(super) fn outline(element: Element, drawing: &Drawing<'_>, room: usize) -> Vec<Point> {
    let plan = &drawing.level.rooms[room];
    match element {
        Element::Object(index) => {
            let object = &drawing.furnished[room].placements[index];
            let half = Point::new(object.size.width, object.size.depth) / 2.0 + Point::splat(OFFSET);
            Convex::rectangle(object.position, half, direction(object.angle)).corners().to_vec()
        }
        Element::Opening(index) => {
            let opening = &drawing.level.openings[index];
            let half = opening.along * (opening.width / 2.0);
            vec![opening.center - half, opening.center + half]
        }
        Element::Wall(index) => vec![plan.walls[index].start, plan.walls[index].end],
        Element::Column(index) => plan.obstacles[index].outline.corners().to_vec(),
        Element::Class(_) => Vec::new(),
    }
}

/// Outlines an element in a colour.
pub(super) fn draw(element: Element, outline: &[Point], canvas: &mut Canvas, color: &str) {
    // A wall is long and concerned in one place; as bold as the others it would be all one sees.
    let width = if matches!(element, Element::Wall(_)) { 1.2 } else { 2.4 };
    let stroke = format!("fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"");
    match outline {
        [] => {}
        &[from, to] => canvas.line(from, to, &stroke),
        corners => canvas.polygon(corners, &format!("{stroke} stroke-linejoin=\"round\"")),
    }
}
