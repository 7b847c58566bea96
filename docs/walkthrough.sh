#!/usr/bin/env bash
# From a plan to a furnished house, changed by hand, and furnished again with the changes kept:
#
#     bash docs/walkthrough.sh [FOLDER]
#
# Works on a copy of the demo's house in FOLDER (walkthrough/ if none is named) and writes nothing elsewhere, but for what
# it sets up where it is missing: the program (cargo build --release), .venv/ and python/roomwright/khronos/node_modules/, as scripts/test.sh
# does. Needs what that needs: Rust, Python 3.11 or newer; Node for the Khronos validator, else that is left out.
#
# Blender 4.2 or newer is taken from ROOMWRIGHT_BLENDER (a `blender`, or a Python with Blender's module bpy), else from the
# PATH, else from .venv-render (scripts/README.md). Where there is none, a Python script makes the same changes in the file.
# ROOMWRIGHT_PROGRAM names another roomwright than the one in target/.
#
# Each command is shown before it runs. The first that fails ends the walk. Exit 0: all went well.
set -euo pipefail

# Paths count from where you are, and the script goes to the project's folder.
from_here() {
  case $1 in
    /* | '') printf '%s' "$1" ;;
    *) printf '%s' "$PWD/$1" ;;
  esac
}

case ${1:-} in
  -h | --help) sed -n '2,/^set /s/^# \{0,1\}//p' "$0"; exit ;;
  -*) echo "unknown option $1; see --help" >&2; exit 2 ;;
  '') folder=walkthrough ;;
  *) folder=$(from_here "$1") ;;
esac
program=$(from_here "${ROOMWRIGHT_PROGRAM:-}")
blender=${ROOMWRIGHT_BLENDER:-}
# A name without a slash is one of the PATH.
case $blender in */*) blender=$(from_here "$blender") ;; esac
cd "$(dirname "$0")/.."
source scripts/set_up.sh

# ------------------------------------------------------------------------------------- how this script talks

number=0

fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

# step TITLE: a heading; what the step is for comes on standard input.
step() {
  number=$((number + 1))
  printf '\n\n%s. %s\n\n' "$number" "$1"
  sed 's/^/   /'
  echo
}

# show COMMAND...: a command as you would type it, then what it says.
show() {
  printf '   $ %s\n' "$*"
  "$@"
}

finish() {
  local status=$? where="before step 1"
  [ "$number" -eq 0 ] || where="in step $number"
  [ "$status" -eq 0 ] || printf '\nStopped %s: exit code %s.\n' "$where" "$status" >&2
}
trap finish EXIT

# ------------------------------------------------------------------------------------------- what it needs

find_program() {
  # The one that was built last.
  [ -n "$program" ] || program=$(ls -t target/release/roomwright target/debug/roomwright 2>/dev/null | head -n 1) || true
  [ -n "$program" ] || program=$(type -P roomwright) || build_program
  "$program" edits --help >/dev/null || fail "$program is no roomwright that knows edits: cargo build --release makes one"
}

build_program() {
  command -v cargo >/dev/null || fail "there is no cargo to build the program with; https://rustup.rs has it"
  echo "Building the program first, which takes some minutes."
  cargo build --release --locked
  program=target/release/roomwright
}

find_python() {
  [ -x .venv/bin/python ] || echo "Setting up Python's environment, .venv/."
  set_up_python >/dev/null
}

find_validator() {
  khronos=()
  if command -v npm >/dev/null; then
    set_up_validator >/dev/null
  else
    echo "Node is not installed: the Khronos validator is left out."
    khronos=(--no-khronos)
  fi
}

# Sets `blender`, and `blender_kind` to `blender` or to `python` for one with bpy; without any, `no_blender` says why.
find_blender() {
  local candidate candidates=("$blender") named=$blender
  [ -n "$named" ] || candidates=(blender .venv-render/bin/python python3)
  blender=
  no_blender="no blender in the PATH, no Python with bpy; ROOMWRIGHT_BLENDER may name one"
  for candidate in "${candidates[@]}"; do
    read -r blender_kind major minor < <(kind_of "$candidate") || continue
    if [ "$((major * 100 + minor))" -ge 402 ]; then
      blender=$candidate
      return
    fi
    no_blender="$candidate is version $major.$minor, and 4.2 or newer is needed; ROOMWRIGHT_BLENDER may name another"
  done
  # A named one must be used.
  [ -z "$named" ] || fail "ROOMWRIGHT_BLENDER: $named is neither Blender nor Python with bpy, 4.2 or newer"
}

# `blender 5 0` or `python 5 0`: what a command is, and the version of Blender in it.
kind_of() {
  local version
  version=$("$1" --version 2>/dev/null </dev/null | sed -n 's/^Blender \([0-9]*\)\.\([0-9]*\).*/blender \1 \2/p') || true
  [ -n "$version" ] || version=$("$1" -c 'import bpy; print("python", *bpy.app.version[:2])' 2>/dev/null | grep '^python ') || true
  [ -z "$version" ] || printf '%s\n' "$version"
}

# The names under which steps call what was found, so that `show` shows what you would type.
roomwright() { "$program" "$@"; }
python() { .venv/bin/python "$@"; }
in_blender() {
  if [ "$blender_kind" = python ]; then
    show "$blender" "$@"
  else
    show "$blender" --background --factory-startup --python-exit-code 1 --python "$1" -- "${@:2}"
  fi
}

