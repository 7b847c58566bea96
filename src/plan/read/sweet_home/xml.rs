//! Reads the text of a home: its elements one after the other, without expanding anything.

use std::borrow::Cow;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use super::faults::Notes;
use super::home::{Cut, Home, HomeLevel, HomeRoom, HomeWall, Piece, Sash};
use crate::geometry::Point;
use crate::plan::limits::{COORDINATE, OUTLINE_CORNERS};
use crate::plan::units::CENTIMETRE;

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
/// The hint about a number that is none.
const NUMBER_HINT: &str = "the element is left out; save the home again in Sweet Home 3D";

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

    fn home(&mut self, element: &mut Attributes<'_, '_>) {
        self.home.name = element.text("name");
        let height = element.length_or("wallHeight", USUAL_WALL_HEIGHT);
        self.home.wall_height = height.unwrap_or(USUAL_WALL_HEIGHT);
    }

    fn room(&mut self, element: &Attributes<'_, '_>) {
        self.home.rooms.push(HomeRoom {
            id: element.text("id"),
            level: element.text("level"),
            name: element.text("name").filter(|name| !name.trim().is_empty()),
            outline: Vec::new(),
            place: element.place,
        });
        self.parts = Parts::Room;
    }

    fn point(&mut self, element: &mut Attributes<'_, '_>) {
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

    fn sash(&mut self, element: &mut Attributes<'_, '_>) {
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

/// The attributes of an element; the first fault of a number leaves it out.
struct Attributes<'text, 'notes> {
    values: Vec<(Cow<'text, str>, Cow<'text, str>)>,
    element: String,
    place: usize,
    notes: &'notes mut Notes,
}

impl<'text, 'notes> Attributes<'text, 'notes> {
    fn of(start: &BytesStart<'text>, place: usize, notes: &'notes mut Notes) -> Self {
        let mut values = Vec::new();
        let element = start.name().as_ref().to_owned();
        for attribute in start.attributes().with_checks(false).flatten() {
            let key = Cow::Owned(attribute.key.as_ref().to_owned());
            match attribute.normalized_value(XmlVersion::Implicit1_0) {
                Ok(value) => values.push((key, Cow::Owned(value.into_owned()))),
                Err(error) => {
                    let message = format!("attribute \"{key}\" of \"{element}\": {error}");
                    notes.warn(place, message, "the attribute is left out");
                }
            }
        }
        Self { values, element, place, notes }
    }

    fn find(&self, name: &str) -> Option<&str> {
        self.values.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_ref())
    }

    fn text(&self, name: &str) -> Option<String> {
        self.find(name).map(str::to_owned)
    }

    /// A number, or what it is where the element does not say; none if it is no number.
    fn number_or(&mut self, name: &str, usual: f64) -> Option<f64> {
        let Some(text) = self.find(name) else { return Some(usual) };
        // A place beyond that is none of a building.
        let most = COORDINATE / CENTIMETRE;
        let number = text.trim().parse::<f64>().ok().filter(|number| number.abs() <= most);
        if number.is_none() {
            let message = format!("\"{name}\" of \"{}\" is \"{text}\", no number of a home", self.element);
            self.notes.error(self.place, message, NUMBER_HINT);
        }
        number
    }

    fn number(&mut self, name: &str) -> Option<f64> {
        if self.find(name).is_none() {
            let message = format!("\"{}\" has no \"{name}\"", self.element);
            self.notes.error(self.place, message, NUMBER_HINT);
            return None;
        }
        self.number_or(name, 0.0)
    }

    /// Metres.
    fn length(&mut self, name: &str) -> Option<f64> {
        self.number(name).map(|number| number * CENTIMETRE)
    }

    /// Metres, or those where the element does not say.
    fn length_or(&mut self, name: &str, usual: f64) -> Option<f64> {
        self.number_or(name, usual / CENTIMETRE).map(|number| number * CENTIMETRE)
    }

    /// Metres, if the element says; the outer one is none if that is no number.
    fn some_length(&mut self, name: &str) -> Option<Option<f64>> {
        match self.find(name) {
            None => Some(None),
            Some(_) => self.length(name).map(Some),
        }
    }

    /// A place, of which y goes down in the file.
    fn point(&mut self, [x, y]: [&str; 2]) -> Option<Point> {
        let (x, y) = (self.length(x), self.length(y));
        Some(Point::new(x?, -y?))
    }

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
