//! Files among those of others: looked at before they are opened, written beside their place and renamed.
//!
//! What later stages may rely on: only regular files are opened, so that a named pipe hangs nobody and a device without end
//! fills no memory; no more bytes are read than were asked for; and what is reached from a folder by a relative path lies in
//! that folder, for a link on the way is an error. Between the look and the opening somebody with the right to write there
//! may still put something else; against that the rights of the folder guard, not this program.

mod hash;
mod inside;
mod lock;
mod regular;
mod temporary;

pub(crate) use hash::{FieldHash, content_hash, file_hash, to_hex};
pub(crate) use inside::{look_inside, open_inside, stray_step};
pub(crate) use lock::{Holder, holder, ignore_unsupported};
pub(crate) use regular::{open_regular, read_plain, read_regular};
pub(crate) use temporary::{TemporaryFolder, new_temporary, remove_temporaries, sweep_temporaries};
