//! Building styles, which choose a style for each room of a building.

use std::collections::BTreeMap;

use super::by_id::StyleRef;

/// Gives each room of a building its style, drawn by seed, all inheritance resolved.
#[derive(Clone, Debug)]
pub struct BuildingStyle {
    /// The word used in plans and on the command line; no style has the same.
    pub id: String,
    /// A title for people.
    pub label: String,
    /// Which rooms are drawn for together.
    pub share: Share,
    /// Styles of rooms whose type is not in `rooms`; empty for the default style.
    pub styles: Vec<WeightedStyle>,
    /// Styles by room type; no list is empty.
    pub rooms: BTreeMap<String, Vec<WeightedStyle>>,
    /// By drawn style, the styles that single dwellings or rooms get in its place; weights are shares of all, together 1
    /// at most.
    pub instead: BTreeMap<StyleRef, Vec<WeightedStyle>>,
}

/// One of the styles that are drawn from.
#[derive(Clone, Debug, PartialEq)]
pub struct WeightedStyle {
    /// The style.
    pub style: StyleRef,
    /// How often it is drawn compared with the others; above zero.
    pub weight: f64,
}

/// Which rooms share one draw: those with the same list of styles get the same style.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Share {
    /// Each room draws for itself.
    Room,
    /// The rooms of a dwelling; those that are part of none, with the others of their level that are part of none.
    #[default]
    Dwelling,
    /// The rooms of a level.
    Level,
    /// All rooms of the building.
    Building,
}

impl Share {
    /// The words in configuration.
    pub(crate) const WORDS: [(&'static str, Self); 4] = [
        ("room", Self::Room),
        ("dwelling", Self::Dwelling),
        ("level", Self::Level),
        ("building", Self::Building),
    ];

    /// The word in configuration.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::WORDS[self as usize].0
    }
}

impl BuildingStyle {
    /// The style of a room type for a number drawn evenly from [0, 1); `None` where it leaves the choice.
    #[must_use]
    pub fn style(&self, room_type: &str, drawn: f64) -> Option<StyleRef> {
        let styles = self.rooms.get(room_type).unwrap_or(&self.styles);
        let mut left = drawn * styles.iter().map(|one| one.weight).sum::<f64>();
        for one in styles {
            if left < one.weight {
                return Some(one.style);
            }
            left -= one.weight;
        }
        // Rounding may leave a trace behind the last.
        styles.last().map(|one| one.style)
    }
}

impl BuildingStyle {
    /// The style that a single dwelling or room gets in place of the drawn one, for a number of its own drawn evenly from
    /// [0, 1); nearly all get none.
    #[must_use]
    pub fn style_instead(&self, style: StyleRef, drawn: f64) -> Option<StyleRef> {
        let mut left = drawn;
        for one in self.instead.get(&style)? {
            if left < one.weight {
                return Some(one.style);
            }
            left -= one.weight;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Definition, Style};

    #[test]
    fn weights_are_shares_of_the_draw() {
        let [old, new, grand, wide] = [0, 1, 2, 3].map(Style::reference);
        let weighted = |(style, weight): (StyleRef, f64)| WeightedStyle { style, weight };
        let block = BuildingStyle {
            id: "block".into(),
            label: "Block".into(),
            share: Share::Dwelling,
            styles: [(old, 3.0), (new, 1.0)].map(weighted).into(),
            rooms: [("lobby".to_owned(), vec![weighted((grand, 0.5))])].into(),
            instead: [(old, vec![weighted((wide, 0.05))])].into(),
        };
        assert_eq!(block.style_instead(old, 0.049), Some(wide));
        assert_eq!(block.style_instead(old, 0.051), None);
        assert_eq!(block.style_instead(new, 0.0), None);
        assert_eq!(block.style("bedroom", 0.0), Some(old));
        assert_eq!(block.style("bedroom", 0.749), Some(old));
        assert_eq!(block.style("bedroom", 0.751), Some(new));
        assert_eq!(block.style("bedroom", 1.0), Some(new));
        assert_eq!(block.style("lobby", 0.9), Some(grand));
        assert_eq!(BuildingStyle { styles: Vec::new(), ..block }.style("bedroom", 0.5), None);
    }

    #[test]
    fn words_stand_in_the_order_of_the_kinds() {
        assert!(Share::WORDS.iter().enumerate().all(|(place, (_, share))| *share as usize == place));
    }
}
