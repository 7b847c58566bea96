//! CityJSON 1.0, 1.1 and 2.0, and its sequences (one object of features on each line): buildings with their parts.
//!
//! Objects are read one by one, so that a large file needs little more memory than its text. What a building has of geometry is
//! taken in the order of [`ground`].

mod geometry;
mod ground;

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde_json::value::RawValue;
use serde_json::{Deserializer, Map, Value};

use geometry::{Geometry, Vertices};
use ground::{Ground, ground_of};

use super::drawn::{Drawing, Drawn};
use super::facts::facts_of;
use super::ids::id_of_words;
use super::notes::SiteNotes;
use super::properties::tags_of;
use super::syntax::fault_of;
use crate::document::{Fault, Faults, Source};

/// Bytes of the text of one object beyond which it is no building: the largest models of one have a tenth.
const LARGEST_OBJECT: usize = 16 * 1024 * 1024;

/// The outermost object of a file, or of a line of a sequence.
#[derive(Deserialize)]
struct City<'a> {
    metadata: Option<Metadata>,
    transform: Option<Transform>,
    #[serde(borrow, rename = "CityObjects", default)]
    objects: BTreeMap<String, &'a RawValue>,
    #[serde(default)]
    vertices: Vec<[f64; 3]>,
}

#[derive(Default, Deserialize)]
struct Metadata {
    #[serde(rename = "referenceSystem")]
    reference_system: Option<String>,
    #[serde(rename = "geographicalExtent")]
    extent: Option<[f64; 6]>,
}

/// How whole numbers become coordinates.
#[derive(Clone, Copy, Debug, Deserialize)]
struct Transform {
    scale: [f64; 3],
    translate: [f64; 3],
}

/// An object of a city.
#[derive(Deserialize)]
struct CityObject {
    #[serde(rename = "type", default)]
    kind: String,
    attributes: Option<Map<String, Value>>,
    geometry: Option<Vec<Geometry>>,
    parents: Option<Vec<String>>,
}

/// Reads the buildings of a file.
///
/// # Errors
/// Faults of syntax, at their places.
pub(super) fn read(path: &Path) -> Result<(Drawing, SiteNotes), Faults> {
    let source = Source::read(path)?;
    let (mut drawing, mut notes) = (Drawing::default(), SiteNotes::default());
    let mut transform = None;
    for city in Deserializer::from_str(source.text()).into_iter::<City<'_>>() {
        let city = city.map_err(|error| fault_of(&source, &error))?;
        // Of a sequence, the first line has what holds for all.
        transform = city.transform.or(transform);
        let Metadata { reference_system, extent } = city.metadata.unwrap_or_default();
        drawing.reference_system = drawing.reference_system.or(reference_system);
        let vertices = placed(city.vertices, transform, extent, &mut notes);
        for (id, text) in city.objects {
            add(&id, text.get(), &vertices, &mut drawing, &mut notes);
        }
    }
    if drawing.buildings.is_empty() && notes.no_buildings.is_empty() && notes.left_out.is_empty() {
        return Err(Fault::of_file(path, "has no objects: \"CityObjects\" is empty").into());
    }
    Ok((drawing, notes))
}

/// The vertices in the units of the reference system. Some writers name a translation that the vertices have already: where the
/// extent of the city says so, it is not made twice.
fn placed(
    vertices: Vertices,
    transform: Option<Transform>,
    extent: Option<[f64; 6]>,
    notes: &mut SiteNotes,
) -> Vertices {
    let Some(Transform { scale, translate }) = transform else { return vertices };
    let moved = |by: [f64; 3]| -> Vertices {
        let place = |vertex: &[f64; 3]| std::array::from_fn(|axis| vertex[axis] * scale[axis] + by[axis]);
        vertices.iter().map(place).collect()
    };
    let placed = moved(translate);
    let Some([west, south, _, east, north, _]) = extent else { return placed };
    let is_inside =
        |vertex: &[f64; 3]| (west..=east).contains(&vertex[0]) && (south..=north).contains(&vertex[1]);
    if vertices.is_empty() || placed.iter().any(is_inside) {
        return placed;
    }
    let still = moved([0.0; 3]);
    if !still.iter().all(is_inside) {
        return placed;
    }
    notes.assumed.push(
        "\"translate\" is passed over: without it, the vertices lie in \"geographicalExtent\"".to_owned(),
    );
    still
}

fn add(key: &str, text: &str, vertices: &Vertices, drawing: &mut Drawing, notes: &mut SiteNotes) {
    let id = id_of_words(key).unwrap_or_else(|| "nameless".to_owned());
    if text.len() > LARGEST_OBJECT {
        let most = LARGEST_OBJECT >> 20;
        return notes.leave_out(id, format!("its text has {} MB, {most} are the most", text.len() >> 20));
    }
    let Ok(object) = serde_json::from_str::<CityObject>(text) else {
        return notes.leave_out(id, "it is no object of CityJSON");
    };
    let is_part = object.kind == "BuildingPart";
    if !is_part && object.kind != "Building" {
        return notes.skip("objects of other kinds");
    }
    let attribute = object.attributes.as_ref().and_then(|attributes| attributes.get("footprint"));
    let Ground { areas, height } =
        ground_of(object.geometry.as_deref().unwrap_or_default(), vertices, attribute);
    let mut facts = facts_of(&tags_of(object.attributes));
    facts.storeys.height = facts.storeys.height.or(height);
    let parent =
        object.parents.iter().flatten().next().filter(|_| is_part).and_then(|parent| id_of_words(parent));
    if areas.is_empty() && is_part {
        return notes.leave_out(id, "it has no outline");
    }
    drawing.buildings.push(Drawn { id: Some(id), is_part, parent, areas, facts });
}
