//! Code that the readers of foreign formats share.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use std::path::Path;

use super::native::number_of_id;
use crate::disk::{open_regular, open_unpacked, unpacked_name};
use crate::document::{Faults, suggest};
use crate::plan::{GENERIC_ROOM_TYPE, RoomDraft};

/// Metres of the widest door with one leaf, where a format has no word for sliding doors: wider ones slide, as those of balconies.
pub(super) const WIDEST_LEAF: f64 = 1.6;

/// Unknown room words that are reported one by one.
const TOLD_WORDS: usize = 20;

/// The first bytes of a file, or of what it holds, packed, as far as they can be read; none if it is no file, as a pipe, which might
/// hang.
pub(super) fn head(path: &Path, size: u64) -> Vec<u8> {
    let unpacked = open_unpacked(path).map(|(file, _)| first(file, size)).unwrap_or_default();
    if !unpacked.is_empty() {
        return unpacked;
    }
    // What begins as if it were packed, and is not.
    open_regular(path).map(|(file, _)| first(file, size)).unwrap_or_default()
}

/// The first bytes, up to where they can be read: a map that is cut off is one, and its reader says what is wrong with it.
fn first(file: impl Read, size: u64) -> Vec<u8> {
    let mut bytes = Vec::new();
    file.take(size).read_to_end(&mut bytes).unwrap_or_default();
    bytes
}

/// The room type that a word means.
#[derive(Clone, Debug)]
pub(super) struct TypeOfWord {
    /// The room type; that of generic rooms until it is guessed.
    pub(super) room_type: String,
    /// The word, if it has no type: the table lacks it, or marks it as generic.
    pub(super) unknown_word: Option<String>,
}

impl TypeOfWord {
    /// Of a word that the table takes for this type.
    pub(super) fn known(word: &str, room_type: &str) -> Self {
        match room_type {
            GENERIC_ROOM_TYPE => Self::unknown(word),
            _ => Self { room_type: room_type.to_owned(), unknown_word: None },
        }
    }

    /// Of a word that the table does not know.
    pub(super) fn unknown(word: &str) -> Self {
        Self { room_type: GENERIC_ROOM_TYPE.to_owned(), unknown_word: Some(word.to_owned()) }
    }
}

/// Fact and hint about each room word that the table does not know, at its first place; of many words the last counts the
/// others. `unknown` holds the first place of a word, and how many rooms have it.
pub(super) fn unknown_words<'a, P>(
    format: &'a str,
    unknown: &'a BTreeMap<String, (P, usize)>,
) -> impl Iterator<Item = (&'a P, String, String)> {
    let told = unknown.iter().take(TOLD_WORDS);
    let told = told.map(|(word, (place, count))| (place, format!("unknown room word \"{word}\""), *count));
    let others = || unknown.values().skip(TOLD_WORDS);
    let words = match others().count() {
        1 => "1 more unknown room word".to_owned(),
        count => format!("{count} more unknown room words"),
    };
    let count = others().map(|(_, count)| count).sum();
    told.chain(others().next().map(|(place, _)| (place, words, count))).map(move |(place, words, count)| {
        let rooms = if count == 1 { "1 room is".to_owned() } else { format!("{count} rooms are") };
        let message = format!("{words}: {rooms} guessed by shape and neighbours");
        (place, message, format!("add it under formats.{format} in a room_words.yaml of yours"))
    })
}

/// The files of a folder of a format.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parts {
    /// Those without which there is no plan.
    pub(crate) needed: &'static [&'static str],
    /// Those that may be there as well.
    pub(crate) others: &'static [&'static str],
}

/// The message for a folder that lacks some files: the fact, and the files found instead.
pub(super) fn missing_parts(folder: &Path, parts: Parts) -> (String, String) {
    missing_files(folder, parts.needed, parts.others)
}

/// As [`missing_parts`], of files that are worked out.
pub(super) fn missing_files(folder: &Path, needed: &[&str], others: &[&str]) -> (String, String) {
    let missing: Vec<&str> = needed.iter().copied().filter(|name| !folder.join(name).is_file()).collect();
    let names: Vec<String> = missing.iter().map(|name| format!("\"{name}\"")).collect();
    let fact = format!("has no {}", names.join(" and no "));
    let mut here = names_here(folder, needed);
    here.retain(|name| !others.contains(&name.as_str()));
    let near = missing.iter().filter_map(|name| Some((name, suggest(name, &here)?)));
    let renamed: Vec<String> = near.map(|(name, here)| format!("\"{here}\" as \"{name}\"")).collect();
    let hint = match (renamed.is_empty(), here.is_empty()) {
        (false, _) => format!("perhaps it should be named otherwise: {}", renamed.join(", ")),
        (true, false) => format!("here lie {}", here.join(", ")),
        (true, true) => "nothing else of this kind lies here".to_owned(),
    };
    (fact, hint)
}

/// Names of files of a folder with the endings of the needed ones, but for these.
fn names_here(folder: &Path, needed: &[&str]) -> Vec<String> {
    /// Names that a hint lists.
    const MOST: usize = 12;
    let ending = |name: &str| Path::new(name).extension().map(|ending| ending.to_ascii_lowercase());
    let entries = std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
    let mut here: Vec<String> = entries
        .filter(|entry| entry.path().is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| !needed.contains(&name.as_str()))
        .filter(|name| needed.iter().any(|needed| ending(needed) == ending(name)))
        .collect();
    here.sort();
    here.truncate(MOST);
    here
}

