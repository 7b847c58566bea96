//! The arguments of `check`, `catalog`, `draw` and `explain`.

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
    /// The part to list: classes, rooms, styles or palettes; or the id of an entry, to show it in full.
    #[arg(value_name = "PART|ID")]
    pub(crate) what: Option<String>,
    /// The id of an entry of that part, to show it in full.
    #[arg(value_name = "ID")]
    pub(crate) id: Option<String>,
    /// Further folders of configuration.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Write the catalogue into this folder as a page with a picture of each room type: catalogue.md and catalogue/.
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
    /// File (`.svg`: one sheet with all levels of a building) or folder to write into [default: the sheet to stdout; at a
    /// terminal, to BUILDING.svg in this folder].
    #[arg(short, long, value_name = "FILE|DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Show the clearances that furniture and doors need.
    #[arg(long)]
    pub(crate) clearances: bool,
    /// With a folder as --out, draw all levels of a building on one sheet, lowest first, instead of a file each.
    #[arg(long)]
    pub(crate) sheet: bool,
    /// Mark the findings of the audit in the drawing, numbered and coloured by severity, and list them below.
    #[arg(long)]
    pub(crate) findings: bool,
    /// Overwrite files that roomwright did not draw, or that were changed since. It replaces its own drawings without this.
    #[arg(long)]
    pub(crate) force: bool,
}

/// `explain`.
#[derive(Clone, Debug, Args)]
pub(crate) struct ExplainArguments {
    /// A plan, project or folder of plans.
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,
    /// The room: [BUILDING/][LEVEL/]ROOM, or its name; without it, the command lists the rooms.
    #[arg(value_name = "ROOM")]
    pub(crate) room: Option<String>,
    /// Building of the room, if several have a room of that id.
    #[arg(long, value_name = "ID")]
    pub(crate) building: Option<String>,
    /// Level of the room, if several have a room of that id.
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
