//! The table of readers of foreign formats, and how to add one.
//!
//! A reader of a format `my_format` is the files of this table. To write it, read `example.rs`, a complete one to copy, then
//! `plan/draft.rs`, which has the types to fill and says what is checked later. The code that readers share (`foreign.rs`, `told.rs`,
//! `sample.rs`) need not be read: the example and the last table here say how it is used. No other reader need be read but where that
//! table names one.
//!
//! | file | its part | written by |
//! |---|---|---|
//! | `src/plan/read/my_format.rs`, or a folder | the reader, with its unit tests | step 1 |
//! | `src/plan/read/mod.rs`, `readers.rs` | a `mod` line; `my_format::FORMAT` in the list below | step 1 |
//! | `docs/commands.md` | a line of the table of formats | `UPDATE_GOLDENS=1 cargo test --lib the_page_about_commands` |
//! | `docs/importing.md` | a section | step 2 |
//! | `configs/room_words.yaml` | words, only of a format that has a list of them | step 3 |
//! | `tests/cases/plan_import/my_case/` | a small plan of the format | step 4 |
//! | `tests/cases/plan_import/my_case.txt` | what is read of it, to be looked at | `UPDATE_GOLDENS=1 cargo test --test plan import` |
//!
//! 1. Write the reader: a file or folder here with a `pub(super) const FORMAT: ForeignFormat`. The example reads a JSON format
//!    of several levels, with ids of its own, openings that are placed by their middles and name their rooms, and outlines along
//!    the middles of walls (there `FORMAT` is private, as no list names it); the last table has what it does not show, and
//!    `reader.rs` says what formats of folders are asked. Set `is_settled: true`, as the example does. Add its line
//!    `mod my_format;` to the first lines of `mod.rs`, among which `cargo fmt` sorts it; nothing else there concerns a reader, and it
//!    need not be read. In a folder, `FORMAT` and `read` stand in its `mod.rs`, of which its other files take nothing. Add its `FORMAT` to
//!    the list below: the first that recognises a file reads it, and all are asked before native plans and projects, so that a
//!    file may have their keys (`levels`, `project`). A new one goes before `indoor::sit::FORMAT`, for that and
//!    `outlines::FORMAT` take maps of any origin. Recognition, `roomwright formats`, `import` and hints follow.
//! 2. Renew the table in `docs/commands.md`: `UPDATE_GOLDENS=1 cargo test --lib the_page_about_commands`; no other golden names
//!    the formats. Add a section "How to export from ..." to `docs/importing.md`: how to get a file, the commands, a table of what
//!    its parts become, and what is not read. That of the Japanese indoor map is the shortest to copy. README.md ends its list in
//!    "and more" and stays as it is; so does CHANGELOG.md, until a version is released.
//! 3. Words for rooms need nothing here if people type the names of rooms ("Open Office 2"). `TypedNames` of `room_names.rs`, as in
//!    the example, finds the longest known words of a name in the section `NAME`, if there is one, and then in that of `ifc`, which
//!    has words of many languages. Hints name `formats.<NAME>` all the same: users add words there, in a file of their own.
//!
//!    If the format has a list of words (`OPEN_OFFICE`), they are a section of `formats` in `configs/room_words.yaml`, which may be
//!    there already (`osm`). `formats` ends the file, with its sections in the order of the alphabet:
//!
//!    ```yaml
//!      my_format:
//!        kitchen: kitchen       # the word of the file: the room type
//!        open_office: office    # in capitals or not; spaces, `_` and `-` as the file writes them
//!        room: generic          # says no more than "a room": guessed, and no fault
//!    ```
//!
//!    The reader asks for them by the name of the section: `words.room_type("my_format", "Open_Office")`. By custom the name is
//!    also `about.name` of the format, the word in the answers of `formats` and `import`; nothing in the program joins the two.
//!    Where an unread format has that word in its name and stays unread (`.osm`), name the format otherwise, such as `osm-indoor`. Of
//!    several words for one room the most specific decides. `TypeOfWord::known(word, room_type)` or `::unknown(word)` of
//!    `foreign.rs` gives the two fields of the `RoomDraft`, and `unknown_words` the warnings.
//! 4. Add a case: a folder below `tests/cases/plan_import/` with a small plan, whose buildings have ids of their own: an id that is
//!    the name of the file must differ from those of other cases. `UPDATE_GOLDENS=1 cargo test --test plan import` writes what is
//!    read of it into a text beside the folder, `<folder>.txt`, and fails so that somebody looks at it. The fuzz test damages the
//!    files of the folder by itself. No test counts the cases.
//! 5. If the format is a line of `unread.rs`, which names formats that are known and not read, delete the line, and its case in the
//!    tests there. Keep both if some files of the format stay unread (OSM without indoor tags): readers are asked first, and a file
//!    that none recognises is refused by its line. The test `a_format_is_read_or_not_read` fails if a word of an unread format's
//!    name is the name of a format that is read. Files that are read now go from the list of refused ones in
//!    `tests/plan/unread.rs`.
//! 6. It is done if these pass, and the last one furnishes the case (`source scripts/set_up.sh && set_up_python` sets up pytest). Functions take five arguments at most, with `self`.
//!    `test_structure.py` fails if a file here uses itself through
//!    others, such as a file of faults that takes a type from the file that reports them:
//!
//!    ```text
//!    cargo clippy --all-targets -- -D warnings
//!    cargo test --lib plan::read                           # the reader's own tests, the table of docs/commands.md, unread formats
//!    cargo test --test plan --test fuzz                    # the golden of the case; the case damaged
//!    cargo test --test command_line formats                # the answers of the command
//!    .venv/bin/python -m pytest tests/scripts/test_structure.py
//!    cargo run -- formats
//!    cargo run -- bake tests/cases/plan_import/<folder> --out out
//!    ```
//!
//! | for | use |
//! |---|---|
//! | the types to fill, what each may leave open, what is checked later | `plan/draft.rs`: its head is the contract |
//! | ids that no two parts share | `UniqueIds` of `foreign.rs`: `of_name(name, otherwise)` makes `kitchen`, `kitchen_2` of names or of ids of the file; `numbered(id)` keeps the letters; `first_free([..])` takes the first of several. One for the levels of a building, one for the rooms of each level, and one for its openings if their ids are not counted |
//! | the type of a room with a name and a category | `names.of_names(&[name, category], place)` of [`TypedNames`](super::room_names::TypedNames): the most telling of the known ones decides |
//! | openings that name rooms by ids of the file | a map from those to the ids of the drafts, as in the example; a name that is not in it is a fault with a line |
//! | seeds of rooms | `number_rooms(&mut rooms)` of `foreign.rs`: a room that is added to the file changes no other |
//! | an outline that is none, at its line | `clean_ring(&outline, &[])` of `plan/clean.rs`: its fault says why in words, and `fault.corner()` where; without a line `assemble` reports the same. `is_place(point)` of `plan/limits.rs` is false for what is not finite or too far |
//! | the text of a file; a JSON or YAML document as a type | `Source::read(path)?`; `source.parse::<T>()?`, where `T` derives `Deserialize` and `JsonSchema`: keys that it does not name are passed over, what may be absent or `null` is an `Option`, and any other value of a wrong type refuses the file with its line and path. A value of two shapes is an enum with `#[serde(untagged)]` |
//! | a fault at a line and column | `source.fault_at(Some((line, column)), message)`, then `.with_hint(hint)`, `.as_warning()` |
//! | a fault at a document path | `source.fault(&path, message, hint, severity)`: a slice of `PathStep`s such as `&["rooms".into(), 3.into()]`, the fact, `Some(String)` or `None`, and `FaultSeverity::Error` or `Warning`; `use crate::document::{FaultSeverity, PathStep}` |
//! | many faults of one file | of a document `DocumentFaults` of `told.rs`, as in the example: `error(&path, message, hint)` and `warn` keep the first 200 and count the others, `warn_always` is for what is said once of many parts, with a count. Of other texts `ToldFaults`: `push(\|\| fault)`, `push_always(fault)`, `finish(\|message\| fault)` |
//! | faults that `assemble` finds | nothing to write: they are reported with file and level but no line, and as warnings unless no building can be so |
//! | limits of numbers | `plan/limits.rs`, in metres: `STOREY_HEIGHT`, `OPENING_WIDTH` and `WALL_THICKNESS` are `(least, most)`, `COORDINATE` an `f64`, `OUTLINE_CORNERS`, `LEVEL_ROOMS`, `LEVEL_OPENINGS`, `BUILDING_LEVELS` and `BUILDING_ROOMS` are `usize`. `assemble` checks all that the draft has: lengths, areas, heights, coordinates, corners, counts of rooms and openings. It does not check `BUILDING_LEVELS` and `BUILDING_ROOMS`, which a file that repeats levels may exceed. Check what you want to report with its line, as the example does, and `COORDINATE` and `OUTLINE_CORNERS` before you compute with outlines |
//! | GeoJSON: features, areas and lines in metres | `geojson/mod.rs`; `imdf/translate.rs` shows its use |
//! | to recognise a file by what it holds | `head(path, 4096)` of `foreign.rs` gives its first bytes: look for words that no other format begins with. Where they come late (tags behind all nodes), test the root first, and only then search a larger part, such as a megabyte. Faults of a recognised file are reported also in a folder, where files that nobody recognises are passed over |
//! | to recognise JSON or XML | `let sample = Sample::read(path, 4096)` (`sample.rs`), then `sample.is_object() && sample.has(&["rooms", "walls"])`, if all of these are outermost keys in the first bytes; `holds_one_of(&["\"Room2D\""])` for words at any depth, `says("type", "Plan")` for a key with its value at any depth, `is_xml("plan")` |
//! | tables of any size | `swiss_dwellings/records.rs`: one record in memory, with its line; `gather.rs` keeps the chosen ones |
//! | binary files | nothing in common yet; `ifc/step.rs` reads STEP from the text. A crate is welcome if it keeps the places of elements, and its line in Cargo.toml says what it saves |
//! | degrees of longitude and latitude | `LocalPlane::at(longitude, latitude)?.project(longitude, latitude)` of `plan/units.rs` (no plane outside ±180° and ±85°), which has `FOOT`, `US_FOOT` and `CENTIMETRE` too: one plane for all levels of a building, at `Bounds::around(points).center()` of its corners; `plane_of` of `geojson/place.rs` does that for GeoJSON. `Polygon` takes metres; an area in degrees counts as none |
//! | axes | plans have x east, y north. Of a file with y down, as of pixels, `Point::new(x, -y)`; with Y up, right-handed, as glTF: `Point::new(x, -z)`; with Y up, left-handed, as Unity: `Point::new(x, z)` |
//! | first bytes, ids from names, words for rooms, missing files, doors too wide for a leaf | `foreign.rs`: `head`, `slug`, `TypeOfWord`, `unknown_words` (at a line or a document path), `missing_parts`, `WIDEST_LEAF` (metres; wider doors slide) |
//! | the id of a building | `id_of_file(path, NAME)` of `foreign.rs`: its file's name without the ending, or `NAME` where that has no Latin letter or digit. Of several buildings in a file, `<that>_<own>` |
//! | a room without a name | keep it: `of_name(None, ..)` of `TypedNames` is `TypeOfWord::unknown("")`. It is guessed by shape and neighbours, with a warning of the guess and none of a word |
//! | plans that share edges of rooms and draw no walls | `outlines: OutlineKind::Center` in the `LevelDraft`, as in the example. A door is a point on the shared edge and needs no direction; corners on a straight line are merged later |
//! | metres that a file does not say | yours to choose, as constants that say so. By custom doors are 2.0 m high, windows reach from 0.9 to 2.1 m, storeys of homes have 2.8 to 3.0 m, inner walls 0.1 m and outer ones 0.3 m; in public buildings doors are 2.1 m high, storeys 3.6 m, outer walls 0.4 m thick. A room's height may stay open |
//! | several levels | a `LevelDraft` each, from the lowest up, as nothing sorts them; its `elevation` is what the file says, else yours to sum up from the heights below, as in the example |
//! | clear heights | `height` of a `RoomDraft`; that of a `LevelDraft` is from floor to floor, 0.3 m more where only clear heights are known. Where storeys stand on each other's ceilings, leave the height of rooms open: the slab is taken from it |
//! | furniture that a file draws | `furniture` of the format gives `DrawnPiece`s; `edits/drawn.rs` keeps them by the words under `pieces` in `room_words.yaml` |
//! | XML, ZIP archives | `sweet_home/xml.rs` and `container.rs` |
//! | a fault of a file without a place | `Fault::of_file(path, message)` |

