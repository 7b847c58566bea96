//! Judges a furnished room: from level and placements come findings and a score. Never changes a layout.
//!
//! - The table of all findings is `checks/mod.rs`, which says how to add one. Each check is a file beside it; the limits, with
//!   their sources, are in `configs/audit.yaml`.
//! - The audit has its own geometry (`convex`), so that a mistake of the layout's does not hide itself. The two share the
//!   statement of what is solid ([`crate::layout::solids`]) and of where people walk ([`crate::walk`]).
//! - A finding counts only if another arrangement could avoid it. The audit asks for that ([`Question`]); the stage after it,
//!   [`crate::solve`], searches and answers.

mod checks;
mod convex;
mod evidence;
mod fault;
mod finding;
mod groups;
mod mean;
mod near;
mod possible;
mod quantity;
mod relations;
mod rounding;
mod score;
mod severity;
mod subject;
mod summary;
mod taking;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;
mod upright_box;
mod verdict;
mod zone;

pub use checks::Code;
pub use fault::Element;
pub use finding::{Finding, Grade};
pub use possible::{Ask, Held, Question};
pub use quantity::{Quantity, Unit};
pub use score::Score;
pub use severity::Severity;
pub use summary::{AuditSummary, GradeCounts};
pub use verdict::{DoorRate, Verdict};

pub(crate) use checks::door_zones;
pub(crate) use convex::{clip_segment, middle, penetration};
pub(crate) use rounding::ROUNDING;

use crate::catalog::{Catalog, ClassIndex};
use crate::layout::{Furnished, opening_id};
use crate::plan::Level;
use crate::walk::EmptyFloors;

use checks::Rates;
use evidence::Evidence;
use near::MOST_NEAR;
use subject::Subject;
use taking::comfort_takings;
use zone::{NearPair, Zone};

/// Judges one furnished room. `empty_floors` are those of the room, for all of its arrangements; `ask` answers what the empty
/// room could hold. [`crate::solve::judge_room`] brings its own.
///
/// `furnished` is what the layout made of the room.
///
/// # Panics
/// If `furnished` names a class, parent, wall or opening that does not exist.
pub(crate) fn judge(
    empty_floors: &EmptyFloors<'_>,
    furnished: &Furnished,
    catalog: &Catalog,
    ask: Ask<'_>,
) -> Verdict {
    let subject = &Subject::new(empty_floors, furnished, catalog);
    // What people need free, and what is near it.
    let zones = all_zones(subject);
    let (collisions, hits) = near_pairs(subject, &zones);
    let comfort = comfort_takings(subject, &zones, &hits);
    let floor = checks::floor(subject);
    // What the checks find, by code; how good the room is beside that.
    let (collisions, hits, floor) = (&collisions, &hits, floor.as_deref());
    let evidence = Evidence { subject, zones: &zones, hits, collisions, comfort: &comfort, floor, ask };
    let findings = finding::findings(checks::faults(&evidence));
    let rates = floor.map_or_else(Vec::new, |floor| checks::rates(subject, floor));
    let score = score::score(&evidence, &rates);
    Verdict { findings, score, walkable: door_rates(subject.at.level, rates) }
}

fn door_rates(level: &Level, rates: Rates) -> Vec<DoorRate> {
    let door =
        |(door, rate): (usize, f64)| DoorRate { door: opening_id(&level.openings[door]).to_string(), rate };
    rates.into_iter().map(door).collect()
}

/// Each required class that is missing and stands on the floor by itself, first in its list, with whatever else the room
/// cannot do without.
pub(crate) fn missing_pieces(
    empty_floors: &EmptyFloors<'_>,
    furnished: &Furnished,
    catalog: &Catalog,
) -> Vec<Vec<ClassIndex>> {
    checks::missing_pieces(&Subject::new(empty_floors, furnished, catalog))
}

/// All regions that people need to be free.
fn all_zones(subject: &Subject<'_>) -> Vec<Zone> {
    let mut zones = checks::door_zones(subject.at, subject.rules().doors);
    zones.extend(taking::zones(subject));
    zones.extend(checks::light_zones(subject));
    zones.extend(checks::bowl_zones(subject));
    zones
}

/// Pairs of bodies whose boxes touch, and pairs of a zone and a body whose boxes touch. A rug is floor for all but other
/// rugs.
fn near_pairs<'z>(subject: &Subject<'_>, zones: &'z [Zone]) -> (Vec<(usize, usize)>, Vec<NearPair<'z>>) {
    let boxes = || subject.bodies.iter().map(|body| body.bounds);
    let near = subject.near_boxes();
    let is_covering = |body: usize| subject.bodies[body].placement.is_covering();
    let mut collisions = near.touching_pairs(boxes());
    collisions.retain(|&(a, b)| is_covering(a) == is_covering(b));
    let mut hits: Vec<(usize, usize)> = Vec::new();
    for (number, zone) in zones.iter().enumerate() {
        // Bounded, so that a heap of copies takes time in proportion to its size.
        let bodies = near.touching(&zone.bounds()).take(MOST_NEAR);
        hits.extend(bodies.filter(|&body| !is_covering(body)).map(|body| (body, number)));
    }
    // By body, whatever order they were found in.
    hits.sort_unstable();
    (collisions, hits.into_iter().map(|(body, zone)| (&zones[zone], body)).collect())
}
