//! The groups of classes that rules are about, with their words and meanings. A class takes part in a rule by naming the word among
//! its `groups` in `configs/classes/`. A further group is one line of the list below; docs/guide.md lists the groups as they
//! stand here: `UPDATE_GOLDENS=1 cargo test --lib the_guide_lists_the_groups`.

macro_rules! groups {
    ($(#[doc = $meaning:literal] $name:ident: $word:literal;)+) => {
        $(#[doc = $meaning] pub(crate) const $name: &str = $word;)+

        /// Words and meanings, for the guide.
        #[cfg(test)]
        const ALL: &[(&str, &str)] = &[$(($word, $meaning)),+];
        #[cfg(test)]
        const NAMES: &[&str] = &[$(stringify!($name)),+];
    };
}

groups! {
    /// People sit on it, stools and benches too.
    SEAT: "seat";
    /// A bed.
    BED: "bed";
    /// People lie on it.
    SLEEPING: "sleeping";
    /// A television, not the screen of a computer.
    SCREEN: "screen";
    /// A desk.
    WORK_SURFACE: "work_surface";
    /// People put things on it, and may sit at it.
    SURFACE: "surface";
    /// A mirror.
    MIRROR: "mirror_glass";
    /// A tub or shower.
    BATHING: "bathing";
    /// A toilet or urinal.
    TOILET: "wc";
    /// It stands in bathrooms and is used with the door shut.
    FIXTURE: "fixture";
    /// One cooks at it.
    COOKING: "cooking";
    /// Small enough to be carried in a hand.
    SMALL: "small";
    /// A lamp.
    LIGHT: "light";
    /// A chair that is moved whenever it is used.
    MOVABLE: "movable";
    /// A plant in a pot.
    PLANT: "greenery";
    /// A curtain or blind.
    WINDOW_DRESSING: "window_dressing";
    /// Looks bare without small things on it.
    DISPLAY_SURFACE: "display_surface";
    /// The top of a row of kitchen units.
    KITCHEN_TOP: "kitchen_top";
}

/// What looks bare without small things on it.
pub(crate) const DISPLAY: [&str; 3] = [WORK_SURFACE, DISPLAY_SURFACE, KITCHEN_TOP];

#[cfg(test)]
mod tests {
    use super::{ALL, NAMES};
    use crate::catalog::builtin_catalog;

    #[test]
    fn every_group_has_a_class() {
        let classes = &builtin_catalog().classes;
        for (word, _) in ALL {
            let has_it = classes.iter().any(|class| class.groups.iter().any(|group| group == word));
            assert!(has_it, "{word}");
        }
    }

    #[test]
    fn the_steps_for_findings_name_every_group() {
        let steps = include_str!("checks/mod.rs");
        let row =
            steps.lines().find(|line| line.contains("| groups of classes |")).expect("the table has the row");
        for name in NAMES {
            assert!(
                row.contains(&format!("`{name}`")) || row.contains(&format!("`groups::{name}`")),
                "{name}"
            );
        }
    }

    /// The list as the guide shows it.
    fn list() -> String {
        let line = |(word, meaning): &(&str, &str)| {
            let meaning = meaning.trim().trim_end_matches('.');
            let (first, rest) = meaning.split_at(1);
            format!("  - `{word}`: {}{rest}\n", first.to_lowercase())
        };
        ALL.iter().map(line).collect()
    }

    #[test]
    fn the_guide_lists_the_groups_with_their_meanings() {
        const BEFORE: &str = "The audit asks for these groups:\n";
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/guide.md");
        let guide = std::fs::read_to_string(path).unwrap();
        let from = guide.find(BEFORE).expect("the guide has the list") + BEFORE.len();
        // From the end of the line before, so that an empty list ends, too.
        let length = guide[from - 1..].find("\n- ").expect("the list ends");
        let (before, shown, after) = (&guide[..from], &guide[from..from + length], &guide[from + length..]);
        if std::env::var_os("UPDATE_GOLDENS").is_some() {
            return std::fs::write(path, [before, &list(), after].concat()).unwrap();
        }
        assert_eq!(
            shown,
            list(),
            "renew it with UPDATE_GOLDENS=1 cargo test --lib the_guide_lists_the_groups"
        );
    }
}
