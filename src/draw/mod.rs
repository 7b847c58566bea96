//! Draws a furnished level as SVG.
//!
//! y points up in plans and down in SVG; only `canvas` converts between them.

mod canvas;
mod color;
mod findings;
mod furniture;
mod labels;
mod legend;
mod room;
mod sheet;
mod shell;
mod symbols;

use crate::audit::Finding;
use crate::catalog::Catalog;
use crate::geometry::{Bounds, Point};
use crate::layout::Furnished;
use crate::plan::{Level, SitePlacement};

use canvas::Canvas;

pub use room::{MarkKind, RoomDrawing, RoomMark, draw_room, room_frame};

/// The input of a drawing.
#[derive(Clone, Copy, Debug)]
pub struct Drawing<'a> {
    /// Id of the building.
    pub building: &'a str,
    /// Where it stands: turns the north arrow.
    pub site: SitePlacement,
    /// The level.
    pub level: &'a Level,
    /// One per room, in the order of the level's rooms.
    pub furnished: &'a [Furnished],
    /// Findings of the audit, in the same order; listed below the plan. May be empty.
    pub findings: &'a [Vec<Finding>],
    /// Classes and room types.
    pub catalog: &'a Catalog,
    /// Seed of the run, for the title.
    pub seed: u64,
    /// Whether to show the regions that furniture needs in front of it.
    pub has_clearances: bool,
    /// Whether to mark the findings in the plan and list them in full.
    pub has_findings: bool,
    /// Whether to explain the signs and to sum up the rooms below the plan.
    pub has_legend: bool,
}

/// Metres of paper around the walls.
const MARGIN: f64 = 0.6;

/// Draws a level.
///
/// # Panics
/// If `furnished` has not one entry per room, or an index in it points nowhere.
#[must_use]
pub fn draw_level(drawing: &Drawing<'_>) -> String {
    paint(drawing).finish()
}

/// Draws several levels on one sheet, in the order given, side by side and in rows that make it about square.
///
/// # Panics
/// As [`draw_level`].
#[must_use]
pub fn draw_levels(drawings: &[Drawing<'_>]) -> String {
    let sheets: Vec<Canvas> = drawings.iter().map(paint).collect();
    let columns = (sheets.len() as f64).sqrt().ceil().max(1.0) as usize;
    let cell = sheets.iter().fold(Point::ZERO, |most, sheet| most.max(sheet.extent()));
    let rows = sheets.len().div_ceil(columns);
    let size = cell * Point::new(columns.min(sheets.len()) as f64, rows as f64);
    let place = |index: usize| cell * Point::new((index % columns) as f64, (index / columns) as f64);
    let parts: String =
        sheets.into_iter().enumerate().map(|(index, sheet)| sheet.finish_at(place(index))).collect();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n\
         <rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n{parts}</svg>\n",
        size.x, size.y
    )
}

fn paint(drawing: &Drawing<'_>) -> Canvas {
    assert_eq!(drawing.furnished.len(), drawing.level.rooms.len(), "one furnished room per room");
    let mut canvas = Canvas::new(bounds(drawing.level));
    // From the ground up: walls, floors, openings, then what stands on the floors.
    shell::draw_walls(&mut canvas, drawing.level);
    shell::draw_floors(&mut canvas, drawing);
    shell::draw_obstacles(&mut canvas, drawing.level);
    if drawing.has_clearances {
        furniture::draw_clearances(&mut canvas, drawing);
    }
    shell::draw_openings(&mut canvas, drawing.level);
    furniture::draw_furniture(&mut canvas, drawing);
    let noted = if drawing.has_findings { findings::number(drawing) } else { Vec::new() };
    findings::draw_regions(&mut canvas, drawing, &noted);
    // Then everything to read: what comes later keeps off what stands already.
    labels::draw_labels(&mut canvas, drawing);
    furniture::draw_names(&mut canvas, drawing);
    findings::draw_marks(&mut canvas, drawing, &noted);
    sheet::draw_notes(&mut canvas, drawing);
    if drawing.has_findings {
        findings::draw_legend(&mut canvas, drawing, &noted);
    }
    canvas
}

/// The sheet in plan metres.
fn bounds(level: &Level) -> Bounds {
    let corners = level.rooms.iter().flat_map(|room| room.region.outline.corners());
    // Doors may open outward, over the margin.
    let leaves = level.openings.iter().flat_map(|opening| &opening.leaves);
    let bounds = Bounds::around(corners.chain(leaves.map(|leaf| &leaf.open_tip)).copied());
    if !bounds.low.is_finite() {
        return Bounds::new(Point::ZERO, Point::ONE);
    }
    let walls = level.rooms.iter().flat_map(|room| &room.walls);
    let thickness = walls.fold(0.0, |most: f64, wall| most.max(wall.thickness));
    bounds.inflated(MARGIN + thickness)
}

#[cfg(test)]
mod tests;
