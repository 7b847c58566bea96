//! The arguments of `navigation`.

use std::path::PathBuf;

use clap::Args;

use super::number::metres;
use crate::walk::CELL;

/// `navigation`.
#[derive(Clone, Debug, Args)]
pub(crate) struct NavigationArguments {
    /// Files that bake wrote (.glb, .gltf), edited or not, or folders with such files.
    #[arg(value_name = "PATH", default_value = "out")]
    pub(crate) paths: Vec<PathBuf>,
    /// Output folder.
    #[arg(long, value_name = "DIR", default_value = "navigation")]
    pub(crate) out: PathBuf,
    /// Further folders of configuration, the same as for the bake.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Radius of the agent of the mesh, in metres [default: half of `walking.robot` in audit.yaml, 0.15].
    #[arg(long, value_name = "METRES", allow_negative_numbers = true, value_parser = metres)]
    pub(crate) radius: Option<f64>,
    /// Height of the agent, in metres: it passes under what hangs higher [default: `walking.body_height` in audit.yaml, 1.5].
    #[arg(long, value_name = "METRES", allow_negative_numbers = true, value_parser = metres)]
    pub(crate) height: Option<f64>,
    /// Metres of a cell of the maps; wider in levels with more than 11 million cells.
    #[arg(long, value_name = "METRES", default_value_t = CELL, allow_negative_numbers = true, value_parser = cell)]
    pub(crate) resolution: f64,
    /// Overwrite files that roomwright did not write, or that were changed since.
    #[arg(long)]
    pub(crate) force: bool,
}

/// Reads the width of a cell.
fn cell(text: &str) -> Result<f64, String> {
    let cell = metres(text)?;
    if (0.005..=1.0).contains(&cell) { Ok(cell) } else { Err("cells are 0.005 to 1 m wide".to_owned()) }
}
