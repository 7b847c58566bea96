//! Reads the text of a home: its elements one after the other, without expanding anything.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::attributes::Attributes;
use super::faults::Notes;
use super::home::{Cut, Home, HomeLevel, HomeRoom, HomeWall, Piece, Sash};
use crate::plan::limits::OUTLINE_CORNERS;

/// The outermost element.
pub(super) const ROOT: &str = "home";
/// Rooms, walls and pieces that are read of a home; what follows them is left out.
const MOST_ELEMENTS: usize = 100_000;
/// Leaves of a door that are read.
const MOST_SASHES: usize = 16;
/// Metres of walls where the home says nothing.
const USUAL_WALL_HEIGHT: f64 = 2.5;
/// The hint about a text that is damaged.
const SAVE_AGAIN: &str = "save the home again in Sweet Home 3D";

/// Reads a home. What is damaged is left out and noted; `None` if the text is no home.
pub(super) fn read_home(notes: &mut Notes) -> Option<Home> {
    let text = notes.text().to_owned();
    let mut reader = Reader::from_str(&text);
    let mut builder = Builder::default();
    loop {
        let place = usize::try_from(reader.buffer_position()).unwrap_or(usize::MAX);
        match reader.read_event() {
            Ok(Event::Eof) => break,
            Ok(Event::DocType(declared)) if declared.as_ref().contains('[') => {
                let message = "declares entities or elements of its own, which no home does";
                notes.error(place, message, "take the declaration out: nothing is expanded or fetched");
                return None;
            }
            Ok(event) => builder.take(&event, place, notes),
            Err(error) => {
                let at = usize::try_from(reader.error_position()).unwrap_or(place);
                notes.error(at, format!("is no sound XML: {error}"), SAVE_AGAIN);
                builder.depth = 0;
                break;
            }
        }
    }
    if builder.depth > 0 {
        notes.error(text.len(), "the text is cut off", "copy the file again: what came before is read");
    }
    if !builder.is_home && !builder.has_begun {
        notes.error(0, "the text has no elements, and so no home", SAVE_AGAIN);
    }
    builder.count_left_out(notes);
    builder.is_home.then_some(builder.home)
}

/// The element to which smaller ones belong.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum Parts {
    #[default]
    None,
    Room,
    Piece,
}

#[derive(Default)]
struct Builder {
    home: Home,
    /// Whether the outermost element was that of a home.
    is_home: bool,
    /// Whether any element has begun.
    has_begun: bool,
    /// Elements that have begun and not ended.
    depth: usize,
    /// Rooms, walls and pieces so far.
    count: usize,
    parts: Parts,
}

impl Builder {
    fn take(&mut self, event: &Event<'_>, place: usize, notes: &mut Notes) {
        match event {
            Event::Start(start) => {
                self.begin(start, place, notes);
                self.depth += 1;
            }
            Event::Empty(start) => {
                self.begin(start, place, notes);
                self.end(start.name().as_ref());
            }
            Event::End(end) => {
                self.depth = self.depth.saturating_sub(1);
                self.end(end.name().as_ref());
            }
            _ => {}
        }
    }

    fn begin(&mut self, start: &BytesStart<'_>, place: usize, notes: &mut Notes) {
        self.has_begun = true;
        let name = start.name();
        let name = name.as_ref();
        if self.depth == 0 {
            if name != ROOT || self.is_home {
                let message = format!("\"{name}\" stands where nothing but one \"{ROOT}\" does");
                notes.error(place, message, SAVE_AGAIN);
            }
            self.is_home |= name == ROOT;
        }
        if !self.is_home {
            return;
        }
        if matches!(name, "room" | "wall") || is_piece(name) {
            self.count += 1;
            self.parts = Parts::None;
            if self.count > MOST_ELEMENTS {
                return;
            }
        }
        let is_read = matches!(name, ROOT | "level" | "room" | "wall" | "point" | "sash");
        if !is_read && !is_piece(name) {
            return;
        }
        let mut element = Attributes::of(start, place, notes);
        match name {
            ROOT => self.home(&mut element),
            "level" => self.home.levels.extend(element.level()),
            "wall" => self.home.walls.extend(element.wall()),
            "room" => self.room(&element),
            "point" if self.parts == Parts::Room => self.point(&mut element),
            "sash" if self.parts == Parts::Piece => self.sash(&mut element),
            name if is_piece(name) => self.piece(element.piece(name)),
            _ => {}
        }
    }

    fn end(&mut self, name: &str) {
        if name == "room" || is_piece(name) {
            self.parts = Parts::None;
        }
    }

    fn home(&mut self, element: &mut Attributes<'_>) {
        self.home.name = element.text("name");
        let height = element.length_or("wallHeight", USUAL_WALL_HEIGHT);
        self.home.wall_height = height.unwrap_or(USUAL_WALL_HEIGHT);
    }

