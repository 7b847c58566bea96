//! Draws a class from above in letters: its box, its sides and the clearances before them.

use super::lines::rounded;
use crate::catalog::{Class, Shape, Side};
use crate::geometry::{Bounds, Point};

/// Letters of the widest plan, and lines of the highest.
const COLUMNS: f64 = 48.0;
const ROWS: f64 = 18.0;

/// Metres of the smallest letter: small classes are drawn enlarged, but not huge.
const SMALLEST_CELL: f64 = 0.05;

/// How much higher than wide a letter is.
const ASPECT: f64 = 2.0;

/// Letters for the object, what must stay free before it, and what should.
const BODY: char = '#';
const MINIMUM: char = ':';
const GOOD: char = '.';

/// The lines of the plan, the front below, with a scale; the first size of the class.
pub(super) fn plan(class: &Class) -> Vec<String> {
    let half = Point::new(class.sizes[0].width, class.sizes[0].depth) / 2.0;
    let body = Bounds::new(-half, half);
    let areas = |is_good: bool| -> Vec<Bounds> {
        let depth =
            |one: &crate::catalog::Clearance| if is_good { one.good.max(one.minimum) } else { one.minimum };
        class.clearances.iter().map(|one| before(one.side, half, depth(one), one.margin)).collect()
    };
    let (needed, good) = (areas(false), areas(true));
    let whole = needed.iter().chain(&good).fold(body, |whole, &area| whole.union(area));
    let (low, size) = (whole.low, whole.size());
    let cell = (size.x / COLUMNS).max(size.y / ASPECT / ROWS).max(SMALLEST_CELL);
    let count = |metres: f64| (metres / cell).round().max(1.0) as usize;
    let (columns, rows) = (count(size.x), count(size.y / ASPECT));
    let letter = |column: usize, row: usize| {
        let share =
            Point::new((column as f64 + 0.5) / columns as f64, 1.0 - (row as f64 + 0.5) / rows as f64);
        let at = low + size * share;
        let is_in = |areas: &[Bounds]| areas.iter().any(|area| area.contains(at));
        match () {
            () if is_body(class, at, half) => BODY,
            () if is_in(&needed) => MINIMUM,
            () if is_in(&good) => GOOD,
            () => ' ',
        }
    };
    let line = |row: usize| (0..columns).map(|column| letter(column, row)).collect::<String>();
    let middle = (-low.x / cell).round() as usize;
    let word = |word: &str| format!("{}{word}", " ".repeat(middle.saturating_sub(word.len() / 2)));
    let mut lines = vec![word("back")];
    lines.extend((0..rows).map(line));
    lines.push(word("front"));
    lines.push(format!("one letter is {} m wide", rounded(cell)));
    lines.iter().map(|line| line.trim_end().to_owned()).collect()
}

fn is_body(class: &Class, at: Point, half: Point) -> bool {
    match class.shape {
        Shape::Disc => (at / half).length() <= 1.0,
        Shape::Box | Shape::Prisms(_) => at.abs().cmple(half).all(),
    }
}

/// The rectangle before a side in the frame of the class, so deep and so much wider than the side.
fn before(side: Side, half: Point, depth: f64, margin: f64) -> Bounds {
    let wide = Point::new(half.x + margin, half.y);
    let high = Point::new(half.x, half.y + margin);
    let (low, high) = match side {
        Side::Front => (Point::new(-wide.x, -half.y - depth), Point::new(wide.x, -half.y)),
        Side::Back => (Point::new(-wide.x, half.y), Point::new(wide.x, half.y + depth)),
        Side::Left => (Point::new(-half.x - depth, -high.y), Point::new(-half.x, high.y)),
        Side::Right => (Point::new(half.x, -high.y), Point::new(half.x + depth, high.y)),
        Side::Above | Side::Below => (-half, half),
    };
    Bounds::new(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Clearance, Size};
    use crate::recipes::find;

    #[test]
    fn the_front_is_below_with_what_it_needs() {
        let size = Size { width: 1.6, depth: 0.8, height: 0.74 };
        let desk = Class {
            clearances: vec![Clearance::SEAT],
            ..Class::plain("desk", vec![size], find("desk").unwrap())
        };
        let plan = plan(&desk);
        let rows_of = |letter: char| plan.iter().filter(|line| line.contains(letter)).count();
        assert!(plan[0].trim() == "back" && plan[plan.len() - 2].trim() == "front");
        let letters: Vec<char> =
            plan[1..plan.len() - 2].iter().filter_map(|line| line.chars().next()).collect();
        assert!(
            letters.is_sorted_by_key(|letter| [BODY, MINIMUM, GOOD].iter().position(|one| one == letter))
        );
        assert!(rows_of(BODY) > 4 && rows_of(MINIMUM) > 4 && rows_of(GOOD) >= 1, "{plan:#?}");
        let bare = Class { clearances: Vec::new(), ..desk };
        let lines = self::plan(&bare);
        assert!(lines[..lines.len() - 1].iter().all(|line| !line.contains([MINIMUM, GOOD])));
    }

    #[test]
    fn left_is_where_the_person_before_the_front_sees_it() {
        let size = Size { width: 1.0, depth: 1.0, height: 0.5 };
        let side = Clearance { side: Side::Left, good: 0.75, ..Clearance::SEAT };
        let bed = Class { clearances: vec![side], ..Class::plain("bed", vec![size], find("bed").unwrap()) };
        assert!(plan(&bed)[3].starts_with(MINIMUM) && plan(&bed)[3].ends_with(BODY));
    }
}
