//! Chairs, stools, benches and rows of seats.

mod auditorium;
mod bar_stool;
mod beam_seats;
mod bench;
mod chair;
mod lounger;
mod office;
mod stool;

pub(super) use auditorium::auditorium_seat;
pub(super) use beam_seats::beam_seats;
pub(super) use bench::bench;
pub(super) use chair::{chair, garden_chair, school_chair};
pub(super) use lounger::lounger;
pub(super) use office::office_chair;
pub(super) use stool::stool;

use crate::model::kit::Bay;

/// Metres of a comfortable seat over the floor.
pub(super) const SEAT_HEIGHT: f64 = 0.45;
/// Share of the height at most taken by the seat, where the chair is low.
const SEAT_SHARE: f64 = 0.55;

/// Height of a seat in a box of this height.
pub(super) fn seat_height(height: f64) -> f64 {
    SEAT_HEIGHT.min(height * SEAT_SHARE)
}

/// Boards side by side from front to back.
pub(super) fn depth_slats(bay: Bay, count: u32, gap: f64) -> Vec<Bay> {
    let depth = (bay.depth() - gap * f64::from(count - 1)) / f64::from(count);
    let back = |index: u32| bay.low.z + f64::from(index) * (depth + gap);
    (0..count).map(|index| bay.with_z([back(index), back(index) + depth])).collect()
}
