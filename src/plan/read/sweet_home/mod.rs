//! Homes of Sweet Home 3D: a `.sh3d` file, which is a ZIP archive with `Home.xml`, or that `Home.xml` alone.
//!
//! One building, one level for each level of the home that has rooms. Of the home are read:
//! - rooms as they are drawn, cut back to the faces of the walls where they are drawn into them; of a level without rooms
//!   the areas that its walls enclose;
//! - walls, also round ones, which tell how thick walls are and where there is none; low ones are railings;
//! - doors and windows, also in groups, with their leaves; stairs, which nothing is put on;
//! - other furniture: it tells the type of a room without a name, and is kept on request (`drawn_furniture`).
//!
//! Not read: slopes of ceilings, materials, lights, cameras, texts, dimension lines, and `Home`, the serialised objects of a
//! Java program.
//!
//! Lengths in the file are centimetres, y goes down, and angles are clockwise; `xml.rs` turns all of them as it reads.

mod attributes;
#[cfg(not(target_arch = "wasm32"))]
mod container;
#[cfg(target_arch = "wasm32")]
#[path = "no_container.rs"]
mod container;
mod faces;
mod faults;
mod home;
mod level;
mod openings;
mod pieces;
mod rooms;
mod walls;
mod xml;

#[cfg(test)]
mod tests;

use std::path::Path;

use self::container::{is_archive, read_text};
use self::faults::Notes;
use self::home::{Home, NAME, Piece};
use self::level::Storey;
use self::pieces::is_furniture;
use self::rooms::Naming;
use super::drawn::DrawnPiece;
use super::foreign::{head, id_of_file};
use super::reader::{DraftedBuilding, ForeignFormat, ReadBuildings, ReadFormat, ReadResult};
use crate::document::{Fault, Faults, counted};
use crate::geometry::Point;
use crate::plan::{BuildingDraft, PlanOptions};

/// The line of the table of readers.
pub(crate) const FORMAT: ForeignFormat = ForeignFormat {
    about: ReadFormat {
        name: NAME,
        title: "Sweet Home 3D",
        input: "an .sh3d file of version 5.3 or later, or its Home.xml",
        content: "rooms, or what walls enclose; walls, round ones too; doors and how they open, windows, levels, stairs; furniture with `import --keep-furniture`; no slopes",
    },
    recognises,
    near_miss: |_| None,
    read,
    furniture: Some(furniture),
};
/// Bytes at the start of a text in which its first element stands.
const HEAD_SIZE: u64 = 4096;

/// Whether a file is of this format: an archive with a home, or an XML file whose first element is one.
fn recognises(path: &Path) -> bool {
    if path.is_dir() {
        return false;
    }
    is_archive(path) || is_home(&String::from_utf8_lossy(&head(path, HEAD_SIZE)))
}

/// Whether the first element of a text is that of a home.
fn is_home(text: &str) -> bool {
    let mut rest = text.trim_start_matches('\u{feff}').trim_start();
    while let Some(declared) = rest.strip_prefix("<?").or_else(|| rest.strip_prefix("<!")) {
        let end = if declared.starts_with("--") { "-->" } else { ">" };
        let Some(at) = declared.find(end) else { return false };
        rest = declared[at + end.len()..].trim_start();
    }
    let name = rest.strip_prefix('<').and_then(|rest| rest.strip_prefix(xml::ROOT));
    name.is_some_and(|rest| rest.starts_with([' ', '\t', '\r', '\n', '>', '/']))
        // Other programs may have homes, too.
        && (rest.contains("wallHeight") || rest.contains("<wall") || rest.contains("furnitureVisibleProperty"))
}

/// Reads the home of a file.
fn read(path: &Path, options: &PlanOptions<'_>) -> ReadResult {
    let mut notes = Notes::new(read_text(path)?);
    let Some(home) = xml::read_home(&mut notes) else { return Err(notes.finish()) };
    let storeys = level::storeys(&home, &mut notes);
    let mut naming = Naming::new(options.words, NAME);
    let levels = level::drafts(&storeys, &mut naming, &mut notes);
    for (place, message, hint) in naming.unknown() {
        notes.warn(*place, message, &hint);
    }
    if !options.keeps_furniture {
        warn_of_furniture(&storeys, &mut notes);
    }
    let mut faults = notes.finish();
    if levels.is_empty() && !faults.has_errors() {
        let hint = "draw walls that enclose rooms, or rooms";
        faults.push(
            Fault::of_file(path, "the home has neither rooms nor walls that enclose one").with_hint(hint),
        );
    }
    let usual_family = Some("home");
    let draft = BuildingDraft { name: title(&home), levels, usual_family, ..BuildingDraft::default() };
    let furniture = options.keeps_furniture.then(|| pieces_of(path, &storeys));
    ReadBuildings::new(
        vec![DraftedBuilding { id: id(path), draft, is_settled: true, ..DraftedBuilding::default() }],
        faults,
    )
    .map(|read| ReadBuildings { furniture, ..read })
}

/// The furniture of a home: what is neither a door nor stairs, and of a size that furniture has.
fn furniture(path: &Path, _: &PlanOptions<'_>) -> Result<Vec<DrawnPiece>, Faults> {
    let mut notes = Notes::new(read_text(path)?);
    let Some(home) = xml::read_home(&mut notes) else { return Err(notes.finish()) };
    Ok(pieces_of(path, &level::storeys(&home, &mut notes)))
}

fn pieces_of(path: &Path, storeys: &[Storey<'_>]) -> Vec<DrawnPiece> {
    let building = id(path);
    let drawn = |storey: &Storey<'_>, piece: &Piece| DrawnPiece {
        building: building.clone(),
        level: storey.id.clone(),
        format: NAME,
        kind: piece.catalog_id.clone().unwrap_or_default(),
        name: piece.name.clone(),
        center: piece.center,
        axis: piece.axis(),
        size: Point::new(piece.size[0], piece.size[1]),
        bottom: piece.elevation,
    };
    let pieces = storeys.iter().flat_map(|storey| {
        let furniture = storey.pieces.iter().filter(|piece| is_left_out(piece) && is_furniture(piece));
        furniture.map(|piece| drawn(storey, piece))
    });
    pieces.collect()
}

/// Whether a plan has no place for a piece.
fn is_left_out(piece: &Piece) -> bool {
    piece.cut.is_none() && !piece.is_staircase
}

/// The furniture that is left out, counted.
fn warn_of_furniture(storeys: &[Storey<'_>], notes: &mut Notes) {
    let furniture = || {
        let pieces = storeys.iter().flat_map(|storey| &storey.pieces);
        pieces.filter(|piece| is_left_out(piece))
    };
    let count = furniture().count();
    if let Some(first) = furniture().map(|piece| piece.place).min() {
        let message = format!("{} of furniture left out: rooms are furnished anew", counted(count, "piece"));
        notes.warn(
            first,
            message,
            "`import --keep-furniture` keeps what the catalogue has, kitchens and baths first",
        );
    }
}

/// The id of a building, the same for its furniture.
fn id(path: &Path) -> String {
    id_of_file(path, "home")
}

/// The title that the home has; the application writes the path of its file there, of which the last part is one.
fn title(home: &Home) -> Option<String> {
    let name = home.name.as_deref()?.rsplit(['/', '\\']).next()?;
    let name = name.strip_suffix(".sh3d").unwrap_or(name).trim();
    (!name.is_empty()).then(|| name.to_owned())
}
