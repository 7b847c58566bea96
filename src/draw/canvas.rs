//! Draws SVG elements at plan points.

use std::fmt::Write;

use crate::document::xml_text;
use crate::geometry::{Bounds, Point};

/// Pixels per metre of a house; large levels are drawn smaller.
const SCALE: f64 = 60.0;

/// Pixels of the longest side of the plan, at most.
const LONGEST_SIDE: f64 = 6000.0;

/// Pixels above the plan for the title.
const HEAD: f64 = 54.0;

/// Pixels of the narrowest sheet, so that titles fit.
const NARROWEST: f64 = 560.0;

/// Pixels between the lines of the notes below the plan.
const LINE_HEIGHT: f64 = 15.0;

/// Mean width of a letter as a share of its size, in the widest of the usual fonts.
pub(crate) const LETTER_WIDTH: f64 = 0.58;

/// A sheet: a title, the plan, notes.
pub(crate) struct Canvas {
    body: String,
    /// The part of the plan that the sheet shows.
    shown: Bounds,
    scale: f64,
    /// Pixels from the top to the next note.
    pen: f64,
    /// Patterns that the elements refer to.
    definitions: String,
    /// Pixels that words and marks take.
    taken: Vec<Bounds>,
}

/// How text is set.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TextStyle {
    /// Pixels of the letters.
    pub(crate) size: f64,
    /// `start`, `middle` or `end`; empty for `start`.
    pub(crate) anchor: &'static str,
    /// CSS colour; black if empty.
    pub(crate) color: &'static str,
    /// Reads from below to above.
    pub(crate) is_upright: bool,
    /// Heavy letters.
    pub(crate) is_bold: bool,
    /// Light edges, readable on anything.
    pub(crate) has_halo: bool,
}

impl Canvas {
    /// A sheet for a part of the plan.
    pub(crate) fn new(shown: Bounds) -> Self {
        let size = shown.size();
        let scale = SCALE.min(LONGEST_SIDE / size.max_element());
        let pen = HEAD + size.y * scale;
        Self { body: String::new(), shown, scale, pen, definitions: String::new(), taken: Vec::new() }
    }

    /// Pixels per metre.
    pub(crate) fn scale(&self) -> f64 {
        self.scale
    }

    /// Pixels from the left and the top.
    pub(crate) fn pixel(&self, point: Point) -> Point {
        let offset = (point - self.shown.low) * self.scale;
        Point::new(offset.x, self.plan_bottom() - offset.y)
    }

    /// Pixels of the sheet's width.
    pub(crate) fn width(&self) -> f64 {
        (self.shown.size().x * self.scale).max(NARROWEST)
    }

    /// Pixels from the top to the end of the plan.
    pub(crate) fn plan_bottom(&self) -> f64 {
        HEAD + self.shown.size().y * self.scale
    }

    /// Pixels from the top to the next note.
    pub(crate) fn pen(&self) -> f64 {
        self.pen
    }

    /// Adds a pattern that elements refer to.
    pub(crate) fn define(&mut self, element: &str) {
        self.definitions.push_str(element);
    }

    /// Whether a rectangle of pixels lies beside the plan or on it, where no words and no marks are.
    pub(crate) fn is_clear(&self, rectangle: Bounds) -> bool {
        let Bounds { low, high } = rectangle;
        let is_on_plan =
            low.x >= 0.0 && high.x <= self.width() && low.y >= HEAD && high.y <= self.plan_bottom();
        is_on_plan && !self.taken.iter().any(|&taken| rectangle.overlaps(taken, 0.0))
    }

    /// Keeps words and marks that ask off a rectangle of pixels.
    pub(crate) fn reserve(&mut self, rectangle: Bounds) {
        self.taken.push(rectangle);
    }

    /// Moves the place of the next note down.
    pub(crate) fn skip(&mut self, pixels: f64) {
        self.pen += pixels;
    }

    /// Adds any element.
    pub(crate) fn raw(&mut self, element: &str) {
        self.body.push_str(element);
        self.body.push('\n');
    }

    /// A closed outline. `attributes` are SVG's: `fill="…" stroke="…"`.
    pub(crate) fn polygon(&mut self, corners: &[Point], attributes: &str) {
        let path = self.ring(corners);
        self.raw(&format!("<path d=\"{path}\" {attributes}/>"));
    }

    /// Outlines of which those inside another are holes.
    pub(crate) fn polygons(&mut self, rings: &[&[Point]], attributes: &str) {
        let path: String = rings.iter().map(|ring| self.ring(ring)).collect();
        self.raw(&format!("<path fill-rule=\"evenodd\" d=\"{path}\" {attributes}/>"));
    }

