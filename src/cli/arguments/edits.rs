//! The arguments of `edits`.

use std::path::PathBuf;

use clap::Subcommand;

use super::number::whole_number;
use super::path::path_or_nothing;

/// The commands of `edits`. Each adds to the edits file and keeps what it says.
#[derive(Clone, Debug, Subcommand)]
pub(crate) enum EditsCommand {
    /// Write the changes that were made to a level, for example in Blender, into its edits file.
    Capture {
        /// The file of the level as it was baked.
        #[arg(value_name = "OLD")]
        old: PathBuf,
        /// The same level, changed and exported again with its custom properties.
        #[arg(value_name = "EDITED")]
        edited: PathBuf,
        /// The edits file [default: NAME.edits.yaml beside the plan or project that OLD was baked from].
        #[arg(long, value_name = "FILE")]
        edits: Option<PathBuf>,
        /// The --cache folder of the bake, which holds the place of the plan.
        #[arg(long, value_name = "DIR|none", env = "ROOMWRIGHT_CACHE", hide_env_values = true, value_parser = path_or_nothing())]
        cache: Option<PathBuf>,
        /// Further folders of configuration.
        #[arg(long, value_name = "DIR")]
        catalog: Vec<PathBuf>,
    },
    /// Keep furniture where it stands in a level; later bakes arrange the rest of the room around it.
    Lock {
        /// The file of a level that bake wrote, edited or not.
        #[arg(value_name = "FLOOR")]
        floor: PathBuf,
        /// Id of the room.
        #[arg(value_name = "ROOM")]
        room: String,
        /// Ids of the objects [default: all of the room].
        #[arg(value_name = "OBJECT")]
        objects: Vec<String>,
        /// The edits file [default: NAME.edits.yaml beside the plan or project that FLOOR was baked from].
        #[arg(long, value_name = "FILE")]
        edits: Option<PathBuf>,
        /// The --cache folder of the bake, which holds the place of the plan.
        #[arg(long, value_name = "DIR|none", env = "ROOMWRIGHT_CACHE", hide_env_values = true, value_parser = path_or_nothing())]
        cache: Option<PathBuf>,
    },
    /// Give a room another seed, for this and all later bakes.
    Reroll {
        /// The plan or project of the room.
        #[arg(value_name = "PLAN")]
        plan: PathBuf,
        /// The room: [BUILDING/][LEVEL/]ROOM.
        #[arg(value_name = "ROOM")]
        room: String,
        /// The seed [default: the next one].
        #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole_number::<u64>(0..=u64::MAX))]
        to: Option<u64>,
        /// The edits file [default: NAME.edits.yaml beside the plan].
        #[arg(long, value_name = "FILE")]
        edits: Option<PathBuf>,
        /// Further folders of configuration.
        #[arg(long, value_name = "DIR")]
        catalog: Vec<PathBuf>,
    },
}
