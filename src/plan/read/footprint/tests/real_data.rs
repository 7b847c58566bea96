//! The shared maps: every building of them is read.

use std::time::Instant;

use super::{ReadSite, assert_accounted, read_site};
use crate::plan::read::footprint::drawn::Drawn;
use crate::plan::read::footprint::osm;
use crate::plan::read::real_data::footprints;

/// Reads a shared map, tells its figures, and checks that nothing is lost. Draws buildings and parts `drawn` in all.
fn read_map(name: &str, drawn: usize) -> Option<ReadSite> {
    let path = footprints(name)?;
    let start = Instant::now();
    let read = read_site(&path).unwrap_or_else(|faults| panic!("{faults}"));
    let notes = &read.notes;
    println!(
        "{name}: {:.0} ms, {} drawn, {} footprints, {} duplicates, {} parts, {} left out, {} split, {} made of parts, \
         {} mended, {} unreadable, {:?}, {} streets, {} entrances, {:?} {:?}",
        start.elapsed().as_secs_f64() * 1000.0,
        notes.drawn,
        read.site.footprints.len(),
        notes.duplicates.len(),
        notes.parts.len(),
        notes.left_out.len(),
        notes.split.len(),
        notes.made_of_parts.len(),
        notes.mended.len(),
        notes.unreadable.len(),
        notes.no_buildings,
        read.site.streets.len(),
        read.site.footprints.iter().map(|footprint| footprint.entrances.len()).sum::<usize>(),
        read.site.reference_system,
        read.site.origin,
    );
    println!("{}\n{:?}", read.faults, notes.left_out);
    assert_eq!(notes.drawn, drawn, "{name}");
    assert_accounted(&read);
    Some(read)
}

#[test]
fn all_buildings_of_berlin_are_read() {
    let Some(read) = read_map("geojson-osmbuildings-berlin/buildings.geojson", 2105) else { return };
    println!("{:?}\n{:?}\n{:?}", read.notes.parts, read.notes.made_of_parts, read.notes.mended);
}

#[test]
fn all_buildings_of_the_netherlands_are_read() {
    read_map("geojson-overture-nl/buildings.geojson", 3754);
}

#[test]
fn all_buildings_of_urbanopt_are_read() {
    read_map("geojson-urbanopt/nrel_stm_footprints.geojson", 35);
}

#[test]
fn all_buildings_of_salt_river_are_read() {
    let Some(read) = read_map("cityjson-geo3d/citjsn_sRiver3D.json", 1377) else { return };
    assert_eq!(read.site.origin.position, [266_000.0, 6_243_000.0]);
    let [longitude, latitude] = read.site.origin.degrees.unwrap();
    assert!((longitude - 18.47).abs() < 0.02 && (latitude + 33.93).abs() < 0.02, "{longitude} {latitude}");
}

#[test]
fn all_buildings_of_the_dutch_samples_are_read() {
    for (file, drawn, footprints) in [("delft", 160, 160), ("multi_lod", 10, 10), ("DH_01_subs.city", 12, 4)]
    {
        let Some(read) = read_map(&format!("cityjson-cjio/{file}.json"), drawn) else { return };
        assert_eq!(read.site.footprints.len(), footprints, "{file}");
    }
}

#[test]
fn all_buildings_of_monaco_are_read() {
    // 1,183 ways and 24 relations, and 13 parts.
    let name = "osm-monaco/monaco-latest.osm.pbf";
    let Some(read) = read_map(name, 1220) else { return };
    let (drawing, _) = osm::read_pbf(&footprints(name).unwrap()).unwrap();
    let of_relations = |drawn: &&Drawn| drawn.id.as_ref().is_some_and(|id| id.starts_with('r'));
    let buildings = || drawing.buildings.iter().filter(|drawn| !drawn.is_part);
    assert_eq!((buildings().count(), buildings().filter(of_relations).count()), (1207, 24));
    assert!(read.site.streets.len() > 500);
}

#[test]
fn all_buildings_of_prague_are_read() {
    // 267 buildings and 40 parts.
    read_map("osm-prague/prague_vinohrady.osm", 307);
}
