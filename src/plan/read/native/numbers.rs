//! Gives rooms the numbers that their seeds depend on.

use std::collections::BTreeSet;

use sha2::{Digest, Sha256};

use super::level_parts::LevelParts;
use super::report::{Report, step};

/// Gives every room without a number one made from its id, so that a room added to a plan, or taken out,
/// leaves the furniture of all others as it is. Numbers that are written down stay; equal ones are faults.
pub(super) fn number_rooms(parts: &mut LevelParts, report: &mut Report<'_>) {
    let mut taken = BTreeSet::new();
    for (index, room) in parts.draft.rooms.iter().enumerate() {
        if let Some(number) = room.number.filter(|number| !taken.insert(*number)) {
            let path = step(&parts.origins.rooms[index].path, "number");
            let hint = Some("numbers of rooms are unique in a level".to_owned());
            report.error(&path, format!("number {number} of room \"{}\" is taken", room.id), hint);
        }
    }
    // In the order of ids, so that the order of rooms in the file does not matter where two numbers meet.
    let order: Vec<usize> = parts.names.values().copied().collect();
    for index in order {
        let room = &mut parts.draft.rooms[index];
        if room.number.is_none() {
            let mut number = number_of_id(&room.id);
            while !taken.insert(number) {
                number = number.wrapping_add(1);
            }
            room.number = Some(number);
        }
    }
}

/// The first bytes of the id's SHA-256.
pub(crate) fn number_of_id(id: &str) -> u32 {
    let hash = Sha256::digest(id.as_bytes());
    u32::from_be_bytes([hash[0], hash[1], hash[2], hash[3]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_ids_never_change() {
        assert_eq!(number_of_id("kitchen"), number_of_id("kitchen"));
        assert_eq!(number_of_id(""), 0xe3b0_c442, "the first bytes of the SHA-256 of nothing");
    }
}
