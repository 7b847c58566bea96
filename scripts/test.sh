#!/usr/bin/env bash
# Runs every check of the project: bash scripts/test.sh
#
# Sets up what it needs by itself (.venv/ from scripts/requirements.txt, python/roomwright/khronos/node_modules/ from the lock
# file), asks nothing, stops at the first step that fails, and ends with "N passed, N failed".
# Needs Rust 1.90 or newer, Python 3.11 or newer with venv, Node 20 or newer; with Chromium or Google Chrome on the path it
# opens the demo in browser clients, too. ROOMWRIGHT_PYTHON names another Python, ROOMWRIGHT_CHROMIUM another browser.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/set_up.sh
top=$PWD
# Without a cache, every checked file is made by this run.
export ROOMWRIGHT_CACHE=none
work=$(mktemp -d)
log=$work/log
passed=0
failed=0
step_name=
started=$SECONDS

finish() {
  local status=$?
  kill $(jobs -p) 2>/dev/null || true
  if [ "$status" -ne 0 ] && [ -n "$step_name" ]; then
    [ "$failed" -gt 0 ] || failed=1
    printf '\nFAILED: %s\n' "$step_name"
  fi
  printf '\n%s passed, %s failed\n' "$passed" "$failed"
  rm -rf "$work"
}
trap finish EXIT

# step TITLE COMMAND...: runs a command under a heading.
step() {
  step_name=$1
  shift
  printf '\n== %s (after %s s)\n' "$step_name" "$((SECONDS - started))"
  "$@"
}

# Adds up the "N passed ... N failed" lines of cargo and pytest.
count_tests() {
  passed=$((passed + $(sum_of passed)))
  failed=$((failed + $(sum_of failed)))
}

# One program, not grep before it: grep fails where nothing matches, and pytest names failures only when it has some.
sum_of() {
  awk -v word=" $1" '{
    while (match($0, "[0-9]+" word)) {
      sum += substr($0, RSTART, RLENGTH)
      $0 = substr($0, RSTART + RLENGTH)
    }
  } END { print sum + 0 }' "$log"
}

# Runs a command that counts its tests.
counted() {
  local status=0
  "$@" 2>&1 | tee "$log" || status=$?
  count_tests
  return "$status"
}

# A check that is no test runner's counts as one.
checked() {
  "$@"
  passed=$((passed + 1))
}

# beside NAME COMMAND...: starts a command beside the steps that follow; `joined NAME` waits for it and prints what it wrote.
beside() {
  local name=$1
  shift
  "$@" >"$work/$name.log" 2>&1 &
  echo $! >"$work/$name.process"
}

# joined NAME: the end of what runs beside; tests that it ran are counted.
joined() {
  local status=0
  wait "$(cat "$work/$1.process")" || status=$?
  counted cat "$work/$1.log"
  return "$status"
}

# release_tests OPTION...: what users run, optimised. The library's own tests, and those of single stages, run in debug; to build
# them once more takes as long as all the others.
release_tests() {
  cargo test --release --locked --test command_line --test end_to_end --test faults --test kill --test properties "$@"
}

# The demo as the README bakes it: no arguments, from the project's folder, in debug and in release.
bake_twice() {
  local out
  for out in debug release; do
    "$top/target/$out/roomwright" bake --out "$work/$out" --quiet
  done
  # The release build wrote what the debug build wrote, byte for byte.
  diff -r "$work/debug" "$work/release"
  (cd "$work/debug" && find . -type f -print0 | sort -z | xargs -0 sha256sum | sha256sum)
}

# Walls of random polygons reach into no room. `bake` ends with 1 where a door fits on no wall.
polygons() {
  .venv/bin/python scripts/random_polygons.py "$work/polygons" --count 400
  "$top/target/release/roomwright" bake "$work/polygons" --out "$work/polygons-out" --textures none --quiet || [ $? -eq 1 ]
  .venv/bin/python scripts/validate.py "$work/polygons-out" --no-khronos
}

# The demo as 3D Tiles: its tree, its boxes, and the pieces that it names.
tiles() {
  "$top/target/release/roomwright" tiles --out "$work/tiles" --quiet
  .venv/bin/python scripts/validate.py "$work/tiles"
}

# The package with its program, of the release build above; pytest installs it in a clean environment.
wheel() {
  .venv/bin/python -m maturin build --release --quiet --out "$work/wheel"
}

# The documentation as a site, where there is mdBook to build it; pytest checks the links of its pages without.
site() {
  local status=0
  .venv/bin/python scripts/build_site.py --out "$work/site" || status=$?
  if [ "$status" -eq 3 ]; then
    echo "skipped: the site of the documentation needs it"
    return
  fi
  [ "$status" -eq 0 ]
  passed=$((passed + 1))
}

