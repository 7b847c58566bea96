//! The list of findings below the plan, in as many columns as fit on the sheet.

use crate::audit::{Grade, Severity};
use crate::draw::Drawing;
use crate::draw::canvas::{Canvas, LETTER_WIDTH, MARGIN_LEFT, TextStyle, short};
use crate::draw::sheet::broken;
use crate::geometry::Point;

use super::mark::{RADIUS, draw_number};
use super::{Noted, grade_color, severity_color};

/// Pixels of a column.
const COLUMN: f64 = 500.0;

/// Lines of the shortest column; fewer do not make another column.
const SHORTEST_COLUMN: usize = 12;

/// Pixels between lines.
const LINE: f64 = 16.0;

/// Pixels from the left of a column to the code, the objects, and the right ends of the two figures.
const CODE: f64 = 24.0;
const OBJECTS: f64 = 128.0;
const MEASURED: f64 = 400.0;
const THRESHOLD: f64 = 478.0;

const WORDS: TextStyle =
    TextStyle { size: 11.0, anchor: "", color: "#444", is_upright: false, is_bold: false, has_halo: false };

/// One line of the legend.
enum Row<'a> {
    /// A room with findings.
    Room(String, Grade),
    /// The first line of a finding, with the first of its objects.
    Finding(&'a Noted<'a>, String),
    /// More objects of the finding above.
    More(String),
}

/// Lists all findings by room.
pub(crate) fn draw_legend(canvas: &mut Canvas, drawing: &Drawing<'_>, all: &[Noted<'_>]) {
    canvas.skip(20.0);
    draw_key(canvas, all);
    if all.is_empty() {
        return;
    }
    let blocks = blocks(drawing, all);
    let column_count = ((canvas.width() - MARGIN_LEFT) / COLUMN).max(1.0) as usize;
    let row_count: usize = blocks.iter().map(Vec::len).sum();
    let column_length = row_count.div_ceil(column_count).max(SHORTEST_COLUMN);
    let top = canvas.pen() + LINE * 1.5;
    let (mut column, mut line, mut longest) = (0, 0, 0);
    for block in &blocks {
        // The findings of a room stay together.
        if line > 0 && line + block.len() > column_length && column + 1 < column_count {
            (column, line) = (column + 1, 0);
        }
        if line == 0 {
            draw_heading(canvas, left_of(column), top - LINE);
        }
        for row in block {
            draw_row(canvas, Point::new(left_of(column), top + LINE * line as f64), row);
            line += 1;
        }
        longest = longest.max(line);
    }
    canvas.skip(LINE * (longest as f64 + 1.0));
}

fn left_of(column: usize) -> f64 {
    MARGIN_LEFT + COLUMN * column as f64
}

/// How many findings there are of each severity, in their colours.
fn draw_key(canvas: &mut Canvas, all: &[Noted<'_>]) {
    let at = |x: f64, canvas: &Canvas| Point::new(x, canvas.pen());
    let bold = TextStyle { is_bold: true, ..WORDS };
    canvas.text_at(at(MARGIN_LEFT, canvas), if all.is_empty() { "No findings" } else { "Findings" }, bold);
    let mut x = MARGIN_LEFT + 80.0;
    for severity in [Severity::Failed, Severity::Minor, Severity::Given] {
        let count = all.iter().filter(|noted| noted.finding.severity == severity).count();
        if count > 0 {
            let text = match severity {
                Severity::Given => format!("{count} given by the plan"),
                _ => format!("{count} {}", severity.name()),
            };
            draw_disc(canvas, at(x, canvas), severity_color(severity));
            canvas.text_at(at(x + 12.0, canvas), &text, WORDS);
            x += 32.0 + text.chars().count() as f64 * WORDS.size * LETTER_WIDTH;
        }
    }
    canvas.skip(LINE);
}

/// The rows of each room that has findings.
fn blocks<'a>(drawing: &Drawing<'_>, all: &'a [Noted<'a>]) -> Vec<Vec<Row<'a>>> {
    let of_room = |noted: &'a [Noted<'a>]| {
        let index = noted[0].room;
        let room = &drawing.level.rooms[index];
        let name = match &room.name {
            Some(name) => shortened(&format!("{name} ({})", room.id)),
            None => shortened(&room.id),
        };
        let mut rows = vec![Row::Room(name, Grade::of(&drawing.findings[index]))];
        for noted in noted {
            let letters = ((MEASURED - 50.0 - OBJECTS) / (WORDS.size * LETTER_WIDTH)) as usize;
            let objects = noted.finding.objects.join(", ");
            let mut lines = broken(&objects, letters, "").into_iter();
            rows.push(Row::Finding(noted, lines.next().unwrap_or_default()));
            rows.extend(lines.map(Row::More));
        }
        rows
    };
    all.chunk_by(|a, b| a.room == b.room).map(of_room).collect()
}

/// An id that fits into a column.
fn shortened(id: &str) -> String {
    const LETTERS: usize = 56;
    if id.chars().count() <= LETTERS {
        id.to_owned()
    } else {
        id.chars().take(LETTERS - 1).chain(['…']).collect()
    }
}

fn draw_heading(canvas: &mut Canvas, left: f64, y: f64) {
    let faint = TextStyle { size: 9.5, color: "#888", ..WORDS };
    let at = |x: f64| Point::new(left + x, y);
    canvas.text_at(at(CODE), "finding", faint);
    canvas.text_at(at(OBJECTS), "objects", faint);
    canvas.text_at(at(MEASURED), "measured", TextStyle { anchor: "end", ..faint });
    canvas.text_at(at(THRESHOLD), "threshold", TextStyle { anchor: "end", ..faint });
}

fn draw_row(canvas: &mut Canvas, at: Point, row: &Row<'_>) {
    let right = |x: f64| Point::new(at.x + x, at.y);
    match row {
        Row::Room(id, grade) => {
            let style = TextStyle { is_bold: true, color: grade_color(*grade), ..WORDS };
            canvas.text_at(at, &format!("{id}: {}", grade.name()), style);
        }
        Row::Finding(noted, objects) => {
            let finding = noted.finding;
            draw_disc(canvas, right(RADIUS), severity_color(finding.severity));
            draw_number(canvas, right(RADIUS), noted.number);
            let unit = finding.quantity.unit();
            let figure = TextStyle { anchor: "end", ..WORDS };
            canvas.text_at(right(CODE), finding.code.name(), WORDS);
            canvas.text_at(right(OBJECTS), objects, WORDS);
            canvas.text_at(right(MEASURED), &unit.show(finding.measured), figure);
            canvas.text_at(right(THRESHOLD), &unit.show(finding.threshold), figure);
        }
        Row::More(objects) => canvas.text_at(right(OBJECTS), objects, WORDS),
    }
}

fn draw_disc(canvas: &mut Canvas, at: Point, color: &str) {
    let (x, y) = (short(at.x), short(at.y));
    canvas.raw(&format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{RADIUS}\" fill=\"{color}\"/>"));
}
