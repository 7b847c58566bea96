//! The legend: the signs of a plan, and the areas of the rooms.

use std::collections::{BTreeMap, BTreeSet};

use crate::geometry::Point;
use crate::layout::Placement;
use crate::plan::{OpeningKind, WallKind};
use crate::recipes::Symbol;

use super::Drawing;
use super::canvas::{Canvas, MARGIN_LEFT, TextStyle, short};
use super::furniture::{DETAIL, OUTLINE, OVERHEAD, hangs, is_marked};
use super::shell;
use super::symbols::{strokes, symbol_of};

/// Pixels of a column of signs, one of rooms, and of a row of either.
const SIGN_COLUMN: f64 = 150.0;
const ROOM_COLUMN: f64 = 260.0;
const ROW: f64 = 24.0;
const LINE: f64 = 15.0;

/// Pixels that a sign takes to either side and up and down.
const SIGN: Point = Point::new(13.0, 9.0);

const WORDS: TextStyle =
    TextStyle { size: 11.0, anchor: "", color: "#444", is_upright: false, is_bold: false, has_halo: false };

/// A sign around the origin, in pixels, and what it means.
struct Sign {
    elements: String,
    meaning: &'static str,
}

/// Explains the signs that this plan shows, then sums up the rooms by type.
pub(crate) fn draw_legend(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    let signs: Vec<Sign> = building_signs(drawing).into_iter().chain(furniture_signs(drawing)).collect();
    let columns = columns_of(canvas, SIGN_COLUMN);
    let start = heading(canvas, "Legend") + ROW;
    for (index, sign) in signs.iter().enumerate() {
        let left = MARGIN_LEFT + SIGN_COLUMN * (index % columns) as f64;
        let middle = start + ROW * (index / columns) as f64;
        let (x, y) = (short(left + SIGN.x), short(middle));
        canvas.raw(&format!("<g transform=\"translate({x} {y})\">{}</g>", sign.elements));
        canvas.text_at(Point::new(left + 2.0 * SIGN.x + 8.0, middle), sign.meaning, WORDS);
    }
    canvas.skip(ROW * signs.len().div_ceil(columns) as f64 + 8.0);
    draw_areas(canvas, drawing);
}

/// Number and square metres of the rooms of each type, and of all.
fn draw_areas(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    let mut types: BTreeMap<&str, (usize, f64)> = BTreeMap::new();
    let mut all = (0, 0.0);
    for room in &drawing.level.rooms {
        let known = drawing.catalog.room_types.get(&room.room_type);
        let of_type = types.entry(known.map_or(&room.room_type, |known| &known.label)).or_default();
        let area = room.region.area();
        *of_type = (of_type.0 + 1, of_type.1 + area);
        all = (all.0 + 1, all.1 + area);
    }
    let total = (types.len() > 1).then_some(("All rooms", all));
    let columns = columns_of(canvas, ROOM_COLUMN);
    let start = heading(canvas, "Rooms") + LINE;
    let rows = (types.len() + usize::from(total.is_some())).div_ceil(columns);
    for (index, (label, (count, area))) in types.into_iter().chain(total).enumerate() {
        let left = MARGIN_LEFT + ROOM_COLUMN * (index / rows) as f64;
        let at = |x: f64| Point::new(left + x, start + LINE * (index % rows) as f64);
        canvas.text_at(at(0.0), label, WORDS);
        let number = TextStyle { anchor: "end", ..WORDS };
        canvas.text_at(at(170.0), &count.to_string(), number);
        canvas.text_at(at(230.0), &format!("{area:.1} m²"), number);
    }
    canvas.skip(LINE * rows as f64);
}

fn heading(canvas: &mut Canvas, text: &str) -> f64 {
    canvas.skip(6.0);
    canvas.note(text, TextStyle { is_bold: true, ..WORDS });
    canvas.pen()
}

fn columns_of(canvas: &Canvas, width: f64) -> usize {
    (((canvas.width() - MARGIN_LEFT) / width) as usize).max(1)
}

