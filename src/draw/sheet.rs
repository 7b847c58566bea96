//! The frame of a sheet: title, scale, north arrow, missing pieces and findings.

use std::collections::BTreeMap;

use crate::geometry::{Point, direction};
use crate::layout::RemovalReason;

use super::Drawing;
use super::canvas::{Canvas, MARGIN_LEFT, TextStyle, short};
use super::legend::draw_legend;

/// Metres that a scale bar may show.
const BAR_LENGTHS: [f64; 6] = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0];

/// Share of the sheet's width that the scale bar takes at most.
const BAR_SHARE: f64 = 0.3;

/// Pixels of a letter of the notes.
const NOTE_LETTER: f64 = 6.2;

const SMALL: TextStyle =
    TextStyle { size: 11.0, anchor: "", color: "#444", is_upright: false, is_bold: false, has_halo: false };

/// Everything around the plan.
pub(crate) fn draw_notes(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    draw_title(canvas, drawing);
    draw_north(canvas, drawing);
    draw_scale(canvas);
    if drawing.has_legend {
        draw_legend(canvas, drawing);
    }
    list_removals(canvas, drawing);
    if !drawing.has_findings {
        list_findings(canvas, drawing);
    }
}

fn draw_title(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    let bold = TextStyle { size: 17.0, is_bold: true, ..TextStyle::default() };
    let level = drawing.level;
    let title =
        if level.name == level.id { level.id.clone() } else { format!("{} ({})", level.name, level.id) };
    canvas.text_at(Point::new(MARGIN_LEFT, 18.0), &format!("{} / {title}", drawing.building), bold);
    let placed: usize = drawing.furnished.iter().map(|room| room.placements.len()).sum();
    let requested: u32 = drawing.furnished.iter().map(|room| room.requested).sum();
    let rooms = match level.rooms.len() {
        1 => "1 room".to_owned(),
        count => format!("{count} rooms"),
    };
    let counts = format!("{rooms}, {placed} of {requested} pieces placed, seed {}", drawing.seed);
    canvas.text_at(Point::new(MARGIN_LEFT, 38.0), &counts, SMALL);
}

/// An arrow to the north of the site: the plan's own north turned back by the building's turn.
fn draw_north(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    const LENGTH: f64 = 14.0;
    const BREADTH: f64 = 6.0;
    let center = Point::new(canvas.width() - 34.0, 27.0);
    let north = direction(std::f64::consts::FRAC_PI_2 - drawing.site.turn);
    let screen = |along: f64, across: f64| {
        let offset = north * along + north.perp() * across;
        let point = Point::new(center.x + offset.x, center.y - offset.y);
        format!("{} {}", short(point.x), short(point.y))
    };
    let [tip, left, notch, right] = [
        screen(LENGTH, 0.0),
        screen(-LENGTH, BREADTH),
        screen(-LENGTH / 2.0, 0.0),
        screen(-LENGTH, -BREADTH),
    ];
    canvas.raw(&format!("<path d=\"M{tip}L{left}L{notch}Z\" fill=\"#222\"/>"));
    canvas.raw(&format!("<path d=\"M{tip}L{right}L{notch}Z\" fill=\"none\" stroke=\"#222\"/>"));
    canvas.text_at(center + Point::new(14.0, 0.0), "N", TextStyle { size: 12.0, is_bold: true, ..SMALL });
}

fn draw_scale(canvas: &mut Canvas) {
    const HEIGHT: f64 = 5.0;
    let longest = BAR_SHARE * canvas.width() / canvas.scale();
    let metres = BAR_LENGTHS.into_iter().rev().find(|&length| length <= longest).unwrap_or(BAR_LENGTHS[0]);
    let half = metres * canvas.scale() / 2.0;
    let (left, top) = (MARGIN_LEFT, canvas.plan_bottom() + 4.0);
    for (index, fill) in ["#222", "#fff"].into_iter().enumerate() {
        let (x, width) = (short(left + index as f64 * half), short(half));
        canvas.raw(&format!(
            "<rect x=\"{x}\" y=\"{}\" width=\"{width}\" height=\"{HEIGHT}\" fill=\"{fill}\" stroke=\"#222\"/>",
            short(top)
        ));
    }
    let at = Point::new(left + 2.0 * half + 8.0, top + HEIGHT / 2.0);
    canvas.text_at(at, &format!("{metres} m"), SMALL);
    canvas.skip(18.0);
}

/// One paragraph per room: what was asked for and is not there.
fn list_removals(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    let paragraph = |(room, furnished): (&crate::plan::Room, &crate::layout::Furnished)| {
        let mut counts: BTreeMap<(&str, RemovalReason), usize> = BTreeMap::new();
        for removal in &furnished.removals {
            *counts.entry((&drawing.catalog.classes[removal.class].id, removal.reason)).or_default() += 1;
        }
        let pieces = counts.iter().map(|((class, reason), count)| match count {
            1 => format!("{class} ({})", reason.name()),
            _ => format!("{count} {class} ({})", reason.name()),
        });
        (!counts.is_empty()).then(|| format!("{}: {}", room.id, pieces.collect::<Vec<_>>().join(", ")))
    };
    let rooms = drawing.level.rooms.iter().zip(drawing.furnished);
    list(canvas, "Not placed", rooms.filter_map(paragraph).collect());
}

fn list_findings(canvas: &mut Canvas, drawing: &Drawing<'_>) {
    let paragraph = |(room, findings): (&crate::plan::Room, &Vec<crate::audit::Finding>)| {
        let texts = findings.iter().map(|finding| {
            let code = serde_json::to_value(finding.code).ok();
            let code = code.as_ref().and_then(serde_json::Value::as_str).unwrap_or_default();
            format!("{code} {}", finding.objects.join(" "))
        });
        (!findings.is_empty()).then(|| format!("{}: {}", room.id, texts.collect::<Vec<_>>().join(", ")))
    };
    let rooms = drawing.level.rooms.iter().zip(drawing.findings);
    list(canvas, "Findings", rooms.filter_map(paragraph).collect());
}

fn list(canvas: &mut Canvas, title: &str, paragraphs: Vec<String>) {
    if paragraphs.is_empty() {
        return;
    }
    canvas.skip(6.0);
    canvas.note(title, TextStyle { is_bold: true, ..SMALL });
    let letters = ((canvas.width() - 2.0 * MARGIN_LEFT) / NOTE_LETTER) as usize;
    for line in paragraphs.iter().flat_map(|paragraph| broken(paragraph, letters, "    ")) {
        canvas.note(&line, SMALL);
    }
}

/// A paragraph in lines of so many letters, broken at spaces; all but the first are indented.
pub(crate) fn broken(text: &str, letters: usize, indent: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let line = lines.last_mut().expect("there is always a line");
        if line.is_empty() {
            line.push_str(word);
        } else if line.chars().count() + word.chars().count() < letters {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(format!("{indent}{word}"));
        }
    }
    lines
}
