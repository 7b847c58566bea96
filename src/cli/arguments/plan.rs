//! The arguments of `plan`.

use std::path::PathBuf;

use clap::Args;

use super::number::whole_number;
use super::sources::MapArguments;

/// `plan`.
#[derive(Clone, Debug, Args)]
pub(crate) struct PlanArguments {
    /// Maps of building outlines: GeoJSON, CityJSON, OSM XML, OSM PBF.
    #[arg(value_name = "PATH", required = true)]
    pub(crate) paths: Vec<PathBuf>,
    /// Folder to write into: a plan for each building, and project.yaml, which places them.
    #[arg(short, long, value_name = "DIR")]
    pub(crate) out: PathBuf,
    /// Overwrite existing files.
    #[arg(long)]
    pub(crate) force: bool,
    /// Further folders of configuration, for their typologies.yaml.
    #[arg(long, value_name = "DIR")]
    pub(crate) catalog: Vec<PathBuf>,
    /// Seed of the plans.
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = whole_number::<u64>(0..=u64::MAX))]
    pub(crate) seed: u64,
    /// Write a report on each building as JSON: its kind, how that and its storeys are known, which way of planning was taken.
    #[arg(long, value_name = "FILE")]
    pub(crate) report: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) map: MapArguments,
}
