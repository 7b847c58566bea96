//! The line along which a room is longest, in the middle of its width: the axis of a nave.

use super::{Point, Segment};

/// Lines across a room that are measured.
const LINES: usize = 64;
/// Share of the longest line that those beside it have while the room is as wide there: an apse or the foot of a tower at an end takes
/// less of them.
const LONG: f64 = 0.8;
/// How many times as long as the other axis one is, where people look along it wherever they come in.
const CLEARLY_LONGER: f64 = 1.2;
/// Metres by which one length must be more than another to count as longer: no last digit decides.
pub(crate) const LONGER: f64 = 1e-3;

/// The line along a direction in the middle of where an outline is longest, from its end that comes first in that direction.
///
/// ```text
///          +-----+
///     +----+     +--+
///     |· · · · · · ·  )      the widest run of long lines, and its middle
///     +----+     +--+
///          +-----+
/// ```
#[must_use]
fn long_axis(edges: &[Segment], along: Point) -> Option<Segment> {
    let across = along.perp();
    let ends = edges.iter().flat_map(|edge| [edge.start.dot(across), edge.end.dot(across)]);
    let (low, high) =
        ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    let at = |line: f64| low + (high - low) * (line + 0.5) / LINES as f64;
    let chords: Vec<(f64, f64)> = (0..LINES).map(|line| chord(edges, along, at(line as f64))).collect();
    let length = |(from, to): (f64, f64)| to - from;
    // The first of equals, so that the run goes on from there.
    let longest =
        (0..LINES).reduce(|a, b| if length(chords[b]) > length(chords[a]) + LONGER { b } else { a })?;
    let is_beside = |&line: &usize| {
        let (from, to) = chords[line];
        let shared = to.min(chords[longest].1) - from.max(chords[longest].0);
        shared >= LONG * length(chords[longest]) - LONGER
    };
    let first = (0..longest).rev().take_while(is_beside).last().unwrap_or(longest);
    let last = (longest..LINES).take_while(is_beside).last().unwrap_or(longest);
    let middle = at(f64::midpoint(first as f64, last as f64));
    let (from, to) = chord(edges, along, middle);
    (to > from).then(|| Segment::new(across * middle + along * from, across * middle + along * to))
}

/// The axis along which people look in a room: the longer of those along a direction and across it, or, of two that are about as long, the
/// one with an end nearer to where they come in, from which `gap` gives the metres of a place.
#[must_use]
pub fn main_axis(edges: &[Segment], along: Point, gap: impl Fn(Point) -> f64) -> Option<Segment> {
    let (along, across) = (long_axis(edges, along)?, long_axis(edges, along.perp())?);
    let nearest = |axis: Segment| gap(axis.start).min(gap(axis.end));
    let (longer, other) =
        if across.length() > along.length() + LONGER { (across, along) } else { (along, across) };
    let is_clear = longer.length() > CLEARLY_LONGER * other.length();
    Some(if is_clear || nearest(longer) <= nearest(other) + LONGER { longer } else { other })
}

/// The longest part of a line inside, from and to along it.
fn chord(edges: &[Segment], along: Point, offset: f64) -> (f64, f64) {
    let across = along.perp();
    let mut crossings: Vec<f64> = edges
        .iter()
        .filter_map(|edge| {
            let (start, end) = (edge.start.dot(across), edge.end.dot(across));
            // An end counts for one of its two edges.
            let crosses = (start <= offset) != (end <= offset);
            crosses.then(|| edge.at((offset - start) / (end - start)).dot(along))
        })
        .collect();
    crossings.sort_by(f64::total_cmp);
    let inside = crossings.chunks_exact(2).map(|pair| (pair[0], pair[1]));
    inside.reduce(|a, b| if b.1 - b.0 > a.1 - a.0 + LONGER { b } else { a }).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::edges;

    fn axis(corners: &[(f64, f64)], along: Point) -> Segment {
        let ring: Vec<Point> = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let edges: Vec<Segment> = edges(&ring).collect();
        long_axis(&edges, along).unwrap()
    }

    fn is_from_to(axis: Segment, start: (f64, f64), end: (f64, f64)) -> bool {
        let near = |a: Point, (x, y): (f64, f64)| a.distance(Point::new(x, y)) < 0.3;
        near(axis.start, start) && near(axis.end, end)
    }

    #[test]
    fn the_axis_of_a_nave_runs_between_its_walls_and_into_the_apse() {
        let nave = [
            (0.0, 0.0),
            (20.0, 0.0),
            (20.0, 2.0),
            (23.0, 4.0),
            (23.0, 6.0),
            (20.0, 8.0),
            (20.0, 10.0),
            (0.0, 10.0),
        ];
        let along = axis(&nave, Point::X);
        assert!(is_from_to(along, (0.0, 5.0), (23.0, 5.0)), "{along:?}");
    }

    #[test]
    fn arms_of_a_cross_do_not_move_the_axis() {
        let cross = [
            (0.0, 0.0),
            (12.0, 0.0),
            (12.0, -9.0),
            (18.0, -9.0),
            (18.0, 0.0),
            (26.0, 0.0),
            (26.0, 8.0),
            (18.0, 8.0),
            (18.0, 12.0),
            (12.0, 12.0),
            (12.0, 8.0),
            (0.0, 8.0),
        ];
        let along = axis(&cross, Point::X);
        assert!(is_from_to(along, (0.0, 4.0), (26.0, 4.0)), "{along:?}");
        let across = axis(&cross, Point::Y);
        assert!(is_from_to(across, (15.0, -9.0), (15.0, 12.0)), "{across:?}");
    }

    #[test]
    fn the_axis_of_a_bent_hall_is_that_of_its_longer_wing() {
        let bent = [(0.0, 0.0), (30.0, 0.0), (30.0, 8.0), (6.0, 8.0), (6.0, 20.0), (0.0, 20.0)];
        let along = axis(&bent, Point::X);
        assert!(is_from_to(along, (0.0, 4.0), (30.0, 4.0)), "{along:?}");
        let across = axis(&bent, Point::Y);
        assert!(is_from_to(across, (3.0, 0.0), (3.0, 20.0)), "{across:?}");
    }
}
