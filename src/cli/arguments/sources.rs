//! Arguments of several commands: plans, configuration, and the options that furniture depends on.

use std::path::PathBuf;

use clap::Args;

use super::number::whole_number;
use crate::best::DEFAULT_EFFORT;

/// Where plans and configuration come from.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct SourceArguments {
    /// Plans, projects, folders, or patterns such as 'plans/*.yaml' [default: the built-in demo].
    #[arg(value_name = "PATH")]
    pub(crate) paths: Vec<PathBuf>,
    /// Further folders of configuration: classes/, rooms/, styles/, palettes/. May be repeated; later ones win.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) edits: EditArguments,
}

/// Which edits are made.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct EditArguments {
    /// A further edits file. May be repeated; later ones win. NAME.edits.yaml beside a plan is read without it.
    #[arg(long = "edits", value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,
    /// Apply no edits.
    #[arg(long, conflicts_with = "files")]
    pub(crate) no_edits: bool,
}

/// The options that furniture depends on.
#[derive(Clone, Debug, Args)]
pub(crate) struct FurnishArguments {
    /// Seed of all rooms; another number gives other arrangements [default: the project's, or 1].
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole_number::<u64>(0..=u64::MAX))]
    pub(crate) seed: Option<u64>,
    /// Style of rooms whose plan names none [default: the project's, or `default`].
    #[arg(long, value_name = "NAME")]
    pub(crate) style: Option<String>,
    /// Furnish a room up to K times, until the audit finds nothing, and keep the best.
    #[arg(long, value_name = "K", default_value_t = DEFAULT_EFFORT, allow_negative_numbers = true, value_parser = whole_number::<u32>(1..=1000))]
    pub(crate) effort: u32,
}
