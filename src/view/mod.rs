//! Serves a project to a page in a browser on the same machine: rooms on demand, edits, changes of files.
//!
//! `questions` is what the page may ask; `session` answers from a world, `baked` from finished files; `ask` asks
//! without a server; `site` says what there is
//! to see; `http` is the server, with the rules of who may ask; `page` has the files of the page (`viewer/`).
//!
//! Callers may rely on:
//! - only this machine can ask, and only a page of this server that knows its random token;
//! - nothing is read but the inputs that were named, and nothing is written but the edits files beside them;
//! - a room is the one that a bake writes.

mod ask;
#[cfg(feature = "cli")]
mod baked;
#[cfg(feature = "cli")]
mod http;
#[cfg(feature = "cli")]
mod page;
mod questions;
mod session;
mod site;

pub use ask::{PageAnswer, PlanPage};
#[cfg(feature = "cli")]
pub(crate) use baked::Baked;
#[cfg(feature = "cli")]
pub(crate) use http::{Server, serve};
#[cfg(feature = "cli")]
pub(crate) use questions::{Answers, Controls};
#[cfg(feature = "cli")]
pub(crate) use session::{EditsChange, Session, ViewSources};
