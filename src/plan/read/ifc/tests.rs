//! The shared Duplex, broken and hostile files.

use std::collections::BTreeMap;
use std::path::Path;

use proptest::prelude::*;

use super::{read, recognises};
use crate::document::Faults;
use crate::geometry::{Point, Polygon};
use crate::plan::read::reader::{DraftedBuilding, ReadResult};
use crate::plan::read::real_data::{folder, words};
use crate::plan::{
    GuessRule, LeafDraft, Level, LevelDraft, OpeningKind, OpeningPlace, RoomWords, assemble_level,
};

const VILLA: &str = "tests/cases/plan_import/villa/villa.ifc";

fn duplex() -> Option<DraftedBuilding> {
    let path = folder("ifc")?.join("Duplex_A_20110907.ifc");
    assert!(recognises(&path));
    let mut found = read(&path, &words(), false).unwrap_or_else(|faults| panic!("{faults}"));
    let expected = "roof windows and hatches: 2 are left out, as a plan has openings in walls only";
    assert!(messages(&found.faults).iter().all(|message| message.ends_with(expected)), "{}", found.faults);
    assert_eq!(found.faults.0.len(), 1);
    assert_eq!(found.buildings.len(), 1);
    found.buildings.pop()
}

/// Reads a text as a file.
fn read_bytes(bytes: &[u8]) -> ReadResult {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("house.ifc");
    std::fs::write(&path, bytes).unwrap();
    read(&path, &words(), false)
}

/// The villa of the tests with some text replaced, read.
fn villa(from: &str, to: &str) -> (Vec<DraftedBuilding>, Faults) {
    let text = std::fs::read_to_string(VILLA).unwrap();
    assert!(text.contains(from), "the villa has no {from}");
    match read_bytes(text.replacen(from, to, 1).as_bytes()) {
        Ok(found) => (found.buildings, found.faults),
        Err(faults) => (Vec::new(), faults),
    }
}

