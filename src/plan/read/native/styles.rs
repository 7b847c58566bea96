//! Checks the styles that a plan or a project names.

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
        check_rooms(&path, &level.rooms, words, report);
    }
}

fn check_rooms(path: &[PathStep], rooms: &[RoomFile], words: &RoomWords, report: &mut Report<'_>) {
    for (index, room) in rooms.iter().enumerate() {
        check_style(&item(path, "rooms", index), room.style.as_ref(), words, report);
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

/// Takes the styles away that do not exist, so that no later stage meets them.
pub(super) fn drop_unknown(draft: &mut BuildingDraft, words: &RoomWords) {
    for room in draft.levels.iter_mut().flat_map(|level| &mut level.rooms) {
        room.style = room.style.take().filter(|style| words.has_style(style));
    }
}