    fn ring(&self, corners: &[Point]) -> String {
        let mut path = String::new();
        for (index, &corner) in corners.iter().enumerate() {
            let Point { x, y } = self.pixel(corner);
            let command = if index == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{command}{} {}", short(x), short(y));
        }
        path + "Z"
    }

    /// A straight line.
    pub(crate) fn line(&mut self, from: Point, to: Point, attributes: &str) {
        let (a, b) = (self.pixel(from), self.pixel(to));
        let path = format!("M{} {}L{} {}", short(a.x), short(a.y), short(b.x), short(b.y));
        self.raw(&format!("<path d=\"{path}\" {attributes}/>"));
    }

    /// The sector that turns from `from` to `to` around `center`; both are equally far from it and less than
    /// half a turn apart.
    pub(crate) fn sector(&mut self, center: Point, from: Point, to: Point, attributes: &str) {
        let radius = short(center.distance(from) * self.scale);
        // A turn to the left in the plan is one to the left on the screen: SVG's flag 0.
        let flag = u8::from((from - center).perp_dot(to - center) < 0.0);
        let [c, a, b] = [center, from, to].map(|point| self.pixel(point));
        let path = format!(
            "M{} {}L{} {}A{radius} {radius} 0 0 {flag} {} {}Z",
            short(c.x),
            short(c.y),
            short(a.x),
            short(a.y),
            short(b.x),
            short(b.y)
        );
        self.raw(&format!("<path d=\"{path}\" {attributes}/>"));
    }

    /// Text in the plan where it covers no other words; `at` is the middle of its height.
    pub(crate) fn text_if_clear(&mut self, at: Point, text: &str, style: TextStyle) {
        let at = self.pixel(at);
        if self.is_clear(extent(at, text, style)) {
            self.text_at(at, text, style);
        }
    }

    /// Text at a pixel.
    pub(crate) fn text_at(&mut self, at: Point, text: &str, style: TextStyle) {
        self.reserve(extent(at, text, style));
        let (x, y) = (short(at.x), short(at.y));
        let anchor = if style.anchor.is_empty() { "start" } else { style.anchor };
        let color = if style.color.is_empty() { "#222" } else { style.color };
        let turn =
            if style.is_upright { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
        let weight = if style.is_bold { " font-weight=\"bold\"" } else { "" };
        let size = short(style.size);
        let common = format!(
            "x=\"{x}\" y=\"{y}\" dy=\"0.35em\" font-size=\"{size}\" text-anchor=\"{anchor}\"{weight}{turn}"
        );
        let text = xml_text(text);
        if style.has_halo {
            self.raw(&format!(
                "<text {common} fill=\"#fff\" stroke=\"#fff\" stroke-width=\"3\" stroke-opacity=\"0.8\">{text}</text>"
            ));
        }
        self.raw(&format!("<text {common} fill=\"{color}\">{text}</text>"));
    }

    /// A line of the notes below the plan.
    pub(crate) fn note(&mut self, text: &str, style: TextStyle) {
        self.pen += LINE_HEIGHT;
        let x = MARGIN_LEFT;
        self.text_at(Point::new(x, self.pen), text, style);
    }

    /// Pixels of the whole sheet.
    pub(crate) fn extent(&self) -> Point {
        Point::new(self.width().ceil(), (self.pen + LINE_HEIGHT).ceil())
    }

    /// The file.
    pub(crate) fn finish(self) -> String {
        self.finish_at(Point::ZERO)
    }

    /// The sheet as a part of a larger one: a pixel that its upper left corner is at.
    pub(crate) fn finish_at(self, at: Point) -> String {
        let Point { x: width, y: height } = self.extent();
        let place = if at == Point::ZERO { String::new() } else { format!("x=\"{}\" y=\"{}\" ", at.x, at.y) };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" {place}width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\">\n\
             <defs><pattern id=\"hatch\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\" \
             patternTransform=\"rotate(45)\"><rect width=\"8\" height=\"8\" fill=\"#eee\"/>\
             <path d=\"M0 0V8\" stroke=\"#ccc\" stroke-width=\"2\"/></pattern>{}</defs>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n{}</svg>\n",
            self.definitions, self.body
        )
    }
}

/// Pixels left of the notes.
pub(crate) const MARGIN_LEFT: f64 = 20.0;

/// A coordinate to a hundredth of a pixel, without zeros at its end.
pub(crate) fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// The pixels that a text takes.
fn extent(at: Point, text: &str, style: TextStyle) -> Bounds {
    let length = text.chars().count() as f64 * style.size * LETTER_WIDTH;
    let before = match style.anchor {
        "middle" => length / 2.0,
        "end" => length,
        _ => 0.0,
    };
    let half = style.size / 2.0;
    if style.is_upright {
        Bounds::new(at + Point::new(-half, before - length), at + Point::new(half, before))
    } else {
        Bounds::new(at - Point::new(before, half), at + Point::new(length - before, half))
    }
}
