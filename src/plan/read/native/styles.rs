//! Checks the styles and households that a plan or a project names.

use super::file::{PlanFile, RoomFile};
use super::report::{Report, item, step};
use crate::document::{PathStep, did_you_mean};
use crate::plan::{BuildingDraft, RoomWords};

/// Reports every style of a plan that does not exist.
///
/// Apart from the other checks, because nothing is lost: the rooms are furnished in the style of the run.
pub(super) fn check_styles(file: &PlanFile, words: &RoomWords, report: &mut Report<'_>) {
    check_style(&[], file.style.as_ref(), words, report);
    for (name, prototype) in &file.prototypes {
        check_rooms(&["prototypes".into(), name.as_str().into()], &prototype.rooms, words, report);
    }
    for (index, level) in file.levels.iter().enumerate() {
        let path = ["levels".into(), index.into()];
        check_style(&path, level.style.as_ref(), words, report);
        check_household(&path, level.household.as_ref(), words, report);
        check_rooms(&path, &level.rooms, words, report);
    }
}

fn check_rooms(path: &[PathStep], rooms: &[RoomFile], words: &RoomWords, report: &mut Report<'_>) {
    for (index, room) in rooms.iter().enumerate() {
        let path = item(path, "rooms", index);
        check_style(&path, room.style.as_ref(), words, report);
        check_household(&path, room.household.as_ref(), words, report);
    }
}

/// Reports the `style` of the value at a document path if it does not exist. Returns whether it does.
pub(crate) fn check_style(
    path: &[PathStep],
    style: Option<&String>,
    words: &RoomWords,
    report: &mut Report<'_>,
) -> bool {
    let Some(unknown) = style.filter(|style| !words.has_style(style)) else { return true };
    let hint = did_you_mean(unknown, &words.styles);
    let hint = hint.unwrap_or_else(|| "see `roomwright catalog styles`".to_owned());
    report.error(&step(path, "style"), format!("unknown style \"{unknown}\""), Some(hint));
    false
}

/// Reports the `household` of the value at a document path if it does not exist.
fn check_household(
    path: &[PathStep],
    household: Option<&String>,
    words: &RoomWords,
    report: &mut Report<'_>,
) {
    if let Some(unknown) = household.filter(|household| !words.has_household(household)) {
        let known = words.households.iter().map(String::as_str).collect::<Vec<_>>().join(", ");
        let hint = did_you_mean(unknown, &words.households).unwrap_or_else(|| format!("there are {known}"));
        report.error(&step(path, "household"), format!("unknown household \"{unknown}\""), Some(hint));
    }
}

/// Takes the styles and households away that do not exist, so that no later stage meets them.
pub(super) fn drop_unknown(draft: &mut BuildingDraft, words: &RoomWords) {
    for room in draft.levels.iter_mut().flat_map(|level| &mut level.rooms) {
        room.style = room.style.take().filter(|style| words.has_style(style));
        room.household = room.household.take().filter(|household| words.has_household(household));
    }
}
