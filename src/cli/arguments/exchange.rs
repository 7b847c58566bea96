//! The arguments of `import` and `merge`.

use std::path::PathBuf;

use clap::Args;

use super::sources::scale;

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
    /// Keep the furniture that the plan draws as locked objects, in an edits file beside each plan; kitchens and baths first.
    #[arg(long)]
    pub(crate) keep_furniture: bool,
    /// Of Swiss Dwellings, read these alone: site_ID, building_ID or floor_ID. Of maps, plan these buildings alone.
    #[arg(long, value_name = "ID,…", value_delimiter = ',')]
    pub(crate) only: Vec<String>,
    /// Metres of one unit of plans that are drawn without a scale (ResPlan) [default: by the area that the plan states].
    #[arg(long, value_name = "METRES", allow_negative_numbers = true, value_parser = scale)]
    pub(crate) scale: Option<f64>,
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
    /// Join the parts (manifest.1-of-4.json and so on) in this folder and in the folders in it, without looking for the files
    /// of the levels, which lie elsewhere. All parts of one division must be there, and must not contradict each other.
    #[arg(long, value_name = "DIR", conflicts_with = "folder")]
    pub(crate) records: Option<PathBuf>,
    /// The levels that the plans have, as `bake --list-levels --json` prints them. Levels that no part has are
    /// reported, as are levels of other inputs.
    #[arg(long, value_name = "FILE", requires = "records")]
    pub(crate) levels: Option<PathBuf>,
    /// File to write the joined records into [default: manifest.json in the folder of --records].
    #[arg(long, value_name = "FILE", requires = "records")]
    pub(crate) out: Option<PathBuf>,
}
