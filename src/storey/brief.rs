//! What a building of a map is to be: how many storeys, which kind; and what of that was estimated.

use schemars::JsonSchema;
use serde::Serialize;

use super::footprint::{Footprint, StoreyFacts};
use super::typology::{PlanKind, Typologies, Typology, Use};
use crate::layout::seed::{Stream, building_stream};

/// Metres from floor to floor by which a height is counted in storeys.
const STOREY: f64 = 3.0;
/// Metres of a roof that a height is taken to include.
const ROOF: f64 = 1.0;
/// Most storeys of a building: the tallest in the world has 163.
const MOST_STOREYS: u32 = 200;
/// Square metres of all storeys together at most: three buildings of the world have more.
const MOST_FLOOR: f64 = 1_000_000.0;

/// What a building is to be.
#[derive(Clone, Debug)]
pub(super) struct Brief<'a> {
    /// Its kind by name.
    pub(super) name: &'a str,
    /// Its kind.
    pub(super) typology: &'a Typology,
    /// How many storeys it has above the ground.
    pub(super) storeys: u32,
    /// How that is known.
    pub(super) known: Known,
}

/// How facts about a building are known.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Known {
    /// How the number of storeys is known.
    pub storeys: StoreySource,
    /// The word of the map that says its use; none where the use was guessed from its size.
    pub use_word: Option<String>,
}

/// How a number of storeys is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StoreySource {
    /// The map says it.
    Map,
    /// From the height that the map says.
    Height,
    /// From the usual number of buildings of this kind.
    Kind,
    /// The command line says it.
    Chosen,
}

/// What the caller decides in place of the map.
#[derive(Clone, Debug, Default)]
pub struct Choices {
    /// A use of the typologies for all buildings.
    pub use_name: Option<String>,
    /// Storeys of all buildings.
    pub storeys: Option<u32>,
    /// Seed of the plans.
    pub seed: u64,
    /// Ids of the buildings that are planned, or of what else is read of a file that holds more than is wanted; all if empty.
    pub only: Vec<String>,
    /// Only buildings with their middle in this box, in the units of the map: west, south, east, north.
    pub bounds: Option<[f64; 4]>,
    /// Metres of one unit of plans that are drawn without a scale.
    pub metres_per_unit: Option<f64>,
}

/// Figures of an outline that kinds of buildings are chosen by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measures {
    /// Square metres.
    pub(super) area: f64,
    /// Metres of the largest disc inside.
    pub(super) depth: f64,
    /// Metres of the longer side.
    pub(super) length: f64,
    /// Share of the outline with a neighbour wall to wall.
    pub(super) party: f64,
}

/// The kinds that a building may be, the first drawn by weight, then the others as a way out: the brief of each.
pub(super) fn briefs<'a>(
    footprint: &Footprint,
    measures: Measures,
    typologies: &'a Typologies,
    choices: &Choices,
) -> Vec<Brief<'a>> {
    let (uses, word) = uses_of(footprint, measures, typologies, choices);
    // The map may say it of the parts alone: then the largest part counts.
    let largest = footprint.parts.iter().reduce(|a, b| if b.region.area() > a.region.area() { b } else { a });
    let of_part = || largest.and_then(|part| told_storeys(&part.storeys, choices));
    let told = told_storeys(&footprint.storeys, choices).or_else(of_part);
    // Between zero and the most.
    let most_storeys = (MOST_FLOOR / measures.area).min(f64::from(MOST_STOREYS)) as u32;
    let mut stream = building_stream(choices.seed, &footprint.id, "brief");
    let brief = |(name, typology): (&'a String, &'a Typology), stream: &mut Stream| {
        let (storeys, source) = told
            .unwrap_or_else(|| (stream.count(typology.storeys.0, typology.storeys.1), StoreySource::Kind));
        let known = Known { storeys: source, use_word: word.clone() };
        Brief { name, typology, storeys: storeys.min(most_storeys).max(1), known }
    };
    let mut briefs: Vec<Brief<'a>> = Vec::new();
    for names in uses.iter().filter_map(|name| Some(&typologies.uses.get(name)?.typologies)) {
        let mut fitting: Vec<((bool, f64), Brief<'a>)> = names
            .iter()
            .filter_map(|name| typologies.typologies.get_key_value(name))
            .map(|entry| {
                let brief = brief(entry, &mut stream);
                let (least, most) = brief.typology.usual_area;
                let is_usual = (least..=most).contains(&measures.area);
                ((is_usual, stream.between(0.0, brief.typology.weight)), brief)
            })
            .filter(|(_, brief)| brief.fits(measures))
            .collect();
        fitting.sort_by(|((is_usual, a), first), ((other_usual, b), second)| {
            other_usual.cmp(is_usual).then(b.total_cmp(a)).then(first.name.cmp(second.name))
        });
        briefs.extend(fitting.into_iter().map(|(_, brief)| brief));
    }
    // What no kind of its use can be is one open hall.
    if briefs.is_empty() {
        let fallback = if measures.area < 30.0 { "shed" } else { "open_hall" };
        let entry = typologies.typologies.get_key_value(fallback).or(typologies.typologies.first_key_value());
        briefs.extend(entry.map(|entry| brief(entry, &mut stream)));
    }
    // A kind of one room has no stairs: what the map counts as its storeys is its height.
    for brief in briefs.iter_mut().filter(|brief| brief.typology.plan == PlanKind::OneRoom) {
        brief.storeys = 1;
    }
    briefs
}

