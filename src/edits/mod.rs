//! Edits: what people changed by hand in a furnished room stays when it is furnished again (the paper's persistence,
//! section 4.1, and what it left open).
//!
//! An edits file stands beside a plan (`house.edits.yaml` beside `house.yaml`) and says of single objects, by room and id,
//! where they stand, that they are gone, added or of another class. Edits are made after the arrangement; what stands
//! on an object follows it. A locked object is there before the others, which are arranged around it. An edit that no
//! longer fits is told with its place in the file, and stays in the file.
//!
//! - `file`: the format; `read`: files to an [`EditBook`], checked;
//! - `locks`: locked objects as the layout takes them; `apply`: a furnished room to the edited one; `tree`: objects in the
//!   frames of their parents;
//! - `capture`: two floors, before and after somebody edited one, to edits; `merge`: into what a file says already.

mod apply;
mod book;
mod capture;
mod file;
mod finish;
mod locked;
mod locks;
mod merge;
mod misfit;
mod read;
mod standing;
#[cfg(test)]
mod tests;
mod tree;
mod write;

pub use book::{EditBook, LevelEdits, ObjectEdit, RoomEdits};
pub use capture::{Captured, capture};
pub use file::{EditsFile, ObjectEntry, RoomEntry};
pub use finish::{Finished, finish, furnish_edited};
pub use locked::lock_objects;
pub use merge::merge;
pub use misfit::{Misfit, distinct_misfits};
pub use read::{EDITS_ENDING, edits_path, read_edits, read_edits_file};
pub use write::write_edits;
