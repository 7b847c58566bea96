//! Resolves shapes, and checks that every part lies inside the box in every size.

use crate::catalog::file::{ClassEntry, ExtentFault, PartEntry, ShapeEntry, read_extent};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Chain;
use crate::catalog::{Extent, PrismRule, Shape, Size};

/// Metres by which a part may stand out of its box through rounding.
const TOLERANCE: f64 = 1e-9;
/// The axes of a box and what its two ends are called.
pub(super) const AXES: [(&str, &str, &str); 3] =
    [("width", "left", "right"), ("depth", "front", "back"), ("height", "underside", "top")];

/// The shape of a class, checked against its sizes.
pub(super) fn resolve_shape(chain: &Chain<'_, ClassEntry>, sizes: &[Size], report: &mut Report<'_>) -> Shape {
    let Some(found) = chain.find("shape", |entry| entry.shape.as_ref()) else { return Shape::Box };
    match found.value {
        ShapeEntry::Word(word) if word == "box" => Shape::Box,
        ShapeEntry::Word(word) if word == "disc" => Shape::Disc,
        ShapeEntry::Word(word) => {
            report.unknown(&found.spot, "shape", word, ["box", "disc"]);
            Shape::Box
        }
        ShapeEntry::Parts(parts) => {
            if parts.is_empty() {
                report.error_with_hint(
                    &found.spot,
                    "the list of parts is empty",
                    "write `shape: box` for a whole box",
                );
            }
            let prisms = parts.iter().enumerate();
            let prisms =
                prisms.filter_map(|(i, part)| resolve_part(part, &found.spot.index(i), sizes, report));
            Shape::Prisms(prisms.collect())
        }
    }
}

fn resolve_part(part: &PartEntry, spot: &Spot, sizes: &[Size], report: &mut Report<'_>) -> Option<PrismRule> {
    let mut low = [Extent { share: 0.0, offset: 0.0 }; 3];
    let mut high = low;
    let mut is_good = true;
    for axis in 0..AXES.len() {
        let mut read = |text, key| {
            let spot = spot.key(key).index(axis);
            read_extent(text).map_err(|fault| report_extent(fault, &spot, report)).ok()
        };
        let (Some(from), Some(to)) = (read(&part.from[axis], "from"), read(&part.to[axis], "to")) else {
            is_good = false;
            continue;
        };
        (low[axis], high[axis]) = (from, to);
        is_good &= sizes.iter().all(|size| check_axis([from, to], axis, length(*size, axis), spot, report));
    }
    is_good.then_some(PrismRule { is_disc: part.disc, low, high })
}

fn length(size: Size, axis: usize) -> f64 {
    [size.width, size.depth, size.height][axis]
}

fn report_extent(fault: ExtentFault, spot: &Spot, report: &mut Report<'_>) {
    let message = match fault {
        ExtentFault::Form => "this is no coordinate inside a box",
        ExtentFault::Share => "the share is not between 0 % and 100 %",
        ExtentFault::NotFinite => "the coordinate is not a finite number",
    };
    report.error_with_hint(
        spot,
        message,
        "write metres from the low end, or a share: \"50%\", \"100%-0.03\"",
    );
}

/// Whether a part lies in a box along one axis; reports the first size for which it does not.
fn check_axis(ends: [Extent; 2], axis: usize, length: f64, spot: &Spot, report: &mut Report<'_>) -> bool {
    let (name, low_name, high_name) = AXES[axis];
    let at = |extent: Extent| extent.share * length + extent.offset;
    let [low, high] = ends.map(at);
    let shown = |metres: f64| (metres * 1e6).round() / 1e6;
    for (key, end, value) in [("from", low_name, low), ("to", high_name, high)] {
        if value < -TOLERANCE || value > length + TOLERANCE {
            let message =
                format!("the part's {end} is at {} m, outside the {name} of {length} m", shown(value));
            report.error_with_hint(
                &spot.key(key).index(axis),
                message,
                "parts lie inside the box in every size",
            );
            return false;
        }
    }
    if high - low <= TOLERANCE {
        let message = format!(
            "the part's {high_name} at {} m is not beyond its {low_name} at {} m",
            shown(high),
            shown(low)
        );
        report.error_with_hint(
            &spot.key("to").index(axis),
            message,
            "`from` is left, front, underside; `to` is right, back, top",
        );
        return false;
    }
    true
}
