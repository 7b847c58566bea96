//! Draws objects from above, low ones first, with their fronts marked.

use crate::catalog::{Class, Shape};
use crate::geometry::{Point, direction};
use crate::layout::{Parent, Placement, clearance_solids, solids};

use super::Drawing;
use super::canvas::{Canvas, LETTER_WIDTH, TextStyle};
use super::color::class_fill;
use super::symbols::symbol_strokes;

const MINIMUM_CLEARANCE: &str =
    "fill=\"#d9480f\" fill-opacity=\"0.08\" stroke=\"#d9480f\" stroke-width=\"0.8\" stroke-dasharray=\"3 2\"";
const GOOD_CLEARANCE: &str = "fill=\"none\" stroke=\"#d9480f\" stroke-width=\"0.5\" stroke-dasharray=\"1 2\"";

/// Metres of an object's shorter side from which its front or its symbol is drawn.
const MARKED_SIDE: f64 = 0.25;

/// Outlines of furniture, what hangs above it, and lines inside outlines: thinner than walls.
pub(crate) const OUTLINE: &str = "stroke=\"#333\" stroke-width=\"0.9\" stroke-linejoin=\"round\"";
pub(crate) const OVERHEAD: &str =
    "fill=\"none\" stroke=\"#777\" stroke-width=\"0.6\" stroke-dasharray=\"4 2.5\"";
pub(crate) const DETAIL: &str =
    "fill=\"none\" stroke=\"#555\" stroke-width=\"0.5\" stroke-linejoin=\"round\"";

/// Metres of an underside above the floor from which an object counts as hanging.
const HANGING: f64 = 1.0;

/// Metres of an object's longer side from which it is named.
const NAMED_SIDE: f64 = 0.6;

/// Pixels of the largest and the smallest letters on furniture.
const LETTERS: (f64, f64) = (10.0, 6.0);

/// The regions that objects need before their sides.
pub(crate) fn draw_clearances(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    for placement in drawing.furnished.iter().flat_map(|room| &room.placements) {
        let class = &drawing.catalog.classes[placement.class];
        for (_, solid) in clearance_solids(class, placement, true) {
            canvas.polygon(solid.base.corners(), GOOD_CLEARANCE);
        }
        for (_, solid) in clearance_solids(class, placement, false) {
            canvas.polygon(solid.base.corners(), MINIMUM_CLEARANCE);
        }
    }
}

/// All objects of all rooms.
pub(crate) fn draw_furniture(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    let mut placements: Vec<&Placement> =
        drawing.furnished.iter().flat_map(|room| &room.placements).collect();
    let top = |placement: &Placement| placement.elevation + placement.size.height;
    placements.sort_by(|a, b| top(a).total_cmp(&top(b)));
    for placement in &placements {
        draw_object(canvas, &drawing.catalog.classes[placement.class], placement);
    }
}

/// The names of objects; they come after all bodies, so that nothing covers them, and cover no other words.
pub(crate) fn draw_names(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    let placements = drawing.furnished.iter().flat_map(|room| &room.placements);
    for placement in placements.filter(|placement| carries_name(placement)) {
        draw_name(canvas, &drawing.catalog.classes[placement.class].label, placement);
    }
}

/// Whether it hangs over what stands below.
pub(crate) fn hangs(placement: &Placement) -> bool {
    placement.parent == Parent::Ceiling || placement.elevation > HANGING
}

/// Whether it stands below and is large enough for a front or a symbol.
pub(crate) fn is_marked(placement: &Placement) -> bool {
    !hangs(placement) && placement.size.width.min(placement.size.depth) >= MARKED_SIDE
}

fn draw_object(canvas: &mut Canvas, class: &Class, placement: &Placement) {
    // Hanging objects do not hide those below.
    if hangs(placement) {
        return draw_outline(canvas, class, placement, OVERHEAD);
    }
    let fill = class_fill(&class.id);
    let opacity = if matches!(class.shape, Shape::Prisms(_)) { 0.6 } else { 0.92 };
    let attributes = format!("fill=\"{fill}\" fill-opacity=\"{opacity}\" {OUTLINE}");
    draw_outline(canvas, class, placement, &attributes);
    if is_marked(placement) {
        draw_inside(canvas, class, placement);
    }
}

/// The lines of an object's symbol; a mark at the front of those that have none.
fn draw_inside(canvas: &mut Canvas, class: &Class, placement: &Placement) {
    let right = direction(placement.angle);
    let front = -right.perp();
    let strokes = symbol_strokes(class, placement.size);
    for stroke in &strokes {
        let place = |point: &Point| placement.position + right * point.x + front * point.y;
        let points: Vec<Point> = stroke.points.iter().map(place).collect();
        match (stroke.is_closed, points.as_slice()) {
            (true, corners) => canvas.polygon(corners, DETAIL),
            (false, ends) => ends.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], DETAIL)),
        }
    }
    if strokes.is_empty() {
        draw_front(canvas, placement);
    }
}

fn draw_outline(canvas: &mut Canvas, class: &Class, placement: &Placement, attributes: &str) {
    for solid in solids(class, placement) {
        canvas.polygon(solid.base.corners(), attributes);
    }
}

/// A small arrowhead inside the middle of the front edge.
fn draw_front(canvas: &mut Canvas, placement: &Placement) {
    const LARGEST: f64 = 0.07;
    const SHARE: f64 = 0.15;
    const INSET: f64 = 0.02;
    let right = direction(placement.angle);
    let front = -right.perp();
    let length = LARGEST.min(SHARE * placement.size.depth);
    let tip = placement.position + front * (placement.size.depth / 2.0 - INSET);
    let base = tip - front * length;
    canvas.polygon(&[tip, base - right * length, base + right * length], "fill=\"#777\"");
}

/// Whether an object gets a name: it stands on the floor and is large enough. A rug would be named over its table.
fn carries_name(placement: &Placement) -> bool {
    const LOWEST: f64 = 0.1;
    !hangs(placement)
        && placement.size.height > LOWEST
        && placement.size.width.max(placement.size.depth) >= NAMED_SIDE
}

/// The label along the object's longer side on the screen, as large as fits.
fn draw_name(canvas: &mut Canvas, label: &str, placement: &Placement) {
    let right = direction(placement.angle).abs();
    let (width, depth) = (placement.size.width, placement.size.depth);
    let extent = Point::new(right.x * width + right.y * depth, right.y * width + right.x * depth);
    let room = extent * canvas.scale();
    let is_upright = room.y > room.x * 1.3;
    let (length, height) = if is_upright { (room.y, room.x) } else { (room.x, room.y) };
    let fitting = length * 0.92 / (label.chars().count() as f64 * LETTER_WIDTH);
    let size = fitting.min(height * 0.6).min(LETTERS.0);
    if size >= LETTERS.1 {
        let style = TextStyle { size, anchor: "middle", is_upright, has_halo: true, ..TextStyle::default() };
        canvas.text_if_clear(placement.position, label, style);
    }
}
