//! Turns ids of buildings and levels into names that every file system accepts.
//!
//! Letters, digits, `.`, `_` and `-` stay; every other byte becomes `%XX`, so that no name depends on
//! Unicode normalisation, separators or shells. `~` is kept for our own use: it marks what an id cannot say.

use std::collections::BTreeMap;

use sha2::{Digest, Sha256};

/// Longest file name without its extension in bytes; common file systems end at 255, archives earlier.
const LONGEST_NAME: usize = 120;

/// Hexadecimal digits of the id's hash in a name that had to be shortened or made unique.
const MARK_LENGTH: usize = 8;

/// Names that Windows keeps for devices, with any extension.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];

/// Device names that end in one digit from 1 to 9.
const NUMBERED_DEVICES: [&str; 2] = ["com", "lpt"];

/// A name for each id, in the order given: safe on its own, and different from all others even where the
/// file system ignores case.
pub(crate) fn distinct_names(ids: &[&str]) -> Vec<String> {
    let names: Vec<String> = ids.iter().map(|id| safe_name(id)).collect();
    let mut spellings: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for (name, id) in names.iter().zip(ids) {
        let same = spellings.entry(name.to_ascii_lowercase()).or_default();
        if !same.contains(id) {
            same.push(id);
        }
    }
    let tell_apart = |(name, id): (String, &&str)| match spellings[&name.to_ascii_lowercase()].len() {
        1 => name,
        _ => marked(&name, id),
    };
    names.into_iter().zip(ids).map(tell_apart).collect()
}

/// Whether a name is one that [`distinct_names`] gives to an id, among whatever others.
pub(crate) fn is_name_of(id: &str, name: &str) -> bool {
    let plain = safe_name(id);
    name == plain || name == marked(&plain, id)
}

/// Whether a name could be one that [`distinct_names`] gives, with an extension or without.
pub(crate) fn is_safe_name(name: &str) -> bool {
    let is_of_safe_letters = name.bytes().all(|byte| is_plain(byte) || matches!(byte, b'%' | b'~'));
    !name.is_empty()
        && is_of_safe_letters
        && !name.starts_with('.')
        && !name.ends_with('.')
        && !is_device(name)
}

/// The name of one id, not yet compared with others.
fn safe_name(id: &str) -> String {
    if id.is_empty() {
        return "~".to_owned();
    }
    let mut name = String::with_capacity(id.len());
    for (index, &byte) in id.as_bytes().iter().enumerate() {
        // A leading dot hides the file, a trailing one is dropped by Windows; `.` and `..` are both.
        let is_outer_dot = byte == b'.' && (index == 0 || index + 1 == id.len());
        if is_plain(byte) && !is_outer_dot {
            name.push(char::from(byte));
        } else {
            push_encoded(&mut name, byte);
        }
    }
    if is_reserved(&name) {
        let first = name.remove(0);
        let mut encoded = String::new();
        push_encoded(&mut encoded, u8::try_from(first).expect("reserved names are ASCII"));
        name.insert_str(0, &encoded);
    }
    if name.len() > LONGEST_NAME { marked(&name[..LONGEST_NAME], id) } else { name }
}

fn is_plain(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'_' | b'-')
}

fn push_encoded(name: &mut String, byte: u8) {
    const DIGITS: &[u8; 16] = b"0123456789ABCDEF";
    name.push('%');
    name.push(char::from(DIGITS[usize::from(byte >> 4)]));
    name.push(char::from(DIGITS[usize::from(byte & 0xF)]));
}

/// Names that stand for something else.
fn is_reserved(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    lower == crate::output::SHARED_GEOMETRY || super::manifest::is_manifest_name(&lower) || is_device(name)
}

/// Windows looks at what stands before the first dot only.
fn is_device(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    let stem = lower.split('.').next().unwrap_or_default();
    let is_numbered = |word: &&str| {
        stem.strip_prefix(*word)
            .is_some_and(|rest| rest.len() == 1 && rest.bytes().all(|byte| (b'1'..=b'9').contains(&byte)))
    };
    DEVICES.contains(&stem) || NUMBERED_DEVICES.iter().any(is_numbered)
}

/// The name with a mark that depends on the exact id.
fn marked(name: &str, id: &str) -> String {
    let hash = crate::disk::to_hex(&Sha256::digest(id.as_bytes()));
    format!("{name}~{}", &hash[..MARK_LENGTH])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn plain_ids_keep_their_name() {
        assert_eq!(safe_name("hotel-12_b.2"), "hotel-12_b.2");
    }

    #[test]
    fn separators_spaces_and_letters_beyond_ascii_are_encoded() {
        assert_eq!(safe_name("a/b\\c"), "a%2Fb%5Cc");
        assert_eq!(safe_name("1 этаж"), "1%20%D1%8D%D1%82%D0%B0%D0%B6");
        assert_eq!(safe_name("100%"), "100%25");
    }

    #[test]
    fn dots_cannot_leave_or_hide() {
        assert_eq!(safe_name("."), "%2E");
        assert_eq!(safe_name(".."), "%2E%2E");
        assert_eq!(safe_name("../../etc"), "%2E.%2F..%2Fetc");
        assert_eq!(safe_name(".roomwright"), "%2Eroomwright");
        assert_eq!(safe_name("end."), "end%2E");
    }

    #[test]
    fn names_of_devices_and_of_the_programs_own_files_are_avoided() {
        assert_eq!(safe_name("CON"), "%43ON");
        assert_eq!(safe_name("nul.txt"), "%6Eul.txt");
        assert_eq!(safe_name("com7"), "%63om7");
        assert_eq!(safe_name("com0"), "com0");
        assert_eq!(safe_name("manifest.json"), "%6Danifest.json");
    }

    #[test]
    fn ids_that_differ_in_case_only_get_different_names() {
        let names = distinct_names(&["EG", "eg", "OG"]);
        assert_ne!(names[0].to_lowercase(), names[1].to_lowercase());
        assert!(names[0].starts_with("EG~"));
        assert_eq!(names[2], "OG");
    }

    #[test]
    fn the_same_id_twice_is_the_same_name() {
        assert_eq!(distinct_names(&["eg", "eg"]), ["eg", "eg"]);
    }

    #[test]
    fn a_long_id_is_shortened_and_stays_unique() {
        let (one, two) = ("ю".repeat(200), format!("{}x", "ю".repeat(200)));
        let names = distinct_names(&[&one, &two]);
        assert!(names.iter().all(|name| name.len() <= LONGEST_NAME + 1 + MARK_LENGTH));
        assert_ne!(names[0], names[1]);
    }

    proptest! {
        #[test]
        fn any_two_ids_get_different_safe_names(one in ".*", two in ".*") {
            let names = distinct_names(&[&one, &two]);
            for name in &names {
                prop_assert!(!name.is_empty() && !name.starts_with('.') && !name.ends_with('.'));
                prop_assert!(name.bytes().all(|byte| is_plain(byte) || matches!(byte, b'%' | b'~')));
            }
            prop_assert_eq!(one == two, names[0].eq_ignore_ascii_case(&names[1]));
        }
    }
}
