//! The command `roomwright`.

use std::process::ExitCode;

fn main() -> ExitCode {
    roomwright::cli::run().into()
}
