//! Counts and guarantees on the shared apartment blocks, and faults of broken files.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use geo::{Buffer, Intersects};

use super::areas::Area;
use super::drawing::Drawing;
use super::{read, recognises};
use crate::document::{Faults, Source};
use crate::geometry::Point;
use crate::plan::read::reader::DraftedBuilding;
use crate::plan::read::real_data::{folder, words};
use crate::plan::units::metres_per_pixel;
use crate::plan::{Leaf, Level, LevelDraft, OpeningKind, Problem, assemble_level};

/// The paths of everything that is read: one site and eight drawings.
fn inputs(data: &Path) -> Vec<PathBuf> {
    let drawings = std::fs::read_dir(data.join("annotations")).unwrap();
    let mut inputs: Vec<PathBuf> = drawings.map(|entry| entry.unwrap().path()).collect();
    inputs.push(data.join("site_1440"));
    inputs.sort();
    inputs
}

fn buildings(data: &Path) -> Vec<DraftedBuilding> {
    let words = words();
    inputs(data)
        .iter()
        .flat_map(|path| {
            assert!(recognises(path), "{}", path.display());
            let found = read(path, &words).unwrap_or_else(|faults| panic!("{faults}"));
            assert!(found.faults.is_empty(), "{}", found.faults);
            found.buildings
        })
        .collect()
}

/// A level of the shared data, by `<building>/<level>`.
struct Assembled {
    name: String,
    draft: LevelDraft,
    level: Level,
    problems: Vec<Problem>,
}

/// All levels, assembled once for all tests.
fn levels(data: &Path) -> &'static [Assembled] {
    static LEVELS: OnceLock<Vec<Assembled>> = OnceLock::new();
    LEVELS.get_or_init(|| assemble_all(data))
}

fn assemble_all(data: &Path) -> Vec<Assembled> {
    let named = buildings(data).into_iter().flat_map(|building| {
        building.draft.levels.into_iter().map(move |draft| (format!("{}/{}", building.id, draft.id), draft))
    });
    named
        .map(|(name, draft)| {
            let (level, problems) = assemble_level(draft.clone());
            Assembled { name, draft, level, problems }
        })
        .collect()
}

/// All drawings of the shared data with their areas, straight from the files.
fn drawings(data: &Path) -> Vec<(Drawing, Vec<Area>)> {
    #[derive(serde::Deserialize, schemars::JsonSchema)]
    struct Row {
        plan_id: i64,
        data: Drawing,
    }
    let site = data.join("site_1440");
    let rows: Vec<Row> = parse(&site.join("react_planner_projects.json"));
    let mut drawings = Vec::new();
    for row in rows {
        let mut areas: Vec<Area> = parse(&site.join("areas.json"));
        areas.retain(|area| area.plan_id == Some(row.plan_id));
        drawings.push((row.data, areas));
    }
    for path in inputs(data).iter().filter(|path| path.is_file()) {
        let name = format!("areas_{}", path.file_name().unwrap().to_str().unwrap());
        drawings.push((parse(path), parse(&data.join("areas").join(name))));
    }
    drawings
}

fn parse<T: for<'de> serde::Deserialize<'de> + schemars::JsonSchema>(path: &Path) -> T {
    Source::read(path).unwrap().parse().unwrap_or_else(|faults: Faults| panic!("{faults}"))
}

