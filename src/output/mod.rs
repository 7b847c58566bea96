//! The formats that levels are written in: a table, as the readers of plans are.
//!
//! To add a format:
//! 1. Write it: a file here with a type that implements [`Output`] and a `pub(crate)` constant of [`OutputFormat`], and its `mod` line
//!    below. `example.rs` is a complete format to copy, with its test; should yours be OBJ, move it. What takes several files
//!    becomes a folder beside `gltf/`, with a row in ARCHITECTURE.md.
//! 2. Add its line to `table.rs`; `--format`, `--help`, the manifest and its checks follow, and the test that formats write the same
//!    files every time. (`roomwright formats` lists formats of plans alone.)
//! 3. Name its files in the list "Files of other formats" of `docs/output.md`. Files that are not read back end here: `audit`, `diff`,
//!    `edits capture` and the scripts take `.glb` and `.gltf`, and `scripts/validate.py` checks what the manifest says of others.
//! 4. Test it in its file, as `example.rs` is: `cargo test --lib output::`, then `cargo test --test command_line all_formats`,
//!    `cargo fmt` and `cargo clippy --all-targets -- -D warnings`. Until a version is released, CHANGELOG.md stays as it is.
//!
//! What follows spares reading the scene and the batch; `GLB` in `gltf/output.rs` is the other format to read.
//!
//! A format is given a [`crate::scene::Scene`] (`scene/node.rs`, which lists all that is in it):
//! - a tree of nodes in metres, Y up, each placed relative to its parent; mesh and material indices are valid. Node names
//!   are unique in the level. They hold ids of the plan, and so any letter: spaces, quotes, `#` and `/`, too.
//!   `docs/output.md`, "Nodes", says where the origin of a node is and where its front faces. A format with the axes of
//!   plans takes [`crate::scene::plan_point`] (of a `DVec3`: nodes and corners are `f32`, so
//!   `plan_point(point.as_dvec3()).as_vec3()`), `plan_angle` and `plan_rotation` to go back to x east, y north, z up: take what
//!   programs for the format expect. The floor of every level lies at 0, and levels do not stack; `elevation` in the extras of the
//!   root says how high it is;
//! - the extras of a node ([`crate::contract::Extras`]), which say what it is; outlines, hinges and sides in them are in the axes
//!   of plans already. `docs/output.md`, "Extras", describes them;
//! - meshes (`mesh/model.rs`, all of whose fields `example.rs` uses): every corner has a unit normal, every triangle three indices.
//!   Unless users ask for `--parts separate`, the walls of a room are one mesh (`walls@<room>`), and so are its other coverings;
//! - materials (`mesh/material.rs` names the factors): colours are linear, [`crate::catalog::srgb_encoded`] makes each of them, an `f64` from 0 to 1, sRGB. What lamps
//!   give off is `emissive`; of clear glass the share `transmission` (`f32`, 0 to 1) of the light passes, so that without that effect its opacity is
//!   `base_color[3] * (1 - transmission)`.
//!   With [`OutputFormat::shows_textures`], materials may show their colour by an image alone (`<palette>.swatches`);
//!   without it each material has its own base colour, whatever textures the user asks for. Materials of users' models keep
//!   the names they came with, so that several may have one name, or hold spaces: a format that refers to materials by name
//!   makes it unique, as `example.rs` does;
//! - its path, `<building>/<level>` in ASCII letters, digits and `. _ - % ~`: files may refer to each other by it;
//! - the options of the user ([`LevelOptions`]). What they say of rooms and shapes has been done; a format that cannot do
//!   what else they ask for (lights, variants, shared files) leaves it out.
//!
//! A level beyond the limits of a format is refused: `TooLarge { message: String, hint: &'static str }`, how large it is and may be,
//! and what helps.
//!
//! `batch` relies on this: the same scene at the same path gives the same files, whatever other levels were written before it and
//! by however many threads.

mod appearance;
#[cfg(test)]
mod example;
mod folders;
mod format;
mod options;
mod shared_images;
mod table;

pub(crate) use folders::{INDEX_FOLDER, INDEX_NAME, SHARED_GEOMETRY, SHARED_TEXTURES};
pub(crate) use format::{
    IndexFiles, IndexedLevel, LevelToWrite, Output, OutputFormat, SceneLook, SharedFile, TooLarge,
    WrittenLevel,
};
pub use options::{Format, IndexOptions, LevelOptions, TextureOptions};
pub(crate) use shared_images::shared_images;
pub(crate) use table::{OUTPUTS, has_index, is_read_back, output_format};
