#!/usr/bin/env bash
# Bakes known floors with many seeds and judges them: bash scripts/judge_known_floors.sh [SEEDS [PLANS...]]
#
# Prints the tables of judge.py over all seeds: measures, agreement with the audit, variety, worst rooms. SEEDS is 20 and
# PLANS is ../shared/data/floorplans unless they are named. Drawings of the first of PLANS are compared with, too.
# ROOMWRIGHT_PROGRAM names the program (target/release/roomwright), ROOMWRIGHT_PYTHON the Python (.venv/bin/python), WORST
# the number of rooms listed for each measure (10), PAGE a page whose figures are renewed (docs/judge.md, with WORST=0). Bakes take 60 MB a seed, in a folder that goes when the script ends.
set -euo pipefail
cd "$(dirname "$0")/.."
seeds=${1:-20}
[ $# -eq 0 ] || shift
plans=("$@")
[ ${#plans[@]} -gt 0 ] || plans=(../shared/data/floorplans)
program=${ROOMWRIGHT_PROGRAM:-target/release/roomwright}
python=${ROOMWRIGHT_PYTHON:-.venv/bin/python}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for plan in "${plans[@]}"; do
  [ -e "$plan" ] || { echo "skipped: $plan is not there"; exit 0; }
done
for seed in $(seq 1 "$seeds"); do
  # Faulty plans are reported, and the others baked.
  "$program" bake "${plans[@]}" --out "$work/$seed" --seed "$seed" --textures none --quiet >"$work/log" 2>&1 || true
done
files=$(find "$work" -name '*.glb' | wc -l)
[ "$files" -gt 0 ] || { echo "nothing was baked:"; cat "$work/log"; exit 2; }
echo "$files files of $seeds seeds: ${plans[*]}"
"$python" scripts/judge.py "$work" --drawn "${plans[0]}" --compare --variety --worst "${WORST:-10}" ${PAGE:+--page "$PAGE"}
