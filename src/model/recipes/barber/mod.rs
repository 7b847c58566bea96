//! What barbers work with.

mod chair;
mod station;

pub(super) use chair::barber_chair;
pub(super) use station::mirror_station;
