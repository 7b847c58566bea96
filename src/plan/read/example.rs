//! A reader to copy: complete, compiled and tested, for a JSON format that exists only in this file.
//!
//! ```json
//! {
//!   "sketch_version": 1,
//!   "title": "House 7",
//!   "levels": [
//!     {
//!       "name": "Ground floor",
//!       "storey_height": 280,
//!       "rooms": [
//!         {"key": "r1", "name": "Kitchen", "corners": [[0, 0], [300, 0], [300, 400], [0, 400]]},
//!         {"key": "r2", "name": null, "corners": [[300, 0], [500, 0], [500, 400], [300, 400]]}
//!       ],
//!       "openings": [
//!         {"kind": "door", "middle": [300, 200], "width": 80, "between": ["r1", "r2"]},
//!         {"kind": "window", "middle": [0, 200], "width": 120, "between": ["r1"]}
//!       ]
//!     },
//!     {"name": "Upper floor", "rooms": [{"key": "r1", "name": "Bedroom", "corners": [[0, 0], [500, 0], [500, 400], [0, 400]]}]}
//!   ]
//! }
//! ```
//!
//! Levels come from the lowest up. Lengths are centimetres, y goes down. Rooms share their edges, which are the middles of walls.
//! Keys of rooms count within their level, where openings name them. People type the names of rooms.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::Deserialize;

use super::foreign::{TypeOfWord, UniqueIds, WIDEST_LEAF, id_of_file, number_rooms};
use super::reader::{DraftedBuilding, ForeignFormat, ReadBuildings, ReadFormat, ReadResult};
use super::room_names::TypedNames;
use super::sample::Sample;
use super::told::DocumentFaults;
use crate::document::{PathStep, Source};
use crate::geometry::Point;
use crate::plan::clean::clean_ring;
use crate::plan::limits::{OPENING_WIDTH, STOREY_HEIGHT};
use crate::plan::units::CENTIMETRE;
use crate::plan::{
    BuildingDraft, LeafDraft, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, OutlineKind, RoomDraft,
    RoomWords,
};

/// The word in the answers of `formats`, and in hints that of a section of `formats` in `room_words.yaml`. The section itself
/// may be missing, as here: the words of `ifc` are asked next.
const NAME: &str = "example";

/// The line of the table of readers.
const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "sketches",
        input: "a JSON file with the keys `sketch_version` and `levels`",
        content: "levels, rooms, doors and windows; the format has no walls",
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
    levels: Vec<SketchedLevel>,
}

#[derive(Debug, Deserialize, JsonSchema)]
struct SketchedLevel {
    name: String,
    storey_height: Option<f64>,
    rooms: Vec<SketchedRoom>,
    openings: Option<Vec<SketchedOpening>>,
}

#[derive(Debug, Deserialize, JsonSchema)]
struct SketchedRoom {
    key: String,
    name: Option<String>,
    corners: Vec<[f64; 2]>,
}

#[derive(Debug, Deserialize, JsonSchema)]
struct SketchedOpening {
    kind: String,
    middle: [f64; 2],
    width: f64,
    /// Keys of the rooms on both sides, or of the one before the open air.
    between: Option<Vec<String>>,
}

fn recognises(path: &Path) -> bool {
    let sample = Sample::read(path, HEAD_SIZE);
    sample.is_object() && sample.has(&["sketch_version", "levels"])
}

