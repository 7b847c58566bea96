//! Homes written by the application itself, and damaged ones.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

use zip::write::{SimpleFileOptions, ZipWriter};

use super::FORMAT;
use crate::catalog::builtin_catalog;
use crate::document::Faults;
use crate::geometry::Point;
use crate::plan::read::finish::finish_draft;
use crate::plan::read::reader::ReadBuildings;
use crate::plan::{Building, Level, Opening, OpeningKind, PlanOptions};

fn homes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/sweet_home")
}

fn try_read(path: &Path) -> Result<ReadBuildings, Faults> {
    (FORMAT.read)(path, &PlanOptions::new(&builtin_catalog().room_words))
}

/// A home with all faults, those of the assembly too.
fn read(path: &Path) -> (Building, Vec<String>) {
    let ReadBuildings { buildings, mut faults, .. } = try_read(path).unwrap();
    let [drafted] = &buildings[..] else { panic!("{} buildings", buildings.len()) };
    let (building, found) = finish_draft(&drafted.id, &drafted.draft, &builtin_catalog().room_words);
    faults.merge(found);
    (building, faults.0.into_iter().map(|fault| fault.message).collect())
}

fn home(name: &str) -> (Building, Vec<String>) {
    read(&homes().join(name).with_extension("sh3d"))
}

fn opening_kinds(level: &Level) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for opening in &level.openings {
        let kind = match opening.kind {
            OpeningKind::Door => "door",
            OpeningKind::SlidingDoor => "sliding",
            OpeningKind::Passage => "passage",
            OpeningKind::Window => "window",
            OpeningKind::OpenBoundary => "open",
        };
        *counts.entry(kind).or_default() += 1;
    }
    counts
}

/// A file with a text, and with it as a packed home.
fn written(xml: &str) -> (tempfile::TempDir, [PathBuf; 2]) {
    let folder = tempfile::tempdir().unwrap();
    let [plain, packed] = ["Home.xml", "home.sh3d"].map(|name| folder.path().join(name));
    std::fs::write(&plain, xml).unwrap();
    std::fs::write(&packed, archive(&[("Home", b"old"), ("Home.xml", xml.as_bytes())])).unwrap();
    (folder, [plain, packed])
}

fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let mut writer = ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
    for (name, bytes) in entries {
        writer.start_file(*name, options).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// A home of one square room of 4 m, with more elements.
fn square(more: &str) -> String {
    let walls: String = [(0, 0, 400, 0), (400, 0, 400, 400), (400, 400, 0, 400), (0, 400, 0, 0)]
        .iter()
        .map(|(x, y, u, v)| {
            format!("<wall xStart='{x}' yStart='{y}' xEnd='{u}' yEnd='{v}' thickness='20'/>\n")
        })
        .collect();
    format!("<?xml version='1.0'?>\n<home version='7000' wallHeight='250'>\n{walls}{more}</home>\n")
}

fn messages(xml: &str) -> Vec<String> {
    let (_folder, [plain, _]) = written(xml);
    let shown = |faults: Faults| -> Vec<String> {
        let place = |position: Option<(usize, usize)>| {
            position.map(|(line, _)| format!("{line}: ")).unwrap_or_default()
        };
        faults.0.into_iter().map(|fault| place(fault.position) + &fault.message).collect()
    };
    match try_read(&plain) {
        Ok(read) => shown(read.faults),
        Err(faults) => shown(faults),
    }
}

#[test]
fn areas_are_those_that_the_application_shows() {
    let table = std::fs::read_to_string(homes().join("areas.tsv")).unwrap();
    let mut count = 0;
    let mut read_homes: BTreeMap<&str, Building> = BTreeMap::new();
    for line in table.lines() {
        let [name, level, title, area] = line.split('\t').collect::<Vec<_>>()[..] else { panic!("{line}") };
        // Those are drawn into the walls, and cut back.
        if name == "centre_lines" {
            continue;
        }
        let building = read_homes.entry(name).or_insert_with(|| home(name).0);
        let level = building.levels.iter().find(|own| level == "-" || own.name == level).unwrap();
        let is_it = |own: &str| if title == "-" { own.is_empty() } else { own == title };
        let room = level.rooms.iter().find(|room| is_it(room.name.as_deref().unwrap_or_default())).unwrap();
        let area: f64 = area.parse().unwrap();
        let read = room.region.area();
        // The round room lost the bows of its door and its window, which stand straight.
        let allowed = if name == "round" { 0.01 } else { 0.001 };
        assert!((read - area).abs() <= allowed * area, "{line}: {read}");
        count += 1;
    }
    assert!(count > 180, "{count} rooms");
}

#[test]
fn a_flat_has_its_rooms_doors_and_windows() {
    let (flat, faults) = home("flat");
    let [level] = &flat.levels[..] else { panic!("{} levels", flat.levels.len()) };
    assert_eq!((level.id.as_str(), level.elevation, level.height), ("ground_floor", 0.0, 2.62));
    let types: Vec<(&str, &str, f64)> =
        level.rooms.iter().map(|room| (room.id.as_str(), room.room_type.as_str(), room.height)).collect();
    let expected = [
        ("living_room", "living_room", 2.5),
        ("kitchen", "kitchen", 2.5),
        ("bedroom_1", "bedroom", 2.5),
        ("entrance_hall", "corridor", 2.5),
        ("bathroom", "bathroom", 2.5),
    ];
    assert_eq!(types, expected);
    // Five doors with leaves on hinges, one frame, one French window with two leaves, three windows.
    assert_eq!(opening_kinds(level), [("door", 6), ("passage", 1), ("window", 3)].into());
    assert_eq!(level.openings.iter().filter(|opening| opening.sides.len() == 2).count(), 5);
    assert_eq!(faults, ["13 pieces of furniture left out: rooms are furnished anew"]);
}

#[test]
fn levels_lie_on_each_other_and_empty_ones_are_left_out() {
    let (house, faults) = home("storeys");
    let levels: Vec<(&str, f64, f64)> =
        house.levels.iter().map(|level| (level.id.as_str(), level.elevation, level.height)).collect();
    assert_eq!(levels, [("erdgeschoss", 0.0, 2.62), ("obergeschoss", 2.62, 2.62)]);
    assert!(faults.contains(&"levels \"Erdgeschoss\" and \"Garten\" lie on the same height".to_owned()));
    // By its name in German, and by what stands in it.
    assert_eq!(house.levels[0].rooms[1].room_type, "kitchen");
    assert_eq!(house.levels[1].rooms[1].room_type, "bathroom", "{faults:?}");
    // Nothing is put on the stairs, nor where they come up.
    let heights: Vec<f64> =
        house.levels.iter().flat_map(|level| &level.rooms[0].obstacles).map(|own| own.height).collect();
    assert_eq!(heights, [2.5, 0.9]);
}

#[test]
fn openings_of_round_walls_stand_straight() {
    let (tower, faults) = home("round");
    let level = &tower.levels[0];
    assert_eq!(opening_kinds(level), [("door", 1), ("window", 2)].into(), "{faults:?}");
    assert!(faults.is_empty(), "{faults:?}");
    assert!(level.rooms[0].walls.len() > 30);
}

#[test]
fn the_areas_that_walls_enclose_become_rooms() {
    let (building, faults) = home("without_rooms");
    let level = &building.levels[0];
    // The hollow of the pillar is a room too; the stub of a wall is a notch of its room.
    let mut areas: Vec<f64> =
        level.rooms.iter().map(|room| (room.region.area() * 100.0).round() / 100.0).collect();
    areas.sort_by(f64::total_cmp);
    assert_eq!(areas.len(), 4, "{areas:?}");
    assert_eq!(areas[0], 0.81);
    // 3.85 m by 5.80 m without the pillar of 1.1 m by 1.1 m, and without the stub of 1.4 m by 0.1 m.
    assert!((areas[3] - (3.85 * 5.8 - 1.21 - 0.14)).abs() < 0.02, "{areas:?}");
    assert_eq!(level.openings.len(), 4);
    assert!(
        faults.iter().any(|fault| fault.ends_with("the 4 that its walls enclose are taken")),
        "{faults:?}"
    );
    let types: Vec<&str> = level.rooms.iter().map(|room| room.room_type.as_str()).collect();
    assert!(types.contains(&"bedroom") && types.contains(&"bathroom"), "{types:?}");
}

#[test]
fn a_ceiling_lies_at_the_lower_end_of_its_walls() {
    let (attic, faults) = home("attic");
    assert_eq!(attic.levels[0].rooms[0].height, 2.0);
    assert_eq!(faults, ["level \"Attic\": 1 room with sloping walls, which are read as flat ones"]);
}

#[test]
fn rooms_that_are_drawn_into_the_walls_are_cut_back() {
    let (building, faults) = home("centre_lines");
    let level = &building.levels[0];
    let areas: Vec<f64> = level.rooms.iter().map(|room| room.region.area()).collect();
    // 4 m less half an outer and half an inner wall, by 4 m less two halves of outer walls.
    areas.iter().for_each(|area| assert!((area - 3.82 * 3.76).abs() < 1e-3, "{areas:?}"));
    assert_eq!(level.openings.len(), 2);
    assert_eq!(faults, ["2 rooms are drawn into the walls and cut back to their faces"]);
}

#[test]
fn members_of_groups_are_read_and_hidden_doors_are_not() {
    let (building, faults) = home("groups");
    let level = &building.levels[0];
    assert_eq!(opening_kinds(level), [("door", 1), ("window", 1)].into());
    assert_eq!(level.rooms[0].room_type, "bedroom");
    // The wall that stands free in the room.
    assert_eq!(level.rooms[0].obstacles.len(), 1);
    assert_eq!(faults, ["3 pieces of furniture left out: rooms are furnished anew"]);
}

#[test]
fn a_roof_of_walls_and_the_end_of_a_pier_leave_the_rest_alone() {
    let level = |id: &str, height: i32| {
        format!("<level id='{id}' name='{id}' elevation='{height}' floorThickness='12' height='250'/>\n")
    };
    let wall = |level: &str, [x, y, u, v]: [i32; 4]| {
        format!("<wall level='{level}' xStart='{x}' yStart='{y}' xEnd='{u}' yEnd='{v}' thickness='20'/>\n")
    };
    let pier = [[200, 200, 300, 200], [300, 200, 300, 205], [300, 205, 200, 205]];
    let corners = [(0, 0), (500, 0), (500, 400), (0, 400)].map(|(x, y)| format!("<point x='{x}' y='{y}'/>"));
    let xml = format!(
        "<home version='7000' wallHeight='250'>\n{}{}{}{}<room level='ground'>{}</room>\n</home>\n",
        level("ground", 0),
        level("roof", 262),
        pier.map(|ends| wall("ground", ends)).concat(),
        wall("roof", [0, 0, 500, 0]),
        corners.concat()
    );
    let (_folder, [plain, _]) = written(&xml);
    assert!(!try_read(&plain).unwrap().faults.has_errors());
    let (building, faults) = read(&plain);
    assert_eq!(building.levels.len(), 1);
    assert_eq!(building.levels[0].rooms[0].room_type, "room", "a home is usual");
    assert!(faults.iter().any(|fault| fault.contains("enclose no room")), "{faults:?}");
    assert!(!faults.iter().any(|fault| fault.contains("crosses itself")), "{faults:?}");
}

/// How the leaf of a door hangs, in the frame of the piece: on its left or right, turning to its front or back.
fn hangs(opening: &Opening, angle: f64) -> Vec<(bool, bool)> {
    let (sine, cosine) = libm::sincos(angle);
    let axis = Point::new(cosine, sine);
    let leaves = opening.leaves.iter().map(|leaf| {
        let is_left = (leaf.hinge - opening.center).dot(axis) < 0.0;
        let is_front = (leaf.open_tip - leaf.hinge).dot(axis.perp()) < 0.0;
        (is_left, is_front)
    });
    leaves.collect()
}

#[test]
fn every_door_hangs_as_the_application_draws_it() {
    let (building, faults) = home("doors");
    let level = &building.levels[0];
    assert_eq!(level.openings.len(), 72, "{faults:?}");
    assert!(level.openings.iter().all(|opening| opening.sides.len() == 2));
    // Nine kinds of doors in columns of 8 m; in each eight turns by a quarter, clockwise, of which the last four are mirrored.
    for opening in &level.openings {
        let (column, row) = ((opening.center.x / 8.0) as usize, (-opening.center.y / 6.0) as usize);
        let angle = -(row as f64) * std::f64::consts::FRAC_PI_2;
        let is_left = row < 4;
        let mut hung = hangs(opening, angle);
        hung.sort_unstable();
        let (kind, expected) = match column {
            0..=4 => (OpeningKind::Door, vec![(is_left, true)]),
            5 => (OpeningKind::Door, vec![(false, true), (true, true)]),
            6 => (OpeningKind::Passage, vec![]),
            _ => (OpeningKind::SlidingDoor, vec![]),
        };
        assert_eq!((opening.kind, hung), (kind, expected), "column {column}, row {row}");
    }
}

#[test]
fn a_home_is_recognised_by_its_content() {
    let (folder, paths) = written(&square(""));
    assert!(paths.iter().all(|path| (FORMAT.recognises)(path)));
    let others = [
        ("a.sh3d", archive(&[("word/document.xml", b"<home/>")])),
        ("b.zip", b"PK\x03\x04 and nothing more".to_vec()),
        ("c.xml", b"<?xml version='1.0'?><!-- <home wallHeight='1'> --><house/>".to_vec()),
        ("d.xml", b"<homes wallHeight='1'/>".to_vec()),
        ("e.xml", b"<home><address/></home>".to_vec()),
        ("f", Vec::new()),
    ];
    for (name, bytes) in others {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        assert!(!(FORMAT.recognises)(&path), "{name}");
    }
    let commented = format!("\u{feff}<?xml version='1.0'?>\n<!-- > -->\n{}", &square("")[22..]);
    std::fs::write(folder.path().join("g"), commented).unwrap();
    assert!((FORMAT.recognises)(&folder.path().join("g")));
}

#[test]
fn a_home_of_an_old_version_is_refused_with_advice() {
    let path = homes().join("before_5_3.sh3d");
    assert!((FORMAT.recognises)(&path));
    let fault = try_read(&path).unwrap_err().0.remove(0);
    assert_eq!(fault.message, "was saved without Home.xml, which is what is read of a home");
    assert!(fault.hint.unwrap().contains("5.3 or later"));
}

#[test]
fn declared_entities_are_refused_and_not_expanded() {
    let laughs =
        "<!DOCTYPE home [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;&a;'>]>\n<home name='&b;' wallHeight='1'/>";
    assert_eq!(messages(laughs), ["1: declares entities or elements of its own, which no home does"]);
    let outside = "<!DOCTYPE home SYSTEM 'file:///etc/passwd'>\n".to_owned() + &square("")[22..];
    assert!(messages(&outside)[0].contains("no rooms"), "a type alone does no harm, and is not fetched");
    let unknown = messages(&square("").replace("version='7000'", "version='7000' name='&b;'"));
    assert!(
        unknown.iter().any(|message| message.starts_with("2: attribute \"name\" of \"home\"")),
        "{unknown:?}"
    );
}

#[test]
fn an_archive_that_unpacks_to_more_than_a_home_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bomb.sh3d");
    let large = vec![b' '; (64 << 20) + 1];
    std::fs::write(&path, archive(&[("Home.xml", &large)])).unwrap();
    assert!(path.metadata().unwrap().len() < 1 << 20);
    let fault = try_read(&path).unwrap_err().0.remove(0);
    assert_eq!(fault.message, "its Home.xml has more than 64 MiB when unpacked");
}

