//! Makes the ids of foreign files ones that native plans take: they name files, folders and nodes.

use std::collections::BTreeMap;

use super::foreign::UniqueIds;
use super::native::{FILE_NAME_FORBIDDEN, NODE_NAME_FORBIDDEN, id_fault};
use crate::document::is_unprintable;
use crate::plan::{BuildingDraft, LeafDraft, LevelDraft};

/// Bytes of an id that is cut off, without the number that may follow.
const LONGEST: usize = 120;

/// The id of a building as its folder may be called.
pub(super) fn fit_building_id(id: &str) -> String {
    if id_fault(id, FILE_NAME_FORBIDDEN).is_some() { fit(id, FILE_NAME_FORBIDDEN) } else { id.to_owned() }
}

/// Mends the ids of a building's levels, rooms and openings, where that is needed. Different ids stay different.
pub(super) fn fit_ids(draft: &mut BuildingDraft) {
    fit_all(draft.levels.iter_mut().map(|level| &mut level.id).collect(), FILE_NAME_FORBIDDEN);
    draft.levels.iter_mut().for_each(fit_level);
}

fn fit_level(level: &mut LevelDraft) {
    let rooms = level.rooms.iter_mut().map(|room| &mut room.id).collect();
    let mended = fit_all(rooms, NODE_NAME_FORBIDDEN);
    fit_all(level.openings.iter_mut().map(|opening| &mut opening.id).collect(), NODE_NAME_FORBIDDEN);
    let mend = |room: &mut String| mended.get(room).into_iter().for_each(|mended| room.clone_from(mended));
    for opening in &mut level.openings {
        opening.rooms.iter_mut().for_each(mend);
        if let LeafDraft::Swing { into: Some(room), .. } = &mut opening.leaf {
            mend(room);
        }
    }
}

/// Mends those of some ids that are none; the mended ones by what they were.
fn fit_all(ids: Vec<&mut String>, forbidden: &[char]) -> BTreeMap<String, String> {
    let (unfit, fine): (Vec<&mut String>, Vec<&mut String>) =
        ids.into_iter().partition(|id| id_fault(id, forbidden).is_some());
    let mut taken: UniqueIds = fine.iter().map(|id| (**id).clone()).collect();
    let mut mended: BTreeMap<String, String> = BTreeMap::new();
    for id in unfit {
        let own = mended.entry(id.clone()).or_insert_with(|| taken.numbered(&fit(id, forbidden)));
        id.clone_from(own);
    }
    mended
}

fn fit(id: &str, forbidden: &[char]) -> String {
    let is_bad = |letter: char| is_unprintable(letter) || forbidden.contains(&letter);
    let mut fit: String = id.trim().chars().map(|letter| if is_bad(letter) { '_' } else { letter }).collect();
    while fit.len() > LONGEST {
        fit.pop();
    }
    // A dot in front hides a file, or names a folder.
    let fit = fit.trim_start_matches('.').trim();
    if fit.is_empty() { "_".to_owned() } else { fit.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::{OpeningDraft, OpeningKind, OpeningPlace, RoomDraft};

    #[test]
    fn ids_that_no_native_plan_takes_are_mended_and_stay_different() {
        let room = |id: &str| RoomDraft { id: id.to_owned(), ..RoomDraft::default() };
        let opening = OpeningDraft {
            id: "d/1".to_owned(),
            kind: OpeningKind::Door,
            place: OpeningPlace::Edge { edge: 0, at: 1.0 },
            rooms: vec!["a/b".to_owned(), "c".to_owned()],
            width: 0.9,
            bottom: 0.0,
            top: 2.0,
            leaf: LeafDraft::Swing { hinge_left: true, into: Some("a/b".to_owned()), count: 1, angle: 1.5 },
        };
        let rooms = ["a_b", "a/b", " c ", "c", "..", "", "a:b"].map(room).to_vec();
        let level =
            LevelDraft { id: "0:1".to_owned(), rooms, openings: vec![opening], ..LevelDraft::default() };
        let upper = LevelDraft { id: "0_1".to_owned(), ..LevelDraft::default() };
        let mut draft = BuildingDraft { levels: vec![level, upper], ..BuildingDraft::default() };
        fit_ids(&mut draft);
        let level = &draft.levels[0];
        let ids: Vec<&str> = level.rooms.iter().map(|room| room.id.as_str()).collect();
        assert_eq!(ids, ["a_b", "a_b_2", "c_2", "c", "_", "__2", "a:b"]);
        assert_eq!(level.openings[0].rooms, ["a_b_2", "c"]);
        let LeafDraft::Swing { into, .. } = &level.openings[0].leaf else { panic!("a leaf") };
        assert_eq!((level.openings[0].id.as_str(), into.as_deref()), ("d_1", Some("a_b_2")));
        assert_eq!(draft.levels.iter().map(|level| level.id.as_str()).collect::<Vec<_>>(), ["0_1_2", "0_1"]);
        let mut again = draft.clone();
        fit_ids(&mut again);
        assert_eq!(format!("{again:?}"), format!("{draft:?}"));
    }

    #[test]
    fn buildings_have_ids_that_folders_may_have() {
        let ids = ["a/b:c", "../x", "house", &"x".repeat(500)].map(fit_building_id);
        assert_eq!(ids, ["a_b_c", "_x", "house", &"x".repeat(LONGEST)]);
    }
}
