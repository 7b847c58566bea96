//! Scenes and glTF files of levels built in code.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a test may stop at the first surprise")]

mod arrays;
mod file;
mod fixture;
#[path = "../golden/mod.rs"]
mod golden;
mod leaks;
mod levels;
mod merged;
mod shell;
mod tree;
mod triangles;
