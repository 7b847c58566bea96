//! Replaces unprintable characters in names and ids: a line break in one would start a line of its own in logs and lists.

use crate::document::{Fault, is_unprintable, printable};
use crate::plan::{BuildingDraft, LeafDraft, LevelDraft};

/// Replaces such signs in everything that a draft names; the first name that had some, and how many others.
pub(super) fn replace_unprintable(draft: &mut BuildingDraft) -> Option<(String, usize)> {
    let mut found: Vec<String> = Vec::new();
    let mut mend = |text: &mut String, sign: char| {
        if text.contains(is_unprintable) {
            found.push(printable(text));
            *text = text.chars().map(|letter| if is_unprintable(letter) { sign } else { letter }).collect();
        }
    };
    draft.name.iter_mut().for_each(|name| mend(name, ' '));
    draft.attribution.iter_mut().for_each(|text| mend(text, ' '));
    for level in &mut draft.levels {
        mend(&mut level.name, ' ');
        mend(&mut level.id, '_');
        names_of(level, &mut mend);
    }
    let first = found.first().cloned()?;
    Some((first, found.len() - 1))
}

fn names_of(level: &mut LevelDraft, mend: &mut impl FnMut(&mut String, char)) {
    for room in &mut level.rooms {
        mend(&mut room.id, '_');
        room.name.iter_mut().for_each(|name| mend(name, ' '));
        room.dwelling.iter_mut().for_each(|name| mend(name, ' '));
        room.unknown_word.iter_mut().for_each(|word| mend(word, ' '));
    }
    for opening in &mut level.openings {
        mend(&mut opening.id, '_');
        opening.rooms.iter_mut().for_each(|room| mend(room, '_'));
        if let LeafDraft::Swing { into: Some(room), .. } = &mut opening.leaf {
            mend(room, '_');
        }
    }
}

/// The fault of a file with such names.
pub(super) fn replaced(file: &std::path::Path, first: &str, others: usize) -> Fault {
    let more = if others == 0 { String::new() } else { format!(", and {others} more names") };
    let message = format!("the name \"{first}\"{more}: signs that cannot be printed");
    Fault::of_file(file, message).as_warning().with_hint("they were replaced by spaces and underscores")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::RoomDraft;

    #[test]
    fn a_newline_in_an_id_does_not_start_a_line() {
        let room = RoomDraft {
            id: "a\n::warning::b".to_owned(),
            name: Some("Ba\u{fffe}th".to_owned()),
            unknown_word: Some("x\ny".to_owned()),
            ..RoomDraft::default()
        };
        let level = LevelDraft { id: "ground".to_owned(), rooms: vec![room], ..LevelDraft::default() };
        let mut draft =
            BuildingDraft { name: Some("Haus".to_owned()), levels: vec![level], ..BuildingDraft::default() };
        let found = replace_unprintable(&mut draft);
        assert_eq!(found, Some(("a\\n::warning::b".to_owned(), 2)));
        let room = &draft.levels[0].rooms[0];
        assert_eq!((room.id.as_str(), room.name.as_deref()), ("a_::warning::b", Some("Ba th")));
        assert_eq!(room.unknown_word.as_deref(), Some("x y"));
        assert_eq!(replace_unprintable(&mut draft), None);
    }
}
