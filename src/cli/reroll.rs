//! Another seed for one room.

use std::fmt;
use std::path::Path;

use crate::document::{Fault, Faults, did_you_mean};
use crate::edits::EditBook;
use crate::plan::{PlacedBuilding, Plan};

/// A room with its new seed.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Rolled {
    /// Building, level, room.
    pub(crate) names: [String; 3],
    /// The seed that its furniture has now.
    pub(crate) seed: u64,
}

impl fmt::Display for Rolled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: seed {}", self.names.join("/"), self.seed)
    }
}

/// Gives a room, named `[BUILDING/][LEVEL/]ROOM`, the seed after the one that it has: its own, else that of the run.
///
/// # Errors
/// If there is no such room, or more than one.
pub(crate) fn reroll(
    plan: &Plan,
    edits: &mut EditBook,
    run_seed: u64,
    named: &str,
) -> Result<Rolled, Faults> {
    let [building, level, room] = find(plan, named)?;
    let own = edits.level(&building, &level).and_then(|edits| edits.room(&room)?.seed);
    let seed = own.unwrap_or(run_seed).wrapping_add(1);
    edits.pin(&building, &level, &room, seed);
    Ok(Rolled { names: [building, level, room], seed })
}

fn find(plan: &Plan, named: &str) -> Result<[String; 3], Faults> {
    let names: Vec<[&str; 3]> = plan.buildings.iter().flat_map(room_names).collect();
    let means = |names: &&[&str; 3]| (0..3).any(|skipped| names[skipped..].join("/") == named);
    let found: Vec<&[&str; 3]> = names.iter().filter(means).collect();
    let fault = |message: String| Fault::of_file(Path::new("ROOM"), message);
    match found.as_slice() {
        [one] => Ok(one.map(str::to_owned)),
        [] => {
            let known = names.iter().flat_map(|names| [names[2].to_owned(), names.join("/")]);
            let fault = fault(format!("no room \"{named}\""));
            Err(did_you_mean(named, known).map_or(fault.clone(), |hint| fault.with_hint(hint)).into())
        }
        several => {
            let fault = fault(format!("{} rooms are called \"{named}\"", several.len()));
            let some: Vec<String> = several.iter().take(5).map(|names| names.join("/")).collect();
            Err(fault.with_hint(format!("write it in full: {}", some.join(", "))).into())
        }
    }
}

/// Building, level and room of each room.
fn room_names(placed: &PlacedBuilding) -> impl Iterator<Item = [&str; 3]> {
    let levels = placed.building.levels.iter();
    levels.flat_map(|level| level.rooms.iter().map(|room| [&*placed.id, &*level.id, &*room.id]))
}