impl Brief<'_> {
    fn fits(&self, measures: Measures) -> bool {
        let Typology { area, depth, length, party, levels, .. } = self.typology;
        let within = |value: f64, (least, most): (f64, f64)| (least..=most).contains(&value);
        within(measures.area, *area)
            && within(measures.depth, *depth)
            && within(measures.length, *length)
            && within(measures.party, *party)
            && (levels.0..=levels.1).contains(&self.storeys)
    }
}

/// The uses by name, the likeliest first, and the word that says so.
fn uses_of(
    footprint: &Footprint,
    measures: Measures,
    typologies: &Typologies,
    choices: &Choices,
) -> (Vec<String>, Option<String>) {
    if let Some(chosen) = choices.use_name.clone() {
        return (vec![chosen], None);
    }
    let by_word = footprint.uses.iter().find_map(|(_, word)| {
        let (name, entry) = typologies.uses.iter().find(|(_, entry)| entry.words.contains(word))?;
        let (name, word) = narrower(entry, footprint, typologies).unwrap_or((name, word));
        Some((vec![name.clone()], Some(word.clone())))
    });
    by_word.unwrap_or_else(|| {
        let rule = typologies.unknown_use.iter().find(|rule| measures.area < rule.below);
        let uses = rule.map(|rule| std::iter::once(&rule.use_name).chain(&rule.otherwise).cloned().collect());
        (uses.unwrap_or_default(), None)
    })
}

/// The use that another word of the map says a use is in particular, and that word.
fn narrower<'a>(
    of: &Use,
    footprint: &'a Footprint,
    typologies: &'a Typologies,
) -> Option<(&'a String, &'a String)> {
    let uses = of.narrower.iter().filter_map(|name| typologies.uses.get_key_value(name));
    let words = || footprint.uses.iter().map(|(_, word)| word);
    uses.into_iter().find_map(|(name, entry)| Some((name, words().find(|word| entry.words.contains(word))?)))
}

fn told_storeys(facts: &StoreyFacts, choices: &Choices) -> Option<(u32, StoreySource)> {
    match choices.storeys {
        Some(chosen) => Some((chosen, StoreySource::Chosen)),
        None => facts.told(),
    }
}

impl StoreyFacts {
    /// The storeys above the ground as the map says them, or as follows from the height that it says.
    pub(crate) fn told(&self) -> Option<(u32, StoreySource)> {
        let count = |storeys: f64| (storeys.clamp(0.0, f64::from(MOST_STOREYS)) + 0.01).floor() as u32;
        if let Some(above) = self.above_ground.filter(|storeys| storeys.is_finite()) {
            return Some((count(above).max(1), StoreySource::Map));
        }
        let height = self.height.filter(|height| height.is_finite() && *height > 0.0)?;
        let walls = if height > 2.0 * STOREY { height - ROOF } else { height };
        Some((count((walls / STOREY).round()).max(1), StoreySource::Height))
    }
}