# Takes away what an earlier walk wrote, and nothing else.
prepare_folder() {
  if [ -e "$folder" ] && [ ! -f "$folder/.walkthrough" ] && [ -n "$(ls -A "$folder" 2>/dev/null || echo file)" ]; then
    fail "$folder is there already and not from a walk like this; name another folder"
  fi
  mkdir -p "$folder"
  touch "$folder/.walkthrough"
  (cd "$folder" && rm -rf plans before after usd house.blend house.blend1 edited.glb changes.html)
  mkdir "$folder/plans"
  cp configs/plans/house.yaml "$folder/plans/"
}

find_program
find_python
find_validator
find_blender
prepare_folder

cat <<TEXT
A walk through Roomwright, in $folder.

   roomwright is $program
   python is     .venv/bin/python
   Blender is    ${blender:-not here: $no_blender}
TEXT

changes="The armchair of the study moves away from the desk, the dining table turns, a cabinet is deleted with all that stands
on it, and a second house plant is added at the other side of the window."

# -------------------------------------------------------------------------------------------------- the walk

step "Bake: furnish every room of the plan" <<TEXT
The plan, $folder/plans/house.yaml, describes rooms, doors and windows. The bake writes a glTF
file for each level, with the shell, the furniture and the lamps.
TEXT
show roomwright bake "$folder/plans/house.yaml" --out "$folder/before"

step "Validate what was baked" <<TEXT
validate.py checks the structure, meshes and hashes of the files, and measures collisions on the meshes, independently
of the program that wrote them.
TEXT
show python scripts/validate.py "$folder/before" "${khronos[@]}"

step "Convert to USD" <<TEXT
convert.py writes the same levels as USD, with one library of models that all levels share.
TEXT
show python scripts/convert.py "$folder/before" --out "$folder/usd"

step "Validate the USD files" <<TEXT
validate.py runs the validators that come with USD.
TEXT
show python scripts/validate.py "$folder/usd"

if [ -n "$blender" ]; then
  step "Open the house in Blender" <<TEXT
Blender imports both levels, one on the other, in collections by room. Here it runs without a window; in Blender's
window, Roomwright's extension does the same: File > Import > Roomwright bake.
TEXT
  in_blender scripts/blender_import.py "$folder/before" --save "$folder/house.blend" --no-ceilings

  step "Change it" <<TEXT
$changes
docs/examples/edit_in_blender.py names the keys for these changes in Blender's window.
TEXT
  in_blender docs/examples/edit_in_blender.py "$folder/house.blend"

  step "Export the changed level" <<TEXT
Blender writes a glTF file that Roomwright reads, as File > Export > Roomwright floor does. Copies get ids of their own.
TEXT
  in_blender scripts/blender_export.py "$folder/house.blend" --level house/ground --out "$folder/edited.glb"
else
  step "Change it, without Blender" <<TEXT
Blender is not here: $no_blender.
Import, change and export in Blender are left out; a script makes the same changes in the glTF file.
$changes
TEXT
  show python docs/examples/edit_without_blender.py "$folder/before/house/ground.glb" "$folder/edited.glb"
fi

step "Judge the changed level" <<TEXT
The audit judges the rooms as they are now. Exit code 1 means that a room fails; the walk goes on all the same.
TEXT
show roomwright audit "$folder/edited.glb" || [ $? -eq 1 ]

step "Capture your changes" <<TEXT
The command compares the level as it was baked with the changed one, and writes the differences into an edits file beside
the plan, which every later bake reads.
TEXT
show roomwright edits capture "$folder/before/house/ground.glb" "$folder/edited.glb" --edits "$folder/plans/house.edits.yaml"
echo
show cat "$folder/plans/house.edits.yaml"

step "Bake again" <<TEXT
The same plan, now with its edits file: the rooms are arranged as before, and your changes are applied.
TEXT
show roomwright bake "$folder/plans/house.yaml" --out "$folder/after"

step "Compare your level with the bake" <<TEXT
The level that you changed and the one just baked must have the same objects at the same places, to a tenth of a millimetre.
(Blender writes meshes and materials in its own way, which is reported and is no difference in the rooms.)
TEXT
show roomwright diff "$folder/edited.glb" "$folder/after/house/ground.glb" \
  --fail-on moved,turned,added,removed,class,variant

step "Compare both bakes" <<TEXT
The differences of the first bake and the second, as in a pull request, also as a page with pictures.
TEXT
show roomwright diff "$folder/before" "$folder/after" --html "$folder/changes.html"
for kind in moved turned added removed; do
  if roomwright diff "$folder/before" "$folder/after" --quiet --fail-on "$kind" >/dev/null; then
    fail "nothing is $kind in the second bake, and something should be"
  fi
done

cat <<TEXT


All steps went well. Look at

   $folder/changes.html               the changed rooms before and after; any browser opens it
   $folder/plans/house.edits.yaml     what you changed; edit or delete lines and bake again
   $folder/after/house/ground.glb     the furnished level: Blender (File > Import > glTF) or any viewer
   $folder/usd/house/building.usda    the house as USD: usdview, Blender, Omniverse
TEXT
[ -z "$blender" ] || echo "   $folder/house.blend                the house as you changed it, to go on with"
cat <<TEXT

Next: another plan (docs/guide.md), other edits (docs/edits.md), a check of pull requests
(docs/continuous-integration.md).
TEXT
