//! The formats that levels are written in: a table, as the readers of plans are.
//!
//! A new format is one folder beside `gltf/` with a type that implements [`Output`], and one line in `table.rs`. What
//! `batch` relies on: the same scene at the same path gives the same files, whatever other levels were written before it and
//! by however many threads.

mod folders;
mod format;
mod options;
mod table;

pub(crate) use folders::SHARED_GEOMETRY;
pub(crate) use format::{LevelToWrite, Output, OutputFormat, SharedFile, TooLarge, WrittenLevel};
pub use options::{FloorOptions, Format, TextureOptions};
pub(crate) use table::{OUTPUTS, output_format};