    fn room(&mut self, element: &Attributes<'_>) {
        self.home.rooms.push(HomeRoom {
            id: element.text("id"),
            level: element.text("level"),
            name: element.text("name").filter(|name| !name.trim().is_empty()),
            outline: Vec::new(),
            place: element.place,
        });
        self.parts = Parts::Room;
    }

    fn point(&mut self, element: &mut Attributes<'_>) {
        let Some(room) = self.home.rooms.last_mut() else { return };
        // More corners are reported with the room.
        if let (Some(point), true) = (element.point(["x", "y"]), room.outline.len() <= OUTLINE_CORNERS) {
            room.outline.push(point);
        }
    }

    fn piece(&mut self, piece: Option<Piece>) {
        if let Some(piece) = piece {
            self.parts = if piece.cut.is_some() { Parts::Piece } else { Parts::None };
            self.home.pieces.push(piece);
        }
    }

    fn sash(&mut self, element: &mut Attributes<'_>) {
        let Some(cut) = self.home.pieces.last_mut().and_then(|piece| piece.cut.as_mut()) else { return };
        if cut.sashes.len() < MOST_SASHES {
            cut.sashes.extend(element.sash());
        }
    }

    fn count_left_out(&self, notes: &mut Notes) {
        if let Some(excess) = self.count.checked_sub(MOST_ELEMENTS).filter(|excess| *excess > 0) {
            let message =
                format!("{excess} rooms, walls and pieces behind the first {MOST_ELEMENTS} are left out");
            notes.error(notes.text().len(), message, "divide the home into several");
        }
    }
}

/// Whether an element is furniture, a door or a window. A group is none: its members stand in it with places of their own.
fn is_piece(name: &str) -> bool {
    matches!(name, "pieceOfFurniture" | "doorOrWindow" | "light" | "shelfUnit")
}

/// Reads single elements; none that is damaged, or hidden.
impl Attributes<'_> {
    fn level(&mut self) -> Option<HomeLevel> {
        let (elevation, height) = (self.length("elevation"), self.length("height"));
        let floor_thickness = self.length_or("floorThickness", 0.0);
        Some(HomeLevel {
            id: self.text("id").unwrap_or_default(),
            name: self.text("name").unwrap_or_default(),
            elevation: elevation?,
            height: height?,
            floor_thickness: floor_thickness?,
            place: self.place,
        })
    }

    fn wall(&mut self) -> Option<HomeWall> {
        let (start, end) = (self.point(["xStart", "yStart"]), self.point(["xEnd", "yEnd"]));
        let (thickness, arc) = (self.length("thickness"), self.number_or("arcExtent", 0.0));
        let heights = [self.some_length("height"), self.some_length("heightAtEnd")];
        Some(HomeWall {
            level: self.text("level"),
            start: start?,
            end: end?,
            thickness: thickness?,
            height: heights[0]?,
            height_at_end: heights[1]?,
            // Clockwise on the screen.
            arc: -arc?,
            place: self.place,
        })
    }

    /// A piece; none that is hidden or damaged.
    fn piece(&mut self, element: &str) -> Option<Piece> {
        if self.find("visible") == Some("false") {
            return None;
        }
        let (center, angle) = (self.point(["x", "y"]), self.number_or("angle", 0.0));
        let size = ["width", "depth", "height"].map(|name| self.length(name));
        let elevation = self.length_or("elevation", 0.0);
        let cut = if element == "doorOrWindow" { Some(self.cut()) } else { None };
        Some(Piece {
            id: self.text("id"),
            level: self.text("level"),
            catalog_id: self.text("catalogId"),
            name: self.text("name").unwrap_or_default(),
            center: center?,
            angle: -angle?,
            size: [size[0]?, size[1]?, size[2]?],
            elevation: elevation?,
            is_mirrored: self.find("modelMirrored") == Some("true"),
            is_staircase: self.find("staircaseCutOutShape").is_some(),
            cut: match cut {
                Some(cut) => Some(cut?),
                None => None,
            },
            place: self.place,
        })
    }

    fn cut(&mut self) -> Option<Cut> {
        let mut share = |name: &str, usual: f64| self.number_or(name, usual);
        let (thickness, distance) = (share("wallThickness", 1.0), share("wallDistance", 0.0));
        let (left, width) = (share("wallLeft", 0.0), share("wallWidth", 1.0));
        let (top, height) = (share("wallTop", 0.0), share("wallHeight", 1.0));
        Some(Cut {
            wall_thickness: thickness?,
            wall_distance: distance?,
            wall_left: left?,
            wall_width: width?,
            wall_top: top?,
            wall_height: height?,
            sashes: Vec::new(),
        })
    }

    fn sash(&mut self) -> Option<Sash> {
        let numbers = ["xAxis", "yAxis", "width", "startAngle", "endAngle"].map(|name| self.number(name));
        let [x, y, width, start, end] = numbers;
        Some(Sash { hinge: [x?, y?], width: width?, angles: [start?, end?] })
    }
}
