//! Resolves classes.

use super::model::resolve_model;
use super::names::Names;
use super::number::{DISTANCE, LENGTH, Quantity, check_count, check_wealth};
use super::parents::{ResolvedParent, resolve_parents};
use super::relations::resolve_relations;
use super::resolve_label;
use super::shape::resolve_shape;
use super::sides::{resolve_clearances, resolve_sides};
use super::sizes::{resolve_further_sizes, resolve_sizes};
use crate::catalog::file::{ClassEntry, WallsEntry};
use crate::catalog::read::Files;
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Chain;
use crate::catalog::{
    COVERING_HEIGHT, Class, ClassIndex, Era, Grid, Light, SHAPES, Size, Variety, WallWishes,
};
use crate::geometry::Point;

/// From a glow to a floodlight.
const LUMENS: Quantity = Quantity { name: "lumens", unit: " lm", range: 1.0..=100_000.0 };
/// The range of temperatures in which the colour of a glowing body is known.
const KELVINS: Quantity = Quantity { name: "kelvin", unit: " K", range: 1667.0..=25_000.0 };
/// Colour temperature in kelvins of lamps that say nothing.
const WARM_WHITE: f64 = 2700.0;

/// As far as points of other wishes go together, and no farther.
const POINTS: Quantity = Quantity { name: "points", unit: "", range: -100.0..=100.0 };

/// Looks of each size where the file says nothing.
const DEFAULT_LOOKS: i64 = 4;

/// A class whose depth is not known yet, and what its parent rules were made of.
pub(crate) struct ResolvedClass {
    /// The class; its depth is 0.
    pub(crate) class: Class,
    /// Where it is defined.
    pub(crate) spot: Spot,
    /// Its parent rules with the words that they were made of.
    pub(crate) parents: Vec<ResolvedParent>,
}

