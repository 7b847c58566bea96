//! What one trains and plays on.

mod dumbbell_rack;
mod exercise_bench;
mod pool_table;
mod tennis_table;
mod treadmill;

pub(super) use dumbbell_rack::dumbbell_rack;
pub(super) use exercise_bench::exercise_bench;
pub(super) use pool_table::pool_table;
pub(super) use tennis_table::tennis_table;
pub(super) use treadmill::treadmill;