#[test]
fn a_damaged_archive_is_a_fault() {
    let sound = std::fs::read(homes().join("flat.sh3d")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flat.sh3d");
    let mut damaged = sound.clone();
    let middle = damaged.len() / 2;
    damaged[middle..middle + 40].fill(0);
    std::fs::write(&path, damaged).unwrap();
    assert!(try_read(&path).is_err());
    std::fs::write(&path, &sound[..sound.len() - 100]).unwrap();
    assert!((FORMAT.recognises)(&path), "a copy that is cut off is called a home");
    let faults = try_read(&path).unwrap_err();
    assert!(faults.0[0].message.starts_with("is no sound ZIP archive"), "{faults}");
}

#[test]
fn an_archive_whose_home_is_no_xml_is_a_fault() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("home.sh3d");
    for text in ["", "/etc/passwd"] {
        std::fs::write(&path, archive(&[("Home.xml", text.as_bytes())])).unwrap();
        let faults = try_read(&path).unwrap_err();
        assert!(faults.to_string().contains("no elements, and so no home"), "{faults}");
    }
}

#[test]
fn all_faults_of_a_home_are_reported_at_their_places() {
    let more = "<room name='Bedroom'><point x='10' y='10'/><point x='390' y='ten'/><point x='390' y='390'/><point x='10' y='390'/></room>\n\
                <room name='Nook'><point x='10' y='10'/></room>\n\
                <wall xStart='0' yStart='200' xEnd='1e99' yEnd='200' thickness='10'/>\n\
                <wall xStart='0' yStart='200' xEnd='400' yEnd='200' thickness='900'/>\n\
                <doorOrWindow name='Door' x='200' y='0' depth='20' height='200'/>\n\
                <room name='Planetarium &amp; more'><point x='10' y='10'/><point x='390' y='10'/><point x='390' y='390'/></room>\n";
    let expected = [
        "7: \"y\" of \"point\" is \"ten\", no number of a home",
        "8: a room has 1 corners",
        "9: \"xEnd\" of \"wall\" is \"1e99\", no number of a home",
        "10: a wall is 9 m thick",
        "11: \"doorOrWindow\" has no \"width\"",
        "12: unknown room word \"planetarium more\": 1 room is guessed by shape and neighbours",
    ];
    assert_eq!(messages(&square(more)), expected);
}

