//! Finds the building of each part that a file draws as one.

use std::collections::BTreeMap;

use super::{Item, SAME_SHARE, Whole, best_around, in_order, likely};
use crate::geometry::Region;
use crate::plan::assemble::BoxIndex;
use crate::plan::read::footprint::facts::Facts;
use crate::plan::read::footprint::notes::{Joined, SiteNotes, Split};
use crate::plan::read::footprint::sound::{common_area, united};
use crate::plan::read::footprint::tidy::tidied;
use crate::storey::StoreyFacts;

/// The share of a part that lies in its building where the file does not name it: parts may reach over the outline.
const PART_SHARE: f64 = 0.5;

/// Attaches parts to their buildings: the one that the file names, else the one that holds most of it. Parts of a building that
/// the file does not draw make it; `shells` are the facts about such buildings by id. A part alone is a building.
pub(in super::super) fn with_parts(
    mut wholes: Vec<Whole>,
    parts: Vec<Item>,
    shells: &BTreeMap<String, Facts>,
    notes: &mut SiteNotes,
) -> Vec<Whole> {
    let parts = once_each(in_order(parts), notes);
    let mut named: BTreeMap<String, usize> = BTreeMap::new();
    for (index, whole) in wholes.iter().enumerate() {
        named.entry(whole.building.id.clone()).or_insert(index);
    }
    let boxes = wholes.iter().map(|whole| whole.building.region.outline.bounds()).zip(0..);
    let places = BoxIndex::of(boxes);
    let mut orphans: BTreeMap<String, Vec<Item>> = BTreeMap::new();
    for part in parts {
        let by_name = part.parent.as_ref().and_then(|parent| named.get(parent).copied());
        let by_place = || {
            let regions = |index: usize| &wholes[index].building.region;
            best_around(&part.region, &places, &regions, PART_SHARE).map(|(index, _)| index)
        };
        // A shell is waiting for its parts: they are no parts of what they lie in.
        let is_of_shell = part.parent.as_ref().is_some_and(|parent| shells.contains_key(parent));
        match by_name.or_else(|| if is_of_shell { None } else { by_place() }) {
            Some(index) => {
                let with = wholes[index].building.id.clone();
                notes.parts.push(Joined { id: part.id.clone(), with });
                wholes[index].parts.push(part);
            }
            None => {
                orphans.entry(part.parent.clone().unwrap_or_else(|| part.id.clone())).or_default().push(part)
            }
        }
    }
    for (id, parts) in orphans {
        wholes.extend(made_of(&id, parts, shells.get(&id), notes));
    }
    wholes
}

/// The parts without those that are drawn twice: of one outline, from the same height.
fn once_each(parts: Vec<Item>, notes: &mut SiteNotes) -> Vec<Item> {
    let mut kept: Vec<Item> = Vec::with_capacity(parts.len());
    let mut places = BoxIndex::of(std::iter::empty());
    let bottom = |item: &Item| (item.facts.storeys.lowest, item.facts.storeys.bottom);
    for part in parts {
        let area = part.region.area();
        let boxes = |index: usize| kept[index].region.outline.bounds();
        let near = likely(part.region.outline.bounds(), &places, &boxes, SAME_SHARE * area);
        let is_same = |other: &Item| {
            bottom(other) == bottom(&part)
                && other.region.area() * SAME_SHARE < area
                && common_area(&other.region, &part.region) > SAME_SHARE * other.region.area()
        };
        match near.into_iter().find(|index| is_same(&kept[*index])) {
            Some(index) => super::drop_one(&mut kept[index], part, notes),
            None => {
                places.add(part.region.outline.bounds(), kept.len());
                kept.push(part);
            }
        }
    }
    kept
}

