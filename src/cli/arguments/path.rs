//! Reads paths that may be empty: a variable of the environment that is set to nothing is no mistake of who types a command.

use std::path::PathBuf;

use clap::builder::{OsStringValueParser, TypedValueParser};

/// A path, or an empty one.
pub(super) fn path_or_nothing() -> impl TypedValueParser<Value = PathBuf> {
    OsStringValueParser::new().map(PathBuf::from)
}