#[test]
fn a_text_that_is_cut_off_gives_what_came_before() {
    let whole = square(
        "<room name='Bedroom'><point x='10' y='10'/><point x='390' y='10'/><point x='390' y='390'/></room>\n",
    );
    let (_folder, [plain, _]) = written(&whole[..whole.len() - 8]);
    let read = try_read(&plain).unwrap();
    assert_eq!(read.buildings[0].draft.levels[0].rooms.len(), 1);
    assert!(read.faults.0.iter().any(|fault| fault.message == "the text is cut off" && fault.is_error()));
}

#[test]
fn thousands_of_faults_are_counted_instead_of_listed() {
    let told = messages(&square(&"<wall xStart='a'/>\n".repeat(5000)));
    assert!(told.len() <= 202, "{}", told.len());
    assert!(told.iter().any(|message| message.ends_with("more faults of this file are not listed")));
}

#[test]
fn walls_that_all_cross_each_other_are_refused() {
    let crossing: String = (0..2000)
        .map(|number| {
            let (x, y) = (number % 50 * 20, number / 50 * 20);
            format!("<wall xStart='{x}' yStart='0' xEnd='{y}' yEnd='1000' thickness='5'/>\n")
        })
        .collect();
    let told = messages(&square(&crossing));
    assert!(told.iter().any(|message| message.contains("more crossings of walls")), "{told:?}");
}

#[test]
fn a_packed_home_and_its_text_are_read_alike() {
    let xml = square(
        "<room name='Bedroom'><point x='10' y='10'/><point x='390' y='10'/><point x='390' y='390'/></room>\n",
    );
    let (_folder, [plain, packed]) = written(&xml);
    let levels = |path: &Path| format!("{:?}", try_read(path).unwrap().buildings[0].draft.levels);
    assert_eq!(levels(&plain), levels(&packed));
}
