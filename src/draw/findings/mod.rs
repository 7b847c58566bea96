//! Draws the audit's findings over the plan: outlines, hatched regions, numbered marks, and a legend below.

mod element;
mod legend;
mod mark;

use crate::audit::{Finding, Grade, Severity};

use super::Drawing;
use super::canvas::Canvas;

pub(crate) use legend::draw_legend;
pub(crate) use mark::draw_marks;

/// A finding with its number on the sheet.
pub(crate) struct Noted<'a> {
    /// Counts from 1 over the whole level.
    number: usize,
    /// Index of its room in the level.
    room: usize,
    finding: &'a Finding,
}

/// All findings of a level, numbered by room.
pub(crate) fn number<'a>(drawing: &Drawing<'a>) -> Vec<Noted<'a>> {
    let findings = drawing.findings.iter().enumerate();
    let findings = findings.flat_map(|(room, findings)| findings.iter().map(move |finding| (room, finding)));
    let noted =
        findings.enumerate().map(|(index, (room, finding))| Noted { number: index + 1, room, finding });
    noted.collect()
}

/// The layer under the texts: hatched regions, then outlines, the worst last so that its colour wins.
pub(crate) fn draw_regions(canvas: &mut Canvas, drawing: &Drawing<'_>, all: &[Noted<'_>]) {
    let mut by_severity: Vec<&Noted<'_>> = all.iter().collect();
    by_severity.sort_by_key(|noted| (noted.finding.severity, noted.number));
    for severity in [Severity::Given, Severity::Minor, Severity::Failed] {
        if all.iter().any(|noted| noted.finding.severity == severity && !noted.finding.region.is_empty()) {
            canvas.define(&hatch(severity));
        }
    }
    for noted in &by_severity {
        let severity = noted.finding.severity;
        let (name, color) = (severity.name(), severity_color(severity));
        for part in &noted.finding.region {
            let attributes = format!("fill=\"url(#hatch-{name})\" stroke=\"{color}\" stroke-width=\"0.8\"");
            canvas.polygon(part, &attributes);
        }
    }
    for noted in by_severity {
        let color = severity_color(noted.finding.severity);
        for &element in &noted.finding.elements {
            let outline = element::outline(element, drawing, noted.room);
            element::draw(element, &outline, canvas, color);
        }
    }
}

/// Diagonal lines in a severity's colour.
fn hatch(severity: Severity) -> String {
    let (name, color) = (severity.name(), severity_color(severity));
    format!(
        "<pattern id=\"hatch-{name}\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" \
         patternTransform=\"rotate(45)\"><path d=\"M0 0V6\" stroke=\"{color}\" stroke-width=\"1.6\" \
         stroke-opacity=\"0.55\"/></pattern>"
    )
}

fn severity_color(severity: Severity) -> &'static str {
    match severity {
        Severity::Failed => "#c92a2a",
        Severity::Minor => "#e67700",
        Severity::Given => "#868e96",
    }
}

/// The colour of a grade, for words.
pub(crate) fn grade_color(grade: Grade) -> &'static str {
    match grade {
        Grade::None => "#2b8a3e",
        Grade::Minor => "#d9480f",
        Grade::Failed => "#c92a2a",
    }
}
