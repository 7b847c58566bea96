//! The formats that levels are written in: a table, as the readers of plans are.
//!
//! A new format takes one folder beside `gltf/` with a type that implements [`Output`], its `mod` line in `lib.rs`, and one line in
//! `table.rs`; `--format`, `--help`, the manifest and its checks follow from that line. `example.rs` is a complete format to copy, in
//! ninety lines. A format is given:
//! - a [`crate::scene::Scene`] (`scene/node.rs`): a tree of nodes in metres, Y up, each placed relative to its parent; node names are
//!   unique in the level, mesh and material indices are valid, colours are linear ([`crate::catalog::srgb_encoded`] makes them sRGB).
//!   The extras of a node say what it is; `docs/output.md` describes them;
//! - with [`OutputFormat::shows_textures`], materials may show their colour by an image alone (`<palette>.swatches`); without it
//!   each material has its own base colour, whatever textures the user asks for.
//!
//! `batch` relies on this: the same scene at the same path gives the same files, whatever other levels were written before it and
//! by however many threads.

mod appearance;
#[cfg(test)]
mod example;
mod folders;
mod format;
mod options;
mod table;

pub(crate) use folders::SHARED_GEOMETRY;
pub(crate) use format::{LevelToWrite, Output, OutputFormat, SharedFile, TooLarge, WrittenLevel};
pub use options::{Format, LevelOptions, TextureOptions};
pub(crate) use table::{OUTPUTS, is_read_back, output_format};
