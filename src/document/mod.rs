//! Reads YAML and JSON files into typed values, and reports all faults of a file at once.
//!
//! `plan/` and `catalog/` share this stage and interpret the values. A file is read into a tree, for YAML one that knows the
//! place of every value, and its type is read from the tree (`typed`). If this fails, the tree is checked against the JSON
//! Schema of the type; JSON is read again for it, with places. Thus every fault is found with its place.

mod alike;
mod choice;
mod diagnose;
mod excerpt;
mod fault;
mod faults;
mod format;
mod json;
mod keys;
mod limits;
mod node;
mod scalar;
mod schema;
mod source;
mod suggest;
mod text;
mod tree;
mod typed;
mod unique;
mod xml;

#[cfg(test)]
mod tests;

pub(crate) use alike::first_of_each_kind;
pub use fault::{Fault, FaultSeverity, PathStep, show_path};
pub use faults::{Faults, Warned};
pub(crate) use keys::top_keys;
pub use limits::FILE_SIZE_LIMIT;
pub use source::Source;
pub use suggest::{did_you_mean, suggest};
pub(crate) use text::{bounded, counted};
pub use text::{is_unprintable, printable, printable_json, printable_lines};
pub use xml::xml_text;