/// All classes that are not abstract and not broken, sorted by id. Abstract ones are checked too.
pub(crate) fn resolve_classes(
    chains: &[Chain<'_, ClassEntry>],
    names: &Names<'_>,
    files: &Files,
    report: &mut Report<'_>,
) -> Vec<ResolvedClass> {
    chains.iter().filter_map(|chain| resolve_class(chain, names, files, report)).collect()
}

fn resolve_class(
    chain: &Chain<'_, ClassEntry>,
    names: &Names<'_>,
    files: &Files,
    report: &mut Report<'_>,
) -> Option<ResolvedClass> {
    let own = chain.own();
    let mut sizes = resolve_sizes(chain, files, report);
    let usual_sizes = sizes.len();
    sizes.extend(resolve_further_sizes(chain, "spare_sizes", |entry| &entry.spare_sizes, report));
    let in_niches = resolve_further_sizes(chain, "niche_sizes", |entry| &entry.niche_sizes, report);
    let niche_sizes = in_niches.len();
    sizes.extend(in_niches);
    let shape = resolve_shape(chain, &sizes, report);
    let parents = resolve_parents(chain, names, report);
    let sides = resolve_sides(chain, &sizes, report);
    let (clearances, either) = resolve_clearances(chain, report);
    let relations = resolve_relations(chain, names, report);
    let looks = resolve_looks(chain, report);
    let covers = resolve_covers(chain, names, &sizes, report);
    let carries = resolve_carries(chain, names, report);
    let grid = resolve_grid(chain, report);
    let walls = resolve_walls(chain, names, report);
    let model = resolve_model(chain, files, report);
    let wealth = resolve_wealth(chain, report);
    let light = resolve_light(chain, report);
    let index = names.index(&own.id).filter(|_| !sizes.is_empty())?;
    let class = Class {
        id: own.id.clone(),
        label: resolve_label(chain, |entry| entry.label.as_ref()),
        groups: names.groups(index).to_vec(),
        sizes,
        usual_sizes,
        niche_sizes,
        looks,
        variety: resolve_variety(chain, looks, report),
        share: chain.find("share", |entry| entry.share.as_ref()).map(|found| (*found.value).into()),
        shape,
        parents: parents.iter().map(|parent| parent.rule.clone()).collect(),
        sides,
        clearances,
        either,
        relations,
        covers,
        stand_ins: names.stand_ins(index),
        carries,
        needs_company: chain
            .find("company", |entry| entry.company.as_ref())
            .is_some_and(|found| *found.value),
        grid,
        fitted: chain.find("fitted", |entry| entry.fitted.as_ref()).map(|found| *found.value),
        is_joint: chain.find("joint", |entry| entry.joint.as_ref()).is_some_and(|found| *found.value),
        walls,
        priority: chain.find("priority", |entry| entry.priority.as_ref()).map_or(0, |found| *found.value),
        eras: resolve_eras(chain),
        wealth,
        model: model?,
        light,
        depth: 0,
    };
    Some(ResolvedClass { class, spot: own.spot.clone(), parents })
}

fn resolve_eras(chain: &Chain<'_, ClassEntry>) -> Vec<Era> {
    let found = chain.find("eras", |entry| entry.eras.as_ref());
    let mut eras: Vec<Era> =
        found.into_iter().flat_map(|found| found.value.items().map(|(_, era)| *era)).collect();
    eras.sort_unstable();
    eras.dedup();
    eras
}

fn resolve_walls(chain: &Chain<'_, ClassEntry>, names: &Names<'_>, report: &mut Report<'_>) -> WallWishes {
    let Some(found) = chain.find("walls", |entry| entry.walls.as_ref()) else { return WallWishes::default() };
    let WallsEntry { tags, with, metre, corner, half_corner } = found.value;
    let mut wishes = WallWishes::default();
    for (tag, points) in tags {
        let spot = found.spot.key("tags").key(tag);
        wishes.tags.push((tag.clone(), POINTS.check(*points, &spot, report)));
    }
    for (word, points) in with {
        let spot = found.spot.key("with").key(word);
        let points = POINTS.check(*points, &spot, report);
        wishes.with.extend(names.classes(word, &spot, report).map(|named| (named.classes, points)));
    }
    wishes.metre = POINTS.check(metre.unwrap_or(0.0), &found.spot.key("metre"), report);
    wishes.corner = POINTS.check(corner.unwrap_or(0.0), &found.spot.key("corner"), report);
    wishes.half_corner = POINTS.check(half_corner.unwrap_or(0.0), &found.spot.key("half_corner"), report);
    wishes
}

fn resolve_wealth(chain: &Chain<'_, ClassEntry>, report: &mut Report<'_>) -> Option<(u32, u32)> {
    let found = chain.find("wealth", |entry| entry.wealth.as_ref())?;
    let (low, high) = found.value.both();
    if low > high {
        let message = format!("wealth goes from {low} down to {high}");
        report.error_with_hint(&found.spot, message, "write the lower number first");
    }
    Some((check_wealth(low, &found.spot, report), check_wealth(high, &found.spot, report)))
}

fn resolve_light(chain: &Chain<'_, ClassEntry>, report: &mut Report<'_>) -> Option<Light> {
    let found = chain.find("light", |entry| entry.light.as_ref())?;
    let lumens = LUMENS.check(found.value.lumens, &found.spot.key("lumens"), report);
    let kelvin = found.value.kelvin.unwrap_or(WARM_WHITE);
    let kelvin = KELVINS.check(kelvin, &found.spot.key("kelvin"), report);
    Some(Light { lumens, kelvin, from: found.value.from.unwrap_or_default() })
}

fn resolve_looks(chain: &Chain<'_, ClassEntry>, report: &mut Report<'_>) -> u32 {
    let Some(found) = chain.find("looks", |entry| entry.looks.as_ref()) else {
        return check_count("looks", DEFAULT_LOOKS, &chain.own().spot, report);
    };
    if *found.value == 0 {
        report.error_with_hint(&found.spot, "looks is 0", "every class has at least one look");
    }
    check_count("looks", *found.value, &found.spot, report).max(1)
}

fn resolve_variety(chain: &Chain<'_, ClassEntry>, looks: u32, report: &mut Report<'_>) -> Variety {
    let Some(found) = chain.find("varied", |entry| entry.varied.as_ref()) else { return Variety::None };
    let variety = Variety::from(*found.value);
    if variety == Variety::Details && looks <= SHAPES {
        let message = format!("varied in details, with {looks} looks");
        let hint =
            format!("the first {SHAPES} looks are shapes; write more `looks`, for example {}", 3 * SHAPES);
        report.error_with_hint(&found.spot, message, &hint);
    }
    variety
}

/// Under whom it lies, in the order of the words.
fn resolve_covers(
    chain: &Chain<'_, ClassEntry>,
    names: &Names<'_>,
    sizes: &[Size],
    report: &mut Report<'_>,
) -> Vec<ClassIndex> {
    let Some(found) = chain.find("covers", |entry| entry.covers.as_ref()) else { return Vec::new() };
    if let Some(thick) = sizes.iter().find(|size| size.height > COVERING_HEIGHT) {
        let message = format!("what is {} m high is no rug", thick.height);
        let hint = format!("`covers` is for what is at most {COVERING_HEIGHT} m high");
        report.error_with_hint(&found.spot, message, &hint);
    }
    let named = names.all_classes(found.value, &found.spot, report);
    named.into_iter().flat_map(|named| named.classes).collect()
}

fn resolve_carries(
    chain: &Chain<'_, ClassEntry>,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Vec<ClassIndex> {
    let Some(found) = chain.find("carries", |entry| entry.carries.as_ref()) else { return Vec::new() };
    let named = names.all_classes(found.value, &found.spot, report);
    named.into_iter().flat_map(|named| named.classes).collect()
}

fn resolve_grid(chain: &Chain<'_, ClassEntry>, report: &mut Report<'_>) -> Option<Grid> {
    let found = chain.find("grid", |entry| entry.grid.as_ref())?;
    let spot = found.spot.key("interval");
    let quantity = Quantity::metres("interval", LENGTH);
    let (x, y) = found.value.interval.both();
    let interval = Point::new(quantity.check(x, &spot, report), quantity.check(y, &spot, report));
    let block = found.value.block.unwrap_or_default();
    let block_spot = found.spot.key("block");
    let block = [0, 1].map(|axis| check_count("block", block[axis], &block_spot.index(axis), report));
    let aisle = Quantity::metres("aisle", DISTANCE);
    let aisle = found.value.aisle.map_or(0.0, |metres| aisle.check(metres, &found.spot.key("aisle"), report));
    let metres = Quantity::metres("margin", DISTANCE);
    let margin = found.value.margin.map_or([0.0; 4], |margin| {
        margin.all().map(|edge| metres.check(edge, &found.spot.key("margin"), report))
    });
    Some(Grid {
        interval,
        block,
        aisle,
        is_centered: found.value.centered,
        is_halved: found.value.halved,
        is_back_to_back: found.value.back_to_back,
        margin,
    })
}
