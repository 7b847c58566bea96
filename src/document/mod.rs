//! Reads YAML and JSON files into typed values, and reports all faults of a file at once.
//!
//! `plan/` and `catalog/` share this stage and interpret the values. Serde reads a good file straight into its type. If
//! this fails, the file is read again into a `tree` that knows the place of every value, and checked against the JSON
//! Schema of the type. Thus every fault is found with its place, and files without faults cost no time for places.

mod choice;
mod diagnose;
mod excerpt;
mod fault;
mod faults;
mod format;
mod keys;
mod limits;
mod scalar;
mod schema;
mod source;
mod suggest;
mod text;
mod tree;
mod xml;

#[cfg(test)]
mod tests;

pub use fault::{Fault, FaultSeverity, PathStep, show_path};
pub use faults::{Faults, Warned};
pub(crate) use keys::top_keys;
pub use limits::FILE_SIZE_LIMIT;
pub use source::Source;
pub use suggest::{did_you_mean, suggest};
pub(crate) use text::{bounded, counted};
pub use text::{is_unprintable, printable, printable_json, printable_lines};
pub use xml::xml_text;
