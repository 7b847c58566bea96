//! Building and placements to findings; never changes a layout.
//!
//! The audit has its own geometry (`convex`): of the layout's it uses only the statement of what is solid
//! ([`crate::layout::solids`]). Where people walk, `walk` tells both. What each code means stands at the
//! head of the file that judges it, the figures and where they come from in `configs/audit.yaml`. Whether the plan leaves
//! another choice the audit asks ([`Question`]): searching for places is the stage after it ([`crate::solve`]).

mod access;
mod bare;
mod bedside;
mod bounds;
mod clearances;
mod collision;
mod containment;
mod convex;
mod crooked;
mod doors;
mod facing;
mod finding;
mod groups;
mod halves;
mod mean;
mod measure;
mod near;
mod possible;
mod programme;
mod reach;
mod relations;
mod score;
mod screens;
mod sparse;
mod subject;
mod summary;
mod support;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;
mod thresholds;
mod tight;
mod verdict;
mod wet_room;
mod windows;
mod zone;

pub use finding::{Code, Finding, Grade, Severity};
pub use measure::Measure;
pub use possible::{Ask, Held, Question};
pub use score::Score;
pub use summary::{AuditSummary, GradeCounts, ScoreSum};
pub use verdict::{DoorRate, Verdict};

pub(crate) use convex::{clip_segment, middle, penetration};
pub(crate) use doors::zones as door_zones;
pub(crate) use thresholds::ROUNDING;

use crate::catalog::{Catalog, ClassIndex};
use crate::layout::Furnished;
use crate::plan::Level;

use near::MOST_NEAR;
use subject::Subject;
use zone::{NearPair, Zone};

/// Judges one furnished room. `ask` answers what the empty room could hold; [`crate::solve::judge_room`] brings its own.
///
/// `room` is an index into `level.rooms`, `furnished` what the layout made of it.
///
/// # Panics
/// If `furnished` names a class, parent, wall or opening that does not exist.
pub fn judge(level: &Level, room: usize, furnished: &Furnished, catalog: &Catalog, ask: Ask<'_>) -> Verdict {
    let subject = &Subject::new(level, room, furnished, catalog);
    let mut findings = Vec::new();
    // The physical faults that one body can have by itself.
    containment::judge(subject, &mut findings);
    support::judge(subject, &mut findings);
    // What two bodies, or a body and a zone that people need, do to each other.
    let zones = all_zones(subject);
    let (collisions, hits) = near_pairs(subject, &zones);
    collision::judge(subject, &collisions, &mut findings);
    doors::judge(subject, &hits, &mut findings);
    clearances::judge(subject, &zones, &hits, &mut findings);
    let comfort = tight::takings(subject, &zones, &hits);
    tight::judge(subject, &comfort, ask, &mut findings);
    windows::judge(subject, &hits, &mut findings);
    screens::judge(subject, &hits, &mut findings);
    wet_room::judge(subject, &hits, &mut findings);
    // Ways through the room.
    let floor = reach::floor(subject);
    let rates = floor.map_or_else(Vec::new, |floor| {
        bedside::judge(subject, &floor, ask, &mut findings);
        reach::judge(subject, &floor, &zones, &mut findings)
    });
    access::judge(subject, &zones, &mut findings);
    // How things stand to each other and in the whole.
    facing::judge(subject, &mut findings);
    crooked::judge(subject, &mut findings);
    halves::judge(subject, ask, &mut findings);
    // What should be there and is not.
    programme::judge(subject, ask, &mut findings);
    sparse::judge(subject, ask, &mut findings);
    bare::judge(subject, &mut findings);
    findings.sort_by(|a, b| a.code.cmp(&b.code).then_with(|| a.objects.cmp(&b.objects)));
    // Two pieces in each other's way are one finding.
    findings.dedup_by(|a, b| a.code == b.code && !a.objects.is_empty() && a.objects == b.objects);
    finding::bound(&mut findings);
    let score = score::score(
        subject,
        &score::Measured { zones: &zones, hits: &hits, comfort: &comfort, rates: &rates },
    );
    let door = |(door, rate): (usize, f64)| DoorRate {
        door: format!("door:{}", subject.level.openings[door].id),
        rate,
    };
    Verdict { findings, score, walkable: rates.into_iter().map(door).collect() }
}

/// Each required class that is missing and stands on the floor by itself, first in its list, with whatever else the room
/// cannot do without.
pub(crate) fn missing_pieces(
    level: &Level,
    room: usize,
    furnished: &Furnished,
    catalog: &Catalog,
) -> Vec<Vec<ClassIndex>> {
    programme::missing_pieces(&Subject::new(level, room, furnished, catalog))
}

/// Whatever people need to be free.
fn all_zones(subject: &Subject<'_>) -> Vec<Zone> {
    let mut zones = doors::zones((subject.level, subject.room), subject.rules().doors);
    zones.extend(clearances::zones(subject));
    zones.extend(windows::zones(subject));
    zones.extend(wet_room::zones(subject));
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
        let bodies = near.touching(&zone.bounds()).take(MOST_NEAR);
        hits.extend(bodies.filter(|&body| !is_covering(body)).map(|body| (body, number)));
    }
    // By body, whatever order they were found in.
    hits.sort_unstable();
    (collisions, hits.into_iter().map(|(body, zone)| (&zones[zone], body)).collect())
}
