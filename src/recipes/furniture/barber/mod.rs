//! The furniture of barbers.

mod chair;
mod station;

pub(super) use chair::BARBER_CHAIR;
pub(super) use station::MIRROR_STATION;
