//! The arguments of `init`, `completions` and `man`.

use std::path::PathBuf;

use clap::Args;
use clap_complete::Shell;

/// `init`.
#[derive(Clone, Debug, Args)]
pub(crate) struct InitArguments {
    /// Folder to write into; created if it is not there.
    #[arg(value_name = "DIR", default_value = ".")]
    pub(crate) folder: PathBuf,
}

/// `completions`.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct CompletionsArguments {
    /// The shell.
    #[arg(value_name = "SHELL", value_enum)]
    pub(crate) shell: Shell,
}

/// `man`.
#[derive(Clone, Debug, Args)]
pub(crate) struct ManArguments {
    /// Write the pages of all commands into this folder: roomwright.1, roomwright-bake.1, ... [default: roomwright.1 to stdout].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Overwrite existing files.
    #[arg(long, requires = "out")]
    pub(crate) force: bool,
}
