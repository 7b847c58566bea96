//! The notation of levels: `0`, `-1`, `0.5`, lists `0;1`, ranges `0-3` and `-1-3` (from -1 to 3).

/// The farthest level from the ground that is believed.
const FARTHEST: i32 = 300;
/// Parts in which levels are counted: stations have landings at `0.5` and `0.25`.
const PARTS: i32 = 100;

/// The number of a level, in hundredths; 0 is the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct LevelNumber(i32);

impl LevelNumber {
    /// Storeys above the ground.
    pub(super) fn storeys(self) -> f64 {
        f64::from(self.0) / f64::from(PARTS)
    }

    /// The id of the level in a plan.
    pub(super) fn id(self) -> String {
        format!("level_{}", self.storeys())
    }
}

/// All levels that words name, sorted, each once.
///
/// # Errors
/// The fault in words.
pub(super) fn levels_of(words: &str) -> Result<Vec<LevelNumber>, String> {
    let mut levels = Vec::new();
    // A bound for texts of separators alone.
    for part in
        words.split([';', ',']).map(str::trim).filter(|part| !part.is_empty()).take(2 * PARTS as usize)
    {
        let (first, last) = range_of(part).ok_or_else(|| {
            format!("level \"{}\" is neither a number nor a range of numbers", shortened(part))
        })?;
        let (low, high) = (first.min(last), first.max(last));
        levels.extend((low..=high).step_by(PARTS as usize).map(LevelNumber));
        levels.push(LevelNumber(high));
    }
    levels.sort_unstable();
    levels.dedup();
    if levels.is_empty() { Err("its level is empty".to_owned()) } else { Ok(levels) }
}

/// A text short enough for a message.
fn shortened(text: &str) -> String {
    text.chars().take(40).collect()
}

/// First and last level of a number or a range, in parts.
fn range_of(part: &str) -> Option<(i32, i32)> {
    // The first sign belongs to the number.
    let middle = part.char_indices().skip(1).find(|(_, letter)| *letter == '-').map(|(at, _)| at);
    match middle {
        None => number_of(part).map(|number| (number, number)),
        Some(at) => Some((number_of(&part[..at])?, number_of(&part[at + 1..])?)),
    }
}

fn number_of(text: &str) -> Option<i32> {
    let text = text.trim();
    let is_number = text.chars().all(|letter| letter.is_ascii_digit() || matches!(letter, '.' | '-' | '+'));
    let number =
        text.parse::<f64>().ok().filter(|number| is_number && number.abs() <= f64::from(FARTHEST))?;
    Some((number * f64::from(PARTS)).round() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn levels(words: &str) -> Vec<f64> {
        levels_of(words).unwrap().into_iter().map(LevelNumber::storeys).collect()
    }

    #[test]
    fn levels_are_numbers_lists_and_ranges() {
        assert_eq!(levels("0"), [0.0]);
        assert_eq!(levels("-1"), [-1.0]);
        assert_eq!(levels("0.5"), [0.5]);
        assert_eq!(levels("0;1"), [0.0, 1.0]);
        assert_eq!(levels("1; 0,1;"), [0.0, 1.0]);
        assert_eq!(levels("0-3"), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(levels("-1-3"), [-1.0, 0.0, 1.0, 2.0, 3.0]);
        assert_eq!(levels("-3--1"), [-3.0, -2.0, -1.0]);
        assert_eq!(levels("2-0"), [0.0, 1.0, 2.0]);
        assert_eq!(levels("0-1.5"), [0.0, 1.0, 1.5]);
        assert_eq!(levels("-1;2-3"), [-1.0, 2.0, 3.0]);
    }

    #[test]
    fn other_words_are_no_levels() {
        for words in ["", ";", "ground", "1-", "-", "--1", "1-2-3", "1e9", "nan", "inf", "301", "0-100000000"]
        {
            assert!(levels_of(words).is_err(), "{words}");
        }
        assert!(levels_of(&"x".repeat(1_000_000)).unwrap_err().len() < 200);
    }

    #[test]
    fn ids_of_levels_are_their_numbers() {
        let ids: Vec<String> = levels_of("-1;0;0.5").unwrap().into_iter().map(LevelNumber::id).collect();
        assert_eq!(ids, ["level_-1", "level_0", "level_0.5"]);
    }
}
