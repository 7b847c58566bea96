//! Makes outlines straight where an opening lies in a round wall: no frame is bent.
//!
//! ```text
//!        . - ~ ~ - .              +-------+
//!     .'             '.   -->   .'         '.
//! ```

use crate::geometry::{Point, edges};

/// Metres from the middle of an opening at which an outline runs along its wall.
const REACH: f64 = 0.5;
/// Metres by which the straight stretch is longer than the opening, at both ends: openings do not end in a corner.
const MARGIN: f64 = 0.03;

/// The outline with a straight edge along an opening, if it runs beside it through a bend.
pub(super) fn straightened(outline: &[Point], center: Point, along: Point, width: f64) -> Option<Vec<Point>> {
    let half = width / 2.0 + MARGIN;
    let local = |point: Point| Point::new((point - center).dot(along), (point - center).perp_dot(along));
    let is_beside = |point: Point| local(point).x.abs() < half && local(point).y.abs() < REACH;
    if !outline.iter().any(|corner| is_beside(*corner)) {
        return None;
    }
    let mut straight = Vec::with_capacity(outline.len() + 2);
    let mut is_changed = false;
    for edge in edges(outline) {
        let [start, end] = [local(edge.start), local(edge.end)];
        if !is_beside(edge.start) {
            straight.push(edge.start);
        } else {
            is_changed = true;
        }
        // Where the edge enters or leaves the stretch along the opening.
        let mut crossings: Vec<f64> = [-half, half]
            .into_iter()
            .map(|at| (at - start.x) / (end.x - start.x))
            .filter(|share| (0.0..1.0).contains(share))
            .filter(|share| local(edge.at(*share)).y.abs() < REACH)
            .collect();
        crossings.sort_by(f64::total_cmp);
        straight.extend(crossings.into_iter().map(|share| edge.at(share)));
    }
    (is_changed && straight.len() >= 3).then_some(straight)
}
