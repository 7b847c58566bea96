//! A reader to copy: complete, compiled and tested, for a JSON format that exists only in this file.
//!
//! ```json
//! {
//!   "sketch_version": 1,
//!   "title": "Flat 7",
//!   "storey_height": 280,
//!   "rooms": [
//!     {"name": "Kitchen", "corners": [[0, 0], [300, 0], [300, 400], [0, 400]]},
//!     {"name": null, "corners": [[310, 0], [510, 0], [510, 400], [310, 400]]}
//!   ],
//!   "openings": [{"kind": "door", "middle": [305, 200], "width": 80}]
//! }
//! ```
//!
//! Lengths are centimetres, y goes down. People type the names of rooms.

use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;

use super::foreign::{TypeOfWord, WIDEST_LEAF, id_of_file};
use super::reader::{DraftedBuilding, ForeignFormat, ReadBuildings, ReadFormat, ReadResult};
use super::room_names::TypedNames;
use super::sample::Sample;
use super::told::DocumentFaults;
use crate::document::{PathStep, Source};
use crate::geometry::Point;
use crate::plan::limits::{OPENING_WIDTH, STOREY_HEIGHT};
use crate::plan::units::CENTIMETRE;
use crate::plan::{
    BuildingDraft, LeafDraft, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft, RoomWords,
};

/// The word in the answers of `formats`, and in hints that of a section of `formats` in `room_words.yaml`. The section itself
/// may be missing, as here: the words of `ifc` are asked next.
const NAME: &str = "example";

/// The line of the table of readers.
const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "sketches",
        input: "a JSON file with the keys `sketch_version` and `rooms`",
        content: "rooms, doors and windows of one level; the format has no walls",
    },
    recognises,
    // For formats that are folders: which of their files are missing.
    near_miss: |_| None,
    read: |path, options| read(path, options.words),
    // For formats that draw furniture, which `import --keep-furniture` keeps.
    furniture: None,
};
/// Bytes at the start of a file in which its outermost keys stand.
const HEAD_SIZE: u64 = 4096;
/// Metres from floor to floor where a sketch does not say.
const USUAL_HEIGHT: f64 = 2.8;
/// Metres of a door's head above the floor, and of sill and head of a window; the format does not say.
const DOOR_HEAD: f64 = 2.0;
const WINDOW: (f64, f64) = (0.9, 2.1);

/// A file. Keys that no field names are passed over. A key that may be absent or `null` is an `Option`; any other value of a
/// wrong type refuses the file with its line and path.
#[derive(Debug, Deserialize, JsonSchema)]
struct Sketch {
    title: Option<String>,
    storey_height: Option<f64>,
    rooms: Vec<SketchedRoom>,
    openings: Option<Vec<SketchedOpening>>,
}

#[derive(Debug, Deserialize, JsonSchema)]
struct SketchedRoom {
    name: Option<String>,
    corners: Vec<[f64; 2]>,
}

#[derive(Debug, Deserialize, JsonSchema)]
struct SketchedOpening {
    kind: String,
    middle: [f64; 2],
    width: f64,
}

fn recognises(path: &Path) -> bool {
    let sample = Sample::read(path, HEAD_SIZE);
    sample.is_object() && sample.has(&["sketch_version", "rooms"])
}

fn read(path: &Path, words: &RoomWords) -> ReadResult {
    let source = Source::read(path)?;
    let sketch: Sketch = source.parse()?;
    let mut reader = Reader { names: TypedNames::new(words, NAME), faults: DocumentFaults::new(source) };
    let level = reader.level(&sketch);
    let mut levels = Vec::new();
    if level.rooms.is_empty() {
        reader.faults.error(&["rooms".into()], "the sketch has no room that can be read", "draw one");
    } else {
        levels.push(level);
    }
    for (&room, message, hint) in reader.names.unknown() {
        let path = ["rooms".into(), room.into(), "name".into()];
        reader.faults.warn_always(&path, message, &hint);
    }
    let building = DraftedBuilding {
        id: id_of_file(path, NAME),
        draft: BuildingDraft { name: sketch.title, levels, ..BuildingDraft::default() },
        // Lengths as the native plan has them, so that a bake of what `import` writes gives the bytes of a bake of this file.
        is_settled: true,
        ..DraftedBuilding::default()
    };
    ReadBuildings::new(vec![building], reader.faults.finish())
}

struct Reader<'a> {
    /// Unknown names stand at the number of their room.
    names: TypedNames<'a, usize>,
    faults: DocumentFaults,
}

