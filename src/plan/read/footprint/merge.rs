//! Makes one building of what a file draws more than once, and of a building and its parts.

mod by_storeys;
mod parts;

use super::facts::Facts;
use super::notes::{Joined, SiteNotes};
use super::sound::common_area;
use crate::geometry::{Bounds, Region};
use crate::plan::assemble::BoxIndex;

pub(super) use by_storeys::in_pieces;
pub(super) use parts::with_parts;

/// The share of both outlines that they have in common where they are one building.
const SAME_SHARE: f64 = 0.98;
/// The share of an outline that lies in another building where it is a part of that.
const INSIDE_SHARE: f64 = 0.90;
/// Neighbours that a building is compared with: more boxes meet only where outlines are drawn upon each other.
const MOST_NEIGHBOURS: usize = 1_000;
/// Neighbours of those, the boxes of which have most in common with its own, whose outlines are clipped with its outline.
const MOST_CLIPPED: usize = 32;

/// A building or a part, cleaned.
#[derive(Clone, Debug)]
pub(super) struct Item {
    pub(super) id: String,
    /// Id of the building it is a part of, if the file says.
    pub(super) parent: Option<String>,
    pub(super) region: Region,
    pub(super) facts: Facts,
}

/// A building with its parts.
#[derive(Clone, Debug)]
pub(super) struct Whole {
    pub(super) building: Item,
    pub(super) parts: Vec<Item>,
}

/// Sorted so that the order in the file does not show: the largest first.
pub(super) fn in_order(mut items: Vec<Item>) -> Vec<Item> {
    let low = |item: &Item| item.region.outline.bounds().low;
    items.sort_by(|a, b| {
        let (here, there) = (low(a), low(b));
        let by_place = || here.x.total_cmp(&there.x).then(here.y.total_cmp(&there.y));
        let by_facts = || b.facts.count().cmp(&a.facts.count());
        let by_area = b.region.area().total_cmp(&a.region.area());
        by_area.then_with(by_place).then_with(|| a.id.cmp(&b.id)).then_with(by_facts)
    });
    items
}

/// The buildings without those that are drawn twice; those that lie in another are its parts.
///
/// Largest first, each is compared with the larger ones near it, which are sorted out already. So no file makes this slow.
pub(super) fn wholes(buildings: Vec<Item>, notes: &mut SiteNotes) -> Vec<Whole> {
    let mut wholes: Vec<Whole> = Vec::with_capacity(buildings.len());
    let mut places = BoxIndex::of(std::iter::empty());
    for item in in_order(buildings) {
        let regions = |index: usize| &wholes[index].building.region;
        let found = best_around(&item.region, &places, &regions, INSIDE_SHARE);
        match found {
            None => {
                places.add(item.region.outline.bounds(), wholes.len());
                wholes.push(Whole { building: item, parts: Vec::new() });
            }
            Some((index, common)) if common > SAME_SHARE * wholes[index].building.region.area() => {
                drop_one(&mut wholes[index].building, item, notes);
            }
            Some((index, _)) => {
                let with = wholes[index].building.id.clone();
                notes.parts.push(Joined { id: item.id.clone(), with });
                wholes[index].parts.push(item);
            }
        }
    }
    wholes
}

/// Keeps the one with more facts, of equals the one that is there.
fn drop_one(kept: &mut Item, mut other: Item, notes: &mut SiteNotes) {
    if other.facts.count() > kept.facts.count() {
        std::mem::swap(kept, &mut other);
    }
    notes.duplicates.push(Joined { id: other.id, with: kept.id.clone() });
}

/// The region that holds most of another, and the square metres in common, if that is at least this share of it.
fn best_around<'a>(
    region: &Region,
    places: &BoxIndex<usize>,
    regions: &impl Fn(usize) -> &'a Region,
    least_share: f64,
) -> Option<(usize, f64)> {
    let (bounds, area) = (region.outline.bounds(), region.area());
    let boxes = |index: usize| regions(index).outline.bounds();
    let shared = likely(bounds, places, &boxes, least_share * area)
        .into_iter()
        .map(|index| (index, common_area(region, regions(index))));
    shared
        .filter(|(_, common)| *common > least_share * area)
        .reduce(|best, next| if next.1 > best.1 { next } else { best })
}

/// The neighbours whose boxes have at least so many square metres in common with a box: those with most, sorted by index.
fn likely(
    bounds: Bounds,
    places: &BoxIndex<usize>,
    boxes: &impl Fn(usize) -> Bounds,
    least: f64,
) -> Vec<usize> {
    let near = places.meeting(bounds).take(MOST_NEIGHBOURS);
    let common = near.map(|index| (common_box(bounds, boxes(index)), index));
    let mut near: Vec<(f64, usize)> = common.filter(|(common, _)| *common >= least).collect();
    near.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    near.truncate(MOST_CLIPPED);
    let mut near: Vec<usize> = near.into_iter().map(|(_, index)| index).collect();
    near.sort_unstable();
    near
}

/// Square metres that two boxes have in common.
fn common_box(one: Bounds, other: Bounds) -> f64 {
    let size = one.high.min(other.high) - one.low.max(other.low);
    if size.min_element() > 0.0 { size.element_product() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Polygon};
    use crate::storey::StoreyFacts;

    fn item(id: &str, low: (f64, f64), size: (f64, f64)) -> Item {
        let outline = Polygon::rectangle(Point::new(low.0, low.1), Point::new(size.0, size.1));
        Item { id: id.into(), parent: None, region: Region::simple(outline), facts: Facts::default() }
    }

    fn known(mut item: Item) -> Item {
        item.facts.storeys = StoreyFacts { above_ground: Some(3.0), ..StoreyFacts::default() };
        item
    }

    #[test]
    fn of_two_drawings_of_one_building_that_with_more_facts_stays() {
        let drawn = || vec![item("a", (0.0, 0.0), (10.0, 10.0)), known(item("b", (0.05, 0.0), (10.0, 10.0)))];
        for items in [drawn(), drawn().into_iter().rev().collect()] {
            let mut notes = SiteNotes::default();
            let wholes = wholes(items, &mut notes);
            let ids: Vec<&str> = wholes.iter().map(|whole| whole.building.id.as_str()).collect();
            assert_eq!(ids, ["b"]);
            assert_eq!(notes.duplicates, [Joined { id: "a".into(), with: "b".into() }]);
        }
    }

    #[test]
    fn a_building_inside_another_is_its_part_and_a_neighbour_is_not() {
        let items = vec![
            item("inside", (2.0, 2.0), (4.0, 4.0)),
            item("block", (0.0, 0.0), (10.0, 10.0)),
            item("beside", (9.5, 0.0), (5.0, 5.0)),
        ];
        let mut notes = SiteNotes::default();
        let wholes = wholes(items, &mut notes);
        assert_eq!(wholes.len(), 2);
        assert_eq!(wholes[0].parts[0].id, "inside");
        assert_eq!(notes.parts, [Joined { id: "inside".into(), with: "block".into() }]);
    }
}
