//! Reads and writes files in folders where other programs write too: files are checked before they are opened, and
//! written beside their place, then renamed.
//!
//! Callers may rely on:
//! - only regular files are opened, so that a named pipe cannot block and an endless device cannot fill the memory;
//! - no more bytes are read than the caller allows;
//! - a file reached from a folder by a relative path lies in that folder: a link on the way is an error.
//!
//! Between the check and the opening, a program with the right to write there may exchange the file. The rights of the
//! folder guard against this, not Roomwright.

mod hash;
mod inside;
mod lock;
mod packed;
mod regular;
mod temporary;

pub(crate) use hash::{FieldHash, content_hash, file_hash, to_hex};
pub(crate) use inside::{look_inside, open_inside, stray_step};
pub(crate) use lock::{Holder, holder, ignore_unsupported};
pub(crate) use packed::{open_unpacked, read_unpacked, unpacked_name};
pub(crate) use regular::{open_plain, open_regular, read_plain, read_regular};
pub(crate) use temporary::{TemporaryFolder, new_temporary, remove_temporaries, sweep_temporaries};
