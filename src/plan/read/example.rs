//! A reader to copy: complete, compiled and tested, for a format that exists only in this file.
//!
//! ```text
//! rooms 1                      the first line, by which the format is recognised
//! room kitchen 0 0 300 400     word for the room, lower left corner, width and depth in centimetres
//! room bath 310 0 200 400
//! door 305 200 80              middle of the door, width
//! ```

use std::collections::BTreeMap;
use std::path::Path;

use super::foreign::{TypeOfWord, head, slug, unknown_words};
use super::reader::{DraftedBuilding, ForeignFormat, ReadBuildings, ReadFormat, ReadResult};
use crate::document::{Faults, Source};
use crate::geometry::Point;
use crate::plan::units::CENTIMETRE;
use crate::plan::{
    BuildingDraft, LeafDraft, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, RoomDraft, RoomWords,
    assemble_level,
};

/// The section of `formats` in `room_words.yaml`, here also `about.name`; it is what the hints about unknown words name.
const NAME: &str = "example";

/// The line of the table of readers.
const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "room lists",
        input: "a file that begins with `rooms 1`",
        content: "rectangular rooms and doors of one level; the format has no windows and no heights",
    },
    recognises,
    near_miss: |_| None,
    read: |path, options| read(path, options.words),
    furniture: None,
};
/// First bytes of a file of the format.
const SIGNATURE: &[u8] = b"rooms 1\n";
/// Metres from floor to floor; the format does not say.
const HEIGHT: f64 = 2.8;
/// Metres of a door's head above the floor.
const DOOR_HEAD: f64 = 2.0;

fn recognises(path: &Path) -> bool {
    head(path, SIGNATURE.len() as u64) == SIGNATURE
}

fn read(path: &Path, words: &RoomWords) -> ReadResult {
    // A file that cannot be read, is too large or is no text is reported here.
    let source = Source::read(path)?;
    let mut reader = Reader { words, rooms: Vec::new(), openings: Vec::new(), unknown: BTreeMap::new() };
    let mut faults = Faults::default();
    for (line, text) in (1..).zip(source.text().lines()).skip(1) {
        if let Err(message) = reader.line(line, text) {
            // What is faulty is left out and reported at its place, so that a user sees all faults at once. `as_warning` on top
            // where nothing of the plan is lost.
            faults.push(
                source.fault_at(Some((line, 1)), message).with_hint("write `room` or `door` and its numbers"),
            );
        }
    }
    for (&line, message, hint) in unknown_words(NAME, &reader.unknown) {
        faults.push(source.fault_at(Some((line, 1)), message).with_hint(hint).as_warning());
    }
    let id = slug(&path.file_stem().unwrap_or_default().to_string_lossy());
    // Fields that the format does not know keep their defaults: `assemble` fills them in or finds them by geometry.
    let level = LevelDraft {
        id: "ground".to_owned(),
        height: HEIGHT,
        exterior_thickness: 0.3,
        interior_thickness: 0.1,
        rooms: reader.rooms,
        openings: reader.openings,
        ..LevelDraft::default()
    };
    ReadBuildings::new(
        vec![DraftedBuilding {
            id,
            draft: BuildingDraft { levels: vec![level], ..BuildingDraft::default() },
            // Lengths as the native plan has them, so that a bake of what `import` writes gives the bytes of a bake of this file.
            is_settled: true,
            ..DraftedBuilding::default()
        }],
        faults,
    )
}

/// Collects what the lines say.
struct Reader<'a> {
    words: &'a RoomWords,
    rooms: Vec<RoomDraft>,
    openings: Vec<OpeningDraft>,
    /// Word without a room type → (its first line, how many rooms have it).
    unknown: BTreeMap<String, (usize, usize)>,
}

impl Reader<'_> {
    fn line(&mut self, line: usize, text: &str) -> Result<(), String> {
        let parts: Vec<&str> = text.split_whitespace().collect();
        match parts[..] {
            [] => {}
            ["room", word, left, lower, width, depth] => {
                let (corner, size) = (point(left, lower)?, point(width, depth)?);
                self.room(line, word, [corner, corner + size]);
            }
            ["door", x, y, width] => self.door(line, point(x, y)?, metres(width)?),
            _ => return Err(format!("\"{text}\" is neither a room nor a door")),
        }
        Ok(())
    }

    fn room(&mut self, line: usize, word: &str, [low, high]: [Point; 2]) {
        let kind = match self.words.room_type(NAME, word) {
            Some(room_type) => TypeOfWord::known(word, room_type),
            None => {
                self.unknown.entry(word.to_owned()).or_insert((line, 0)).1 += 1;
                TypeOfWord::unknown(word)
            }
        };
        self.rooms.push(RoomDraft {
            id: format!("room_{line}"),
            room_type: kind.room_type,
            unknown_word: kind.unknown_word,
            // Inner faces of the walls, counter-clockwise or not; `outlines` of the level says so.
            outline: vec![low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)],
            ..RoomDraft::default()
        });
    }

    fn door(&mut self, line: usize, center: Point, width: f64) {
        self.openings.push(OpeningDraft {
            id: format!("door_{line}"),
            kind: OpeningKind::Door,
            // Walls and rooms on both sides are found by geometry.
            place: OpeningPlace::Points { center, along: None },
            rooms: Vec::new(),
            width,
            bottom: 0.0,
            top: DOOR_HEAD,
            leaf: LeafDraft::Automatic,
        });
    }
}

fn metres(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().map_err(|_| format!("\"{text}\" is no number"))?;
    Ok(number * CENTIMETRE)
}

fn point(x: &str, y: &str) -> Result<Point, String> {
    Ok(Point::new(metres(x)?, metres(y)?))
}

#[test]
fn a_room_list_is_read_with_its_faults() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("my flat.rooms");
    std::fs::write(
        &file,
        "rooms 1\nroom kitchen 0 0 300 400\nroom bath 310 0 200 400\ndoor 305 200 80\nroof\n",
    )
    .unwrap();
    assert!((FORMAT.recognises)(&file) && (FORMAT.near_miss)(folder.path()).is_none());

    let words = RoomWords {
        words: [(NAME.to_owned(), [("kitchen".to_owned(), "kitchen".to_owned())].into())].into(),
        ..RoomWords::default()
    };
    let ReadBuildings { buildings, faults, .. } =
        (FORMAT.read)(&file, &crate::plan::PlanOptions::new(&words)).unwrap();
    let shown: Vec<(usize, &str)> =
        faults.0.iter().map(|fault| (fault.position.unwrap().0, fault.message.as_str())).collect();
    let unknown = "unknown room word \"bath\": 1 room is guessed by shape and neighbours";
    assert_eq!(shown, [(3, unknown), (5, "\"roof\" is neither a room nor a door")]);

    let [building] = &buildings[..] else { panic!("{} buildings", buildings.len()) };
    assert_eq!(building.id, "my_flat");
    let (level, problems) = assemble_level(building.draft.levels[0].clone());
    assert!(problems.is_empty());
    let areas: Vec<f64> = level.rooms.iter().map(|room| room.region.area().round()).collect();
    assert_eq!((areas, level.openings[0].sides.len()), (vec![12.0, 8.0], 2));
    assert_eq!(
        level.rooms.iter().map(|room| room.room_type.as_str()).collect::<Vec<_>>(),
        ["kitchen", "generic"]
    );
}
