//! The formats that levels are written in, as a table, like the readers of plans.
//!
//! A new format is one folder beside `gltf/` with a type that implements [`Output`], and one line in `table.rs`. `batch`
//! relies on this: the same scene at the same path gives the same files, whatever other levels were written before, and
//! by any number of threads.

mod folders;
mod format;
mod options;
mod table;

pub(crate) use folders::SHARED_GEOMETRY;
pub(crate) use format::{LevelToWrite, Output, OutputFormat, SharedFile, TooLarge, WrittenLevel};
pub use options::{FloorOptions, Format, TextureOptions};
pub(crate) use table::{OUTPUTS, output_format};
