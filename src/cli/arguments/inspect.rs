//! `check`, `catalog`, `draw` and `explain`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::{EditArguments, FurnishArguments, SourceArguments};

/// `check`.
#[derive(Clone, Debug, Args)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    pub(crate) sources: SourceArguments,
    /// Style of rooms whose plan names none, as for `bake`.
    #[arg(long, value_name = "NAME")]
    pub(crate) style: Option<String>,
}

/// `catalog`.
#[derive(Clone, Debug, Args)]
pub(crate) struct CatalogArguments {
    /// What to list: classes, rooms, styles or palettes; or an id, to see all about it.
    #[arg(value_name = "PART|ID")]
    pub(crate) what: Option<String>,
    /// One entry of that part, in full.
    #[arg(value_name = "ID")]
    pub(crate) id: Option<String>,
    /// Further folders of configuration.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Write everything as a page with a picture of each room type: catalogue.md and catalogue/ in this folder.
    #[arg(long, value_name = "DIR", conflicts_with = "what")]
    pub(crate) docs: Option<PathBuf>,
    /// Overwrite existing files.
    #[arg(long, requires = "docs")]
    pub(crate) force: bool,
}

/// Parts of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CatalogWord {
    /// Pieces of furniture.
    Classes,
    /// Room types.
    Rooms,
    /// Styles.
    Styles,
    /// Sets of materials.
    Palettes,
}

/// `draw`.
#[derive(Clone, Debug, Args)]
pub(crate) struct DrawArguments {
    #[command(flatten)]
    pub(crate) sources: SourceArguments,
    #[command(flatten)]
    pub(crate) furnish: FurnishArguments,
    /// Draw this building only.
    #[arg(long, value_name = "ID")]
    pub(crate) building: Option<String>,
    /// Draw this level only.
    #[arg(long, value_name = "ID")]
    pub(crate) level: Option<String>,
    /// File (`.svg`: one sheet with all levels of a building) or folder to write into. Without it, the sheet goes to stdout, or,
    /// at a terminal, into BUILDING.svg in this folder.
    #[arg(short, long, value_name = "FILE|DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Show the clearances that furniture and doors need.
    #[arg(long)]
    pub(crate) clearances: bool,
    /// In a folder, too, draw all levels of a building on one sheet, from below to above, not a file each.
    #[arg(long)]
    pub(crate) sheet: bool,
    /// Mark what the audit finds in the plan, numbered and coloured by severity, and list it below.
    #[arg(long)]
    pub(crate) findings: bool,
    /// Overwrite files that roomwright did not draw, or that were changed since; its own drawings are renewed without.
    #[arg(long)]
    pub(crate) force: bool,
}

/// `explain`.
#[derive(Clone, Debug, Args)]
pub(crate) struct ExplainArguments {
    /// A plan, project or folder of plans.
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,
    /// The room: [BUILDING/][LEVEL/]ROOM, or its name; without it, the answer names the rooms.
    #[arg(value_name = "ROOM")]
    pub(crate) room: Option<String>,
    /// Building of the room, where several have one of that id.
    #[arg(long, value_name = "ID")]
    pub(crate) building: Option<String>,
    /// Level of the room, where several have one of that id.
    #[arg(long, value_name = "ID")]
    pub(crate) level: Option<String>,
    #[command(flatten)]
    pub(crate) furnish: FurnishArguments,
    /// Further folders of configuration.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) edits: EditArguments,
}
