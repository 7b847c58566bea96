//! Which floors of the table are read: those that `--only` names by the ids of the table.

/// The ids that were asked for; all floors if there are none.
#[derive(Clone, Debug, Default)]
pub(super) struct Selection {
    /// Column and id, as `("building", "2357")`.
    wanted: Vec<(String, String)>,
}

/// The ids of a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ids<'a> {
    /// Empty in tables without sites.
    pub(super) site: &'a str,
    pub(super) building: &'a str,
    pub(super) floor: &'a str,
}

impl Selection {
    /// Of the words of `--only`: `site_<id>`, `building_<id>`, `floor_<id>`. Others are ids of other inputs.
    pub(super) fn of(words: &[String]) -> Self {
        let wanted = words.iter().map(|word| match word.split_once('_') {
            Some((column, id)) => (column.to_owned(), id.to_owned()),
            None => (String::new(), word.clone()),
        });
        Self { wanted: wanted.collect() }
    }

    /// Whether a row belongs to what was asked for.
    pub(super) fn holds(&self, ids: Ids<'_>) -> bool {
        let is_meant = |(column, id): &(String, String)| match column.as_str() {
            "site" => id == ids.site,
            "building" => id == ids.building,
            "floor" => id == ids.floor,
            _ => false,
        };
        self.wanted.is_empty() || self.wanted.iter().any(is_meant)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floors_are_chosen_by_site_building_or_floor() {
        let ids = Ids { site: "1", building: "2", floor: "3" };
        let holds = |words: &[&str]| {
            Selection::of(&words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>()).holds(ids)
        };
        assert!(holds(&[]) && holds(&["site_1"]) && holds(&["building_2"]) && holds(&["floor_9", "floor_3"]));
        assert!(!holds(&["site_2"]) && !holds(&["building_3"]) && !holds(&["2"]) && !holds(&["house_2"]));
    }
}
