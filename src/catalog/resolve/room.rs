//! Resolves room types.

use std::ops::RangeInclusive;

use super::names::{NamedClasses, Names};
use super::number::{AREA, DISTANCE, Quantity, SHARE};
use super::request::{ResolvedProgramme, resolve_programme};
use super::resolve_label;
use crate::catalog::file::{Pair, RoomTypeEntry};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Chain;
use crate::catalog::{Dado, Finish, Plausible, RoomType, Share};
use crate::recipes::Slot;

/// Metres of wall for each socket where nothing is said, and what may be said besides 0.
const SOCKET_INTERVAL: f64 = 3.0;
const SOCKET_INTERVALS: RangeInclusive<f64> = 0.5..=100.0;

/// A room type and the words that it was made of.
pub(crate) struct ResolvedRoomType {
    /// The room type.
    pub(crate) room_type: RoomType,
    /// Its own programme, with the words that it was made of.
    pub(crate) programme: ResolvedProgramme,
    /// The classes that it excludes.
    pub(crate) excluded: Vec<NamedClasses>,
}

/// All room types that are not abstract and not broken, sorted by id. Abstract ones are checked too.
pub(crate) fn resolve_room_types(
    chains: &[Chain<'_, RoomTypeEntry>],
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Vec<ResolvedRoomType> {
    let resolved =
        chains.iter().map(|chain| (chain.own().entry.is_abstract, resolve_room_type(chain, names, report)));
    resolved.filter(|(is_abstract, _)| !is_abstract).map(|(_, room_type)| room_type).collect()
}

fn resolve_room_type(
    chain: &Chain<'_, RoomTypeEntry>,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> ResolvedRoomType {
    let density = chain.find("density", |entry| entry.density.as_ref());
    let density = density.map_or((0.0, 1.0), |found| {
        Quantity::plain("density", SHARE).check_pair(found.value.both(), &found.spot, report)
    });
    let area = chain.find("area", |entry| entry.area.as_ref());
    let area = area.map_or((*AREA.start(), *AREA.end()), |found| {
        Quantity { name: "area", unit: " m²", range: AREA }.check_pair(
            found.value.both(),
            &found.spot,
            report,
        )
    });
    let excluded = resolve_excludes(chain, names, report);
    let programme = chain.find("programme", |entry| entry.programme.as_deref());
    let programme =
        programme.map(|found| resolve_programme(found.value, &found.spot, names, report)).unwrap_or_default();
    let mut excludes: Vec<String> = excluded.iter().map(|one| one.word.clone()).collect();
    excludes.sort();
    excludes.dedup();
    let room_type = RoomType {
        id: chain.own().id.clone(),
        label: resolve_label(chain, |entry| entry.label.as_ref()),
        is_furnished: chain.find("furnish", |entry| entry.furnish.as_ref()).is_none_or(|found| *found.value),
        joins_levels: chain
            .find("joins_levels", |entry| entry.joins_levels.as_ref())
            .is_some_and(|found| *found.value),
        programme: programme.requests.clone(),
        excludes,
        area,
        plausible: resolve_plausible(chain, report),
        density,
        finish: resolve_finish(chain, report),
        share: chain
            .find("share", |entry| entry.share.as_ref())
            .map_or(Share::Building, |found| (*found.value).into()),
    };
    ResolvedRoomType { room_type, programme, excluded }
}

/// Key by key from the nearest definition that says something.
fn resolve_plausible(chain: &Chain<'_, RoomTypeEntry>, report: &mut Report<'_>) -> Plausible {
    let mut pair = |quantity: Quantity, get: fn(&RoomTypeEntry) -> Option<&Pair>| {
        let found = chain.find("plausible", get)?;
        Some(quantity.check_pair(found.value.both(), &found.spot.key(quantity.name), report))
    };
    let everything = Plausible::default();
    let area = Quantity { name: "area", unit: " m²", range: AREA };
    Plausible {
        area: pair(area, |entry| entry.plausible.as_ref()?.area.as_ref()).unwrap_or(everything.area),
        height: pair(Quantity::metres("height", DISTANCE), |entry| entry.plausible.as_ref()?.height.as_ref())
            .unwrap_or(everything.height),
    }
}

fn resolve_excludes(
    chain: &Chain<'_, RoomTypeEntry>,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Vec<NamedClasses> {
    let Some(found) = chain.find("excludes", |entry| entry.excludes.as_ref()) else { return Vec::new() };
    let words = found.value.items();
    words.filter_map(|(place, word)| names.classes(word, &found.spot.item(place), report)).collect()
}

fn resolve_finish(chain: &Chain<'_, RoomTypeEntry>, report: &mut Report<'_>) -> Finish {
    let dado = resolve_dado(chain, report);
    let sockets = resolve_sockets(chain, report);
    let switches = chain.find("finish", |entry| entry.finish.as_ref()?.switches.as_ref());
    let mut slot = |key: &str, get: fn(&RoomTypeEntry) -> Option<&String>, default: Slot| {
        let Some(found) = chain.find("finish", get) else { return default };
        find_slot(found.value, &found.spot.key(key), report).unwrap_or(default)
    };
    Finish {
        floor: slot("floor", |entry| entry.finish.as_ref()?.floor.as_ref(), Slot::Parquet),
        wall: slot("wall", |entry| entry.finish.as_ref()?.wall.as_ref(), Slot::Plaster),
        ceiling: slot("ceiling", |entry| entry.finish.as_ref()?.ceiling.as_ref(), Slot::Ceiling),
        dado,
        sockets,
        has_switches: switches.is_none_or(|found| *found.value),
    }
}

/// The lower part of the walls; a height of zero takes an inherited one away.
fn resolve_dado(chain: &Chain<'_, RoomTypeEntry>, report: &mut Report<'_>) -> Option<Dado> {
    let found = chain.find("finish", |entry| entry.finish.as_ref()?.dado.as_ref())?;
    let spot = found.spot.key("dado");
    let slot = find_slot(&found.value.slot, &spot.key("slot"), report);
    let height = Quantity::metres("dado", DISTANCE).check(found.value.height, &spot.key("height"), report);
    (height > 0.0).then_some(Dado { slot: slot?, height })
}

/// Metres of wall for each socket; zero for none.
fn resolve_sockets(chain: &Chain<'_, RoomTypeEntry>, report: &mut Report<'_>) -> Option<f64> {
    let Some(found) = chain.find("finish", |entry| entry.finish.as_ref()?.sockets.as_ref()) else {
        return Some(SOCKET_INTERVAL);
    };
    let interval = Quantity::metres("sockets", SOCKET_INTERVALS);
    (*found.value != 0.0).then(|| interval.check(*found.value, &found.spot.key("sockets"), report))
}

/// The material slot of a word; an unknown word is reported.
pub(super) fn find_slot(word: &str, spot: &Spot, report: &mut Report<'_>) -> Option<Slot> {
    let slot = Slot::find(word);
    if slot.is_none() {
        report.unknown(spot, "material slot", word, Slot::ALL.iter().map(|slot| slot.name()));
    }
    slot
}