# The newcomer's walk from a plan to kept edits, in Blender where there is one; its page and edits file are looked at.
walk() {
  ROOMWRIGHT_PROGRAM=$top/target/release/roomwright bash docs/walkthrough.sh "$work/walkthrough"
  grep -q '<svg' "$work/walkthrough/changes.html"
  grep -q 'remove: true' "$work/walkthrough/plans/house.edits.yaml"
}

# The demo in browser clients, where there is a browser to open them in.
viewers() {
  if ! node tests/viewers/find_chromium.mjs; then
    echo "skipped: three.js, Babylon.js, model-viewer and CesiumJS need it"
    return
  fi
  set_up_viewers
  counted env ROOMWRIGHT_BAKED="$work/release" node --test --test-reporter=./tests/viewers/report.mjs tests/viewers/viewers.test.mjs
}

# Tiles in the clients that stream cities, where there is a browser to open them in; ROOMWRIGHT_LONG=1 picks 240 pixels and flies to
# a tower, too.
tile_viewers() {
  if ! node tests/viewers/find_chromium.mjs; then
    echo "skipped: CesiumJS and 3d-tiles-renderer need it"
    return
  fi
  set_up_viewers
  counted env ROOMWRIGHT_PROGRAM="$top/target/release/roomwright" \
    node --test --test-reporter=./tests/viewers/report.mjs tests/tiles/*.test.mjs
}

# The page of `roomwright view`: its modules without a browser, and, where there is one, the page itself.
viewer() {
  if node tests/viewers/find_chromium.mjs; then set_up_viewer; fi
  counted env ROOMWRIGHT_PROGRAM="$top/target/release/roomwright" \
    node --test --test-reporter=./tests/viewers/report.mjs tests/viewer/*.test.mjs
}

# The program as WebAssembly writes the bytes of the native one. Without the target, it is said and left out.
web() {
  local status=0
  cargo fmt --manifest-path web/Cargo.toml --check
  CARGO_TARGET_DIR=$top/target/web bash web/build.sh "$work/try" || status=$?
  if [ "$status" -eq 3 ]; then return; fi
  [ "$status" -eq 0 ]
  counted env ROOMWRIGHT_PROGRAM="$top/target/release/roomwright" ROOMWRIGHT_WASM="$work/try/roomwright.wasm" \
    ROOMWRIGHT_TRY="$work/try" node --test --test-reporter=./tests/viewers/report.mjs web/compare.test.mjs tests/viewer/try.test.mjs
}

step "Python environment" set_up_python
step "Khronos validator" set_up_validator
step "mypy" checked .venv/bin/python -m mypy
step "cargo fmt" checked cargo fmt --check
# Debug and release builds have folders of their own, and much of each is work for one processor.
beside release release_tests --no-run
step "cargo clippy" checked cargo clippy --all-targets --locked -- -D warnings
step "cargo check (without the command)" checked cargo check --no-default-features --lib --locked
step "cargo doc" checked env RUSTDOCFLAGS="-D warnings" cargo doc --no-deps --locked --document-private-items
# With checks of arithmetic and debug assertions, and slow: single stages, damaged inputs, and the pinned levels.
# Whole commands, random rooms and kills run below, as users run them; `cargo test` alone runs everything with these checks.
step "cargo test (debug)" counted cargo test --locked --lib --test plan --test scene
step "cargo test (debug, pinned levels)" counted cargo test --locked --test command_line pinned
step "cargo test (documentation)" counted cargo test --locked --doc
step "cargo build (release)" joined release
step "cargo test (release)" counted release_tests
step "cargo build" cargo build --locked
# One processor reads hostile inputs; so it is with most of the steps from here to pytest.
beside hostile cargo test --locked --test fuzz
step "The demo, twice" checked bake_twice
step "validate.py" checked .venv/bin/python scripts/validate.py "$work/release"
step "validate.py (random polygons)" checked polygons
step "validate.py (tiles)" checked tiles
step "convert.py" checked .venv/bin/python scripts/convert.py "$work/release" --out "$work/usd"
step "validate.py (USD)" checked .venv/bin/python scripts/validate.py "$work/usd"
step "docs/walkthrough.sh" checked walk
step "The site of the documentation" site
step "Viewers" viewers
step "Tiles in viewers" tile_viewers
step "The page of roomwright view" viewer
step "WebAssembly" web
step "Wheel" checked wheel
step "cargo test (debug, hostile inputs)" joined hostile
step "pytest" counted env ROOMWRIGHT_WHEEL="$(echo "$work"/wheel/*.whl)" ROOMWRIGHT_BAKED="$work/release" ROOMWRIGHT_PROGRAM="$top/target/release/roomwright" .venv/bin/python -m pytest -q -rs -n 2 --dist loadfile tests/scripts
step_name=
