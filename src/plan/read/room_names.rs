//! Finds the room types of names that people give to rooms, in many languages: the longest known words in them.

use std::collections::BTreeMap;

use super::foreign::{TypeOfWord, unknown_words};
use crate::plan::{GENERIC_ROOM_TYPE, RoomWords};

/// Gives rooms the types that their names say, and remembers the names that no table knows. `P` is a place in the file.
#[derive(Debug)]
pub(super) struct TypedNames<'a, P> {
    /// The table.
    pub(super) words: &'a RoomWords,
    /// Sections of `formats` in `room_words.yaml`; hints name the first.
    formats: [&'static str; 2],
    /// Name → (its first place, how many rooms have it).
    unknown: BTreeMap<String, (P, usize)>,
}

impl<'a, P> TypedNames<'a, P> {
    /// Of a format: its own section comes first, if there is one, then that of `ifc`, which has the words of many languages.
    pub(super) fn new(words: &'a RoomWords, format: &'static str) -> Self {
        Self { words, formats: [format, "ifc"], unknown: BTreeMap::new() }
    }

    /// The type of a room by its name; a room without one is guessed, and no unknown word is reported.
    pub(super) fn of_name(&mut self, name: Option<&str>, place: impl FnOnce() -> P) -> TypeOfWord {
        self.of_names(&[name], place)
    }

    /// The same of a room with several names, such as its own and that of its category: the most telling one that is known decides,
    /// of equals the first. If none is known, the first that says anything is reported.
    pub(super) fn of_names(&mut self, names: &[Option<&str>], place: impl FnOnce() -> P) -> TypeOfWord {
        let texts: Vec<Vec<String>> =
            names.iter().map(|name| plain_words(name.unwrap_or_default())).collect();
        let texts: Vec<&[String]> = texts.iter().map(Vec::as_slice).collect();
        let said = texts.iter().copied().find(|text| !text.is_empty()).unwrap_or_default();
        self.of_texts(&texts, said, place)
    }

    /// The type of a room by the words of several texts, as [`most_telling`]; if none is known, `said` is reported.
    pub(super) fn of_texts(
        &mut self,
        texts: &[&[String]],
        said: &[String],
        place: impl FnOnce() -> P,
    ) -> TypeOfWord {
        let found =
            most_telling(texts.iter().filter_map(|text| type_of_words(self.words, &self.formats, text)));
        let is_known = |text: &[String]| type_of_words(self.words, &self.formats, text).is_some();
        // A "Rm 12" that is a "sterilizer" besides: what says more is unknown all the same.
        let found = found.filter(|found| *found != GENERIC_ROOM_TYPE || is_known(said));
        let said = said.join(" ");
        if let Some(found) = found {
            return TypeOfWord::known(&said, found);
        }
        if !said.is_empty() {
            self.unknown.entry(said.clone()).or_insert_with(|| (place(), 0)).1 += 1;
        }
        TypeOfWord::unknown(&said)
    }

    /// Place, fact and hint of each unknown name.
    pub(super) fn unknown(&self) -> impl Iterator<Item = (&P, String, String)> {
        unknown_words(self.formats[0], &self.unknown)
    }
}

/// The room type of the longest run of words that the table of one of the formats knows; of equals the last, which mostly
/// carries the sense ("kitchen store").
pub(super) fn type_of_words<'a>(table: &'a RoomWords, formats: &[&str], words: &[String]) -> Option<&'a str> {
    // Names of rooms are short; what goes on for long is a remark.
    const LONGEST: usize = 12;
    let words = &words[..words.len().min(LONGEST)];
    let runs = (1..=words.len()).rev().flat_map(|length| words.windows(length).rev());
    let of_run = |run: &[String]| {
        let run = run.join(" ");
        formats.iter().find_map(|format| table.room_type(format, &run))
    };
    most_telling(runs.filter_map(of_run))
}

/// The first type, but that of generic rooms only where there is no other: an "office space" is an office.
pub(super) fn most_telling<'a>(types: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let types: Vec<&str> = types.collect();
    types.iter().find(|kind| **kind != GENERIC_ROOM_TYPE).or(types.first()).copied()
}

/// The words of a text in lower case, without numbers: "Bedroom 2.04" and "Bedroom2" are bedrooms.
pub(super) fn plain_words(text: &str) -> Vec<String> {
    let words = text.split(|letter: char| !letter.is_alphanumeric()).filter_map(without_number);
    words.map(str::to_lowercase).collect()
}

