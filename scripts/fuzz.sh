#!/usr/bin/env bash
# Feeds the readers with damaged inputs, for hours: bash scripts/fuzz.sh [COUNT] [SEED]
#
# COUNT inputs of each target of fuzz/ (default 100000), made from the corpus by SEED (default: the day's), each at most 1 s and 200 MB.
# One that fails is kept in target/fuzz-finds/: once it is mended, it becomes a case of fuzz/corpus/. `cargo test` does the same
# with 300. Where nightly Rust and cargo-fuzz are, `ROOMWRIGHT_FUZZ_TARGET=TARGET cargo +nightly fuzz run any fuzz/corpus/TARGET`
# looks for new paths by itself.
set -euo pipefail
cd "$(dirname "$0")/.."
export ROOMWRIGHT_FUZZ_COUNT=${1:-100000} ROOMWRIGHT_FUZZ_SEED=${2:-$(date +%Y%m%d)} ROOMWRIGHT_FUZZ_SECONDS=1
exec cargo test --release --locked --test fuzz -- --nocapture
