//! Code that the tests of plans share.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use roomwright::internals::plan::{Level, PlanOptions, PlanReading, RoomWords, read_plans};

/// Room types that exist in these tests, whatever the catalogue holds.
const ROOM_TYPES: [&str; 26] = [
    "balcony",
    "bathroom",
    "bedroom",
    "classroom",
    "corridor",
    "dining_room",
    "generic",
    "hotel_room",
    "kitchen",
    "kitchenette",
    "library",
    "living_dining",
    "living_room",
    "lobby",
    "meeting_room",
    "office",
    "restaurant",
    "restroom",
    "shaft",
    "shop",
    "stairs",
    "storeroom",
    "study",
    "toilet",
    "utility_room",
    "void",
];

/// A file or folder of the repository.
pub(super) fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The files of a folder with an extension, sorted.
pub(super) fn files(folder: &Path, extensions: &[&str]) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|found| extensions.iter().any(|known| found == *known)));
    files.sort();
    files
}

/// Reads plans with the room types of these tests.
pub(super) fn read(paths: &[PathBuf]) -> PlanReading {
    let words = RoomWords { known: ROOM_TYPES.map(str::to_owned).into(), ..RoomWords::default() };
    read_plans(paths, &PlanOptions::new(&words))
}

#[test]
fn every_room_type_of_these_tests_is_one_of_the_catalogue() {
    let catalog =
        roomwright::internals::catalog::load_catalog(&[]).unwrap_or_else(|faults| panic!("{faults}")).value;
    for name in ROOM_TYPES {
        assert!(catalog.room_words.known.contains(name), "{name}");
    }
}

/// Reads plans with the room types of the catalogue.
pub(super) fn read_ready(paths: &[PathBuf]) -> PlanReading {
    let catalog =
        roomwright::internals::catalog::load_catalog(&[]).unwrap_or_else(|faults| panic!("{faults}")).value;
    assert!(!catalog.room_words.known.is_empty());
    read_plans(paths, &PlanOptions::new(&catalog.room_words))
}

/// Reads a text as a native plan.
pub(super) fn read_text(text: &str) -> PlanReading {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plan.yaml");
    std::fs::write(&path, text).unwrap();
    read(&[path])
}

/// A level as text: one line per room, wall tags where the plan gives some, and opening; metres to the millimetre.
pub(super) fn summary(level: &Level) -> String {
    let mut text = format!(
        "level {} \"{}\" elevation {:.3} height {:.3}\n",
        level.id, level.name, level.elevation, level.height
    );
    for room in &level.rooms {
        let corners: Vec<String> = room
            .region
            .outline
            .corners()
            .iter()
            .map(|corner| format!("{:.3},{:.3}", corner.x, corner.y))
            .collect();
        let style = room.style.as_deref().unwrap_or("-");
        let _ = write!(text, "  room {} {} style {style} height {:.3}", room.id, room.room_type, room.height);
        let _ = write!(text, " holes {} columns {}", room.region.holes.len(), room.obstacles.len());
        let _ = writeln!(text, " area {:.3} corners {}", room.region.area(), corners.join(" "));
    }
    for opening in &level.openings {
        let rooms: Vec<&str> = opening.sides.iter().map(|side| level.rooms[side.room].id.as_str()).collect();
        let (center, along) = (opening.center, opening.along);
        let _ = write!(text, "  {:?} {} in {}", opening.kind, opening.id, rooms.join("+"));
        let _ = write!(text, " at {:.3},{:.3} along {:.3},{:.3}", center.x, center.y, along.x, along.y);
        let _ = write!(text, " width {:.3} from {:.3} to {:.3}", opening.width, opening.bottom, opening.top);
        for leaf in &opening.leaves {
            let (hinge, tip) = (leaf.hinge, leaf.open_tip);
            let _ = write!(text, " leaf {:.3},{:.3} to {:.3},{:.3}", hinge.x, hinge.y, tip.x, tip.y);
        }
        text.push('\n');
    }
    // No negative zeros: they are the same place.
    text.replace("-0.000", "0.000")
}
