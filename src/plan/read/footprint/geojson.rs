//! GeoJSON (RFC 7946, and older files with `crs`): areas with arbitrary properties.
//!
//! Each feature is read by itself, so that a large file needs no more memory than its text, and one bad feature costs no other.

mod feature;

use std::path::Path;

use serde::Deserialize;
use serde_json::value::RawValue;
use serde_json::{Deserializer, Value};

use feature::{Feature, Shape};

use super::drawn::{Drawing, Drawn};
use super::facts::{Facts, Tags, facts_of};
use super::ids::id_of_words;
use super::kind::{FileKinds, Kind, kind_of, undecided};
use super::notes::SiteNotes;
use super::properties::tags_of;
use super::streets::is_street;
use super::syntax::fault_of;
use crate::document::{Faults, Source};
use crate::plan::read::geojson::{as_collection, reference_system};

/// Metres of a storey that OSM Buildings takes where it knows none: its heights are storeys times this, at least one.
const OSM_BUILDINGS_STOREY: f64 = 4.0;
/// Keys under which an id may stand among the properties, those that others refer to before row numbers.
const ID_KEYS: [&str; 9] =
    ["@id", "id", "full_id", "osm_way_id", "osm_id", "gml_id", "uuid", "building_id", "fid"];

/// The outermost object: a collection, or a feature.
#[derive(Deserialize)]
struct Collection<'a> {
    #[serde(borrow)]
    features: Option<Vec<&'a RawValue>>,
    crs: Option<Value>,
}

/// Reads the buildings of a file.
///
/// # Errors
/// Faults of syntax, at their places.
pub(super) fn read(path: &Path) -> Result<(Drawing, SiteNotes), Faults> {
    let source = as_collection(Source::read(path)?);
    let mut reading = Reading::default();
    let mut count = 0;
    // One collection, or several one after the other.
    for value in Deserializer::from_str(source.text()).into_iter::<&RawValue>() {
        let value = value.map_err(|error| fault_of(&source, &error))?;
        let collection: Collection =
            serde_json::from_str(value.get()).map_err(|error| fault_of(&source, &error))?;
        reading.drawing.reference_system =
            reading.drawing.reference_system.or(reference_system(collection.crs.as_ref()));
        for feature in collection.features.unwrap_or_else(|| vec![value]) {
            reading.add(feature.get(), count);
            count += 1;
        }
    }
    Ok(reading.finish())
}

/// A file as far as it is read.
#[derive(Default)]
struct Reading {
    drawing: Drawing,
    notes: SiteNotes,
    kinds: FileKinds,
    /// Areas that nothing marks as buildings: they are if the file marks none.
    unmarked: Vec<Drawn>,
}

impl Reading {
    /// Reads a feature, the `index`th of its file.
    fn add(&mut self, text: &str, index: usize) {
        let place = || format!("features[{index}]");
        let feature: Feature<'_> = match serde_json::from_str(text) {
            Ok(feature) => feature,
            Err(_) => return self.notes.leave_out(place(), "it is no feature of GeoJSON"),
        };
        let tags = tags_of(feature.properties);
        let id = id_of(feature.id.as_ref(), &tags);
        let shape = match feature.geometry.map(|geometry| geometry.shape()) {
            None => return self.notes.skip("without a place"),
            Some(Ok(shape)) => shape,
            Some(Err(reason)) => return self.notes.leave_out(id.unwrap_or_else(place), reason),
        };
        match shape {
            Shape::Points(points) if tags.says("entrance") => self.drawing.entrances.extend(points),
            Shape::Lines(lines) if is_street(&tags) => self.drawing.streets.extend(lines),
            Shape::Points(_) => self.notes.skip("points"),
            Shape::Lines(_) => self.notes.skip("lines"),
            Shape::Nothing => self.notes.skip("without a place"),
            Shape::Areas(areas) if areas.is_empty() => {
                self.notes.leave_out(id.unwrap_or_else(place), "it has no outline");
            }
            Shape::Areas(areas) => {
                let kind = kind_of(&tags);
                self.kinds.note(kind);
                let facts = known_facts(facts_of(&tags), id.as_deref(), &tags);
                let is_part = kind == Kind::Part;
                let parent = tags.text("relationId").filter(|_| is_part).and_then(id_of_words);
                let drawn = Drawn { id, is_part, parent, areas, facts };
                match kind {
                    Kind::Building | Kind::Part => self.drawing.buildings.push(drawn),
                    Kind::Unmarked => self.unmarked.push(drawn),
                    Kind::Other(reason) => self.notes.skip(reason),
                }
            }
        }
    }

    fn finish(mut self) -> (Drawing, SiteNotes) {
        if self.kinds.marks_buildings() {
            (0..self.unmarked.len()).for_each(|_| self.notes.skip(undecided()));
        } else {
            self.drawing.buildings.append(&mut self.unmarked);
        }
        self.drawing.is_degrees_unless_said = true;
        (self.drawing, self.notes)
    }
}

fn id_of(id: Option<&Value>, tags: &Tags) -> Option<String> {
    let words = match id {
        Some(Value::String(words)) => id_of_words(words),
        Some(Value::Number(number)) => id_of_words(&number.to_string()),
        _ => None,
    };
    words.or_else(|| {
        ID_KEYS.iter().find_map(|key| {
            let value = tags.get(key)?;
            id_of_words(&value.words())
        })
    })
}

/// The facts without heights that OSM Buildings makes of storeys, or of nothing.
fn known_facts(mut facts: Facts, id: Option<&str>, tags: &Tags) -> Facts {
    let is_id = |id: &str| {
        let number = id.strip_prefix(['w', 'r']).unwrap_or_default();
        !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    };
    let is_osm_buildings =
        id.is_some_and(is_id) && !tags.has_any(&["building", "building:part", "building:levels"]);
    let storeys = facts.storeys.above_ground.unwrap_or(1.0);
    if is_osm_buildings && facts.storeys.height == Some(storeys * OSM_BUILDINGS_STOREY) {
        facts.storeys.height = None;
    }
    facts
}
