//! Rules that hold for every room of any shape, size, type and style, and for every model of furniture.
//!
//! The same rooms are drawn on each run; `PROPTEST_RNG_SEED=n` draws others, `PROPTEST_CASES=n` more.
#![allow(clippy::unwrap_used, clippy::print_stdout, clippy::disallowed_methods, unreachable_pub)]

mod models;
mod rooms;

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

use roomwright::internals::audit::{AuditSummary, Code, Finding, Verdict};
use roomwright::internals::catalog::{Catalog, load_catalog};
use roomwright::internals::layout::{FurnishOptions, Furnished, Parent, furnish};
use roomwright::internals::plan::Level;
use roomwright::internals::solve::judge_room;

use rooms::sketches;

/// Rooms per property: enough that each room type is drawn several times in each kind of shape.
const CASES: u32 = 400;

static CATALOG: LazyLock<Catalog> = LazyLock::new(|| load_catalog(&[]).unwrap().value);

fn config() -> ProptestConfig {
    let mut config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = CASES;
    }
    if std::env::var_os("PROPTEST_RNG_SEED").is_none() {
        config.rng_seed = RngSeed::Fixed(1);
    }
    config
}

/// Asks a property of every room that can be built from a sketch.
fn for_every_room(property: impl Fn(&Level, &Furnished, &Verdict) -> Result<(), TestCaseError>) {
    let catalog = &*CATALOG;
    let mut runner = TestRunner::new(config());
    let answer = runner.run(&sketches(), |sketch| {
        let Some(level) = sketch.level(catalog) else { return Ok(()) };
        let options = FurnishOptions::new(sketch.seed, "random");
        let furnished = furnish(level.room(0), catalog, &options);
        let verdict = judge_room(level.room(0), &furnished, catalog);
        property(&level, &furnished, &verdict)
    });
    if let Err(error) = answer {
        panic!("{error}");
    }
}

fn without(codes: impl Fn(Code) -> bool, findings: &[Finding]) -> Result<(), TestCaseError> {
    let found: Vec<&Finding> = findings.iter().filter(|finding| codes(finding.code)).collect();
    prop_assert!(found.is_empty(), "{found:?}");
    Ok(())
}

#[test]
fn bodies_obey_the_physical_rules() {
    for_every_room(|_, _, verdict| without(Code::is_physical, &verdict.findings));
}

#[test]
fn doors_can_be_opened_and_walked_through() {
    for_every_room(|_, _, verdict| without(|code| code == Code::DoorBlocked, &verdict.findings));
}

#[test]
fn the_same_room_is_furnished_and_judged_the_same_again() {
    for_every_room(|level, furnished, verdict| {
        let options = FurnishOptions::new(0, "random");
        prop_assert_eq!(
            furnish(level.room(0), &CATALOG, &options),
            furnish(level.room(0), &CATALOG, &options)
        );
        prop_assert_eq!(&judge_room(level.room(0), furnished, &CATALOG), verdict);
        Ok(())
    });
}

#[test]
fn parents_come_first_and_ids_are_unique() {
    for_every_room(|level, furnished, _| {
        let mut ids = BTreeSet::new();
        for (index, placement) in furnished.placements.iter().enumerate() {
            prop_assert!(ids.insert((placement.class, placement.number)));
            prop_assert!((0.0..=level.rooms[0].height).contains(&placement.elevation));
            if let Parent::Object(parent) = placement.parent {
                prop_assert!(parent < index);
            }
        }
        Ok(())
    });
}

/// No pass or fail: what the verdicts over random rooms are, for the record.
#[test]
fn verdicts_are_counted() {
    let counts = RefCell::new((AuditSummary::default(), BTreeMap::<String, u32>::new()));
    for_every_room(|level, _, verdict| {
        let (summary, kinds) = &mut *counts.borrow_mut();
        summary.add_room(verdict);
        for finding in &verdict.findings {
            let classes = finding.objects.iter().map(|id| id.split(['.', ':']).next().unwrap());
            let classes = classes.collect::<Vec<_>>().join(" ");
            let kind = format!("{} {} in {}", finding.code.name(), classes, level.rooms[0].room_type);
            *kinds.entry(kind).or_insert(0) += 1;
        }
        Ok(())
    });
    let (summary, kinds) = counts.into_inner();
    println!("random rooms: {summary:?}\n{kinds:#?}");
    assert!(summary.room_count() > 100, "most sketches are rooms");
}
