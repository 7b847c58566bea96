//! The arguments of `walk`.

use std::path::PathBuf;

use clap::Args;

use super::number::{degrees, metres, whole_number};
use super::{FurnishArguments, SourceArguments};

/// `walk`.
#[derive(Clone, Debug, Args)]
pub(crate) struct WalkArguments {
    #[command(flatten)]
    pub(crate) sources: SourceArguments,
    #[command(flatten)]
    pub(crate) furnish: FurnishArguments,
    /// Walk the path of this file: YAML, as `configs/walks/hotel.yaml` shows.
    #[arg(long, value_name = "FILE", conflicts_with = "random")]
    pub(crate) path: Option<PathBuf>,
    /// Walk so many metres at random [default: 1000, without --path].
    #[arg(long, value_name = "METRES", value_parser = some_metres)]
    pub(crate) random: Option<f64>,
    /// Seed of the random walk.
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = whole_number::<u64>(0..=u64::MAX))]
    pub(crate) path_seed: u64,
    /// Metres a second, once for each walk: walking is 1.4, running 4.
    #[arg(long, value_name = "SPEED,…", value_delimiter = ',', default_values_t = [1.4, 4.0], value_parser = speed)]
    pub(crate) speed: Vec<f64>,
    /// Threads that furnish in the background.
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = whole_number::<usize>(1..=256))]
    pub(crate) threads: usize,
    /// Rooms that are held at most.
    #[arg(long, value_name = "N", default_value_t = 512, allow_negative_numbers = true, value_parser = whole_number::<usize>(1..=1_000_000))]
    pub(crate) budget_rooms: usize,
    /// Megabytes of furnished rooms that are held at most.
    #[arg(long, value_name = "N", default_value_t = 64, allow_negative_numbers = true, value_parser = whole_number::<usize>(1..=100_000))]
    pub(crate) budget_megabytes: usize,
    /// Degrees that one sees from side to side.
    #[arg(long, value_name = "DEGREES", default_value_t = 90.0, value_parser = degrees)]
    pub(crate) view: f64,
    /// Metres of the way to rooms that have to be there though one does not see them.
    #[arg(long, value_name = "METRES", default_value_t = crate::world::DEFAULT_REACH, value_parser = metres)]
    pub(crate) reach: f64,
}

/// Metres a second of the slowest walk: one that hardly moves looks around for months.
const SLOWEST: f64 = 0.1;

/// Of something that moves.
fn speed(text: &str) -> Result<f64, String> {
    let speed = metres(text)?;
    if speed >= SLOWEST { Ok(speed) } else { Err(format!("write metres a second, from {SLOWEST} on")) }
}

/// More than none, and not more than a walk around the earth.
fn some_metres(text: &str) -> Result<f64, String> {
    let metres = metres(text)?;
    if metres > 0.0 { Ok(metres) } else { Err("write metres above 0".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_walk_moves() {
        assert_eq!((speed("1.4"), speed("0.1")), (Ok(1.4), Ok(0.1)));
        for wrong in ["0", "0.000001"] {
            assert_eq!(speed(wrong), Err("write metres a second, from 0.1 on".to_owned()));
        }
    }
}
