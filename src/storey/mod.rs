//! Plans storeys inside the outlines of buildings: footprint → rooms, doors and windows as a [`crate::plan::BuildingDraft`].
//!
//! ```text
//! site ─▶ outline, facade ─▶ brief ─▶ grounds ─▶ house | flats | corridor | open ─▶ street level, entrance room, thin parts traded
//!      ─▶ faces ─▶ links, entries ─▶ balconies ─▶ windows ─▶ check, egress ─▶ draft
//! ```
//!
//! Later stages may rely on:
//! - rooms are made by cutting the floor of a storey (`ring.rs`): they cover it and do not overlap, whatever its outline;
//! - every room is reached from the way in, and rooms that need windows have some (`check.rs`); what does not come out is tried
//!   in simpler ways, down to one room for each storey: there is always a plan;
//! - walls, stairs and windows of the storeys of a building stand above each other;
//! - a plan depends on the footprint, on what stands around it, and on the seed: not on other buildings or their order.

mod axial;
mod balconies;
mod brief;
mod building;
mod check;
mod corridor;
mod deep;
mod disc;
mod draft;
mod dwelling;
mod egress;
mod ends;
mod entrance_room;
mod entries;
mod facade;
mod faces;
mod fill;
mod flats;
mod footprint;
mod frame;
mod hall;
mod hopeless;
mod house;
mod links;
mod open;
mod plate;
mod ring;
mod spine;
mod street_level;
mod suites;
#[cfg(test)]
mod tests;
mod thin;
mod typology;
mod windows;
mod wings;

pub use brief::Choices;
pub(crate) use building::plan_building;
pub use building::{PlanReport, PlannedBuilding};
pub(crate) use facade::Neighbourhood;
pub use footprint::{Footprint, FootprintPart, Origin, Site, StoreyFacts};
pub use typology::Typologies;
