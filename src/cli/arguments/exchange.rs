//! The arguments of `import` and `merge`.

use std::path::PathBuf;

use clap::Args;

/// `import`.
#[derive(Clone, Debug, Args)]
pub(crate) struct ImportArguments {
    /// Foreign plans.
    #[arg(value_name = "PATH", required = true)]
    pub(crate) paths: Vec<PathBuf>,
    /// File (one building) or folder to write into.
    #[arg(short, long, value_name = "DIR|FILE")]
    pub(crate) out: PathBuf,
    /// Overwrite existing files.
    #[arg(long)]
    pub(crate) force: bool,
    /// Further folders of configuration, for their room words.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// List what was read, attached to rooms and left out, level by level; with --json as part of the result.
    #[arg(long)]
    pub(crate) report: bool,
}

/// `merge`.
#[derive(Clone, Debug, Args)]
pub(crate) struct MergeArguments {
    /// The output folder.
    #[arg(value_name = "DIR", default_value = "out")]
    pub(crate) folder: PathBuf,
}