use std::path::Path;

use super::drawn::DrawnPiece;
use super::fit_ids::fit_building_id;
use super::reader::{ForeignFormat, ReadFormat};
use super::{archilyse, honeybee, ifc, imdf, indoor, outlines, resplan, sweet_home, swiss_dwellings};
use crate::document::Faults;
use crate::plan::PlanOptions;

/// All formats but the native one, in the order in which they are asked: a map with rooms as well as outlines of buildings is a
/// plan of the rooms.
pub(crate) const FOREIGN_FORMATS: &[ForeignFormat] = &[
    archilyse::FORMAT,
    imdf::FORMAT,
    indoor::mlit::FORMAT,
    ifc::FORMAT,
    sweet_home::FORMAT,
    honeybee::FORMAT,
    swiss_dwellings::FORMAT,
    resplan::FORMAT,
    indoor::sit::FORMAT,
    outlines::FORMAT,
];

/// The formats of this program itself.
const OWN_FORMATS: [ReadFormat; 2] = [
    ReadFormat {
        name: "native",
        title: "native YAML or JSON",
        input: "a file with the key `levels`; its edits lie beside it in <name>.edits.yaml",
        content: "everything; the schema is configs/schema/plan.schema.json",
    },
    ReadFormat {
        name: "project",
        title: "projects",
        input: "a file with the key `project`",
        content: "plans of any format, placed many times; the schema is configs/schema/project.schema.json",
    },
];

