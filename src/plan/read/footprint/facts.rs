//! What the tags of a building say of it, whatever family of keys they are from.

use std::borrow::Cow;
use std::collections::BTreeMap;

use crate::plan::units::{FOOT, length_of_words};
use crate::storey::StoreyFacts;

/// The most storeys and metres of height that are believed: twice the highest building.
const MOST: f64 = 2_000.0;
/// The most flats that are believed.
const MOST_FLATS: f64 = 100_000.0;

/// Storeys above the ground: OpenStreetMap, its exports, OSM Buildings, Overture, URBANopt, CityGML.
const STOREYS: [&str; 13] = [
    "building:levels",
    "building_levels",
    "levels",
    "num_floors",
    "number_of_stories_above_ground",
    "number_of_stories",
    "storeysAboveGround",
    "bldg:storeysAboveGround",
    "storeys_above_ground",
    "storeys",
    "stories",
    "floors",
    "NumFloors",
];
/// Storeys of the roof.
const ROOF_STOREYS: [&str; 3] = ["roof:levels", "roofLevels", "roof_levels"];
/// Storeys below a part that begins higher up.
const LOWEST_STOREYS: [&str; 5] =
    ["building:min_level", "min_level", "building_min_level", "minLevel", "min_floor"];
/// Metres to the top.
const HEIGHTS: [&str; 9] = [
    "height",
    "building:height",
    "building_height",
    "measuredHeight",
    "bldg:measuredHeight",
    "measured_height",
    "RelativeRidgeHeight",
    "est_height",
    "height_m",
];
/// Feet to the top.
const HEIGHTS_IN_FEET: [&str; 1] = ["maximum_roof_height"];
/// Metres to the bottom of a part that begins higher up.
const BOTTOMS: [&str; 4] = ["min_height", "building:min_height", "minHeight", "building_min_height"];
/// Numbers of flats.
const FLATS: [&str; 4] = ["building:flats", "building:units", "flats", "number_of_residential_units"];
/// What it is used for. What the whole building is comes before who is in it; kinds before their families.
const USES: [&str; 20] = [
    "building:use",
    "building",
    "building:part",
    "amenity",
    "shop",
    "office",
    "tourism",
    "healthcare",
    "leisure",
    "craft",
    "man_made",
    "building_type",
    "function",
    "bldg:function",
    "usage",
    "bldg:usage",
    "class",
    "bldg:class",
    "subtype",
    "religion",
];
/// Words that say nothing of a use.
const NO_USES: [&str; 6] = ["", "yes", "true", "no", "unknown", "null"];

/// What is known of a building.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Facts {
    pub(super) name: Option<String>,
    pub(super) storeys: StoreyFacts,
    pub(super) uses: Vec<(String, String)>,
    pub(super) flats: Option<u32>,
    /// Keys and values that nobody can read.
    pub(super) unreadable: Vec<(String, String)>,
}

impl Facts {
    /// How much is known: of two drawings of one building that with more stays.
    pub(super) fn count(&self) -> usize {
        let StoreyFacts { above_ground, in_roof, lowest, height, bottom } = self.storeys;
        let numbers = [above_ground, in_roof, lowest, height, bottom];
        numbers.iter().flatten().count()
            + self.uses.len()
            + usize::from(self.name.is_some())
            + usize::from(self.flats.is_some())
    }
}

/// A value of a tag.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum TagValue {
    /// Words, perhaps with a number in them.
    Text(String),
    /// A number.
    Number(f64),
}

impl TagValue {
    /// The value in words.
    pub(super) fn words(&self) -> Cow<'_, str> {
        match self {
            Self::Text(text) => Cow::Borrowed(text),
            Self::Number(number) => Cow::Owned(number.to_string()),
        }
    }
}

/// Keys and values of a thing of a map.
#[derive(Clone, Debug, Default)]
pub(super) struct Tags(BTreeMap<String, TagValue>);

impl Tags {
    /// Adds a tag; the first of two with one key stays.
    pub(super) fn add(&mut self, key: impl Into<String>, value: TagValue) {
        self.0.entry(key.into()).or_insert(value);
    }

    /// The value of a key.
    pub(super) fn get(&self, key: &str) -> Option<&TagValue> {
        self.0.get(key)
    }

    /// The value of a key in words; `None` for numbers.
    pub(super) fn text(&self, key: &str) -> Option<&str> {
        match self.0.get(key)? {
            TagValue::Text(text) => Some(text.trim()),
            TagValue::Number(_) => None,
        }
    }

    /// Whether there is such a key with another value than `no`.
    pub(super) fn says(&self, key: &str) -> bool {
        match self.0.get(key) {
            Some(TagValue::Text(text)) => !matches!(text.trim(), "" | "no" | "false"),
            Some(TagValue::Number(number)) => *number != 0.0,
            None => false,
        }
    }

    /// Whether one of some keys is there.
    pub(super) fn has_any(&self, keys: &[&str]) -> bool {
        keys.iter().any(|key| self.0.contains_key(*key))
    }
}

