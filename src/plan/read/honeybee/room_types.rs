//! Finds the room types of spaces by their names and programs, and tells plenums.

use super::model::{Place, Space};
use crate::geometry::signed_area;
use crate::plan::read::foreign::TypeOfWord;
use crate::plan::read::room_names::{TypedNames, plain_words};

/// The section of `formats` in `room_words.yaml`, and the word in the answers of `formats`.
pub(super) const NAME: &str = "ladybug";
/// Square metres from which the zone of a flat is the whole flat and no room of it.
const WHOLE_FLAT: f64 = 30.0;

/// The types of spaces.
pub(super) type Naming<'a> = TypedNames<'a, Place>;

/// The type of a space: by its name, which people gave it, then by its program, which may be that of a whole building.
pub(super) fn type_of(space: &Space, naming: &mut Naming<'_>) -> TypeOfWord {
    let name = name_words(space.name.as_deref());
    let program = program_words(space);
    // The identifier is the name of rooms without another.
    let own = if space.name.is_none() { name_words(Some(&space.identifier)) } else { Vec::new() };
    let said = if program.is_empty() { &name } else { &program };
    naming.of_texts(&[&name, &own, &program], said, || space.place.clone())
}

/// The words of a program: those behind its building, `2019::MidriseApartment::Corridor`.
fn program_words(space: &Space) -> Vec<String> {
    let mut words = name_words(space.program.as_deref().and_then(|program| program.rsplit("::").next()));
    if words.last().is_some_and(|word| word == "apartment") && signed_area(&space.outline).abs() > WHOLE_FLAT
    {
        words = vec!["whole".to_owned(), "apartment".to_owned()];
    }
    words
}

fn name_words(name: Option<&str>) -> Vec<String> {
    plain_words(&spaced(name.unwrap_or_default()))
}

/// A text in which words that begin in capitals, and numbers behind them, stand apart: `ClosedOffice1`.
fn spaced(text: &str) -> String {
    let mut spaced = String::with_capacity(text.len());
    let mut before = ' ';
    for letter in text.chars() {
        let begins = letter.is_uppercase() && before.is_lowercase();
        if begins || (letter.is_numeric() && before.is_alphabetic()) {
            spaced.push(' ');
        }
        spaced.push(letter);
        before = letter;
    }
    spaced
}

/// Whether a space is the hollow between a ceiling and the floor above.
pub(super) fn is_plenum(name: Option<&str>, program: Option<&str>) -> bool {
    let says = |text: Option<&str>| name_words(text).iter().any(|word| word == "plenum");
    says(name) || says(program)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_names_and_programs_stand_apart() {
        assert_eq!(name_words(Some("ClosedOffice1")), ["closed", "office"]);
        assert_eq!(name_words(Some("Kitchen & Dining 101")), ["kitchen", "dining"]);
        assert_eq!(name_words(Some("IT_Room 2.04")), ["it", "room"]);
        assert!(name_words(None).is_empty());
    }

    #[test]
    fn plenums_are_told_by_name_or_program() {
        assert!(is_plenum(Some("Level 2 Plenum"), None));
        assert!(is_plenum(None, Some("2019::MediumOffice::Plenum")) && is_plenum(None, Some("Plenum")));
        assert!(!is_plenum(Some("Plena"), Some("2019::MediumOffice::ClosedOffice")));
    }
}
