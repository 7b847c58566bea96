//! Pieces to train and play on.

mod dumbbell_rack;
mod exercise_bench;
mod goal;
mod pool_table;
mod tennis_table;
mod treadmill;
mod wall_bars;

pub(super) use dumbbell_rack::DUMBBELL_RACK;
pub(super) use exercise_bench::EXERCISE_BENCH;
pub(super) use goal::GOAL;
pub(super) use pool_table::POOL_TABLE;
pub(super) use tennis_table::TENNIS_TABLE;
pub(super) use treadmill::TREADMILL;
pub(super) use wall_bars::WALL_BARS;
