//! The output contract: how nodes are named, what ids mean, and what the `extras` of nodes hold.
//!
//! `scene` writes these types and `read_back` reads the same ones, so that both always agree.
//!
//! Callers may rely on:
//! - an id that is shown ([`std::fmt::Display`]) and parsed ([`std::str::FromStr`]) is the same id;
//! - words that later versions may add to (classes, styles, reasons, codes) are texts, fixed ones are enums;
//! - numbers are metres and radians, x east and y north, unless a field says otherwise.
//!
//! The module depends on no stage: it holds plain data. `docs/output.md` says the same in prose, and
//! `configs/schema/extras.schema.json` as a JSON Schema.

mod extras;
mod id;
mod name;
mod part;

pub use extras::{
    Closure, Corner, Extras, FindingExtras, FurnitureExtras, HouseholdExtras, LeafExtras, LevelExtras,
    LightExtras, OpeningExtras, OpeningWord, PartExtras, RemovedExtras, RoomExtras, SideExtras, SiteExtras,
    Word,
};
pub use id::{ElementId, ObjectId, RoomId, VariantId};
pub use name::{level_name, model_in_name, model_name, owned_name, owner_in_name, room_in_name, room_name};
pub use part::{Part, PartId};
