//! Edits: changes by hand to furnished rooms, applied again after every bake (the paper's persistence, section 4.1, and
//! what it left open).
//!
//! An edits file lies beside a plan (`house.edits.yaml` beside `house.yaml`). It says of single objects, by room and id,
//! where they stand, or that they are removed, added or of another class. Edits are applied after the arrangement;
//! objects that stand on an edited object follow it. Locked objects are placed first, and the others are arranged around
//! them. An edit that cannot be applied is rejected: it is reported with its place in the file, and stays in the file.
//!
//! - `file` is the format; `read` reads files as an [`EditBook`] and checks them;
//! - `locks` gives locked objects as the layout takes them; `apply` edits a furnished room; `tree` has the objects in the frames
//!   of their parents;
//! - `drawn` locks furniture that a plan draws;
//! - `capture` derives edits from a level before and after a change; `merge` puts new edits into those of a file.

mod apply;
mod book;
mod capture;
mod drawn;
mod file;
mod finish;
mod locked;
mod locks;
mod merge;
mod misfit;
mod read;
mod set;
mod standing;
#[cfg(test)]
mod tests;
mod tree;
mod write;

pub use book::{EditBook, LevelEdits, RoomEdits};
pub use capture::{Captured, capture};
pub use drawn::{KeptFurniture, keep_drawn};
pub use file::{EditsFile, RoomEntry};
pub use finish::{Finished, finish, furnish_edited};
pub use locked::lock_objects;
pub use merge::merge;
pub use misfit::{Misfit, distinct_misfits};
pub use read::{EDITS_ENDING, edits_path, read_edits, read_edits_file};
pub use set::{set_object, set_seed};
pub use write::write_edits;