impl Reader<'_> {
    fn level(&mut self, sketch: &Sketch) -> LevelDraft {
        let rooms = sketch.rooms.iter().enumerate();
        let openings = sketch.openings.iter().flatten().enumerate();
        let mut height = sketch.storey_height.map_or(USUAL_HEIGHT, |height| height * CENTIMETRE);
        if !self.is_within(STOREY_HEIGHT, height, &["storey_height".into()], "the usual height is taken") {
            height = USUAL_HEIGHT;
        }
        // Fields that the format does not know keep their defaults: `assemble` fills them in or finds them by geometry.
        LevelDraft {
            id: "ground".to_owned(),
            height,
            exterior_thickness: 0.3,
            interior_thickness: 0.1,
            rooms: rooms.map(|(number, room)| self.room(number, room)).collect(),
            openings: openings.filter_map(|(number, opening)| self.opening(number, opening)).collect(),
            ..LevelDraft::default()
        }
    }

    /// Reports a length that is out of its limits. `assemble` would report it as well, but without the line.
    fn is_within(&mut self, (least, most): (f64, f64), length: f64, path: &[PathStep], fate: &str) -> bool {
        let is_within = (least..=most).contains(&length);
        if !is_within {
            let hint = format!("{fate}: {least} to {most} m are possible");
            self.faults.error(path, format!("{length} m is no length of this kind"), &hint);
        }
        is_within
    }

    fn room(&mut self, number: usize, room: &SketchedRoom) -> RoomDraft {
        // A room without a name, or with an unknown one, is guessed by its shape and neighbours.
        let TypeOfWord { room_type, unknown_word } = self.names.of_name(room.name.as_deref(), || number);
        RoomDraft {
            id: format!("room_{}", number + 1),
            name: room.name.clone(),
            room_type,
            unknown_word,
            // Inner faces of the walls, in either direction; `outlines` of the level says so.
            outline: room.corners.iter().copied().map(point).collect(),
            ..RoomDraft::default()
        }
    }

    fn opening(&mut self, number: usize, opening: &SketchedOpening) -> Option<OpeningDraft> {
        let path = |key: &str| ["openings".into(), number.into(), key.into()];
        let width = opening.width * CENTIMETRE;
        if !self.is_within(OPENING_WIDTH, width, &path("width"), "left out") {
            return None;
        }
        let (kind, (bottom, top)) = match opening.kind.as_str() {
            "door" if width > WIDEST_LEAF => (OpeningKind::SlidingDoor, (0.0, DOOR_HEAD)),
            "door" => (OpeningKind::Door, (0.0, DOOR_HEAD)),
            "window" => (OpeningKind::Window, WINDOW),
            other => {
                let hint = "left out: known are door and window";
                self.faults.error(&path("kind"), format!("unknown kind \"{other}\""), hint);
                return None;
            }
        };
        Some(OpeningDraft {
            id: format!("opening_{}", number + 1),
            kind,
            // The wall, its direction and the rooms on both sides are found by geometry.
            place: OpeningPlace::Points { center: point(opening.middle), along: None },
            rooms: Vec::new(),
            width,
            bottom,
            top,
            leaf: LeafDraft::Automatic,
        })
    }
}

/// In metres, with y up.
fn point([x, y]: [f64; 2]) -> Point {
    Point::new(x, -y) * CENTIMETRE
}

#[test]
fn a_sketch_is_read_with_its_faults() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("My flat.json");
    let text = r#"{"sketch_version": 1, "title": null, "storey_height": 28000, "rooms": [
        {"name": "Küche 2", "corners": [[0, 0], [300, 0], [300, 400], [0, 400]]},
        {"name": "Planetarium", "corners": [[310, 0], [510, 0], [510, 400], [310, 400]]},
        {"name": null, "corners": [[520, 0], [620, 0], [620, 400], [520, 400]]}],
        "openings": [{"kind": "door", "middle": [305, 200], "width": 80},
        {"kind": "hatch", "middle": [305, 200], "width": 80}]}"#;
    std::fs::write(&file, text).unwrap();
    assert!((FORMAT.recognises)(&file) && (FORMAT.near_miss)(folder.path()).is_none());

    let words = super::real_data::words();
    let ReadBuildings { buildings, faults, .. } =
        (FORMAT.read)(&file, &crate::plan::PlanOptions::new(&words)).unwrap();
    let shown: Vec<(usize, &str)> =
        faults.0.iter().map(|fault| (fault.position.unwrap().0, fault.message.as_str())).collect();
    let unknown = "unknown room word \"planetarium\": 1 room is guessed by shape and neighbours";
    let height = "280 m is no length of this kind";
    assert_eq!(shown, [(1, height), (3, unknown), (6, "unknown kind \"hatch\"")]);

    let [building] = &buildings[..] else { panic!("{} buildings", buildings.len()) };
    assert_eq!(building.id, "my_flat");
    let (level, problems) = crate::plan::assemble_level(building.draft.levels[0].clone());
    assert!(problems.is_empty());
    let types: Vec<&str> = level.rooms.iter().map(|room| room.room_type.as_str()).collect();
    assert_eq!((types, level.openings[0].sides.len()), (vec!["kitchen", "generic", "generic"], 2));
}
