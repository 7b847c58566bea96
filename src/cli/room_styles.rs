//! Warns of styles that are not made for the type of their room.

use std::collections::BTreeMap;
use std::path::Path;

use crate::catalog::Catalog;
use crate::document::{Fault, Faults};
use crate::plan::Plan;

/// Warnings about rooms whose style is made for other types of rooms: one per style and room type and building,
/// naming the first room. Styles that do not exist are reported by the plan reader.
pub(crate) fn check_room_styles(plan: &Plan, catalog: &Catalog) -> Faults {
    let mut first_rooms: BTreeMap<(&str, &str, &str), String> = BTreeMap::new();
    for placed in &plan.buildings {
        for level in &placed.building.levels {
            for room in &level.rooms {
                let Some(style) = &room.style else { continue };
                let place = || format!("{}/{}/{}", placed.id, level.id, room.id);
                first_rooms.entry((&placed.id, style, &room.room_type)).or_insert_with(place);
            }
        }
    }
    let found = first_rooms.iter().filter_map(|((_, style, room_type), place)| {
        let fault = judge(style, room_type, catalog)?;
        Some(Fault { file: Path::new(place).to_owned(), ..fault })
    });
    Faults(found.collect())
}

fn judge(style: &str, room_type: &str, catalog: &Catalog) -> Option<Fault> {
    let known = catalog.styles.get(style)?;
    let suits = known.room_types.is_empty() || known.room_types.iter().any(|one| one == room_type);
    (!suits).then(|| {
        let message = format!("style \"{style}\" is not made for rooms of type \"{room_type}\"");
        let hint = format!("it is made for {}", known.room_types.join(", "));
        Fault::of_file(Path::new(""), message).with_hint(hint).as_warning()
    })
}
