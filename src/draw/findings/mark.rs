//! Numbered marks, each as near to what it is about as the other words allow.

use crate::draw::Drawing;
use crate::draw::canvas::{Canvas, TextStyle, short};
use crate::draw::labels::label_place;
use crate::geometry::{Bounds, Point, direction, edges};

use super::{Noted, element, severity_color};

/// Pixels of a mark's radius.
pub(super) const RADIUS: f64 = 7.5;

/// Pixels between the rings on which a free place is looked for, and how many there are.
const RING: f64 = 6.0;
const RINGS: usize = 40;

/// Directions that are tried on each ring.
const DIRECTIONS: usize = 16;

/// Pixels of a mark's number.
const LETTERS: f64 = 9.0;

/// One mark for each finding.
pub(crate) fn draw_marks(canvas: &mut Canvas, drawing: &Drawing<'_>, all: &[Noted<'_>]) {
    for noted in all {
        let outline = outline(drawing, noted);
        let anchor = middle(&outline).unwrap_or_else(|| label_place(drawing, noted.room));
        let anchor = canvas.pixel(anchor);
        let at = free_place(canvas, anchor);
        if !outline.is_empty() {
            draw_leader(canvas, at, &outline, severity_color(noted.finding.severity));
        }
        draw_mark(canvas, at, noted);
    }
}

/// The subject of the mark: the region if there is one, else the first object or room part.
fn outline(drawing: &Drawing<'_>, noted: &Noted<'_>) -> Vec<Point> {
    let outlines =
        noted.finding.elements.iter().map(|&element| element::outline(element, drawing, noted.room));
    let mut outlines = noted.finding.region.iter().cloned().chain(outlines);
    outlines.find(|outline| !outline.is_empty()).unwrap_or_default()
}

fn middle(outline: &[Point]) -> Option<Point> {
    let sum = outline.iter().copied().reduce(|a, b| a + b)?;
    Some(sum / outline.len() as f64)
}

/// The nearest pixel to another around which no words stand; that one itself if there is none.
fn free_place(canvas: &Canvas, anchor: Point) -> Point {
    let on_ring = |index: usize| {
        let angle = std::f64::consts::TAU * (index % DIRECTIONS) as f64 / DIRECTIONS as f64;
        anchor + direction(angle) * (RING * (1 + index / DIRECTIONS) as f64)
    };
    let mut places = std::iter::once(anchor).chain((0..RINGS * DIRECTIONS).map(on_ring));
    places.find(|&place| canvas.is_clear(Bounds::around_point(place, RADIUS + 1.0))).unwrap_or(anchor)
}

/// A line from a mark that stands off to what it belongs to.
fn draw_leader(canvas: &mut Canvas, at: Point, outline: &[Point], color: &str) {
    let corners: Vec<Point> = outline.iter().map(|&corner| canvas.pixel(corner)).collect();
    let near = edges(&corners).map(|edge| edge.nearest(at));
    let near = near.min_by(|a, b| a.distance(at).total_cmp(&b.distance(at)));
    let is_off = |end: &Point| end.distance(at) > RADIUS && !encloses(&corners, at);
    if let Some(end) = near.filter(is_off) {
        let [x, y, u, v] = [at.x, at.y, end.x, end.y].map(short);
        canvas.raw(&format!("<path d=\"M{x} {y}L{u} {v}\" stroke=\"{color}\" stroke-width=\"1\"/>"));
    }
}

/// Whether a convex outline has a point inside, whichever way round it runs.
fn encloses(corners: &[Point], point: Point) -> bool {
    let sides = || edges(corners).map(|edge| edge.side(point));
    corners.len() > 2 && (sides().all(|side| side >= 0.0) || sides().all(|side| side <= 0.0))
}

/// A disc with the finding's number.
fn draw_mark(canvas: &mut Canvas, at: Point, noted: &Noted<'_>) {
    let (x, y) = (short(at.x), short(at.y));
    let color = severity_color(noted.finding.severity);
    canvas.raw(&format!(
        "<circle cx=\"{x}\" cy=\"{y}\" r=\"{RADIUS}\" fill=\"{color}\" stroke=\"#fff\" stroke-width=\"1\"/>"
    ));
    canvas.reserve(Bounds::around_point(at, RADIUS));
    draw_number(canvas, at, noted.number);
}

/// The number in the middle of a mark.
pub(super) fn draw_number(canvas: &mut Canvas, at: Point, number: usize) {
    let size = if number < 100 { LETTERS } else { LETTERS * 0.78 };
    let style = TextStyle { size, anchor: "middle", color: "#fff", is_bold: true, ..TextStyle::default() };
    canvas.text_at(at, &number.to_string(), style);
}