fn messages(faults: &Faults) -> Vec<String> {
    let line = |position: Option<(usize, usize)>| position.map_or(0, |(line, _)| line);
    faults.0.iter().map(|fault| format!("{}: {}", line(fault.position), fault.message)).collect()
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn the_shared_duplex_has_the_counts_of_its_source() {
    let Some(duplex) = duplex() else { return };
    assert_eq!(
        (duplex.id.as_str(), duplex.draft.name.as_deref()),
        ("Duplex_A_20110907", Some("Duplex Apartment"))
    );
    let levels: Vec<(&str, usize)> =
        duplex.draft.levels.iter().map(|level| (level.id.as_str(), level.rooms.len())).collect();
    assert_eq!(levels, [("level_1", 10), ("level_2", 10), ("roof", 1)]);
    let elevations: Vec<f64> = duplex.draft.levels.iter().map(|level| level.elevation).collect();
    assert!(elevations.iter().zip([0.0, 3.1, 6.0]).all(|(found, known)| (found - known).abs() < 1e-6));
    let openings = || duplex.draft.levels.iter().flat_map(|level| &level.openings);
    let count = |kind: OpeningKind| openings().filter(|opening| opening.kind == kind).count();
    // Of 24 windows two are in the roof, and four times three are one above the other.
    assert_eq!((count(OpeningKind::Door), count(OpeningKind::Window)), (14, 24 - 2 - 4 * 2));
    let mut types: BTreeMap<&str, usize> = BTreeMap::new();
    for room in duplex.draft.levels.iter().flat_map(|level| &level.rooms) {
        *types.entry(&room.room_type).or_default() += 1;
    }
    for (kind, rooms) in
        [("living_room", 2), ("kitchen", 2), ("bathroom", 4), ("bedroom", 4), ("utility_room", 2)]
    {
        assert_eq!(types.get(kind), Some(&rooms), "{types:?}");
    }
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn every_level_of_the_duplex_assembles() {
    let Some(duplex) = duplex() else { return };
    for draft in duplex.draft.levels {
        let (rooms, openings) = (draft.rooms.len(), draft.openings.len());
        let (level, problems) = assemble_level(draft);
        assert!(problems.is_empty(), "{problems:?}");
        assert_eq!(level.rooms.len(), rooms);
        // Further openings are stretches where rooms meet without a wall.
        assert!(level.openings.len() >= openings);
    }
}

fn area(level: &LevelDraft, room: &str) -> f64 {
    let room = level.rooms.iter().find(|found| found.id == room).unwrap();
    Polygon::new(&room.outline).unwrap().area()
}

#[test]
fn shapes_of_all_kinds_have_their_areas() {
    let (buildings, _) = villa("#1=", "#1=");
    let [ground, upper] = &buildings[0].draft.levels[..] else { panic!() };
    let corner = 1.0 - std::f64::consts::FRAC_PI_4;
    for (level, room, square_metres) in [
        (ground, "001", 20.0),
        (ground, "002", 12.0 - corner),
        (ground, "003", 14.4),
        (upper, "101", 7.5),
        (upper, "102", 27.6),
    ] {
        assert!((area(level, room) - square_metres).abs() < 0.01, "{room}: {}", area(level, room));
    }
    assert_eq!(ground.rooms[1].name.as_deref(), Some("Küche"));
    assert!((upper.elevation - 2.9).abs() < 1e-9 && (ground.height - 2.9).abs() < 1e-9);
}

#[test]
fn a_space_whose_names_say_nothing_is_what_its_classification_says() {
    const CLASS: &str = "#900=IFCCLASSIFICATIONREFERENCE($,'13-15 11 34 11: Office',$,$);\n\
        #901=IFCRELASSOCIATESCLASSIFICATION('0r900',$,$,$,(#100,#110),#900);\n#100=IFCSPACE(";
    let text = std::fs::read_to_string(VILLA).unwrap().replacen("#100=IFCSPACE(", CLASS, 1);
    let nameless = text.replace("'Wohnen'", "'A-101'");
    let found = read_bytes(nameless.as_bytes()).unwrap_or_else(|faults| panic!("{faults}"));
    let rooms = &found.buildings[0].draft.levels[0].rooms;
    assert_eq!(rooms[0].room_type, "office");
    assert_eq!(rooms[1].room_type, "kitchen", "the name comes first");
}

#[test]
fn openings_stand_where_they_are_and_open_as_they_say() {
    let (buildings, _) = villa("#1=", "#1=");
    let ground = &buildings[0].draft.levels[0];
    let opening = |id: &str| ground.openings.iter().find(|opening| opening.id == id).unwrap();
    let center = |id: &str| match opening(id).place {
        OpeningPlace::Points { center, .. } => center,
        OpeningPlace::Edge { .. } => panic!("no point"),
    };
    for (id, place) in
        [("0door1", (1.45, 4.1)), ("0door2", (0.0, 5.1)), ("0window1", (2.5, 0.0)), ("0hole2", (6.45, 4.1))]
    {
        assert!(center(id).distance(Point::new(place.0, place.1)) < 1e-6, "{id}: {}", center(id));
    }
    assert_eq!(opening("0door1").rooms, ["003", "001"]);
    let LeafDraft::Points(leaves) = &opening("0door1").leaf else { panic!("no leaf") };
    assert!(leaves[0].hinge.distance(Point::new(1.0, 4.1)) < 1e-6);
    assert!(leaves[0].open_tip.distance(Point::new(1.0, 5.0)) < 1e-6);
    let LeafDraft::Points(leaves) = &opening("0door2").leaf else { panic!("no leaves") };
    assert_eq!(leaves.len(), 2);
    assert_eq!(opening("0hole2").kind, OpeningKind::Passage);
    assert!((opening("0window1").bottom - 0.9).abs() < 1e-9 && (opening("0window1").top - 2.2).abs() < 1e-9);
    assert_eq!(ground.openings.len(), 4);
    assert_eq!(ground.obstacles.len(), 1);
}

#[test]
fn rooms_without_a_wall_between_them_are_open_to_each_other() {
    let (mut buildings, _) = villa("#1=", "#1=");
    let (level, _) = assemble_level(buildings[0].draft.levels.remove(0));
    let open = |level: &Level| {
        level.openings.iter().filter(|opening| opening.kind == OpeningKind::OpenBoundary).count()
    };
    assert_eq!(open(&level), 1);
    // Where a wall cannot be read, one is taken to be there.
    let (mut buildings, faults) = villa("#206=IFCEXTRUDEDAREASOLID(#207", "#206=IFCEXTRUDEDAREASOLID(#124");
    assert!(messages(&faults).iter().any(|message| message.contains("a wall is not read")), "{faults}");
    let (level, _) = assemble_level(buildings[0].draft.levels.remove(0));
    assert_eq!(open(&level), 0);
}

#[test]
fn fixtures_in_a_space_with_an_unknown_word_are_noted() {
    let shower = "#900=IFCFURNISHINGELEMENT('0f',$,'Shower Tray:80 x 80',$,$,$,$,$);\n\
                  #901=IFCRELCONTAINEDINSPATIALSTRUCTURE('0g',$,$,$,(#900),#150);\n#150=";
    let rule = GuessRule { fixtures: vec!["shower".to_owned()], ..GuessRule::default() };
    let words = RoomWords { guesses: vec![rule], ..words() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("villa.ifc");
    let text = std::fs::read_to_string(VILLA).unwrap().replacen("#150=", shower, 1);
    std::fs::write(&path, text).unwrap();
    let found = read(&path, &words, false).unwrap();
    let rooms = found.buildings.iter().flat_map(|found| &found.draft.levels).flat_map(|level| &level.rooms);
    let noted: Vec<(&str, Vec<&str>)> = rooms
        .filter(|room| !room.fixtures.is_empty())
        .map(|room| (room.id.as_str(), room.fixtures.iter().map(String::as_str).collect()))
        .collect();
    assert_eq!(noted, [("103", vec!["shower"])], "words that no rule asks for are left");
}

#[test]
fn faults_have_their_line_and_leave_the_rest_alone() {
    let dome = villa("'BoundingBox',(#153)", "'BoundingBox',(#154)");
    let open = villa("'it''s (odd; text'", "'it''s (odd; text");
    assert_eq!(dome.0[0].draft.levels.iter().map(|level| level.rooms.len()).sum::<usize>(), 5);
    assert_eq!(open.0[0].draft.levels.iter().map(|level| level.rooms.len()).sum::<usize>(), 6);
    let text = std::fs::read_to_string(VILLA).unwrap();
    let line = |start: &str| text.lines().position(|line| line.starts_with(start)).unwrap() + 1;
    let window = ("#330=", "roof windows and hatches: one is left out, as a plan has openings in walls only");
    let planetarium =
        ("#150=", "unknown room word \"planetarium\": 1 room is guessed by shape and neighbours");
    let body = ("#154=", "space \"103\": #154 IFCCARTESIANPOINT: curves of this kind are not read");
    for ((_, faults), expected) in
        [(dome, vec![window, body]), (open, vec![planetarium, window, ("#500=", "a text has no end")])]
    {
        let mut found = messages(&faults);
        let mut expected: Vec<String> =
            expected.iter().map(|(start, message)| format!("{}: {message}", line(start))).collect();
        found.sort();
        expected.sort();
        assert_eq!(found, expected);
    }
}

#[test]
fn a_file_in_one_line_has_its_faults_shown_too() {
    let text =
        std::fs::read_to_string(VILLA).unwrap().replace('\n', " ").replace("#104=IFCRECT", "#104=IFCROUND");
    let faults = read_bytes(text.as_bytes()).unwrap().faults;
    let column = text.find("#104=").unwrap() + 1;
    let fault = faults.0.iter().find(|fault| fault.position == Some((1, column))).unwrap();
    assert!(fault.line.as_ref().is_some_and(|line| line.contains("#104=IFCROUND")), "{faults}");
}

#[test]
fn only_rooms_with_broken_values_are_left_out() {
    let cases = [
        (
            "#104=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,5000.",
            "#104=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,-5000.",
            "value 4 is no number above zero",
        ),
        (
            "#104=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,5000.",
            "#104=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,1e999",
            "no finite number",
        ),
        ("(#104,#107,#8,2500.)", "(#104,#107,#8,2500.", "a comma or a bracket ) is missing"),
        ("(#104,#107,#8,2500.)", "(#9999,#107,#8,2500.)", "#9999 is not in the file"),
        ("(#104,#107,#8,2500.)", "(#7,#107,#8,2500.)", "profiles of this kind are not read"),
        ("(#104,#107,#8,2500.)", "($,#107,#8,2500.)", "value 1 is no reference"),
        ("#107=IFCAXIS2PLACEMENT3D(#106,", "#107=IFCAXIS2PLACEMENT3D(#107,", "a point has two or three"),
        (
            "#102=IFCSHAPEREPRESENTATION($,'Body','SweptSolid',(#103))",
            "#102=IFCSHAPEREPRESENTATION($,'Body','x',())",
            "value 4 is no list",
        ),
        ("'Wohnen',.ELEMENT.,.SPACE.,$,$);\n", "'Wohnen,.ELEMENT.,.SPACE.,$,$);\n", "a text has no end"),
    ];
    for (from, to, message) in cases {
        let (buildings, faults) = villa(from, to);
        assert_eq!(buildings[0].draft.levels[0].rooms.len(), 2, "{to}");
        let fault = faults.0.iter().find(|fault| fault.message.contains(message));
        assert!(
            fault.is_some_and(|fault| fault.position.is_some() && fault.hint.is_some()),
            "{to}: {faults}"
        );
    }
}

#[test]
fn files_without_a_plan_are_rejected_with_the_reason() {
    let cases: [(&[u8], &str); 6] = [
        (b"", "does not begin with ISO-10303-21"),
        (b"PK\x03\x04\xff\xfe", "does not begin with ISO-10303-21"),
        (b"<?xml version=\"1.0\"?><ifcXML/>", "does not begin with ISO-10303-21"),
        (b"ISO-10303-21;", "schema \"\" is not read"),
        (b"ISO-10303-21;HEADER;FILE_SCHEMA(('AP203'));ENDSEC;", "schema \"AP203\" is not read"),
        (
            b"ISO-10303-21;HEADER;FILE_SCHEMA(('IFC2X3'));ENDSEC;DATA;ENDSEC;END-ISO-10303-21;",
            "holds no spaces",
        ),
    ];
    for (bytes, message) in cases {
        let faults = read_bytes(bytes).unwrap_err();
        let fault = faults.0.iter().find(|fault| fault.message.contains(message));
        assert!(fault.is_some_and(|fault| fault.hint.is_some()), "{message}: {faults}");
    }
    let (buildings, faults) = villa("#28=IFCRELAGGREGATES('0r5',$,$,$,#22,(#130,#140,#150));", "");
    assert_eq!(buildings[0].draft.levels.len(), 1);
    assert!(
        messages(&faults).iter().any(|message| message.contains("space \"101\" is on no storey")),
        "{faults}"
    );
}

#[test]
fn spaces_that_a_building_holds_itself_are_on_a_storey_for_each_height_of_their_floors() {
    let text = std::fs::read_to_string(VILLA).unwrap();
    let usual = read_bytes(text.as_bytes()).unwrap();
    let storeyless = text
        .replace("#26=IFCRELAGGREGATES('0r3',$,$,$,#16,(#22,#18,#23));", "")
        .replace("$,$,$,#18,(#100,#110,#120)", "$,$,$,#16,(#100,#110,#120)")
        .replace("$,$,$,#22,(#130,#140,#150)", "$,$,$,#16,(#130,#140,#150)");
    let found = read_bytes(storeyless.as_bytes()).unwrap();
    let rooms = |levels: &[LevelDraft]| -> Vec<(f64, Vec<String>)> {
        let ids = |level: &LevelDraft| level.rooms.iter().map(|room| room.id.clone()).collect();
        levels.iter().map(|level| (level.elevation, ids(level))).collect()
    };
    assert_eq!(rooms(&found.buildings[0].draft.levels), rooms(&usual.buildings[0].draft.levels));
    // Those of the upper floor alone, which lie on a storey that there is.
    let upper = text.replace("$,$,$,#22,(#130,#140,#150)", "$,$,$,#16,(#130,#140,#150)");
    let found = read_bytes(upper.as_bytes()).unwrap();
    let (found, usual) = (&found.buildings[0].draft.levels, &usual.buildings[0].draft.levels);
    assert_eq!(rooms(found), rooms(usual));
    assert_eq!(found[1].name, "1. Obergeschoss");
}

#[test]
fn spaces_of_the_site_are_counted_beside_buildings_with_rooms_and_an_error_alone() {
    let on_site = "#28=IFCRELAGGREGATES('0r5',$,$,$,#14,(#130,#140,#150));";
    let (buildings, faults) = villa("#28=IFCRELAGGREGATES('0r5',$,$,$,#22,(#130,#140,#150));", on_site);
    assert_eq!(buildings[0].draft.levels.len(), 1);
    assert!(!faults.has_errors(), "{faults}");
    let count = "spaces of the site, outside of buildings: 3 left out";
    assert!(messages(&faults).iter().any(|message| message.ends_with(count)), "{faults}");
    let text = std::fs::read_to_string(VILLA).unwrap();
    let alone = text
        .replace("#27=IFCRELAGGREGATES('0r4',$,$,$,#18,", "#27=IFCRELAGGREGATES('0r4',$,$,$,#14,")
        .replace("#28=IFCRELAGGREGATES('0r5',$,$,$,#22,", "#28=IFCRELAGGREGATES('0r5',$,$,$,#14,");
    let faults = read_bytes(alone.as_bytes()).unwrap_err();
    assert!(
        messages(&faults).iter().any(|message| message.contains("space \"101\" is on no storey")),
        "{faults}"
    );
}

#[test]
fn angles_and_trapeziums_are_floors_of_their_shape() {
    let living_room = "IFCRECTANGLEPROFILEDEF(.AREA.,$,$,5000.,4000.)";
    for (profile, square_metres) in [
        ("IFCTRAPEZIUMPROFILEDEF(.AREA.,$,$,5000.,4000.,4000.,500.)", 18.0),
        ("IFCLSHAPEPROFILEDEF(.AREA.,$,$,4000.,5000.,1500.,$,$,$)", 11.25),
        // A section of steel is its box.
        ("IFCLSHAPEPROFILEDEF(.AREA.,$,$,4000.,5000.,12.,$,$,$)", 20.0),
    ] {
        let (buildings, faults) = villa(living_room, profile);
        let found = area(&buildings[0].draft.levels[0], "001");
        assert!((found - square_metres).abs() < 1e-6, "{profile}: {found} m², {faults}");
    }
}

#[test]
fn files_of_the_first_schemas_are_read_like_later_ones() {
    let drafts = |schema: &str| {
        let (buildings, _) = villa("'IFC4'", schema);
        buildings.iter().map(|building| format!("{:?}", building.draft)).collect::<Vec<_>>()
    };
    let before = drafts("'IFC4'");
    assert!(!before.is_empty());
    for schema in ["'IFC2X_FINAL'", "'IFC2X2_FINAL'"] {
        assert_eq!(drafts(schema), before, "{schema}");
    }
}

#[test]
fn old_encodings_are_read_and_cut_files_too() {
    let text = std::fs::read_to_string(VILLA).unwrap();
    let latin: Vec<u8> =
        text.replace("K\\X2\\00FC\\X0\\che", "K\u{fc}che").chars().map(|letter| letter as u8).collect();
    let found = read_bytes(&latin).unwrap();
    assert_eq!(found.buildings[0].draft.levels[0].rooms[1].name.as_deref(), Some("Küche"));
    assert!(messages(&found.faults).iter().any(|message| message.contains("is not UTF-8 text")));
    let cut = &text.as_bytes()[..text.find("#200=").unwrap() + 9];
    let found = read_bytes(cut).unwrap();
    assert_eq!(found.buildings[0].draft.levels[0].rooms.len(), 3);
    let texts = messages(&found.faults);
    assert!(texts.iter().any(|message| message.contains("ends in the middle")), "{texts:?}");
    assert!(texts.iter().any(|message| message.contains("END-ISO-10303-21")), "{texts:?}");
}

#[test]
fn circular_references_end() {
    for (from, to) in [
        ("#17=IFCLOCALPLACEMENT(#15", "#17=IFCLOCALPLACEMENT(#17"),
        ("#13=IFCLOCALPLACEMENT($", "#13=IFCLOCALPLACEMENT(#17"),
        (
            "#113=IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#114",
            "#113=IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,#113",
        ),
        ("(#117,#118),.F.", "(#117,#118,#117),.F."),
        (
            "#117=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#119)",
            "#117=IFCCOMPOSITECURVESEGMENT(.CONTINUOUS.,.T.,#116)",
        ),
        ("'SweptSolid',(#146)", "'SweptSolid',(#143,#143,#143,#143)"),
        ("#180=IFCDERIVEDPROFILEDEF(.AREA.,$,#181", "#180=IFCDERIVEDPROFILEDEF(.AREA.,$,#180"),
        (
            "#6=IFCMEASUREWITHUNIT(IFCPLANEANGLEMEASURE(0.017453292519943295),#5)",
            "#6=IFCMEASUREWITHUNIT(1.,#4)",
        ),
        ("#24=IFCRELAGGREGATES('0r1',$,$,$,#1,(#14))", "#24=IFCRELAGGREGATES('0r1',$,$,$,#16,(#14))"),
        ("#28=IFCRELAGGREGATES('0r5',$,$,$,#22", "#28=IFCRELAGGREGATES('0r5',$,$,$,#130"),
    ] {
        let (_, faults) = villa(from, to);
        assert!(!faults.is_empty(), "{to}");
    }
}

#[test]
fn feet_inches_and_missing_units_are_known() {
    let foot = "#3=IFCCONVERSIONBASEDUNIT($,.LENGTHUNIT.,'FOOT',#900);#900=IFCMEASUREWITHUNIT(IFCRATIOMEASURE(0.3048),#901);\
                #901=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);";
    let (buildings, _) = villa("#3=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);", foot);
    let first = |buildings: &[DraftedBuilding]| buildings[0].draft.levels[0].rooms[0].outline[1].x;
    assert!((first(&buildings) - 5000.0 * 0.3048).abs() < 1e-6);
    let (buildings, faults) = villa("((#3,#4))", "((#4))");
    assert!((first(&buildings) - 5000.0).abs() < 1e-6);
    assert!(messages(&faults).iter().any(|message| message.contains("metres are taken")), "{faults}");
}

#[test]
fn coordinates_of_a_country_are_moved_to_the_building() {
    let (buildings, _) = villa("#15=IFCLOCALPLACEMENT(#13,#10)", "#15=IFCLOCALPLACEMENT($,#10)");
    let placed = villa("#17=IFCLOCALPLACEMENT(#15,#10)", "#17=IFCLOCALPLACEMENT(#15,#12)").0;
    let corner = |buildings: &[DraftedBuilding]| {
        buildings[0].draft.levels.last().unwrap().rooms[0].outline[0].length()
    };
    assert!(corner(&buildings) < 10.0);
    let far = placed[0].draft.levels.iter().flat_map(|level| &level.rooms).flat_map(|room| &room.outline);
    assert!(far.clone().any(|corner| corner.length() < 10.0));
}

#[test]
fn files_of_other_formats_are_left_to_other_readers() {
    assert!(recognises(Path::new(VILLA)));
    assert!(!recognises(Path::new("tests/cases/plan_import/villa")));
    assert!(!recognises(Path::new("configs/plans/house.yaml")));
    let folder = tempfile::tempdir().unwrap();
    for (name, text, is_ours) in [
        ("a.stp", "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AP214'));", false),
        ("b.txt", "ISO-10303-21;\nHEADER;\nFILE_SCHEMA (( 'IFC4' ));", true),
        ("c.IFC", "", true),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        assert_eq!(recognises(&path), is_ours, "{name}");
    }
}

/// Damage to a file; places are shares of its length.
#[derive(Clone, Debug)]
enum Harm {
    Cut(f64),
    Drop(f64, usize),
    Write(f64, Vec<u8>),
    /// The reference at a place becomes another.
    Refer(f64, u64),
}

fn harm() -> impl Strategy<Value = Harm> {
    let bytes =
        prop::collection::vec(prop::sample::select(&b"#();',.$*=0123456789-eE\\\n/\xffIFC"[..]), 1..6);
    prop_oneof![
        1 => (0.3..1.0f64).prop_map(Harm::Cut),
        4 => (0.0..1.0f64, 1..40usize).prop_map(|(at, length)| Harm::Drop(at, length)),
        6 => (0.0..1.0f64, bytes).prop_map(|(at, bytes)| Harm::Write(at, bytes)),
        6 => (0.1..1.0f64, 1..410u64).prop_map(|(at, id)| Harm::Refer(at, id)),
    ]
}

fn harmed(mut text: Vec<u8>, harms: &[Harm]) -> Vec<u8> {
    for harm in harms {
        let place = |share: &f64| (text.len() as f64 * share) as usize;
        match harm {
            Harm::Cut(at) => text.truncate(place(at)),
            Harm::Drop(at, length) => {
                let at = place(at);
                text.drain(at..text.len().min(at + length));
            }
            Harm::Write(at, bytes) => {
                let at = place(at);
                text.splice(at..text.len().min(at + bytes.len()), bytes.iter().copied());
            }
            Harm::Refer(at, id) => {
                let at = place(at);
                let Some(hash) = text[at..].iter().position(|byte| *byte == b'#') else { continue };
                let start = at + hash + 1;
                let digits = text[start..].iter().take_while(|byte| byte.is_ascii_digit()).count();
                text.splice(start..start + digits, id.to_string().bytes());
            }
        }
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn damaged_files_never_stop_the_reader(
        case in prop::sample::select(&["villa", "rotunda", "attic", "pavilion", "shell"][..]),
        harms in prop::collection::vec(harm(), 1..12),
    ) {
        let path = format!("tests/cases/plan_import/{case}/{case}.ifc");
        let text = harmed(std::fs::read(path).unwrap(), &harms);
        if let Ok(found) = read_bytes(&text) {
            for level in found.buildings.into_iter().flat_map(|building| building.draft.levels) {
                let (level, _) = assemble_level(level);
                prop_assert!(level.rooms.iter().all(|room| room.region.outline.area() > 0.0));
            }
        }
    }
}