fn read(path: &Path, words: &RoomWords) -> ReadResult {
    let source = Source::read(path)?;
    let sketch: Sketch = source.parse()?;
    let mut reader = Reader { names: TypedNames::new(words, NAME), faults: DocumentFaults::new(source) };
    let mut ids = UniqueIds::default();
    let (mut levels, mut elevation) = (Vec::new(), 0.0);
    for (number, level) in sketch.levels.iter().enumerate() {
        let id = ids.of_name(&level.name, &format!("level_{number}"));
        let draft = LevelDraft { id, elevation, ..reader.level(number, level) };
        elevation += draft.height;
        // One without rooms would become an empty file.
        levels.extend((!draft.rooms.is_empty()).then_some(draft));
    }
    if levels.is_empty() {
        reader.faults.error(&["levels".into()], "the sketch has no room that can be read", "draw one");
    }
    for (&room, message, hint) in reader.names.unknown() {
        reader.faults.warn_always(&place(room, "rooms", "name"), message, &hint);
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

/// Numbers of a level and of a part of it.
type Part = (usize, usize);

/// Where a key of a part stands in the file.
fn place((level, number): Part, list: &str, key: &str) -> [PathStep; 5] {
    ["levels".into(), level.into(), list.into(), number.into(), key.into()]
}

struct Reader<'a> {
    /// Unknown names stand at their rooms.
    names: TypedNames<'a, Part>,
    faults: DocumentFaults,
}

impl Reader<'_> {
    fn level(&mut self, number: usize, level: &SketchedLevel) -> LevelDraft {
        let path = ["levels".into(), number.into(), "storey_height".into()];
        let mut height = level.storey_height.map_or(USUAL_HEIGHT, |height| height * CENTIMETRE);
        if !self.is_within(STOREY_HEIGHT, height, &path, "the usual height is taken") {
            height = USUAL_HEIGHT;
        }
        let (mut rooms, mut ids) = (Vec::new(), UniqueIds::default());
        // The id of each room by its key in the file.
        let mut ids_of_keys = BTreeMap::new();
        for (index, room) in level.rooms.iter().enumerate() {
            let Some(draft) = self.room((number, index), room, &mut ids) else { continue };
            if ids_of_keys.contains_key(room.key.as_str()) {
                let message = format!("the key \"{}\" is used twice", room.key);
                self.faults.warn(&place((number, index), "rooms", "key"), message, "openings join the first");
            } else {
                ids_of_keys.insert(room.key.as_str(), draft.id.clone());
            }
            rooms.push(draft);
        }
        number_rooms(&mut rooms);
        let openings = level.openings.iter().flatten().enumerate();
        let openings =
            openings.filter_map(|(index, opening)| self.opening((number, index), opening, &ids_of_keys));
        // Fields that the format does not know keep their defaults: `assemble` fills them in or finds them by geometry.
        LevelDraft {
            name: level.name.clone(),
            height,
            exterior_thickness: 0.3,
            interior_thickness: 0.1,
            // Without this line the outlines are the inner faces of walls.
            outlines: OutlineKind::Center,
            openings: openings.collect(),
            rooms,
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

    fn room(&mut self, part: Part, room: &SketchedRoom, ids: &mut UniqueIds) -> Option<RoomDraft> {
        // In either direction.
        let outline: Vec<Point> = room.corners.iter().copied().map(point).collect();
        // `assemble` finds the same faults; it would not know the line.
        if let Err(fault) = clean_ring(&outline, &[]) {
            self.faults.error(&place(part, "rooms", "corners"), fault.to_string(), "the room is left out");
            return None;
        }
        // A room without a name, or with an unknown one, is guessed by its shape and neighbours.
        let TypeOfWord { room_type, unknown_word } = self.names.of_name(room.name.as_deref(), || part);
        let id = ids.of_name(&room.key, "room");
        Some(RoomDraft {
            id,
            name: room.name.clone(),
            room_type,
            unknown_word,
            outline,
            ..RoomDraft::default()
        })
    }

    fn opening(
        &mut self,
        part: Part,
        opening: &SketchedOpening,
        ids_of_keys: &BTreeMap<&str, String>,
    ) -> Option<OpeningDraft> {
        let path = |key: &str| place(part, "openings", key);
        let width = opening.width * CENTIMETRE;
        if !self.is_within(OPENING_WIDTH, width, &path("width"), "left out") {
            return None;
        }
        let mut rooms = Vec::new();
        for key in opening.between.iter().flatten() {
            let Some(id) = ids_of_keys.get(key.as_str()) else {
                self.faults.error(
                    &path("between"),
                    format!("no room \"{key}\" that can be read"),
                    "left out",
                );
                return None;
            };
            rooms.push(id.clone());
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
            id: format!("opening_{}", part.1 + 1),
            kind,
            // The wall and its direction are found by geometry, and the rooms where `rooms` is empty.
            place: OpeningPlace::Points { center: point(opening.middle), along: None },
            rooms,
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
    let file = folder.path().join("My house.json");
    let text = r#"{"sketch_version": 1, "title": null, "levels": [
        {"name": "Ground floor", "storey_height": 28000, "rooms": [
        {"key": "r1", "name": "Küche 2", "corners": [[0, 0], [300, 0], [300, 400], [0, 400]]},
        {"key": "r2", "name": "Planetarium", "corners": [[300, 0], [500, 0], [500, 400], [300, 400]]},
        {"key": "r2", "name": null, "corners": [[500, 0], [600, 0], [600, 400], [500, 400]]},
        {"key": "r3", "name": "Hall", "corners": [[600, 0], [700, 400], [700, 0], [600, 400]]}],
        "openings": [{"kind": "door", "middle": [300, 200], "width": 80, "between": ["r1", "r2"]},
        {"kind": "hatch", "middle": [300, 200], "width": 80},
        {"kind": "door", "middle": [600, 200], "width": 80, "between": ["r3"]}]},
        {"name": "Ground floor", "rooms": [
        {"key": "r1", "name": "Bedroom", "corners": [[0, 0], [500, 0], [500, 400], [0, 400]]}]}]}"#;
    std::fs::write(&file, text).unwrap();
    assert!((FORMAT.recognises)(&file) && (FORMAT.near_miss)(folder.path()).is_none());

    let words = super::real_data::words();
    let ReadBuildings { buildings, faults, .. } =
        (FORMAT.read)(&file, &crate::plan::PlanOptions::new(&words)).unwrap();
    let shown: Vec<(usize, &str)> =
        faults.0.iter().map(|fault| (fault.position.unwrap().0, fault.message.as_str())).collect();
    let expected = [
        (2, "280 m is no length of this kind"),
        (4, "unknown room word \"planetarium\": 1 room is guessed by shape and neighbours"),
        (5, "the key \"r2\" is used twice"),
        (6, "outline crosses itself: edge 0 meets edge 2"),
        (8, "unknown kind \"hatch\""),
        (9, "no room \"r3\" that can be read"),
    ];
    assert_eq!(shown, expected);

    let [building] = &buildings[..] else { panic!("{} buildings", buildings.len()) };
    assert_eq!(building.id, "my_house");
    let assembled = building.draft.levels.iter().cloned().map(crate::plan::assemble_level);
    let (levels, problems): (Vec<_>, Vec<_>) = assembled.unzip();
    assert!(problems.concat().is_empty());
    let shown: Vec<(&str, f64)> = levels.iter().map(|level| (level.id.as_str(), level.elevation)).collect();
    assert_eq!(shown, [("ground_floor", 0.0), ("ground_floor_2", USUAL_HEIGHT)]);
    let rooms = levels.iter().flat_map(|level| &level.rooms);
    let shown: Vec<(&str, &str)> = rooms.map(|room| (room.id.as_str(), room.room_type.as_str())).collect();
    assert_eq!(shown, [("r1", "kitchen"), ("r2", "generic"), ("r2_2", "generic"), ("r1", "bedroom")]);
    let sides: Vec<usize> = levels[0].openings[0].sides.iter().map(|side| side.room).collect();
    assert_eq!(sides, [0, 1]);
}
