//! Faults that differ in names and numbers alone: the first few are listed, and one line counts the others.

use std::collections::BTreeMap;

use super::Faults;

/// Warnings, and errors, of one kind that are listed.
const LISTED_WARNINGS: usize = 20;
const LISTED_ERRORS: usize = 200;

/// The same faults in the same order, of each kind no more than so many; behind the last of a kind stands how many others there are.
pub(crate) fn first_of_each_kind(faults: Faults) -> Faults {
    let mut counts: BTreeMap<(bool, String), usize> = BTreeMap::new();
    let kinds: Vec<(bool, String)> =
        faults.0.iter().map(|fault| (fault.is_error(), kind(&fault.message))).collect();
    for kind in &kinds {
        *counts.entry(kind.clone()).or_default() += 1;
    }
    let mut passed: BTreeMap<&(bool, String), usize> = BTreeMap::new();
    let mut listed = Faults::default();
    for (mut fault, kind) in faults.0.into_iter().zip(&kinds) {
        let place = passed.entry(kind).or_default();
        *place += 1;
        let most = if fault.is_error() { LISTED_ERRORS } else { LISTED_WARNINGS };
        let others = counts.get(kind).map_or(0, |count| count - most.min(*count));
        // One more is no longer than the line that counts it.
        if *place > most + 1 {
            continue;
        }
        if *place > most && others > 1 {
            fault.message = format!("{} (and {} more like it)", fault.message, others - 1);
        }
        listed.push(fault);
    }
    listed
}

/// A message without its names and numbers.
fn kind(message: &str) -> String {
    let unquoted: String = message.split('"').step_by(2).collect();
    unquoted.chars().filter(|letter| !letter.is_ascii_digit()).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::document::Fault;

    fn messages(faults: Faults) -> Vec<String> {
        first_of_each_kind(faults).0.into_iter().map(|fault| fault.message).collect()
    }

    fn sealed(count: usize) -> impl Iterator<Item = Fault> {
        (0..count).map(|room| {
            Fault::of_file(Path::new("a.yaml"), format!("room \"r{room}\" has no way in")).as_warning()
        })
    }

    #[test]
    fn of_many_warnings_of_a_kind_the_first_are_listed_and_the_others_counted() {
        let other = Fault::of_file(Path::new("a.yaml"), "room \"r0\" is 7 m long");
        let all = messages(Faults(sealed(500).chain([other]).collect()));
        assert_eq!(all.len(), LISTED_WARNINGS + 2);
        assert_eq!(all[LISTED_WARNINGS], "room \"r20\" has no way in (and 479 more like it)");
        assert_eq!(all[LISTED_WARNINGS + 1], "room \"r0\" is 7 m long");
    }

    #[test]
    fn one_more_is_listed_like_the_others() {
        let all = messages(Faults(sealed(LISTED_WARNINGS + 1).collect()));
        assert_eq!(all.last().map(String::as_str), Some("room \"r20\" has no way in"));
    }

    #[test]
    fn more_errors_than_warnings_are_listed() {
        let errors =
            (0..1_000).map(|room| Fault::of_file(Path::new("a.yaml"), format!("room {room} crosses itself")));
        assert_eq!(messages(Faults(errors.collect())).len(), LISTED_ERRORS + 1);
    }
}
