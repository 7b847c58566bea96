//! Plans storeys inside the outlines of buildings: footprint → rooms, doors and windows as a [`crate::plan::BuildingDraft`].

mod footprint;

pub use footprint::{Footprint, FootprintPart, Origin, Site, StoreyFacts};
