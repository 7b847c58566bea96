//! Seats for waiting rooms and for lying in the garden.

use glam::DVec3;

use super::{depth_slats, seat_height};
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, Station, crowned, pipe, sheet, sweep};
use crate::model::recipes::input::{Draft, GeometrySet};

/// Metres that one waiting person takes.
const PERSON: f64 = 0.55;

/// Seats side by side on one beam: shells of plastic, wood or wire, or padded ones.
pub(in super::super) fn beam_seats(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.input.look as usize % 4;
    let count = draft.count_along("seats", (bay.width(), PERSON), 8).min(8);
    let seat = seat_height(bay.height());
    let slot = match draft.set() {
        GeometrySet::Plain => ["fabric", "leather", "wood", "fabric_accent"][form],
        GeometrySet::Traditional => ["wood", "leather", "wood_dark", "wood"][form],
        GeometrySet::Industrial => ["metal", "metal_dark", "metal", "wood"][form],
        GeometrySet::Budget => ["plastic", "painted_accent", "plastic_dark", "plastic"][form],
    };
    let middle = bay.center().z;
    let beam = Bay::around(DVec3::new(0.0, seat - 0.11, middle), bay.width() - 0.02, 0.05, 0.06);
    builder.block("metal_dark", beam, 0.005);
    let foot = (bay.width() * 0.24).min(0.5);
    for x in [foot - bay.width() / 2.0, bay.width() / 2.0 - foot] {
        let post = Bay::new([x - 0.025, x + 0.025], [0.02, seat - 0.12], [middle - 0.02, middle + 0.02]);
        builder.cuboid("metal_dark", post);
        let base = Bay::new([x - 0.03, x + 0.03], [0.0, 0.03], [bay.low.z + 0.02, bay.high.z - 0.02]);
        builder.block("metal_dark", base, 0.01);
    }
    let cells = bay.columns(count, 0.03);
    for cell in &cells {
        let is_padded = matches!(slot, "fabric" | "leather" | "fabric_accent");
        shell(builder, slot, *cell, (seat, is_padded));
    }
    if !form.is_multiple_of(2) {
        for pair in cells.windows(2) {
            arm_rest(builder, (pair[0].high.x + pair[1].low.x) / 2.0, seat, bay);
        }
    }
}

/// One seat and back in a bent sheet, with a cushion where it is padded.
fn shell(builder: &mut Builder, slot: &'static str, cell: Bay, (seat, is_padded): (f64, bool)) {
    let (x, half) = (cell.center().x, cell.width() / 2.0);
    let thickness = if is_padded { 0.045 } else { 0.012 };
    let (low, high) = (cell.low.z, cell.high.z);
    let top = cell.high.y - 0.003 + thickness / 2.0;
    let station = |y: f64, z: f64, share: f64| Station {
        at: DVec3::new(x, y - thickness / 2.0, z),
        half_width: half * share,
        sag: 0.018,
    };
    let lean = low + 0.012 + thickness / 2.0;
    let path = [
        station(seat - 0.03, high - 0.008, 0.92),
        station(seat, high - 0.05, 0.98),
        station(seat - 0.03, low + 0.22, 1.0),
        station(seat - 0.015, low + 0.15, 0.96),
        station(seat + 0.05, low + 0.11, 0.9),
        station(seat + 0.2, lean + 0.04, 0.94),
        station(top - 0.05, lean + 0.004, 0.96),
        station(top, lean, 0.84),
    ];
    builder.add(slot, sheet(&path, DVec3::NEG_X, thickness, 4));
    let bracket = Bay::around(DVec3::new(x, seat - 0.08, cell.center().z), half, 0.05, 0.1);
    builder.cuboid("metal_dark", bracket);
}

fn arm_rest(builder: &mut Builder, x: f64, seat: f64, bay: Bay) {
    let top = seat + 0.18;
    let path =
        [(seat - 0.1, 0.0), (top, 0.02), (top, 0.2)].map(|(y, z)| DVec3::new(x, y, bay.center().z - 0.1 + z));
    builder.add("metal_dark", pipe(&path, 0.011, 0.04));
    let pad =
        Bay::new([x - 0.02, x + 0.02], [top, top + 0.025], [bay.center().z - 0.08, bay.center().z + 0.12]);
    builder.block("plastic_dark", pad, 0.008);
}

