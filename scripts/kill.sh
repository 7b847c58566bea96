#!/usr/bin/env bash
# Kills bakes, merges and drawings 200 times at random moments, for every night: bash scripts/kill.sh [KILLS] [SEED]
#
# After each kill every file in place is whole; run again to the end, all bytes are those of an undisturbed bake. The seed is
# the day's unless one is given; the test says it. `cargo test` does the same 20 times.
set -euo pipefail
cd "$(dirname "$0")/.."
export ROOMWRIGHT_KILLS=${1:-200} ROOMWRIGHT_KILL_SEED=${2:-$(date +%Y%m%d)}
exec cargo test --release --locked --test kill -- --nocapture
