//! Checks ids.

use crate::document::is_unprintable;

/// Letters that some system rejects in file names.
pub(crate) const FILE_NAME_FORBIDDEN: &[char] = &['/', '\\', ':', '*', '?', '"', '<', '>', '|'];
/// Letters that would make a node's name a path.
pub(crate) const NODE_NAME_FORBIDDEN: &[char] = &['/'];
/// Most bytes of an id: file systems take 255 for a name with its ending.
const ID_LENGTH_LIMIT: usize = 200;

/// Why a word is no id, if it is none.
pub(crate) fn id_fault(id: &str, forbidden: &[char]) -> Option<String> {
    if id.is_empty() {
        return Some("an id is empty".to_owned());
    }
    if id.len() > ID_LENGTH_LIMIT {
        return Some(format!("an id is {} letters long", id.len()));
    }
    if id == "." || id == ".." || id != id.trim() {
        return Some(format!("\"{id}\" is no id"));
    }
    let bad = id.chars().find(|letter| is_unprintable(*letter) || forbidden.contains(letter))?;
    Some(format!("id \"{}\" holds the letter {bad:?}", id.escape_debug()))
}
