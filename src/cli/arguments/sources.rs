//! Arguments of several commands: plans, configuration, and the options that furniture depends on.

use std::path::PathBuf;

use clap::Args;

use super::number::{so_many_numbers, whole_number};
use crate::best::DEFAULT_EFFORT;
use crate::storey::Choices;

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
    #[command(flatten)]
    pub(crate) map: MapArguments,
}

/// How buildings are planned of which a map shows only the outline, and what other files leave open.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Options for maps of building outlines")]
pub(crate) struct MapArguments {
    /// Plan these buildings alone. Of Swiss Dwellings, read these alone: site_ID, building_ID or floor_ID.
    #[arg(long, value_name = "ID,…", value_delimiter = ',')]
    pub(crate) only: Vec<String>,
    /// Plan only buildings with their middle in this box, in the units of the map.
    #[arg(long, value_name = "WEST,SOUTH,EAST,NORTH", allow_negative_numbers = true, value_parser = bounds)]
    pub(crate) bbox: Option<[f64; 4]>,
    /// The use of all buildings, in place of what the map says: a name of `uses` in typologies.yaml.
    #[arg(long = "use", value_name = "NAME")]
    pub(crate) use_name: Option<String>,
    /// Storeys of all buildings, in place of what the map says.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole_number::<u32>(1..=200))]
    pub(crate) levels: Option<u32>,
    /// Metres of one unit of plans that are drawn without a scale (ResPlan) [default: by the area that the plan states].
    #[arg(long, value_name = "METRES", allow_negative_numbers = true, value_parser = scale)]
    pub(crate) scale: Option<f64>,
    /// Seed of the plans.
    #[arg(skip)]
    pub(crate) seed: Option<u64>,
}

fn bounds(text: &str) -> Result<[f64; 4], String> {
    let bounds = so_many_numbers(text)?;
    let [west, south, east, north] = bounds;
    if west < east && south < north { Ok(bounds) } else { Err("the box has no area".to_owned()) }
}

/// Metres of a unit, as `--scale` has them.
pub(super) fn scale(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|metres| (1e-6..=1e3).contains(metres));
    number.ok_or_else(|| "write the metres of one unit, as 0.04".to_owned())
}

impl SourceArguments {
    /// The same, where buildings of maps are planned by a seed.
    pub(crate) fn seeded(&self, seed: Option<u64>) -> Self {
        let mut seeded = self.clone();
        seeded.map.seed = seed;
        seeded
    }

    /// The choices for planning buildings.
    pub(crate) fn choices(&self) -> Choices {
        let MapArguments { only, bbox, use_name, levels, scale, seed } = self.map.clone();
        Choices {
            use_name,
            storeys: levels,
            seed: seed.unwrap_or(1),
            only,
            bounds: bbox,
            metres_per_unit: scale,
        }
    }
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
