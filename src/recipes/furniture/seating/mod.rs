//! Chairs, stools, benches and rows of seats.

mod auditorium;
mod bar_stool;
mod beam_seats;
mod bench;
mod chair;
mod lounger;
mod office;
mod stool;

pub(super) use auditorium::AUDITORIUM_SEAT;
pub(super) use beam_seats::BEAM_SEATS;
pub(super) use bench::BENCH;
pub(super) use chair::{CHAIR, GARDEN_CHAIR, SCHOOL_CHAIR};
pub(super) use lounger::LOUNGER;
pub(super) use office::OFFICE_CHAIR;
pub(super) use stool::STOOL;

use crate::recipes::kit::Bay;

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
