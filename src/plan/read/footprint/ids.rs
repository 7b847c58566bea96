//! Ids of buildings: those of the file in letters that file names take, or ones made from places.

use std::collections::BTreeSet;

use crate::document::is_unprintable;
use crate::geometry::{Bounds, Point};
use crate::plan::read::native::FILE_NAME_FORBIDDEN;

/// Bytes of the longest id; more is cut off. File names need some for themselves.
const LONGEST: usize = 120;

/// The id of a file in letters that file names take. `way/123` and `relation/123` of exports of OpenStreetMap are `w123` and
/// `r123`, as other exports write them. `None` of a text without a letter.
pub(super) fn id_of_words(words: &str) -> Option<String> {
    let words = words.trim();
    for (long, short) in [("way/", "w"), ("relation/", "r"), ("node/", "n")] {
        if let Some(number) = words.strip_prefix(long).filter(|number| is_number(number)) {
            return Some(format!("{short}{number}"));
        }
    }
    let is_bad = |letter: char| {
        letter.is_whitespace() || is_unprintable(letter) || FILE_NAME_FORBIDDEN.contains(&letter)
    };
    let mut id: String = words.chars().map(|letter| if is_bad(letter) { '_' } else { letter }).collect();
    while id.len() > LONGEST {
        id.pop();
    }
    // A dot in front hides a file, or names a folder.
    (id.chars().any(char::is_alphanumeric) && !id.starts_with('.')).then_some(id)
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// An id made from the middle of an outline, in the coordinates of its file: to 0.1 m, in degrees to about as much.
pub(super) fn id_of_place(corners: &[Point], is_degrees: bool) -> String {
    let Point { x, y } = Bounds::around(corners.iter().copied()).center();
    // Adding zero makes a negative zero positive.
    let rounded = |value: f64, factor: f64| (value * factor).round() / factor + 0.0;
    if is_degrees {
        let (x, y) = (rounded(x, 1e6), rounded(y, 1e6));
        return format!("at_{y:.6}_{x:.6}");
    }
    format!("at_{:.1}_{:.1}", rounded(x, 10.0), rounded(y, 10.0))
}

/// The ids, where those that are there already have `-2`, `-3` and so on behind them.
pub(super) fn unique_ids(ids: Vec<String>) -> Vec<String> {
    let all: BTreeSet<String> = ids.iter().cloned().collect();
    let mut taken = BTreeSet::new();
    // The next number to try of each id that is there more than once, so that a million of one id are no million squared.
    let mut next = std::collections::BTreeMap::new();
    let mut unique = Vec::with_capacity(ids.len());
    for id in ids {
        if taken.insert(id.clone()) {
            unique.push(id);
            continue;
        }
        let number = next.entry(id.clone()).or_insert(2_usize);
        let other = loop {
            let other = format!("{id}-{number}");
            *number += 1;
            if !all.contains(&other) && taken.insert(other.clone()) {
                break other;
            }
        };
        unique.push(other);
    }
    unique
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_have_letters_that_file_names_take() {
        let cases = [
            ("way/123", Some("w123")),
            ("relation/4", Some("r4")),
            ("w123", Some("w123")),
            ("NL.IMBAG.Pand.0796", Some("NL.IMBAG.Pand.0796")),
            ("https://a/b?c", Some("https___a_b_c")),
            ("way/../x", Some("way_.._x")),
            ("a b\n", Some("a_b")),
            ("..", None),
            ("", None),
            ("/", None),
        ];
        for (words, id) in cases {
            assert_eq!(id_of_words(words).as_deref(), id, "{words}");
        }
        assert_eq!(id_of_words(&"ä".repeat(500)).unwrap().len(), LONGEST);
    }

    #[test]
    fn ids_of_places_are_the_same_whatever_the_corner_that_begins() {
        let corners = [Point::new(5.1, 52.1), Point::new(5.2, 52.1), Point::new(5.2, 52.3)];
        assert_eq!(id_of_place(&corners, true), "at_52.200000_5.150000");
        assert_eq!(id_of_place(&[corners[1], corners[2], corners[0]], true), "at_52.200000_5.150000");
        assert_eq!(id_of_place(&[Point::new(-0.01, 7.26)], false), "at_0.0_7.3");
    }

    #[test]
    fn no_two_ids_are_equal() {
        let ids = ["a", "a", "a-2", "a", "b"].map(str::to_owned).to_vec();
        assert_eq!(unique_ids(ids), ["a", "a-3", "a-2", "a-4", "b"]);
    }
}
