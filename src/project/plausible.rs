//! Warns of rooms with an unusual size for their type, which may have a wrong unit or comma.

use std::collections::BTreeMap;
use std::path::Path;

use crate::catalog::{Catalog, Plausible};
use crate::document::{Fault, Faults};
use crate::plan::{Plan, Room};

/// The measure of a room that is unusual.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Measure {
    Area,
    Height,
}

/// Rooms of one building and type that are asked about for the same reason.
struct Question {
    /// The first of them: where it is, and its measure.
    place: String,
    measured: f64,
    count: usize,
}

/// Warnings about rooms beyond what is plausible for their type: one per building, room type and measure, naming the first room.
pub(crate) fn check_plausible(plan: &Plan, catalog: &Catalog) -> Faults {
    let mut questions: BTreeMap<(&str, &str, Measure), Question> = BTreeMap::new();
    for placed in &plan.buildings {
        for level in &placed.building.levels {
            for room in &level.rooms {
                let Some(room_type) = catalog.room_types.get(&room.room_type) else { continue };
                for (measure, measured) in beyond(room, &room_type.plausible) {
                    let place = || format!("{}/{}/{}", placed.id, level.id, room.id);
                    questions
                        .entry((&placed.id, &room.room_type, measure))
                        .or_insert_with(|| Question { place: place(), measured, count: 0 })
                        .count += 1;
                }
            }
        }
    }
    let faults = questions.iter().map(|((_, room_type, measure), question)| {
        fault(room_type, *measure, question, &catalog.room_types[*room_type].plausible)
    });
    Faults(faults.collect())
}

/// The measures of a room that are beyond their bounds.
fn beyond(room: &Room, plausible: &Plausible) -> Vec<(Measure, f64)> {
    let is_within = |value: f64, (least, most): (f64, f64)| (least..=most).contains(&value);
    let area = room.region.area();
    let measures = [(Measure::Area, area, plausible.area), (Measure::Height, room.height, plausible.height)];
    let found = measures.into_iter().filter(|(_, value, bounds)| !is_within(*value, *bounds));
    found.map(|(measure, value, _)| (measure, value)).collect()
}

fn fault(room_type: &str, measure: Measure, question: &Question, plausible: &Plausible) -> Fault {
    let Question { place, measured, count } = question;
    let others =
        if *count > 1 { format!(" (and {} more rooms of the building)", count - 1) } else { String::new() };
    let article = if room_type.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    let kind = format!("{article} {room_type}");
    let (message, (least, most), unit) = match measure {
        Measure::Area => (format!("{kind} of {measured:.1} m²{others}"), plausible.area, "m²"),
        Measure::Height => (format!("{kind} that is {measured:.1} m high{others}"), plausible.height, "m"),
    };
    let hint = format!(
        "{least} to {most} {unit} are usual: is the unit right, and the type? `plausible` in a room type says otherwise"
    );
    Fault::of_file(Path::new(place), message).with_hint(hint).as_warning()
}
