//! Resolves the places and clearances at the sides of a class.

use super::number::{DISTANCE, LENGTH, Quantity, SIGNED_DISTANCE, check_count};
use crate::catalog::file::{ClassEntry, ClearanceEntry, SideEntry};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Chain;
use crate::catalog::{Clearance, Side, SideOffer, Size};

/// Metres up to which a clearance reaches where the file says nothing: a person with raised head.
const CLEARANCE_HEIGHT: f64 = 2.0;

/// The offers of all sides, each from the nearest definition that names the side.
pub(super) fn resolve_sides(
    chain: &Chain<'_, ClassEntry>,
    sizes: &[Size],
    report: &mut Report<'_>,
) -> [SideOffer; 6] {
    Side::ALL.map(|side| {
        let found = chain.find("sides", |entry| entry.sides.as_ref()?.get(side));
        found.map_or(SideOffer::NONE, |found| {
            let spot = found.spot.key(side.name());
            resolve_side(found.value, side, &spot, sizes, report)
        })
    })
}

fn resolve_side(
    entry: &SideEntry,
    side: Side,
    spot: &Spot,
    sizes: &[Size],
    report: &mut Report<'_>,
) -> SideOffer {
    let places = entry.places.map(|places| check_count("places", places, &spot.key("places"), report));
    if places.is_none() {
        let message = format!("side \"{}\" does not say how many places it offers", side.name());
        report.error_with_hint(spot, message, "write `places:`");
    }
    let mut metres = |name: &'static str, value: Option<f64>| {
        value.map(|value| Quantity::metres(name, LENGTH).check(value, &spot.key(name), report))
    };
    let (space, surface) = (metres("space", entry.space), metres("surface", entry.surface));
    let margin = entry.margin.map_or([0.0; 4], |margin| {
        margin.all().map(|edge| Quantity::metres("margin", DISTANCE).check(edge, &spot.key("margin"), report))
    });
    let offer = SideOffer { places: places.unwrap_or(0), space, surface, margin };
    if side == Side::Above {
        check_surface(entry, &offer, spot, sizes, report);
    } else {
        for (key, is_written) in [("surface", entry.surface.is_some()), ("margin", entry.margin.is_some())] {
            if is_written {
                let message = format!("side \"{}\" has no {key}", side.name());
                report.error_with_hint(&spot.key(key), message, "only the side above carries");
            }
        }
    }
    offer
}

/// The surface lies in the box and something of it carries, in every size.
fn check_surface(entry: &SideEntry, offer: &SideOffer, spot: &Spot, sizes: &[Size], report: &mut Report<'_>) {
    let &SideOffer { surface, margin: [left, front, right, back], .. } = offer;
    for size in sizes {
        if let Some(surface) = surface.filter(|&surface| surface > size.height) {
            let message = format!("the surface at {surface} m lies above the top at {} m", size.height);
            report.error_with_hint(&spot.key("surface"), message, "leave `surface` out if the top carries");
        }
        if entry.margin.is_some() && (left + right >= size.width || front + back >= size.depth) {
            let message = format!("the margins leave nothing of a top of {} × {} m", size.width, size.depth);
            report.error_with_hint(&spot.key("margin"), message, "one number, or [left, front, right, back]");
        }
    }
}

/// The clearances, one for each side that is named: those that are needed, and those of which one is enough.
pub(super) fn resolve_clearances(
    chain: &Chain<'_, ClassEntry>,
    report: &mut Report<'_>,
) -> (Vec<Clearance>, Vec<Clearance>) {
    let (mut clearances, mut either) = (Vec::new(), Vec::new());
    let Some(found) = chain.find("clearances", |entry| entry.clearances.as_ref()) else {
        return (clearances, either);
    };
    for (place, entry) in found.value.items() {
        let spot = found.spot.item(place);
        if entry.either && (entry.side.items().count() < 2 || !either.is_empty()) {
            let message = "`either` is for one line that names several sides";
            report.error_with_hint(&spot.key("either"), message.to_owned(), "as in `side: [left, right]`");
        }
        for (place, &side) in entry.side.items() {
            if matches!(side, Side::Above | Side::Below) {
                let message = format!("there is no clearance {} a class", side.name());
                let hint = "possible here: front, back, left, right";
                report.error_with_hint(&spot.key("side").item(place), message, hint);
            }
            let those = if entry.either { &mut either } else { &mut clearances };
            those.push(resolve_clearance(entry, side, &spot, report));
        }
    }
    (clearances, either)
}

fn resolve_clearance(entry: &ClearanceEntry, side: Side, spot: &Spot, report: &mut Report<'_>) -> Clearance {
    let mut metres = |name, range, value| Quantity::metres(name, range).check(value, &spot.key(name), report);
    let minimum = metres("minimum", DISTANCE, entry.minimum);
    let good = metres("good", DISTANCE, entry.good.unwrap_or(entry.minimum));
    let margin = metres("margin", SIGNED_DISTANCE, entry.margin.unwrap_or(0.0));
    let height = metres("height", LENGTH, entry.height.unwrap_or(CLEARANCE_HEIGHT));
    if good < minimum {
        let message = format!("the good clearance of {good} m is below the minimum of {minimum} m");
        report.error_with_hint(
            &spot.key("good"),
            message,
            "`good` is what there should be, `minimum` what there must be",
        );
    }
    Clearance { side, minimum, good, margin, height, allows_children: entry.children }
}
