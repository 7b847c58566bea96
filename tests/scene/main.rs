//! Scenes and glTF files of levels built in code.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first surprise")]

mod file;
mod fixture;
mod levels;
mod shell;
mod tree;
mod triangles;
