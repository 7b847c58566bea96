//! Tests with hostile or exhausted surroundings: tampered records, links, special files, full disks, few resources. No
//! file outside the output folder is touched, no command hangs or panics, and messages help.

#![allow(clippy::unwrap_used)] // a test that cannot set up its folder fails

#[path = "../command_line/world.rs"]
#[allow(dead_code)] // of all that it offers, each test program needs a part
mod world;

#[cfg(unix)]
mod bounded;
mod cached;
mod clocks;
#[cfg(target_os = "linux")]
mod limits;
#[cfg(unix)]
mod links;
mod lost_output;
#[path = "../fuzz/mutate.rs"]
mod mutate;
mod names;
mod parallel;
mod records;
#[cfg(unix)]
mod special_files;
