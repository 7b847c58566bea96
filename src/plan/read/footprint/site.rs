//! Makes a site of a drawing: metres, sound outlines, one footprint for each building.

use std::collections::BTreeMap;
use std::path::Path;

use rayon::prelude::*;

use super::ReadSite;
use super::drawn::{Drawing, Drawn};
use super::entrances::add_entrances;
use super::facts::Facts;
use super::frame::{Frame, in_true_metres};
use super::ids::{id_of_place, unique_ids};
use super::merge::{Item, Whole, in_pieces, wholes, with_parts};
use super::notes::{SiteNotes, Split, Unreadable};
use super::sound::{Sound, sound, united};
use super::tidy::tidied;
use crate::document::{Fault, Faults};
use crate::geometry::{Point, Region};
use crate::plan::limits::is_place;
use crate::storey::{Footprint, FootprintPart, Site};

/// The site of a drawing. The order of the buildings in the drawing does not show in it.
///
/// # Errors
/// Coordinates that are no degrees although they should be; no building with a usable outline.
pub(super) fn site_of(drawing: Drawing, mut notes: SiteNotes, file: &Path) -> Result<ReadSite, Faults> {
    let mut drawing = in_true_metres(drawing);
    notes.drawn = drawing.buildings.len() + notes.left_out.len() + notes.duplicates.len();
    if drawing.buildings.is_empty() {
        return Err(nothing(notes, file));
    }
    let frame = Frame::of(&drawing, file)?;
    notes.assumed.extend(frame.assumed(&drawing));
    let buildings = std::mem::take(&mut drawing.buildings);
    let cleaned: Vec<Cleaned> = buildings.into_par_iter().map(|drawn| cleaned(drawn, &frame)).collect();
    let Sorted { buildings, parts, shells } = sorted(cleaned, &mut notes);
    let wholes = with_parts(wholes(buildings, &mut notes), parts, &shells, &mut notes);
    note_shells(&wholes, shells, &mut notes);
    let mut footprints = footprints_of(in_pieces(wholes, &mut notes));
    let entrances: Vec<Point> = drawing.entrances.iter().map(|place| frame.to_plane(*place)).collect();
    add_entrances(&mut footprints, &entrances);
    if footprints.is_empty() {
        return Err(nothing(notes, file));
    }
    notes.sort();
    let mut faults = notes.faults(file);
    faults.sort();
    let streets = streets_of(&drawing, &frame);
    let reference_system = frame.name_of(&drawing);
    let site = Site { reference_system, origin: frame.origin(), footprints, streets };
    Ok(ReadSite { site, faults, notes })
}

/// The regions of a drawn building, or the reason why it has none.
struct Cleaned {
    id: String,
    drawn: Drawn,
    regions: Result<Vec<Region>, String>,
    is_mended: bool,
}

fn cleaned(drawn: Drawn, frame: &Frame) -> Cleaned {
    let outer = drawn.areas.first().map(|rings| rings.outer.as_slice()).unwrap_or_default();
    let id = drawn.id.clone().unwrap_or_else(|| id_of_place(outer, frame.is_degrees()));
    let found: Vec<Result<Sound, String>> =
        drawn.areas.iter().map(|rings| sound(&frame.rings_to_plane(rings))).collect();
    let is_mended = found.iter().flatten().any(|sound| sound.is_mended);
    let mut reasons = Vec::new();
    let mut regions = Vec::new();
    for area in found {
        match area {
            Ok(sound) => regions.push(sound.region),
            Err(reason) => reasons.push(reason),
        }
    }
    if regions.len() > 1 {
        // Areas that share an edge are one building.
        regions = united(&regions);
    }
    let regions: Vec<Region> = regions.into_iter().map(tidied).collect();
    let regions = match reasons.into_iter().next() {
        Some(reason) if regions.is_empty() => Err(reason),
        _ => Ok(regions),
    };
    Cleaned { id, drawn: Drawn { areas: Vec::new(), ..drawn }, regions, is_mended }
}

/// What a map draws, by kind.
#[derive(Default)]
struct Sorted {
    buildings: Vec<Item>,
    parts: Vec<Item>,
    /// Buildings that have no area but that of their parts.
    shells: BTreeMap<String, Facts>,
}

