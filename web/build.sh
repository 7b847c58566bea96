#!/usr/bin/env bash
# Builds the page that furnishes plans in a visitor's browser, as a folder for any static host: bash web/build.sh [DIR]
#
# Needs the target wasm32-unknown-unknown (`rustup target add wasm32-unknown-unknown`). Where it cannot be had, the standard library
# is built from its sources, if ROOMWRIGHT_RUST_LIBRARY names the folder `library/` of the sources of this very compiler (packages
# such as Debian's `rust-src` hold it). Ends with 3 where neither is there.
set -euo pipefail
cd "$(dirname "$0")"
out=$(mkdir -p "${1:-../target/try}" && cd "${1:-../target/try}" && pwd)
target=wasm32-unknown-unknown
build=(cargo build --release --locked --target "$target")
if [ -d "$(rustc --print sysroot)/lib/rustlib/$target" ]; then
  "${build[@]}"
elif [ -n "${ROOMWRIGHT_RUST_LIBRARY:-}" ]; then
  # The stable compiler builds its own library when it is told to behave as a nightly one, and where the sources are.
  RUSTC_BOOTSTRAP=1 __CARGO_TESTS_ONLY_SRC_ROOT=$ROOMWRIGHT_RUST_LIBRARY "${build[@]}" -Zbuild-std=std,panic_abort
else
  echo "skipped: the target $target is not installed, and ROOMWRIGHT_RUST_LIBRARY is not set" >&2
  exit 3
fi
cp "${CARGO_TARGET_DIR:-target}/$target/release/roomwright_web.wasm" "$out/roomwright.wasm"
cp -R ../docs/try/. "$out/"
mkdir -p "$out/viewer" && cp -R ../viewer/. "$out/viewer/"
cp ../configs/plans/house.yaml "$out/house.yaml"
echo "$out: $(wc -c < "$out/roomwright.wasm") bytes of WebAssembly, $(gzip -9 -c "$out/roomwright.wasm" | wc -c) compressed"