/// A word without the number at its end; nothing of numbers, and of codes such as `A102` or `3B`.
fn without_number(word: &str) -> Option<&str> {
    let letters = word.trim_end_matches(char::is_numeric);
    let is_word = !letters.is_empty() && !letters.chars().any(char::is_numeric);
    // One letter before a number is a wing or a floor; in scripts without spaces it is a word.
    let is_code = letters.len() < word.len() && letters.len() == 1;
    (is_word && !is_code).then_some(letters)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::builtin_catalog;
    use crate::plan::read::real_data::published;

    #[test]
    fn numbers_and_signs_are_not_room_words() {
        assert_eq!(plain_words("A-102 Living Room"), ["a", "living", "room"]);
        assert_eq!(plain_words("WC/Dusche 1.04"), ["wc", "dusche"]);
        assert!(plain_words("2.14").is_empty());
        assert_eq!(plain_words("Bedroom2 Du/WC1 卧室1"), ["bedroom", "du", "wc", "卧室"]);
        assert!(plain_words("A102 3B 1OG").is_empty(), "codes of rooms and floors");
    }

    #[test]
    fn the_longest_known_run_counts_and_the_last_of_equals() {
        let table = [
            ("living room", "living_room"),
            ("room", "room"),
            ("kitchen", "kitchen"),
            ("store", "storeroom"),
            ("space", "generic"),
        ];
        let table = table.map(|(word, kind)| (word.to_owned(), kind.to_owned()));
        let words = RoomWords { words: [("ifc".to_owned(), table.into())].into(), ..RoomWords::default() };
        let known = |text: &str| type_of_words(&words, &["ifc"], &plain_words(text));
        assert_eq!(known("Large Living Room 3"), Some("living_room"));
        assert_eq!(known("Kitchen store"), Some("storeroom"));
        assert_eq!(known("Kitchen space"), Some("kitchen"), "a space is no more than a room");
        assert_eq!(known("Space 12"), Some("generic"));
        assert_eq!(known("Planetarium"), None);
    }

    #[test]
    fn of_several_names_the_most_telling_known_one_decides() {
        let table = &builtin_catalog().room_words;
        let mut typed = TypedNames::new(table, "ifc");
        let mut kind = |names: &[Option<&str>]| typed.of_names(names, || ()).room_type;
        assert_eq!(kind(&[Some("Wing A"), Some("Kitchen")]), "kitchen");
        assert_eq!(kind(&[Some("Kitchen"), Some("Space 3")]), "kitchen");
        assert_eq!(kind(&[None, Some("Kitchen")]), "kitchen");
        let mut unknown = TypedNames::new(table, "ifc");
        unknown.of_names(&[None, Some("Zorp 1"), Some("Quux")], || ());
        let told: Vec<String> = unknown.unknown().map(|(_, fact, _)| fact).collect();
        assert!(told.len() == 1 && told[0].contains("zorp"), "{told:?}");
    }

    #[test]
    fn names_of_homes_and_offices_are_known_in_many_languages() {
        let table = &builtin_catalog().room_words;
        let cases = [
            ("Прихожая", "corridor"),
            ("С/У", "bathroom"),
            ("Комната переговоров 3", "meeting_room"),
            ("主卧室", "bedroom"),
            ("会议室2", "meeting_room"),
            ("キッチン", "kitchen"),
            ("화장실", "bathroom"),
            ("Obývací pokoj", "living_room"),
            ("Fürdőszoba", "bathroom"),
            ("Makuuhuone 1", "bedroom"),
            ("YEMEK ODASI", "dining_room"),
            ("Sandėliukas", "storeroom"),
            ("Κουζίνα", "kitchen"),
            ("Spavaća soba", "bedroom"),
            ("חדר שינה", "bedroom"),
            ("Phòng khách", "living_room"),
            ("Bad/WC", "bathroom"),
            ("Mens RR", "restroom_male"),
            ("Conf Rm 12", "meeting_room"),
            ("MECH", "utility_room"),
            ("Living space", "living_room"),
        ];
        for (name, kind) in cases {
            assert_eq!(type_of_words(table, &["ifc"], &plain_words(name)), Some(kind), "{name}");
        }
    }

    #[test]
    fn each_published_function_of_rooms_is_more_than_a_room() {
        let table = &builtin_catalog().room_words;
        let type_of = |word: &str| type_of_words(table, &["ifc"], &plain_words(word));
        for vocabulary in ["omniclass", "din_277"] {
            let mut words = published(vocabulary);
            assert!(words.len() > 100, "{vocabulary}");
            words.retain(|word| matches!(type_of(word), None | Some(GENERIC_ROOM_TYPE)));
            assert!(words.is_empty(), "{vocabulary}: {words:?}");
        }
        assert_eq!(type_of("13-15 31 11: Control Room"), Some("security"), "and no bedroom");
        assert_eq!(type_of("Assembly Hall"), Some("auditorium"), "and no corridor");
    }
}