fn sorted(cleaned: Vec<Cleaned>, notes: &mut SiteNotes) -> Sorted {
    let mut sorted = Sorted::default();
    for Cleaned { id, drawn, regions, is_mended } in cleaned {
        let unreadable = drawn.facts.unreadable.iter().cloned();
        notes.unreadable.extend(unreadable.map(|(key, value)| Unreadable { id: id.clone(), key, value }));
        if is_mended {
            notes.mended.push(id.clone());
        }
        let regions = match regions {
            Ok(regions) => regions,
            Err(reason) => {
                notes.leave_out(id, reason);
                continue;
            }
        };
        if regions.is_empty() {
            sorted.shells.insert(id, drawn.facts);
            continue;
        }
        let count = regions.len();
        if count > 1 {
            notes.split.push(Split { id: id.clone(), pieces: count });
        }
        let list = if drawn.is_part { &mut sorted.parts } else { &mut sorted.buildings };
        list.extend(regions.into_iter().enumerate().map(|(index, region)| Item {
            id: if count > 1 { format!("{id}-{}", index + 1) } else { id.clone() },
            parent: drawn.parent.clone(),
            region,
            facts: drawn.facts.clone(),
        }));
    }
    sorted
}

/// Notes buildings that have neither an outline nor parts.
fn note_shells(wholes: &[Whole], mut shells: BTreeMap<String, Facts>, notes: &mut SiteNotes) {
    for part in wholes.iter().flat_map(|whole| &whole.parts) {
        part.parent.as_ref().map(|parent| shells.remove(parent));
    }
    shells.into_keys().for_each(|id| notes.leave_out(id, "it has no outline"));
}

fn footprints_of(mut wholes: Vec<Whole>) -> Vec<Footprint> {
    // Those of one id are large ones before small ones, as the wholes are.
    wholes.sort_by(|a, b| a.building.id.cmp(&b.building.id));
    let ids = wholes.iter().map(|whole| whole.building.id.clone()).collect();
    let mut footprints: Vec<Footprint> =
        wholes.into_iter().zip(unique_ids(ids)).map(|(whole, id)| footprint(whole, id)).collect();
    footprints.sort_by(|a, b| a.id.cmp(&b.id));
    footprints
}

fn footprint(Whole { building, mut parts }: Whole, id: String) -> Footprint {
    let Item { region, facts, .. } = building;
    let bottom = |part: &Item| part.facts.storeys.bottom.or(part.facts.storeys.lowest).unwrap_or_default();
    // Those of one bottom are large ones before small ones.
    parts.sort_by(|a, b| bottom(a).total_cmp(&bottom(b)));
    let part = |part: Item| FootprintPart { region: part.region, storeys: part.facts.storeys };
    let Facts { name, storeys, uses, flats, .. } = facts;
    Footprint {
        id,
        name,
        region,
        parts: parts.into_iter().map(part).collect(),
        storeys,
        uses,
        flats,
        entrances: Vec::new(),
    }
}

fn streets_of(drawing: &Drawing, frame: &Frame) -> Vec<Vec<Point>> {
    let street = |line: &Vec<Point>| {
        let mut points: Vec<Point> =
            line.iter().map(|place| frame.to_plane(*place)).filter(|point| is_place(*point)).collect();
        points.dedup();
        points
    };
    let mut streets: Vec<Vec<Point>> =
        drawing.streets.iter().map(street).filter(|points| points.len() > 1).collect();
    let key = |point: &Point| [point.x, point.y];
    streets.sort_by(|a, b| {
        let pairs = a.iter().flat_map(key).zip(b.iter().flat_map(key));
        let first = pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne());
        first.unwrap_or_else(|| a.len().cmp(&b.len()))
    });
    streets.dedup();
    streets
}

/// The faults of a file without a building.
fn nothing(mut notes: SiteNotes, file: &Path) -> Faults {
    notes.sort();
    let counts: Vec<String> =
        notes.no_buildings.iter().map(|(reason, count)| format!("{reason} ({count})")).collect();
    let fact = match (notes.drawn, counts.is_empty()) {
        (0, true) => "holds no building".to_owned(),
        (0, false) => format!("holds no building: {}", counts.join(", ")),
        (count, _) => format!("holds no building with a usable outline, of {count}"),
    };
    let hint = "buildings are areas, with tags such as \"building\": \"yes\" where there are other areas too";
    let mut faults = notes.faults(file);
    faults.push(Fault::of_file(file, fact).with_hint(hint));
    faults.sort();
    faults
}
