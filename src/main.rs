//! The command `roomwright`.

use std::process::ExitCode;

/// Layout and scene make many short-lived lists: see `Cargo.toml`.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    roomwright::run_command().into()
}
