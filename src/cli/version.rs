//! `--version --json`: what a script pins or reports, without parsing a line of text.

use std::env::consts::{ARCH, OS};

use schemars::JsonSchema;
use serde::Serialize;

use super::exit::Outcome;
use super::screen::Screen;
use crate::batch::PROGRAM;
use crate::plan::read_formats;

/// The program that answers.
#[derive(Serialize, JsonSchema)]
pub(crate) struct VersionAnswer {
    /// `roomwright`.
    name: &'static str,
    /// Its semantic version.
    version: &'static str,
    /// The version with a hash of the sources, as manifests have it in `program`: the same program, input and seed give the same
    /// bytes.
    program: &'static str,
    /// The operating system that it was built for, as `linux`.
    system: &'static str,
    /// The processor that it was built for, as `x86_64`.
    processor: &'static str,
    /// Names of the plan formats that it reads, as `formats --json` lists them.
    formats: Vec<&'static str>,
}

/// Whether the words on the command line ask for JSON: clap ends at `--version`, so that options behind it are not read.
pub(crate) fn asks_for_json(mut words: impl Iterator<Item = std::ffi::OsString>) -> bool {
    words.any(|word| word == "--json")
}

/// Prints the answer.
pub(crate) fn show(screen: Screen) -> Outcome {
    let formats = read_formats().into_iter().map(|format| format.name).collect();
    let version = env!("CARGO_PKG_VERSION");
    let name = env!("CARGO_PKG_NAME");
    screen.json(&VersionAnswer { name, version, program: PROGRAM, system: OS, processor: ARCH, formats });
    Outcome::Done
}
