//! Recognises maps of footprints by the beginnings of their files.

use std::path::Path;

use crate::plan::read::foreign::head;
use crate::plan::read::sample::Sample;

/// Bytes at the start of a file by which it is recognised.
const HEAD_SIZE: u64 = 64 * 1024;
/// The same where all places come before all tags.
const XML_HEAD_SIZE: u64 = 1024 * 1024;
/// Values of the key `indoor` of OpenStreetMap that make a map of rooms; `yes` stands on benches, too.
const ROOM_WORDS: [&str; 5] = ["room", "area", "corridor", "wall", "level"];

/// A format of footprints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FootprintFormat {
    /// Features with arbitrary properties (RFC 7946), in degrees or in metres.
    GeoJson,
    /// Cities in three dimensions, of which the ground is taken.
    CityJson,
    /// OpenStreetMap in XML.
    OsmXml,
    /// OpenStreetMap in blocks of protocol buffers.
    OsmPbf,
}

/// The format of a file, if it is one of footprints. Maps of rooms are none: IMDF, the Japanese indoor map, and OpenStreetMap
/// with more rooms than buildings at its beginning.
pub(crate) fn recognises(path: &Path) -> Option<FootprintFormat> {
    let sample = Sample::of(path, head(path, HEAD_SIZE));
    if sample.head.get(4..).is_some_and(|rest| rest.starts_with(b"\x0a\x09OSMHeader")) {
        return Some(FootprintFormat::OsmPbf);
    }
    if sample.is_xml("osm") {
        // Tags of areas stand behind all nodes.
        let text = String::from_utf8_lossy(&head(path, XML_HEAD_SIZE)).into_owned();
        return (!has_more_rooms_in_xml(&text)).then_some(FootprintFormat::OsmXml);
    }
    if is_cityjson(&sample) {
        return Some(FootprintFormat::CityJson);
    }
    is_geojson(&sample).then_some(FootprintFormat::GeoJson)
}

fn is_cityjson(sample: &Sample) -> bool {
    sample.text.starts_with('{') && (sample.says("type", "CityJSON") || sample.has(&["CityObjects"]))
}

fn is_geojson(sample: &Sample) -> bool {
    let is_one = sample.text.starts_with('{') && (sample.is_geojson() || sample.says("type", "Feature"));
    let is_of_rooms = ["\"feature_type\"", "\"floor_id\""].iter().any(|key| sample.text.contains(key));
    is_one && !is_of_rooms && !has_more_rooms(&sample.text)
}

/// Whether a text in JSON has more rooms than buildings.
fn has_more_rooms(text: &str) -> bool {
    let values = |key: &'static str| {
        let places = text.match_indices(key).map(move |(at, _)| &text[at + key.len()..]);
        places.filter_map(|rest| rest.trim_start().strip_prefix(':')?.trim_start().strip_prefix('"'))
    };
    let is_room = |rest: &str| {
        ROOM_WORDS.iter().any(|word| rest.strip_prefix(word).is_some_and(|rest| rest.starts_with('"')))
    };
    let rooms = values("\"indoor\"").filter(|rest| is_room(rest)).count();
    rooms > values("\"building\"").count()
}

/// Whether a text in XML has more rooms than buildings.
fn has_more_rooms_in_xml(text: &str) -> bool {
    let text = text.replace('\'', "\"");
    let is_room = |rest: &&str| {
        let value = rest.trim_start().strip_prefix("v=\"");
        value.is_some_and(|value| {
            ROOM_WORDS.iter().any(|word| value.strip_prefix(word).is_some_and(|rest| rest.starts_with('"')))
        })
    };
    const INDOOR: &str = "k=\"indoor\"";
    let rooms = text.match_indices(INDOOR).map(|(at, _)| &text[at + INDOOR.len()..]).filter(is_room).count();
    rooms > text.matches("k=\"building\"").count()
}