/// All formats that are read, for people.
#[must_use]
pub fn read_formats() -> Vec<ReadFormat> {
    OWN_FORMATS.into_iter().chain(FOREIGN_FORMATS.iter().map(|format| format.about)).collect()
}

/// The furniture of a plan of any format, by building and in the order of the file; of a format that has none, nothing.
///
/// # Errors
/// Why the file cannot be read.
pub fn drawn_furniture(path: &Path, options: &PlanOptions<'_>) -> Result<Vec<DrawnPiece>, Faults> {
    let format = FOREIGN_FORMATS.iter().find(|format| (format.recognises)(path));
    let Some(read) = format.and_then(|format| format.furniture) else { return Ok(Vec::new()) };
    let mut pieces = read(path, options)?;
    pieces.iter_mut().for_each(|piece| piece.building = fit_building_id(&piece.building));
    Ok(pieces)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::super::unread::unread_formats;
    use super::*;

    #[test]
    fn a_format_is_read_or_not_read() {
        let read = read_formats();
        let names: BTreeSet<&str> = read.iter().map(|format| format.name).collect();
        assert_eq!(names.len(), read.len());
        // A packed form, or one file of a folder, may be unread where the format is read.
        let is_whole = |name: &str| !name.contains("ZIP archive") && !name.starts_with("a file of");
        for (unread, _) in unread_formats().into_iter().filter(|(name, _)| is_whole(name)) {
            let mut words = unread.split(|letter: char| !letter.is_alphanumeric()).map(str::to_lowercase);
            assert!(!words.any(|word| names.contains(word.as_str())), "{unread} is read now");
        }
    }

    /// The table as the page shows it.
    fn page_table() -> String {
        let row =
            |format: ReadFormat| format!("| {} | {} | {} |\n", format.title, format.input, format.content);
        let rows: String = read_formats().into_iter().map(row).collect();
        // A name in angle brackets would be an element of HTML.
        format!("| format | name | what is read |\n|---|---|---|\n{}", rows.replace('<', "\\<"))
    }

    #[test]
    fn the_page_about_commands_has_the_table_of_formats() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/commands.md");
        let page = std::fs::read_to_string(path).unwrap();
        let from = page.find("| format | name |").expect("the page has the table");
        let length = page[from..].find("\n\n").expect("the table ends") + 1;
        let shown = &page[from..from + length];
        if std::env::var_os("UPDATE_GOLDENS").is_some() {
            return std::fs::write(path, page.replace(shown, &page_table())).unwrap();
        }
        assert_eq!(
            shown,
            page_table(),
            "renew it with UPDATE_GOLDENS=1 cargo test --lib the_page_about_commands"
        );
    }
}