fn count<'a>(words: impl Iterator<Item = &'a str>) -> BTreeMap<&'a str, usize> {
    let mut counts = BTreeMap::new();
    for word in words {
        *counts.entry(word).or_default() += 1;
    }
    counts
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_drawings_have_the_counts_of_their_source() {
    let Some(data) = folder("archilyse") else { return };
    let drawings = drawings(&data);
    assert_eq!(drawings.len(), 14);
    let (site, others) = drawings.split_at(6);
    let area_count =
        |floors: &[(Drawing, Vec<Area>)]| floors.iter().map(|(_, areas)| areas.len()).sum::<usize>();
    assert_eq!((area_count(site), area_count(others)), (742, 373));
    let holes = drawings.iter().flat_map(|(drawing, _)| drawing.holes());
    let holes = count(holes.map(|(_, hole)| hole.kind.as_str()));
    let expected = [("door", 488), ("entrance_door", 147), ("sliding_door", 62), ("window", 284)];
    assert_eq!(holes.into_iter().collect::<Vec<_>>(), expected);
    let fixtures: Vec<_> = drawings.iter().flat_map(|(drawing, _)| drawing.fixtures(1.0)).collect();
    let fixtures = count(fixtures.iter().map(|fixture| fixture.kind.as_str()));
    for (kind, number) in
        [("toilet", 131), ("sink", 131), ("bathtub", 68), ("shower", 59), ("kitchen", 138), ("elevator", 37)]
    {
        assert_eq!(fixtures[kind], number, "{kind}");
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn a_site_is_one_building_with_its_floors_in_order() {
    let Some(data) = folder("archilyse") else { return };
    let site = read(&data.join("site_1440"), &words()).unwrap().buildings;
    assert_eq!(site.len(), 1);
    let levels = &site[0].draft.levels;
    let ids: Vec<&str> = levels.iter().map(|level| level.id.as_str()).collect();
    assert_eq!(ids, ["floor_0", "floor_1", "floor_2", "floor_3", "floor_4", "floor_5"]);
    assert!(levels.windows(2).all(|pair| (pair[1].elevation - pair[0].elevation - 2.9).abs() < 1e-9));
    let rooms: usize = levels.iter().map(|level| level.rooms.len()).sum();
    assert_eq!(rooms, 742);
    let named = levels.iter().flat_map(|level| &level.rooms).filter(|room| room.name.is_some());
    assert_eq!(named.count(), 630);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn two_floors_of_one_number_have_ids_of_their_own() {
    let Some(data) = folder("archilyse") else { return };
    let site = tempfile::tempdir().unwrap();
    for file in std::fs::read_dir(data.join("site_1440")).unwrap().map(Result::unwrap) {
        let text = std::fs::read_to_string(file.path()).unwrap();
        let text = text.replacen("\"floor_number\": 1,", "\"floor_number\": 0,", 1);
        std::fs::write(site.path().join(file.file_name()), text).unwrap();
    }
    let buildings = read(site.path(), &words()).unwrap().buildings;
    let ids: Vec<&str> = buildings[0].draft.levels.iter().map(|level| level.id.as_str()).collect();
    assert_eq!(ids, ["floor_0", "floor_0_2", "floor_2", "floor_3", "floor_4", "floor_5"]);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn every_shared_floor_assembles_without_errors() {
    let Some(data) = folder("archilyse") else { return };
    let levels = levels(&data);
    assert_eq!(levels.len(), 14);
    let mut slivers = 0;
    for Assembled { name, draft, level, problems } in levels {
        for problem in problems {
            assert!(!problem.is_error, "{name}: {}", problem.message);
            let is_sliver = problem.message.contains("is a sliver of 0.0");
            assert!(is_sliver || problem.message.contains("was cut into"), "{name}: {}", problem.message);
            slivers += usize::from(is_sliver);
        }
        assert_eq!(level.height, draft.height);
        assert!(level.rooms.iter().all(|room| (room.height - 2.6).abs() < 1e-9));
    }
    assert_eq!(slivers, 3, "two shafts and one unnamed area below 0.05 m²");
    let rooms: usize = levels.iter().map(|assembled| assembled.level.rooms.len()).sum();
    assert_eq!(rooms + slivers, 1115);
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn openings_of_the_shared_floors_join_the_rooms_that_they_touch() {
    let Some(data) = folder("archilyse") else { return };
    let mut sides: BTreeMap<(String, usize), usize> = BTreeMap::new();
    for Assembled { draft, level, .. } in levels(&data) {
        for opening in &draft.openings {
            // A window in pieces counts once, with its first piece.
            let placed = level.openings.iter().find(|placed| placed.id == opening.id).unwrap();
            let kind = format!("{:?}", opening.kind);
            *sides.entry((kind, placed.sides.len())).or_default() += 1;
        }
    }
    // 488 doors, of which the drawing shows two against one room only, with another behind a gap or a corner; and
    // 147 entrance doors, 33 of them to the open air.
    assert_eq!(sides[&("Door".to_owned(), 2)], 488 + 114);
    assert_eq!(sides[&("Door".to_owned(), 1)], 33);
    assert_eq!(sides[&("SlidingDoor".to_owned(), 2)], 62);
    // By the grown polygon 76 windows touch two areas; some only at a corner behind a partition.
    assert_eq!(sides[&("Window".to_owned(), 2)] + sides[&("Window".to_owned(), 1)], 284);
    assert!((50..=80).contains(&sides[&("Window".to_owned(), 2)]), "{sides:?}");
}

/// Another way to attach, straight from the data's description: grow the opening by 5 cm, take what it meets.
#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn attachment_agrees_with_growing_the_opening() {
    let Some(data) = folder("archilyse") else { return };
    let levels: Vec<&Level> = levels(&data).iter().map(|assembled| &assembled.level).collect();
    let (mut agreeing, mut total) = (0, 0);
    for (drawing, areas) in drawings(&data) {
        let pixel = metres_per_pixel(drawing.scale).unwrap();
        let areas: Vec<(String, geo::Polygon<f64>)> = areas
            .iter()
            .filter(|area| area.area_type != "SHAFT")
            .map(|area| (area.id.to_string(), polygon(&area.outlines().unwrap()[0].outer)))
            .collect();
        for (id, hole) in drawing.holes().filter(|(_, hole)| hole.kind != "window") {
            let ring: Vec<Point> =
                hole.coordinates[0].iter().map(|&corner| Point::from_array(corner) * pixel).collect();
            let grown = polygon(&ring).buffer(0.05);
            let mut met: Vec<&str> = areas
                .iter()
                .filter(|(_, area)| area.intersects(&grown))
                .map(|(room, _)| room.as_str())
                .collect();
            met.sort_unstable();
            let placed = levels
                .iter()
                .find_map(|level| Some((level, level.openings.iter().find(|opening| opening.id == *id)?)));
            let (level, opening) = placed.unwrap();
            let mut joined: Vec<&str> =
                opening.sides.iter().map(|side| level.rooms[side.room].id.as_str()).collect();
            joined.sort_unstable();
            total += 1;
            agreeing += usize::from(joined == met);
        }
    }
    assert_eq!(total, 488 + 62 + 147);
    // The rest meets three areas at a corner, of which two are joined, or a lift drawn with a gap.
    assert!(agreeing >= 690, "{agreeing} of {total}");
}

fn polygon(ring: &[Point]) -> geo::Polygon<f64> {
    let line = ring.iter().map(|corner| geo::Coord { x: corner.x, y: corner.y });
    geo::Polygon::new(line.collect(), Vec::new())
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn people_can_walk_into_every_shared_room_that_has_a_floor() {
    let Some(data) = folder("archilyse") else { return };
    let mut locked = Vec::new();
    let (mut kitchens, mut open_kitchens) = (0, 0);
    for Assembled { name, level, .. } in levels(&data) {
        for room in &level.rooms {
            let kinds = room.openings.iter().map(|entry| level.openings[entry.opening].kind);
            if room.room_type == "kitchen" {
                kitchens += 1;
                open_kitchens += usize::from(kinds.clone().any(|kind| kind == OpeningKind::OpenBoundary));
            }
            let is_floorless = ["shaft", "void", "elevator"].contains(&room.room_type.as_str());
            if !is_floorless && !kinds.clone().any(OpeningKind::is_walkable) {
                locked.push(format!("{name}/{}", room.id));
            }
        }
    }
    // Upper rooms of flats on two floors, reached by stairs that are drawn in the room.
    let upper = ["791037", "791038", "791039"].map(|id| format!("site_1440/floor_1/{id}"));
    locked.sort();
    assert_eq!(locked, upper);
    assert_eq!(kitchens, 67);
    assert!(open_kitchens * 2 > kitchens, "{open_kitchens} of {kitchens} kitchens have no door");
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn drawn_leaves_keep_hinge_side_and_angle() {
    let Some(data) = folder("archilyse") else { return };
    let drawings = drawings(&data);
    for Assembled { level, .. } in levels(&data) {
        for opening in level.openings.iter().filter(|opening| opening.kind == OpeningKind::Door) {
            let drawn = drawings.iter().find_map(|(drawing, _)| {
                let (_, hole) = drawing.holes().find(|(id, _)| **id == opening.id)?;
                Some((hole.door_sweeping_points.as_ref()?, metres_per_pixel(drawing.scale)?))
            });
            let (sweep, pixel) = drawn.unwrap();
            let drawn_hinge = Point::from_array(sweep.angle_point) * pixel;
            // Wide doors are drawn with one sweep and have two leaves.
            let near = |leaf: &Leaf| leaf.hinge.distance(drawn_hinge);
            let leaf = opening.leaves.iter().min_by(|a, b| near(a).total_cmp(&near(b))).unwrap();
            let drawn_open = Point::from_array(sweep.opened_point) * pixel - drawn_hinge;
            let open = leaf.open_tip - leaf.hinge;
            assert!(open.normalize().dot(drawn_open.normalize()) > 0.97, "{}", opening.id);
            // From the middle of the wall, where it is drawn, to the face where it hangs; and into the wall at a corner.
            assert!(leaf.hinge.distance(drawn_hinge) < 0.45, "{}", opening.id);
        }
    }
}

/// The miniature drawing of the tests with some text replaced, read.
fn broken(from: &str, to: &str) -> Faults {
    let cases = Path::new("tests/cases/plan_import/drawing");
    let folder = tempfile::tempdir().unwrap();
    for name in ["annotations/plan_7.json", "areas/areas_plan_7.json"] {
        let text = std::fs::read_to_string(cases.join(name)).unwrap();
        let path = folder.path().join(Path::new(name).file_name().unwrap());
        std::fs::write(path, text.replacen(from, to, 1)).unwrap();
    }
    match read(&folder.path().join("plan_7.json"), &words()) {
        Ok(read) => read.faults,
        Err(faults) => faults,
    }
}

#[test]
fn broken_files_give_faults_with_their_place() {
    let cases = [
        ("\"scale\": 1.0", "\"scale\": 0.0", (4, 11), "scale 0 is no size of a pixel"),
        ("\"scale\": 1.0", "\"scale\": null", (4, 11), "found nothing"),
        ("\"scale\": 1.0,", "", (1, 1), "scale"),
        ("[[-30.0, -30.0]", "[null", (9, 73), "found nothing"),
        ("POLYGON ((0 0", "POLYGON ((0 zero", (2, 67), "broken well-known text"),
        ("POLYGON ((0 0", "POINT ((0 0", (2, 67), "is no polygon"),
        ("\"id\": 100", "\"id\": null", (2, 9), "found nothing"),
    ];
    for (from, to, position, message) in cases {
        let faults = broken(from, to);
        let fault = &faults.0[0];
        assert!(fault.message.contains(message), "{to}: {faults}");
        assert!(fault.is_error());
        assert_eq!(fault.position, Some(position), "{to}: {faults}");
    }
}

#[test]
fn unknown_words_are_warnings() {
    let faults = broken("\"BALCONY\"", "\"SAUNA\"");
    assert_eq!(faults.0.len(), 1);
    let message = "unknown room word \"SAUNA\": 2 rooms are guessed by shape and neighbours";
    assert_eq!((faults.0[0].message.as_str(), faults.0[0].is_error()), (message, false));
}

#[test]
fn missing_partners_and_truncated_files_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let drawing = folder.path().join("plan_7.json");
    let text = std::fs::read_to_string("tests/cases/plan_import/drawing/annotations/plan_7.json").unwrap();
    std::fs::write(&drawing, &text[..text.len() / 2]).unwrap();
    assert!(recognises(&drawing));
    let faults = read(&drawing, &words()).unwrap_err();
    assert_eq!(faults.0[0].message, "its areas \"areas_plan_7.json\" are missing");
    std::fs::write(folder.path().join("areas_plan_7.json"), "[]").unwrap();
    let faults = read(&drawing, &words()).unwrap_err();
    assert!(faults.0[0].position.is_some(), "{faults}");
    let site = folder.path().join("site");
    std::fs::create_dir(&site).unwrap();
    std::fs::write(site.join("react_planner_projects.json"), "[").unwrap();
    assert!(recognises(&site));
    let faults = read(&site, &words()).unwrap_err();
    assert_eq!(faults.0[0].file, site.join("react_planner_projects.json"));
    assert_eq!(faults.0[1].message, "the site has no \"areas.json\" and no \"floors.json\"");
}

#[test]
fn other_json_is_not_taken_for_a_drawing() {
    let folder = tempfile::tempdir().unwrap();
    let native = folder.path().join("plan.json");
    std::fs::write(&native, "{\"version\": 1, \"levels\": []}").unwrap();
    assert!(!recognises(&native));
    assert!(!recognises(folder.path()));
    assert!(!recognises(&folder.path().join("nothing.json")));
    assert!(!recognises(Path::new("tests/cases/plan_import/drawing/areas/areas_plan_7.json")));
    assert!(recognises(Path::new("tests/cases/plan_import/drawing/annotations/plan_7.json")));
}