/// A sun lounger along x, its head raised on the left.
pub(in super::super) fn lounger(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.input.look as usize % 4;
    let lying = (bay.height() * 0.72).min(0.32);
    let (frame, cover) = match draft.set() {
        GeometrySet::Plain => (
            ["wood", "metal_dark", "painted", "wood"][form],
            ["fabric_light", "fabric", "fabric_accent", "fabric"][form],
        ),
        GeometrySet::Traditional => (
            ["wood", "wood_dark", "wood", "painted"][form],
            ["wood", "wood_dark", "fabric_light", "painted"][form],
        ),
        GeometrySet::Industrial => (
            ["metal_dark", "metal_dark", "metal", "metal_dark"][form],
            ["wood", "leather", "wood", "fabric"][form],
        ),
        GeometrySet::Budget => (
            ["plastic", "chrome", "plastic", "painted"][form],
            ["plastic", "fabric_accent", "plastic", "fabric_light"][form],
        ),
    };
    let is_soft = cover.starts_with("fabric") || cover == "leather";
    lounger_frame(builder, frame, bay, lying);
    let knee = bay.low.x + bay.width() * 0.36;
    let flat = Bay::new([knee, bay.high.x], [lying - 0.026, lying], bay.z()).inset(0.0, 0.0, 0.002);
    let slope = libm::asin(((bay.high.y - lying) / (knee - bay.low.x)).clamp(0.05, 0.7));
    let length = (knee - bay.low.x) / libm::cos(slope) - 0.006;
    let head = Bay::new([-length, 0.0], [-0.026, 0.0], [-bay.depth() / 2.0, bay.depth() / 2.0]);
    let parts = |part: Bay| part.columns((part.width() / 0.1).round().clamp(3.0, 16.0) as u32, 0.02);
    if is_soft {
        builder.add(cover, crowned(flat.without(Side::Below, -0.03), 0.025, 0.012));
        builder.add(
            cover,
            crowned(head.without(Side::Below, -0.03), 0.025, 0.012).turned_z(-slope).moved(knee, lying, 0.0),
        );
        return;
    }
    for board in parts(flat) {
        builder.block(cover, board, 0.004);
    }
    for board in parts(head) {
        let solid = crate::model::kit::rounded_box(board.inset(0.0, 0.0, SINK), DVec3::splat(0.004), 1);
        builder.add(cover, solid.turned_z(-slope).moved(knee - 0.01, lying, 0.0));
    }
    let prop = [
        DVec3::new(knee - length * 0.6, lying - 0.05, 0.0),
        DVec3::new(knee - length * 0.62, lying + length * 0.6 * libm::sin(slope) - 0.02, 0.0),
    ];
    builder.add(frame, sweep(&prop, 0.012, 6));
    for strip in depth_slats(head.inset(0.02, 0.0, 0.06), 2, head.depth() * 0.6) {
        let solid = crate::model::kit::cuboid(strip.moved(0.0, -0.024, 0.0));
        builder.add(frame, solid.turned_z(-slope).moved(knee - 0.01, lying, 0.0));
    }
}

/// Two rails on four legs, with bars across.
fn lounger_frame(builder: &mut Builder, frame: &'static str, bay: Bay, lying: f64) {
    for z in [bay.low.z + 0.025, bay.high.z - 0.025] {
        let rail = Bay::new(
            [bay.low.x + 0.02, bay.high.x - 0.001],
            [lying - 0.07, lying - 0.025],
            [z - 0.024, z + 0.024],
        );
        builder.block(frame, rail, 0.006);
        for x in [bay.low.x + bay.width() * 0.16, bay.high.x - 0.1] {
            let leg = [DVec3::new(x + 0.02, 0.014, z), DVec3::new(x, lying - 0.05, z)];
            builder.add(frame, sweep(&leg, 0.02, 6));
        }
    }
    for x in [bay.low.x + 0.2, bay.high.x - 0.06] {
        let bar =
            [DVec3::new(x, lying - 0.05, bay.low.z + 0.02), DVec3::new(x, lying - 0.05, bay.high.z - 0.02)];
        builder.add(frame, sweep(&bar, 0.014, 6));
    }
}