/// Reads the tags of a building.
pub(super) fn facts_of(tags: &Tags) -> Facts {
    let mut numbers = Numbers { tags, unreadable: Vec::new() };
    let storeys = StoreyFacts {
        above_ground: numbers.first(&STOREYS, count_of_words, 0.0),
        in_roof: numbers.first(&ROOF_STOREYS, count_of_words, 0.0),
        lowest: numbers.first(&LOWEST_STOREYS, count_of_words, 0.0).filter(|lowest| *lowest > 0.0),
        height: numbers
            .first(&HEIGHTS, length_of_words, f64::MIN_POSITIVE)
            .or_else(|| numbers.first(&HEIGHTS_IN_FEET, length_of_words, 0.0).map(|feet| feet * FOOT)),
        bottom: numbers.first(&BOTTOMS, length_of_words, 0.0).filter(|bottom| *bottom > 0.0),
    };
    let flats = numbers.first(&FLATS, count_of_words, 0.0).filter(|flats| *flats <= MOST_FLATS);
    Facts {
        name: tags.text("name").filter(|name| !name.is_empty()).map(str::to_owned),
        storeys,
        uses: uses_of(tags),
        // Between zero and the most: no digit is lost but those behind the point.
        flats: flats.filter(|flats| *flats >= 1.0).map(|flats| flats as u32),
        unreadable: numbers.unreadable,
    }
}

fn uses_of(tags: &Tags) -> Vec<(String, String)> {
    let words = |key: &str| {
        let words = tags.text(key).unwrap_or_default().to_lowercase();
        let words: Vec<String> = words.split(';').map(|word| word.trim().to_owned()).collect();
        words.into_iter().filter(|word| !NO_USES.contains(&word.as_str()))
    };
    USES.iter().flat_map(|key| words(key).map(|word| ((*key).to_owned(), word))).collect()
}

/// Reads numbers and keeps what is none.
struct Numbers<'a> {
    tags: &'a Tags,
    unreadable: Vec<(String, String)>,
}

impl Numbers<'_> {
    /// The number of the first key that has one, not below `least`.
    fn first(&mut self, keys: &[&str], read: fn(&str) -> Option<f64>, least: f64) -> Option<f64> {
        for key in keys {
            let Some(value) = self.tags.get(key) else { continue };
            let (number, shown) = match value {
                TagValue::Number(number) => (Some(*number), number.to_string()),
                TagValue::Text(text) if is_nothing(text) => continue,
                TagValue::Text(text) => (largest(text, read), text.clone()),
            };
            match number {
                Some(number) if (least..=MOST).contains(&number) => return Some(number),
                // Exports write these for "not known".
                Some(-1.0 | 0.0) => {}
                _ => self.unreadable.push(((*key).to_owned(), shown)),
            }
        }
        None
    }
}

/// Whether a text is how exports write that there is no value.
fn is_nothing(text: &str) -> bool {
    matches!(text.trim().to_ascii_lowercase().as_str(), "" | "null" | "none" | "nan" | "unknown" | "n/a")
}

/// The largest number of a list such as `4;5`, which stands for parts of different heights.
fn largest(text: &str, read: fn(&str) -> Option<f64>) -> Option<f64> {
    let numbers: Option<Vec<f64>> = text.split(';').map(read).collect();
    numbers?.into_iter().max_by(f64::total_cmp)
}

/// A number of storeys or flats; of a span such as `4-5` the larger.
fn count_of_words(words: &str) -> Option<f64> {
    let number = |words: &str| words.trim().replace(',', ".").parse::<f64>().ok().filter(|n| n.is_finite());
    let span = || {
        let (low, high) = words.split_once('-')?;
        Some(number(low)?.max(number(high)?))
    };
    number(words).or_else(span)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facts(pairs: &[(&str, &str)]) -> Facts {
        let mut tags = Tags::default();
        pairs.iter().for_each(|(key, value)| tags.add(*key, TagValue::Text((*value).to_owned())));
        facts_of(&tags)
    }

    #[test]
    fn numbers_in_words_are_read() {
        for (words, number) in
            [("5", 5.0), ("5.5", 5.5), ("4;5", 5.0), ("4-5", 5.0), (" 3 ", 3.0), ("2,5", 2.5)]
        {
            assert_eq!(facts(&[("building:levels", words)]).storeys.above_ground, Some(number), "{words}");
        }
        assert_eq!(facts(&[("height", "12 m")]).storeys.height, Some(12.0));
        assert!((facts(&[("height", "40'")]).storeys.height.unwrap() - 12.192).abs() < 1e-9);
    }

    #[test]
    fn values_that_are_no_numbers_are_kept_as_they_are() {
        for words in ["many", "-3", "99999", "4;x"] {
            let found = facts(&[("building:levels", words)]);
            assert_eq!(found.storeys.above_ground, None, "{words}");
            assert_eq!(found.unreadable, [("building:levels".to_owned(), words.to_owned())]);
        }
        for nothing in ["", "-1", "unknown"] {
            assert_eq!(facts(&[("building:levels", nothing)]).unreadable, [], "{nothing}");
        }
    }

    #[test]
    fn the_next_family_of_keys_counts_where_the_first_says_nothing() {
        let found = facts(&[("building:levels", "some"), ("num_floors", "3"), ("height", "0")]);
        assert_eq!(found.storeys.above_ground, Some(3.0));
        assert_eq!(found.storeys.height, None);
    }

    #[test]
    fn uses_are_words_in_small_letters_without_those_that_say_nothing() {
        let found = facts(&[("building", "Yes"), ("amenity", "school;kindergarten"), ("class", "Education")]);
        let uses: Vec<_> = found.uses.iter().map(|(key, word)| (key.as_str(), word.as_str())).collect();
        assert_eq!(uses, [("amenity", "school"), ("amenity", "kindergarten"), ("class", "education")]);
    }
}
