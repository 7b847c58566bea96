//! Recognises maps of rooms by what they hold.

use std::path::Path;

use super::geojson::OTHER_TAGS;
use super::mapped::SPACE_WORDS;
use crate::plan::read::foreign::head;
use crate::plan::read::osm::{Element, ElementKind, Elements, PbfFile};
use crate::plan::read::sample::Sample;

/// Bytes at the start of a file by which its encoding is recognised.
const HEAD_SIZE: u64 = 4096;
/// Bytes of text that are searched for rooms: their tags stand behind all nodes.
const TEXT_SIZE: u64 = 32 * 1024 * 1024;
/// Bytes of the largest packed file that is unpacked to look for rooms; larger ones are maps of cities.
const PACKED_SIZE: u64 = 16 * 1024 * 1024;
/// Buildings for each room from which on a file is a map of buildings, in which a few rooms are drawn by chance.
const CITY: usize = 100;

/// An encoding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SitFormat {
    GeoJson,
    Xml,
    Pbf,
}

/// The encoding of a file, if it is a map of rooms.
pub(super) fn recognises(path: &Path) -> Option<SitFormat> {
    let sample = Sample::read(path, HEAD_SIZE);
    if sample.head.get(4..).is_some_and(|rest| rest.starts_with(b"\x0a\x09OSMHeader")) {
        return has_rooms_in_pbf(path).then_some(SitFormat::Pbf);
    }
    if sample.is_xml("osm") {
        let text = String::from_utf8_lossy(&head(path, TEXT_SIZE)).replace('\'', "\"");
        return is_of_rooms(counts(&text, ["k=\"indoor\"", "k=\"building\""], "v="))
            .then_some(SitFormat::Xml);
    }
    if !sample.is_object() || !(sample.is_geojson() || sample.says("type", "Feature")) {
        return None;
    }
    let mut text = String::from_utf8_lossy(&head(path, TEXT_SIZE)).into_owned();
    if text.contains(OTHER_TAGS) {
        text = text.replace("\\\"", "\"").replace("=>", ":");
    }
    let is_other = sample.holds_one_of(&["\"feature_type\"", "\"floor_id\""]);
    (!is_other && is_of_rooms(counts(&text, ["\"indoor\"", "\"building\""], ":")))
        .then_some(SitFormat::GeoJson)
}

/// Whether a file with some rooms and buildings is a map of rooms.
fn is_of_rooms((rooms, buildings): (usize, usize)) -> bool {
    rooms > 0 && rooms.saturating_mul(CITY) >= buildings
}

/// How many rooms and buildings a text has, by the keys and the sign between key and value.
fn counts(text: &str, [indoor, building]: [&str; 2], sign: &str) -> (usize, usize) {
    let is_room = |rest: &str| {
        let value = rest.trim_start().strip_prefix(sign).map(str::trim_start);
        let value = value.and_then(|value| value.strip_prefix('"')).unwrap_or_default();
        SPACE_WORDS.iter().any(|word| value.strip_prefix(word).is_some_and(|rest| rest.starts_with('"')))
    };
    let rooms = text.match_indices(indoor).filter(|(at, key)| is_room(&text[at + key.len()..])).count();
    (rooms, text.matches(building).count())
}

fn has_rooms_in_pbf(path: &Path) -> bool {
    let is_small = path.metadata().is_ok_and(|found| found.len() <= PACKED_SIZE);
    let Some(file) = is_small.then(|| PbfFile::open(path).ok()).flatten() else { return false };
    let mut counts = (0, 0);
    let mut count = |element: Element<'_>| {
        let mut tags = element.tags.iter();
        counts.0 +=
            usize::from(tags.any(|(key, value)| key == "indoor" && SPACE_WORDS.contains(&value.as_ref())));
        counts.1 += usize::from(element.has("building"));
    };
    // A damaged file is reported by the reader that takes it.
    let read = [ElementKind::Way, ElementKind::Relation].map(|kind| file.each(kind, &mut count).is_ok());
    read.into_iter().all(|is_read| is_read) && is_of_rooms(counts)
}
