//! Feeds hostile inputs to the targets of `fuzz/`: cases of its corpus, and many more made from them.
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
use targets::{TARGETS, Target};

/// Inputs of a target, unless `ROOMWRIGHT_FUZZ_COUNT` says otherwise.
const COUNT: u64 = 300;
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
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(target);
    let entries = fs::read_dir(&folder).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let name = |path: &PathBuf| path.file_name().unwrap().to_str().unwrap().to_owned();
    paths.iter().map(|path| (name(path), fs::read(path).unwrap())).collect()
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
        let count =
            number("ROOMWRIGHT_FUZZ_COUNT").unwrap_or(if SLOW.contains(&name) { SLOW_COUNT } else { COUNT });
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
