//! Recognises maps of footprints by the beginnings of their files.

use std::path::Path;

use crate::plan::read::sample::Sample;

/// Bytes at the start of a file by which it is recognised.
const HEAD_SIZE: u64 = 64 * 1024;

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

/// The format of a file, if it is one of footprints. IMDF and the Japanese indoor map are none. Maps of OpenStreetMap with rooms
/// are taken by the reader of these, which is asked before; here they count for their outlines of buildings.
pub(crate) fn recognises(path: &Path) -> Option<FootprintFormat> {
    let sample = Sample::read(path, HEAD_SIZE);
    if sample.head.get(4..).is_some_and(|rest| rest.starts_with(b"\x0a\x09OSMHeader")) {
        return Some(FootprintFormat::OsmPbf);
    }
    if sample.is_xml("osm") {
        return Some(FootprintFormat::OsmXml);
    }
    if is_cityjson(&sample) {
        return Some(FootprintFormat::CityJson);
    }
    is_geojson(&sample).then_some(FootprintFormat::GeoJson)
}

fn is_cityjson(sample: &Sample) -> bool {
    sample.is_object() && (sample.says("type", "CityJSON") || sample.has(&["CityObjects"]))
}

fn is_geojson(sample: &Sample) -> bool {
    let is_one = sample.is_object() && (sample.is_geojson() || sample.says("type", "Feature"));
    let is_of_rooms = sample.holds_one_of(&["\"feature_type\"", "\"floor_id\""]);
    is_one && !is_of_rooms
}