/// The signs of walls and openings that the level has.
fn building_signs(drawing: &Drawing<'_>) -> Vec<Sign> {
    let level = drawing.level;
    let walls = || level.rooms.iter().flat_map(|room| &room.walls);
    let has = |kinds: &[OpeningKind]| level.openings.iter().any(|opening| kinds.contains(&opening.kind));
    let is_hatched =
        |room: &crate::plan::Room| !shell::is_furnished(drawing, room) && !shell::is_stairs(room);
    let line = |y: i32, style: &str| format!("<path d=\"M-13 {y}H13\" {style}/>");
    let bar = |style: &str| format!("<rect x=\"-13\" y=\"-3\" width=\"26\" height=\"6\" {style}/>");
    let panes = format!("{}{}{}", bar(shell::GLASS), line(-1, shell::GLASS_LINE), line(1, shell::GLASS_LINE));
    let swing = format!("<path d=\"M-8 8L-8 -8A16 16 0 0 1 8 8Z\" {}/>", shell::SWING);
    let door = format!("{swing}<path d=\"M-8 8V-8\" {}/>", shell::LEAF);
    let passage = line(-3, shell::DASHES) + &line(3, shell::DASHES);
    let is_railing = |wall: &crate::plan::Wall| wall.kind != WallKind::Solid;
    let all = [
        (walls().any(|wall| !is_railing(wall)), bar(shell::WALL), "wall"),
        (walls().any(is_railing), line(0, shell::RAILING), "railing, parapet"),
        (has(&[OpeningKind::Window]), panes, "window"),
        (has(&[OpeningKind::Door]), door, "door and its swing"),
        (has(&[OpeningKind::SlidingDoor]), line(0, shell::LEAF), "sliding door"),
        (has(&[OpeningKind::Passage, OpeningKind::OpenBoundary]), passage, "open passage"),
        (level.rooms.iter().any(|room| !room.obstacles.is_empty()), square(shell::OBSTACLE), "column"),
        (level.rooms.iter().any(is_hatched), square(shell::UNFURNISHED), "not furnished"),
        (placements(drawing).any(hangs), square(OVERHEAD), "hangs above"),
    ];
    let shown = all.into_iter().filter(|(is_there, ..)| *is_there);
    shown.map(|(_, elements, meaning)| Sign { elements, meaning }).collect()
}

fn square(style: &str) -> String {
    format!("<rect x=\"-9\" y=\"-9\" width=\"18\" height=\"18\" {style}/>")
}

/// The symbols of furniture that stands in the rooms, in the order in which they are declared.
fn furniture_signs(drawing: &Drawing<'_>) -> Vec<Sign> {
    let shown = placements(drawing).filter(|placement| is_marked(placement));
    let symbols: BTreeSet<Symbol> =
        shown.filter_map(|placement| symbol_of(&drawing.catalog.classes[placement.class])).collect();
    symbols.into_iter().map(|symbol| Sign { elements: picture(symbol), meaning: symbol.meaning() }).collect()
}

fn placements<'d>(drawing: &Drawing<'d>) -> impl Iterator<Item = &'d Placement> {
    drawing.furnished.iter().flat_map(|room| &room.placements)
}

/// A piece of the usual size with its symbol, the front below, as large as a sign may be.
fn picture(symbol: Symbol) -> String {
    let half = symbol.usual_size() / 2.0;
    let scale = (SIGN / half).min_element();
    let coordinates = |point: Point| format!("{} {}", short(point.x * scale), short(point.y * scale));
    let Point { x, y } = half * scale;
    let [left, top, width, height] = [-x, -y, 2.0 * x, 2.0 * y].map(short);
    let mut elements = format!(
        "<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"#fff\" {OUTLINE}/>"
    );
    for stroke in strokes(symbol, half) {
        let points: Vec<String> = stroke.points.into_iter().map(coordinates).collect();
        let end = if stroke.is_closed { "Z" } else { "" };
        elements += &format!("<path d=\"M{}{end}\" {DETAIL}/>", points.join("L"));
    }
    elements
}