/// Buildings made of parts alone: one for each piece of the ground that they cover.
fn made_of(id: &str, mut parts: Vec<Item>, shell: Option<&Facts>, notes: &mut SiteNotes) -> Vec<Whole> {
    if parts.len() == 1 && shell.is_none() {
        let building = Item { parent: None, ..parts.remove(0) };
        return vec![Whole { building, parts }];
    }
    let grounds: Vec<Region> =
        united(parts.iter().map(|part| &part.region)).into_iter().map(tidied).collect();
    let count = grounds.len();
    if count > 1 && shell.is_some() {
        notes.split.push(Split { id: id.to_owned(), pieces: count });
    }
    let facts = joined_facts(&parts, shell);
    let whole = |(index, region): (usize, Region)| {
        let id = if count > 1 { format!("{id}-{}", index + 1) } else { id.to_owned() };
        let facts = facts.clone();
        Whole { building: Item { id, parent: None, region, facts }, parts: Vec::new() }
    };
    let mut wholes: Vec<Whole> = grounds.into_iter().enumerate().map(whole).collect();
    let places =
        BoxIndex::of(wholes.iter().map(|whole| whole.building.region.outline.bounds()).zip(0_usize..));
    for part in parts {
        let near = places.near(part.region.outline.bounds());
        let area = |whole: usize| common_area(&wholes[whole].building.region, &part.region);
        let shares = near.into_iter().map(|whole| (area(whole), whole));
        let most = shares.reduce(|best, next| if next.0 > best.0 { next } else { best });
        // What lies in none belongs to the largest.
        let most = most.map(|(_, whole)| whole).or((!wholes.is_empty()).then_some(0));
        let Some(most) = most else {
            notes.leave_out(part.id, "its building has no usable outline");
            continue;
        };
        notes.parts.push(Joined { id: part.id.clone(), with: wholes[most].building.id.clone() });
        wholes[most].parts.push(part);
    }
    if shell.is_none() {
        notes.made_of_parts.extend(wholes.iter().map(|whole| whole.building.id.clone()));
    }
    wholes
}

/// What is known of a building by itself, and else from its parts: the highest counts.
fn joined_facts(parts: &[Item], shell: Option<&Facts>) -> Facts {
    let mut facts = shell.cloned().unwrap_or_default();
    let highest = |value: fn(&StoreyFacts) -> Option<f64>| {
        parts.iter().filter_map(|part| value(&part.facts.storeys)).max_by(f64::total_cmp)
    };
    let storeys = &mut facts.storeys;
    storeys.above_ground = storeys.above_ground.or_else(|| highest(|storeys| storeys.above_ground));
    storeys.height = storeys.height.or_else(|| highest(|storeys| storeys.height));
    if facts.uses.is_empty() {
        for used in parts.iter().flat_map(|part| &part.facts.uses) {
            if !facts.uses.contains(used) {
                facts.uses.push(used.clone());
            }
        }
    }
    facts.name = facts.name.or_else(|| parts.iter().find_map(|part| part.facts.name.clone()));
    facts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Polygon};

    fn part(id: &str, parent: Option<&str>, low: (f64, f64), size: (f64, f64)) -> Item {
        let outline = Polygon::rectangle(Point::new(low.0, low.1), Point::new(size.0, size.1));
        Item {
            id: id.into(),
            parent: parent.map(str::to_owned),
            region: Region::simple(outline),
            facts: Facts::default(),
        }
    }

    fn ids(wholes: &[Whole]) -> Vec<(&str, Vec<&str>)> {
        wholes
            .iter()
            .map(|whole| {
                let parts = whole.parts.iter().map(|part| part.id.as_str()).collect();
                (whole.building.id.as_str(), parts)
            })
            .collect()
    }

    #[test]
    fn parts_lie_in_their_building_or_make_it() {
        let block = Whole { building: part("block", None, (0.0, 0.0), (20.0, 20.0)), parts: Vec::new() };
        let parts = vec![
            part("tower", None, (5.0, 5.0), (5.0, 5.0)),
            part("west", Some("r1"), (100.0, 0.0), (10.0, 10.0)),
            part("east", Some("r1"), (110.0, 0.0), (10.0, 9.0)),
            part("alone", None, (200.0, 0.0), (10.0, 10.0)),
        ];
        let mut notes = SiteNotes::default();
        let wholes = with_parts(vec![block], parts, &BTreeMap::new(), &mut notes);
        let expected = [("block", vec!["tower"]), ("alone", vec![]), ("r1", vec!["west", "east"])];
        assert_eq!(ids(&wholes), expected);
        assert!((wholes[2].building.region.area() - 190.0).abs() < 1e-6);
        assert_eq!(notes.made_of_parts, ["r1"]);
    }

    #[test]
    fn parts_of_one_outline_at_different_heights_are_two() {
        let above = |id: &str, bottom: Option<f64>| {
            let mut part = part(id, Some("r1"), (0.0, 0.0), (10.0, 10.0));
            part.facts.storeys.bottom = bottom;
            part
        };
        let parts = vec![above("a", None), above("b", Some(9.0)), above("c", None)];
        let mut notes = SiteNotes::default();
        let wholes = with_parts(Vec::new(), parts, &BTreeMap::new(), &mut notes);
        assert_eq!(ids(&wholes), [("r1", vec!["a", "b"])]);
        assert_eq!(notes.duplicates, [Joined { id: "c".into(), with: "a".into() }]);
    }
}
