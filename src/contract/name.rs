//! Names of nodes, unique in a level and stable between bakes, and the ids that they hold.
//!
//! One rule: `<id>@<owner>` for everything that belongs to a room or an opening, where the owner is the
//! room's id or the opening's node name; `<kind>:<id>` for rooms and openings themselves.
//!
//! ```text
//! tower/2                      the level
//! |- door:d1                   every walkable opening; window:w1
//! |  '- leaf@door:d1
//! '- room:201
//!    |- wall.0@201
//!    '- desk.1@201
//!       '- lamp.1@201
//! ```

use crate::contract::VariantId;
use std::fmt::{Display, Write};

use super::id::ObjectId;

/// Before the id of a room in the name of its node.
const ROOM: &str = "room:";

/// Between what a name names and what it belongs to.
const OF: char = '@';

/// Name of a level's root.
#[must_use]
pub fn level_name(building: &str, level: &str) -> String {
    format!("{building}/{level}")
}

/// Name of a room's node.
#[must_use]
pub fn room_name(id: &str) -> String {
    format!("{ROOM}{id}")
}

/// The room that a node of this name is: the other way of [`room_name`].
#[must_use]
pub fn room_in_name(name: &str) -> Option<&str> {
    name.strip_prefix(ROOM)
}

/// Name of what belongs to a room (by id) or an opening (by the name of its node).
#[must_use]
pub fn owned_name(id: &impl Display, owner: &str) -> String {
    let mut name = String::with_capacity(16 + owner.len());
    // Writing to a text does not fail.
    let _ = write!(name, "{id}{OF}");
    name.push_str(owner);
    name
}

/// The owner in the name of a node, also of one that an editor has copied: `101` in `desk.1@101` and `desk.1@101.002`.
///
/// `id` is what the node itself says it is. A room may be called `1.001` itself; a copy of what was baked never has
/// another id.
#[must_use]
pub fn owner_in_name<'n>(name: &'n str, id: &ObjectId) -> Option<&'n str> {
    let (before, owner) = name.split_once(OF)?;
    let is_copy = |number: &str| number.len() == 3 && number.bytes().all(|byte| byte.is_ascii_digit());
    let original = owner.rsplit_once('.').filter(|(_, number)| is_copy(number)).map(|(owner, _)| owner);
    (original.is_some() || before == id.to_string()).then_some(original.unwrap_or(owner))
}

/// Name of the mesh of a variant of a class: `desk.3@modern/oak`, from the second look on `desk.3@modern/oak#2`.
#[must_use]
pub fn model_name(variant: &VariantId, geometry: &str, palette: &str, look: usize) -> String {
    let mut name = format!("{variant}{OF}{geometry}/{palette}");
    if look > 1 {
        let _ = write!(name, "#{look}");
    }
    name
}

/// The variant in the name of a mesh: the other way of [`model_name`].
#[must_use]
pub fn model_in_name(name: &str) -> Option<VariantId> {
    let (class, number) = name.split_once(OF)?.0.rsplit_once('.')?;
    Some(VariantId { class: class.to_owned(), number: number.parse().ok()? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_rooms_and_models_also_of_copies() {
        let desk = ObjectId::new("desk", 1);
        let owner = |name: &str| owner_in_name(name, &desk).map(str::to_owned);
        assert_eq!(owner(&owned_name(&desk, "101")).as_deref(), Some("101"));
        assert_eq!(owner("desk.1@101.002").as_deref(), Some("101"));
        assert_eq!(owner("favourite desk"), None);
        assert_eq!(room_in_name(&room_name("1.001")), Some("1.001"));
        let chair = VariantId { class: "arm_chair".to_owned(), number: 3 };
        for look in [1, 2] {
            assert_eq!(model_in_name(&model_name(&chair, "plain", "oak", look)), Some(chair.clone()));
        }
        assert_eq!(model_in_name("Cube.001"), None);
    }
}