/// A name that reads well in paths: small letters and digits, one `_` for all between. The storey "-1" is `minus_1`, not that above the
/// ground.
pub(super) fn slug(name: &str) -> String {
    const MINUS: [char; 2] = ['-', '\u{2212}'];
    let mut slug = String::new();
    let mut before = ' ';
    let mut letters = name.chars().peekable();
    while let Some(letter) = letters.next() {
        let is_number = letters.peek().is_some_and(char::is_ascii_digit);
        let is_sign = MINUS.contains(&letter) && before == ' ' && is_number;
        before = letter;
        if letter.is_ascii_alphanumeric() {
            slug.push(letter.to_ascii_lowercase());
        } else if is_sign {
            slug.push_str("minus_");
        } else if !slug.is_empty() && !slug.ends_with('_') {
            slug.push('_');
        }
    }
    slug.trim_end_matches('_').to_owned()
}

/// The id of a building that only its file names; `otherwise` for a name without a Latin letter or digit.
pub(super) fn id_of_file(path: &Path, otherwise: &str) -> String {
    let id = slug(&unpacked_name(path).file_stem().unwrap_or_default().to_string_lossy());
    if id.is_empty() { otherwise.to_owned() } else { id }
}

/// Ids that are given already: those of a file's buildings, of a building's levels, or of a level's rooms or openings.
#[derive(Debug, Default)]
pub(super) struct UniqueIds {
    taken: BTreeSet<String>,
    /// The number to try next behind an id, so that a thousand rooms of one name take no million steps.
    next: BTreeMap<String, usize>,
}

impl UniqueIds {
    /// The id; where it is taken, with `_2`, `_3` and so on behind it.
    pub(super) fn numbered(&mut self, id: &str) -> String {
        let next = self.next.entry(id.to_owned()).or_insert(1);
        loop {
            let own = if *next == 1 { id.to_owned() } else { format!("{id}_{next}") };
            *next += 1;
            if self.taken.insert(own.clone()) {
                return own;
            }
        }
    }

    /// As [`Self::numbered`], of the [`slug`] of a name; `otherwise` for a name without a Latin letter or digit.
    pub(super) fn of_name(&mut self, name: &str, otherwise: &str) -> String {
        let slug = slug(name);
        self.numbered(if slug.is_empty() { otherwise } else { &slug })
    }

    /// The first of several ids that is neither empty nor taken.
    pub(super) fn first_free(&mut self, ids: impl IntoIterator<Item = String>) -> Option<String> {
        ids.into_iter().find(|id| !id.is_empty() && self.taken.insert(id.clone()))
    }
}

impl FromIterator<String> for UniqueIds {
    fn from_iter<T: IntoIterator<Item = String>>(taken: T) -> Self {
        Self { taken: taken.into_iter().collect(), next: BTreeMap::new() }
    }
}

/// Gives the rooms of a level the numbers of their ids, on which their seeds depend: a room keeps its furniture where others are
/// added before it. Of two with one number the first has it.
pub(super) fn number_rooms(rooms: &mut [RoomDraft]) {
    let mut taken = BTreeSet::new();
    for room in rooms {
        let number = number_of_id(&room.id);
        room.number = taken.insert(number).then_some(number);
    }
}

/// Both values, or the faults of both.
pub(super) fn both<A, B>(first: Result<A, Faults>, second: Result<B, Faults>) -> Result<(A, B), Faults> {
    match (first, second) {
        (Ok(first), Ok(second)) => Ok((first, second)),
        (first, second) => {
            let mut faults = first.err().unwrap_or_default();
            faults.merge(second.err().unwrap_or_default());
            Err(faults)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_building_is_named_as_its_file_without_the_ending() {
        assert_eq!(id_of_file(Path::new("plans/My flat (2).json"), "plan"), "my_flat_2");
        assert_eq!(id_of_file(Path::new("未命名.json"), "plan"), "plan");
    }

    #[test]
    fn storeys_below_the_ground_have_other_ids_than_those_above() {
        let names = ["-1", "1", "Level -2", "Level - 2", "B-2", "2024-01", "\u{2212}3 Keller"];
        let slugs = ["minus_1", "1", "level_minus_2", "level_2", "b_2", "2024_01", "minus_3_keller"];
        assert_eq!(names.map(slug), slugs);
    }

    #[test]
    fn no_two_ids_are_equal() {
        let mut ids = UniqueIds::default();
        let names = ["Bad", "Bad 2", "bad", "Bad", "厨房"];
        assert_eq!(names.map(|name| ids.of_name(name, "room")), ["bad", "bad_2", "bad_3", "bad_4", "room"]);
        let first_free = |ids: &mut UniqueIds, wanted: [&str; 3]| ids.first_free(wanted.map(str::to_owned));
        assert_eq!(first_free(&mut ids, ["", "bad", "7"]).as_deref(), Some("7"));
        assert_eq!(first_free(&mut ids, ["", "bad", "7"]), None);
        let mut others: UniqueIds = ["a".to_owned()].into_iter().collect();
        assert_eq!(["a", "a"].map(|id| others.numbered(id)), ["a_2", "a_3"]);
    }

    #[test]
    fn thousands_of_unknown_words_are_counted_instead_of_listed() {
        let words = |count: usize| -> BTreeMap<String, (usize, usize)> {
            (0..count).map(|number| (format!("w{number:04}"), (number, 2))).collect()
        };
        let told = |count: usize| -> Vec<String> {
            unknown_words("ifc", &words(count)).map(|(_, message, _)| message).collect()
        };
        assert_eq!(told(5000).len(), TOLD_WORDS + 1);
        let last = told(5000).pop().expect("a message");
        assert_eq!(last, "4980 more unknown room words: 9960 rooms are guessed by shape and neighbours");
        assert!(told(21)[20].starts_with("1 more unknown room word: 2 rooms"));
        assert_eq!(told(20).len(), 20);
        assert!(told(0).is_empty());
    }
}
