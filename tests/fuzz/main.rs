//! Feeds hostile inputs to the targets of `fuzz/`: cases of its corpus and of the readers' tests, and many more made from them.
//!
//! The same inputs are made on each run. `ROOMWRIGHT_FUZZ_COUNT=n` makes n for each target, `ROOMWRIGHT_FUZZ_SEED=n`
//! others, `ROOMWRIGHT_FUZZ_TARGET=name` those of one target. `scripts/fuzz.sh` does all this for hours with the release
//! build, where `ROOMWRIGHT_FUZZ_SECONDS=n` bounds the time of each. A failing input is kept in `target/fuzz-finds/`;
//! once the fault is mended, it becomes a case of the corpus.
#![allow(clippy::unwrap_used, clippy::print_stdout, unreachable_pub)]

mod mutate;
mod resources;
#[path = "../../fuzz/targets.rs"]
mod targets;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use mutate::Draw;
use resources::Watch;
use targets::{PLAN_IMPORT, TARGETS, Target};

/// Inputs of a target, unless `ROOMWRIGHT_FUZZ_COUNT` says otherwise.
const COUNT: u64 = 300;
/// For each case of [`PLAN_IMPORT`], as its cases are of many readers.
const COUNT_OF_IMPORT: u64 = 50;
/// Of one of the slow targets.
const SLOW_COUNT: u64 = 40;
/// Targets whose every input reads the whole catalogue, or plans, writes and reads again some buildings.
const SLOW: [&str; 5] = ["catalog", "cityjson", "geojson", "model", "osm"];
/// The most bytes of an input.
const LARGEST: usize = 1 << 20;
/// The most megabytes that reading an input may take.
const MEGABYTES: u64 = 200;

fn number(variable: &str) -> Option<u64> {
    std::env::var(variable).ok().map(|text| text.parse().unwrap())
}

/// The cases of a target, by name.
fn corpus(target: &str) -> Vec<(String, Vec<u8>)> {
    let project = Path::new(env!("CARGO_MANIFEST_DIR"));
    let name = |path: &PathBuf| path.file_name().unwrap().to_str().unwrap().to_owned();
    if target == PLAN_IMPORT {
        let cases =
            entries(&project.join("tests/cases/plan_import")).into_iter().filter(|path| path.is_dir());
        return cases.map(|case| (name(&case), bundle(&case, ""))).collect();
    }
    let cases = entries(&project.join("fuzz/corpus").join(target));
    cases.iter().map(|path| (name(path), fs::read(path).unwrap())).collect()
}

/// Whatever lies in a folder, by name.
fn entries(folder: &Path) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

/// The files of a folder as one input; `below` is the path of the folder in it.
fn bundle(folder: &Path, below: &str) -> Vec<u8> {
    let mut bundle = Vec::new();
    for path in entries(folder) {
        let name = format!("{below}{}", path.file_name().unwrap().to_str().unwrap());
        if path.is_dir() {
            bundle.extend(self::bundle(&path, &format!("{name}/")));
        } else {
            let file = fs::read(&path).unwrap();
            bundle.extend([format!("=== {name}\n").as_bytes(), &file, b"\n"].concat());
        }
    }
    bundle
}

/// How many inputs are made of the cases of a target.
fn count(target: &str, cases: usize) -> u64 {
    number("ROOMWRIGHT_FUZZ_COUNT").unwrap_or(match target {
        PLAN_IMPORT => COUNT_OF_IMPORT * cases as u64,
        _ if SLOW.contains(&target) => SLOW_COUNT,
        _ => COUNT,
    })
}

/// One test for all: memory is that of the process.
#[test]
fn hostile_inputs_are_read_or_rejected_within_bounds() {
    resources::check_that_memory_is_seen();
    targets::warm_up();
    let only = std::env::var("ROOMWRIGHT_FUZZ_TARGET").ok();
    let mut fails = Vec::new();
    for (name, target) in
        TARGETS.iter().copied().filter(|(name, _)| only.as_deref().is_none_or(|only| only == *name))
    {
        let cases = corpus(name);
        assert!(!cases.is_empty(), "{name} has no cases");
        let mut watch = Watch::default();
        for (case, bytes) in &cases {
            fails.extend(failure(target, bytes, &mut watch).map(|why| format!("{name}/{case}: {why}")));
        }
        assert!(watch.read_count() > 0, "no case of {name} can be read");
        let count = count(name, cases.len());
        let first = number("ROOMWRIGHT_FUZZ_SEED").unwrap_or(0).wrapping_mul(1 << 32);
        for seed in first..first + count {
            let mut draw = Draw::new(name, seed);
            let bytes = mutate::made(&cases, &mut draw, LARGEST);
            // Nothing catches a stack that overflows: what is read is kept before.
            let path = kept(name, seed, &bytes);
            let Some(why) = failure(target, &bytes, &mut watch) else {
                fs::remove_file(path).unwrap();
                continue;
            };
            fails.push(format!("{name}, seed {seed}, kept as {}: {why}", path.display()));
        }
        println!("{name}: {} cases, {count} inputs made of them; {watch}", cases.len());
    }
    assert!(fails.is_empty(), "{} inputs fail:\n{}", fails.len(), fails.join("\n"));
}

/// Why an input fails.
fn failure(target: Target, bytes: &[u8], watch: &mut Watch) -> Option<String> {
    let mut ran = Ok(false);
    let spent = watch.spent(|| ran = catch_unwind(AssertUnwindSafe(|| target(bytes))));
    watch.count(matches!(ran, Ok(true)));
    if let Err(panic) = ran {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        return Some(format!("panics: {}", text.or(panic.downcast_ref().copied()).unwrap_or("?")));
    }
    if spent.megabytes > MEGABYTES {
        return Some(format!("takes {} MB, {MEGABYTES} are the most", spent.megabytes));
    }
    let most = number("ROOMWRIGHT_FUZZ_SECONDS")?;
    let seconds = spent.time.as_secs_f64();
    (seconds > most as f64).then(|| format!("takes {seconds:.2} s, {most} s are the most"))
}

fn kept(target: &str, seed: u64, bytes: &[u8]) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/fuzz-finds").join(target);
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join(seed.to_string());
    fs::write(&path, bytes).unwrap();
    path
}
