//! The lines of the symbols that recipes name, inside the outlines of their pieces.

use core::f64::consts::TAU;

use crate::catalog::{Class, ModelSource, Size};
use crate::geometry::{Bounds, Point, direction};
use crate::recipes::Symbol;

/// A line of a symbol in metres in its object's frame: x to the right, y to the front, from its middle.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stroke {
    /// Corners in order.
    pub(crate) points: Vec<Point>,
    /// Whether the last corner is joined to the first.
    pub(crate) is_closed: bool,
}

/// The lines inside the outline of an object of a class.
pub(crate) fn symbol_strokes(class: &Class, size: Size) -> Vec<Stroke> {
    let half = Point::new(size.width, size.depth) / 2.0;
    symbol_of(class).map_or_else(Vec::new, |symbol| strokes(symbol, half))
}

/// The symbol of a class, if it has one.
pub(crate) fn symbol_of(class: &Class) -> Option<Symbol> {
    match &class.model {
        ModelSource::Recipe { recipe, parameters } => recipe.symbol_of(parameters),
        ModelSource::File { .. } => None,
    }
}

/// `half` is half the width and half the depth.
pub(crate) fn strokes(symbol: Symbol, half: Point) -> Vec<Stroke> {
    match symbol {
        Symbol::Bed => bed(half),
        Symbol::Sofa => sofa(half),
        Symbol::Chair => chair(half),
        Symbol::Toilet => toilet(half),
        Symbol::Basin => basin(half),
        Symbol::Tub => tub(half),
        Symbol::Shower => [diagonals(half), vec![ring(Point::ZERO, Point::splat(0.05))]].concat(),
        Symbol::Cooker => cooker(half),
        Symbol::Fridge => diagonals(half),
        Symbol::Diagonal => diagonals(half)[..1].to_vec(),
        Symbol::Drum => vec![ring(Point::ZERO, Point::splat(half.min_element() * 0.7))],
        Symbol::Wardrobe => wardrobe(half),
        Symbol::Doors => vec![across(half, half.y - 0.03_f64.min(half.y * 0.3))],
        Symbol::Shelf => vec![across(half, -half.y + 0.04_f64.min(half.y * 0.4))],
        Symbol::Plant => plant(half),
        Symbol::Lamp => cross(half.min_element() * 0.7),
        Symbol::Frame => vec![rectangle(-half * 0.85, half * 0.85)],
        Symbol::Rug => {
            let inner = half - Point::splat(half.min_element().min(0.08));
            vec![rectangle(-inner, inner)]
        }
        Symbol::Net => vec![line(Point::new(0.0, -half.y), Point::new(0.0, half.y))],
    }
}

fn bed(half: Point) -> Vec<Stroke> {
    const TWO_SLEEP: f64 = 1.3;
    const PILLOW_DEPTH: f64 = 0.4;
    let count = if half.x * 2.0 >= TWO_SLEEP { 2 } else { 1 };
    let depth = PILLOW_DEPTH.min(half.y * 0.4);
    let share = half.x * 2.0 / f64::from(count);
    let (low, high) = (-half.y + 0.06, -half.y + 0.06 + depth);
    let pillow = |index: u32| {
        let left = share * f64::from(index) - half.x;
        rectangle(Point::new(left + share * 0.1, low), Point::new(left + share * 0.9, high))
    };
    let fold = high + 0.12;
    let corner = [Point::new(half.x, fold + half.x * 0.5), Point::new(half.x * 0.5, fold)];
    (0..count).map(pillow).chain([across(half, fold), line(corner[0], corner[1])]).collect()
}

fn sofa(half: Point) -> Vec<Stroke> {
    const ARM: f64 = 0.16;
    const CUSHION: f64 = 0.7;
    let arm = ARM.min(half.x * 0.25);
    let back = -half.y + 0.2_f64.min(half.y * 0.5);
    let inner = half.x - arm;
    let count = (inner * 2.0 / CUSHION).round().max(1.0) as u32;
    let share = inner * 2.0 / f64::from(count);
    let seam = |index: u32| {
        let x = share * f64::from(index) - inner;
        line(Point::new(x, back), Point::new(x, half.y))
    };
    let back_line = line(Point::new(-inner, back), Point::new(inner, back));
    std::iter::once(back_line).chain((0..=count).map(seam)).collect()
}

fn chair(half: Point) -> Vec<Stroke> {
    let back = -half.y + 0.08_f64.min(half.y * 0.4);
    vec![across(half, back)]
}

fn toilet(half: Point) -> Vec<Stroke> {
    const CISTERN: f64 = 0.18;
    const BOWL: f64 = 0.18;
    let end = -half.y + CISTERN.min(half.y * 0.6);
    let width = BOWL.min(half.x * 0.9);
    let reach = 0.25_f64.min((half.y - end) / 2.0) * 0.95;
    let cistern = rectangle(Point::new(-width, -half.y), Point::new(width, end));
    vec![cistern, ring(Point::new(0.0, end + reach), Point::new(width * 0.95, reach))]
}

fn basin(half: Point) -> Vec<Stroke> {
    const LARGEST: f64 = 0.24;
    let radii = Point::new(LARGEST.min(half.x * 0.75), (half.y * 0.6).min(LARGEST));
    let tap = Point::new(0.0, -half.y * 0.8);
    vec![ring(Point::new(0.0, half.y * 0.12), radii), line(tap, Point::new(0.0, -half.y * 0.3))]
}

