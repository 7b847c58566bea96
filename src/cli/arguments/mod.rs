//! The command line as typed, one file for each group of commands.

// These comments are help texts: brackets are what one may leave out, no links.
#![allow(rustdoc::broken_intra_doc_links)]

mod bake;
mod edits;
mod exchange;
mod inspect;
mod judge;
mod navigation;
mod number;
#[cfg(test)]
mod pages;
mod path;
mod plan;
mod setup;
mod sources;
mod tiles;
mod view;
mod walk;

use clap::{Args, Parser, Subcommand};

use super::exit::{AUDIT_EXIT_CODES, DIFF_EXIT_CODES, EXIT_CODES};

pub(crate) use bake::{
    BakeArguments, DetailWord, LightsWord, NormalsWord, PartsWord, ProfileWord, ProgressWord, RunArguments,
    TextureWord,
};
pub(crate) use edits::EditsCommand;
pub(crate) use exchange::{ImportArguments, MergeArguments};
pub(crate) use inspect::{CatalogArguments, CatalogWord, CheckArguments, DrawArguments, ExplainArguments};
pub(crate) use judge::{AuditArguments, DiffArguments};
pub(crate) use navigation::NavigationArguments;
pub(crate) use plan::PlanArguments;
pub(crate) use setup::{CompletionsArguments, InitArguments, ManArguments};
pub(crate) use sources::{EditArguments, FurnishArguments, MapArguments, SourceArguments};
pub(crate) use tiles::{InstancingWord, Near, TilesArguments};
pub(crate) use view::ViewArguments;
pub(crate) use walk::WalkArguments;

/// Furnishes the rooms of floor plans and writes one glTF file for each level of a building.
///
/// Without a command, the built-in demo is baked into out/.
#[derive(Debug, Parser)]
#[command(version, after_help = EXIT_CODES, max_term_width = 100, subcommand_help_heading = "Commands")]
pub(crate) struct Arguments {
    /// The command.
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    /// The options for printing.
    #[command(flatten)]
    pub(crate) manner: Manner,
}

/// Options of all commands.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct Manner {
    /// Show errors only.
    #[arg(short, long, global = true)]
    pub(crate) quiet: bool,
    /// Print the result as JSON on stdout.
    #[arg(long, global = true)]
    pub(crate) json: bool,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Write a first plan, style and project; existing files stay as they are.
    #[command(after_help = EXIT_CODES)]
    Init(InitArguments),
    /// Furnish plans and write one glTF file for each level.
    #[command(after_help = EXIT_CODES)]
    Bake(BakeArguments),
    /// Report all faults of plans and configuration; write nothing.
    #[command(after_help = EXIT_CODES)]
    Check(CheckArguments),
    /// List the catalogue: classes of furniture, room types, styles, palettes.
    Catalog(CatalogArguments),
    /// Judge the rooms of finished files, edited or not.
    #[command(after_help = AUDIT_EXIT_CODES)]
    Audit(AuditArguments),
    /// Report the differences of two bakes or two files: rooms, furniture, openings, findings.
    #[command(after_help = DIFF_EXIT_CODES)]
    Diff(DiffArguments),
    /// Draw furnished levels as SVG.
    #[command(after_help = EXIT_CODES)]
    Draw(DrawArguments),
    /// Keep changes by hand (furniture that was moved, added, removed, swapped; seeds of rooms) for later bakes.
    #[command(after_help = EXIT_CODES)]
    Edits {
        #[command(subcommand)]
        command: EditsCommand,
    },
    /// Report why each object of a room stands where it is, and why pieces are missing.
    #[command(after_help = EXIT_CODES)]
    Explain(ExplainArguments),
    /// List the plan formats that are read, and known ones that are not.
    Formats,
    /// Convert foreign plans to native ones.
    #[command(after_help = EXIT_CODES)]
    Import(ImportArguments),
    /// Plan the rooms of buildings of which a map shows only the outline; write native plans and a project.
    #[command(after_help = EXIT_CODES)]
    Plan(PlanArguments),
    /// Join the records of several bakes into one folder (--shard) into its manifest.
    #[command(after_help = EXIT_CODES)]
    Merge(MergeArguments),
    /// Furnish plans, or take a finished bake, and write 3D Tiles: one tileset for clients that stream cities.
    #[command(after_help = EXIT_CODES)]
    Tiles(TilesArguments),
    /// Write navigation meshes and occupancy maps of finished files, for robots and simulators.
    #[command(after_help = EXIT_CODES)]
    Navigation(NavigationArguments),
    /// Show furnished buildings in the browser: walk through them, ask why, move furniture.
    #[command(after_help = EXIT_CODES)]
    View(ViewArguments),
    /// Walk through furnished buildings without a picture; report whether rooms are there before they are seen.
    #[command(after_help = EXIT_CODES)]
    Walk(WalkArguments),
    /// Print a script that completes commands and options in a shell.
    Completions(CompletionsArguments),
    /// Print the manual page.
    Man(ManArguments),
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_definition_is_sound() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn options_of_all_commands_stand_anywhere() {
        for line in [["roomwright", "--json", "merge"], ["roomwright", "merge", "--json"]] {
            assert!(Arguments::try_parse_from(line).unwrap().manner.json);
        }
    }
}
