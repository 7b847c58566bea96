//! Puts the panes of curtain walls into lines, and joins those that stand above each other.

use super::openings::Hole;
use super::swing::Doorway;
use crate::geometry::Point;

/// Metres between panes above each other that are one window with a bar across, and by which columns of panes may overlap.
const TRANSOM: f64 = 0.3;
const OVERLAP: f64 = 0.05;
/// Cosine of the angle and metres between panes of one line.
const PARALLEL: f64 = 0.999;
const ABREAST: f64 = 0.2;

/// Panes in one vertical plane.
pub(super) struct Line {
    pub(super) origin: Point,
    pub(super) along: Point,
    pub(super) spans: Vec<Span>,
}

/// A pane in its line: metres along it and of its height above the building's zero.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Span {
    pub(super) pane: u64,
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Span {
    fn area(&self) -> f64 {
        (self.to - self.from) * (self.high - self.low)
    }
}

/// Adds a pane to the line that it stands in, or to a new one.
pub(super) fn enlist(lines: &mut Vec<Line>, pane: u64, hole: &Hole) {
    let Doorway { center, along, width } = hole.doorway;
    let is_in = |line: &&mut Line| {
        line.along.dot(along).abs() > PARALLEL && (center - line.origin).perp_dot(line.along).abs() < ABREAST
    };
    let found = lines.iter_mut().find(is_in);
    let line = match found {
        Some(line) => line,
        None => {
            lines.push(Line { origin: center, along, spans: Vec::new() });
            let last = lines.len() - 1;
            &mut lines[last]
        }
    };
    let middle = (center - line.origin).dot(line.along);
    let (from, to) = (middle - width / 2.0, middle + width / 2.0);
    line.spans.push(Span { pane, from, to, low: hole.low, high: hole.high });
}

/// Joins panes above each other; of those with a solid stretch between, the largest is the window.
pub(super) fn columns(mut spans: Vec<Span>) -> Vec<Span> {
    spans.sort_by(|a, b| a.from.total_cmp(&b.from).then(a.low.total_cmp(&b.low)).then(a.pane.cmp(&b.pane)));
    let mut columns: Vec<Span> = Vec::new();
    for span in spans {
        match columns.last_mut().filter(|last| span.from < last.to - OVERLAP) {
            Some(last) if span.low < last.high + TRANSOM && last.low < span.high + TRANSOM => {
                last.to = last.to.max(span.to);
                (last.low, last.high) = (last.low.min(span.low), last.high.max(span.high));
            }
            Some(last) if span.area() > last.area() => *last = span,
            Some(_) => {}
            None => columns.push(span),
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    fn span(pane: u64, along: (f64, f64), height: (f64, f64)) -> Span {
        Span { pane, from: along.0, to: along.1, low: height.0, high: height.1 }
    }

    #[test]
    fn panes_above_each_other_are_one_window() {
        let panes = vec![
            span(2, (0.0, 1.0), (1.05, 2.5)),
            span(1, (0.0, 1.0), (0.0, 1.0)),
            span(3, (1.05, 2.0), (0.0, 2.5)),
        ];
        let joined = [span(1, (0.0, 1.0), (0.0, 2.5)), span(3, (1.05, 2.0), (0.0, 2.5))];
        assert_eq!(columns(panes), joined);
    }

    #[test]
    fn of_panes_with_a_parapet_between_the_larger_is_the_window() {
        let panes = vec![span(1, (0.0, 1.0), (0.0, 0.4)), span(2, (0.0, 1.0), (0.9, 2.4))];
        assert_eq!(columns(panes.clone()), [panes[1].clone()]);
    }
}
