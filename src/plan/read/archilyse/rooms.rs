//! Finds the room types for the words of areas, with one warning for each unknown word.

use std::collections::BTreeMap;

use super::NAME;
use super::areas::{Area, Outline};
use super::tables::Table;
use crate::document::{Fault, FaultSeverity, Faults, PathStep};
use crate::plan::RoomWords;
use crate::plan::read::foreign::{TypeOfWord, unknown_words};

/// The room type of guest toilets, which the format does not distinguish from bathrooms.
const TOILET_TYPE: &str = "toilet";

/// Areas of a file with their outlines, by place in the file.
pub(super) type Outlined<'a> = Vec<(&'a Area, Vec<Outline>)>;

/// The outlines of all areas of a table; an area whose text is no polygon is left out and reported at its place.
pub(super) fn outlined<'a>(areas: &'a Table<Area>, faults: &mut Faults) -> Outlined<'a> {
    let mut outlined = Vec::new();
    for (index, area) in areas.rows() {
        match area.outlines() {
            Ok(outlines) => outlined.push((area, outlines)),
            Err(message) => {
                let path = [PathStep::from(index), "scaled_polygon".into()];
                let hint = Some("POLYGON ((x y, ...)) in metres is needed".to_owned());
                faults.push(areas.source.fault(&path, message, hint, FaultSeverity::Error));
            }
        }
    }
    outlined
}

/// The type of an area's word; `None` if the table of words lacks it.
pub(crate) fn type_of(words: &RoomWords, word: &str, is_toilet: bool) -> Option<TypeOfWord> {
    if is_toilet && words.known.contains(TOILET_TYPE) {
        return Some(TypeOfWord::known(word, TOILET_TYPE));
    }
    words.room_type(NAME, word).map(|found| TypeOfWord::known(word, found))
}

/// Room types by word, remembering the words that are unknown.
pub(super) struct RoomTypes<'a> {
    words: &'a RoomWords,
    /// word → (id of its first area, how many).
    unknown: BTreeMap<String, (i64, usize)>,
}

impl<'a> RoomTypes<'a> {
    /// Nothing unknown yet.
    pub(super) fn new(words: &'a RoomWords) -> Self {
        Self { words, unknown: BTreeMap::new() }
    }

    /// The type of an area's word; for an unknown one a warning comes later.
    pub(super) fn of(&mut self, area: &Area, is_toilet: bool) -> TypeOfWord {
        let word = area.area_type.as_str();
        if let Some(found) = type_of(self.words, word, is_toilet) {
            return found;
        }
        self.unknown.entry(word.to_owned()).or_insert((area.id, 0)).1 += 1;
        TypeOfWord::unknown(word)
    }

    /// Warnings for unknown words, at their first areas.
    pub(super) fn warnings(&self, areas: &Table<Area>) -> Faults {
        let mut places: BTreeMap<i64, usize> = BTreeMap::new();
        for (index, area) in areas.rows() {
            places.entry(area.id).or_insert(index);
        }
        let warning = |(id, message, hint): (&i64, String, String)| -> Fault {
            let index = places.get(id).copied().unwrap_or_default();
            let path = [index.into(), "area_type".into()];
            areas.source.fault(&path, message, Some(hint), FaultSeverity::Warning)
        };
        Faults(unknown_words(NAME, &self.unknown).map(warning).collect())
    }
}