fn tub(half: Point) -> Vec<Stroke> {
    const RIM: f64 = 0.07;
    let inner = (half - Point::splat(RIM)).max(half * 0.5);
    let is_long = half.x >= half.y;
    let end = if is_long { Point::new(inner.x - 0.2, 0.0) } else { Point::new(0.0, inner.y - 0.2) };
    vec![rounded(inner, inner.min_element() * 0.6), ring(end.max(Point::ZERO), Point::splat(0.03))]
}

fn cooker(half: Point) -> Vec<Stroke> {
    const RINGS: [(f64, f64, f64); 4] =
        [(-0.48, -0.42, 0.3), (0.48, -0.42, 0.38), (-0.48, 0.42, 0.38), (0.48, 0.42, 0.3)];
    let least = half.min_element();
    RINGS.iter().map(|&(x, y, r)| ring(half * Point::new(x, y), Point::splat(least * r))).collect()
}

fn wardrobe(half: Point) -> Vec<Stroke> {
    const HANGER: f64 = 0.18;
    let count = (half.x * 2.0 / HANGER).floor().max(1.0) as u32;
    let share = half.x * 2.0 / f64::from(count);
    let hanger = |index: u32| {
        let x = share * (f64::from(index) + 0.5) - half.x;
        let lean = Point::new(0.03, half.y * 0.7);
        line(Point::new(x, 0.0) - lean, Point::new(x, 0.0) + lean)
    };
    std::iter::once(across(half, 0.0)).chain((0..count).map(hanger)).collect()
}

fn plant(half: Point) -> Vec<Stroke> {
    const LEAVES: u32 = 7;
    let leaf = |index: u32| {
        let tip = direction(f64::from(index) * TAU / f64::from(LEAVES)) * half * 0.95;
        line(tip * 0.15, tip)
    };
    (0..LEAVES).map(leaf).collect()
}

fn cross(reach: f64) -> Vec<Stroke> {
    let [x, y] = [Point::new(reach, 0.0), Point::new(0.0, reach)];
    vec![line(-x, x), line(-y, y)]
}

fn diagonals(half: Point) -> Vec<Stroke> {
    let other = Point::new(half.x, -half.y);
    vec![line(-half, half), line(-other, other)]
}

/// A line from side to side at a depth.
fn across(half: Point, y: f64) -> Stroke {
    line(Point::new(-half.x, y), Point::new(half.x, y))
}

fn line(from: Point, to: Point) -> Stroke {
    Stroke { points: vec![from, to], is_closed: false }
}

fn rectangle(low: Point, high: Point) -> Stroke {
    Stroke { points: Bounds::new(low, high).corners().into(), is_closed: true }
}

/// An ellipse as a polygon that is round on paper.
fn ring(center: Point, radii: Point) -> Stroke {
    const CORNERS: u32 = 20;
    let corner = |index: u32| center + direction(f64::from(index) * TAU / f64::from(CORNERS)) * radii;
    Stroke { points: (0..CORNERS).map(corner).collect(), is_closed: true }
}

/// A rectangle around the middle with round corners.
fn rounded(half: Point, radius: f64) -> Stroke {
    const STEPS: u32 = 4;
    let corner = |index: u32| {
        let angle = f64::from(index % (STEPS + 1)) / f64::from(STEPS);
        let quarter = index / (STEPS + 1);
        let sign = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][quarter as usize];
        let center = (half - Point::splat(radius)) * Point::new(sign.0, sign.1);
        center + direction((f64::from(quarter) + angle) * TAU / 4.0) * radius
    };
    Stroke { points: (0..4 * (STEPS + 1)).map(corner).collect(), is_closed: true }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipes::find;

    #[test]
    fn lines_stay_inside_outlines_of_usual_and_of_odd_sizes() {
        for half in [Point::new(1.0, 0.45), Point::new(0.2, 0.2), Point::new(0.45, 1.0), Point::new(0.8, 1.0)]
        {
            for symbol in Symbol::ALL {
                let points = strokes(symbol, half).into_iter().flat_map(|stroke| stroke.points);
                for point in points {
                    let excess = (point.abs() - half).max_element();
                    assert!(excess < 1e-9, "{symbol:?} of {half}: {point}");
                }
            }
        }
    }

    #[test]
    fn a_wide_bed_has_two_pillows_and_a_narrow_one_has_one() {
        let pillows = |width: f64| {
            let drawn = bed(Point::new(width / 2.0, 1.0));
            drawn.iter().filter(|stroke| stroke.is_closed).count()
        };
        assert_eq!((pillows(1.6), pillows(0.9)), (2, 1));
    }

    #[test]
    fn a_kitchen_unit_with_a_sink_has_a_basin() {
        let size = Size { width: 0.6, depth: 0.6, height: 0.9 };
        let mut unit = Class::plain("sink_unit", vec![size], find("worktop").unwrap());
        assert_eq!(symbol_of(&unit), None);
        let parameters = vec![("sink".into(), 1.0)];
        unit.model = ModelSource::Recipe { recipe: find("worktop").unwrap(), parameters };
        assert_eq!(symbol_of(&unit), Some(Symbol::Basin));
    }
}
