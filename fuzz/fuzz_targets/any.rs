//! Any target of `targets.rs`: `ROOMWRIGHT_FUZZ_TARGET=ifc cargo +nightly fuzz run any fuzz/corpus/ifc`
#![no_main]
#[path = "../targets.rs"]
mod targets;

use std::sync::LazyLock;

static NAME: LazyLock<String> = LazyLock::new(|| {
    std::env::var("ROOMWRIGHT_FUZZ_TARGET").expect("the variable names a target of fuzz/targets.rs")
});

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    targets::run(&NAME, data);
});
