//! Serving trolleys: 0.7 to 0.9 m long, 0.45 wide, 0.80 to 0.95 high, two or three trays.

use super::castors;
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, cylinder, lathe};
use crate::model::recipes::input::{Draft, GeometrySet};

/// A trolley with two or three trays between posts.
pub(in super::super) fn serving_trolley(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.input.look as usize % 4;
    let (board, post) = match draft.set() {
        GeometrySet::Plain => (
            ["wood", "glass", "painted", "wood_light"][look],
            ["metal_dark", "brass", "metal", "chrome"][look],
        ),
        GeometrySet::Traditional => {
            (["wood_dark", "glass", "wood", "wood_dark"][look], ["wood_dark", "brass", "wood", "brass"][look])
        }
        GeometrySet::Industrial => ("metal", ["metal", "metal_dark", "metal", "chrome"][look]),
        GeometrySet::Budget => ("plastic_dark", ["metal", "plastic", "chrome", "metal_dark"][look]),
    };
    let lift = 0.1_f64.min(bay.height() * 0.15);
    let frame = bay.inset(0.012, 0.0, 0.012);
    castors(builder, frame.inset(-0.002, 0.0, -0.002), lift);
    let radius = 0.012;
    let inset = lift * 0.5 - 0.002;
    for x in [frame.low.x + inset, frame.high.x - inset] {
        for z in [frame.low.z + inset, frame.high.z - inset] {
            if draft.is_traditional() {
                let profile = [
                    (radius, lift - SINK),
                    (radius * 1.6, lift + 0.05),
                    (radius * 0.8, bay.height() * 0.4),
                    (radius * 1.6, bay.height() * 0.52),
                    (radius * 0.8, bay.height() * 0.6),
                    (radius, bay.high.y - 0.02),
                    (radius * 1.5, bay.high.y - 0.008),
                    (radius * 0.5, bay.high.y),
                ];
                builder.add(post, lathe(&profile, 8).moved(x, 0.0, z));
            } else {
                builder.add(post, cylinder(radius, [lift - SINK, bay.high.y], 8).moved(x, 0.0, z));
            }
        }
    }
    let shelves: &[f64] = if look.is_multiple_of(2) { &[0.2, 0.9] } else { &[0.2, 0.55, 0.9] };
    for (index, &rise) in shelves.iter().enumerate() {
        let y = bay.high.y * rise;
        // One tray reaches the sides of the box.
        let tray = if index == 0 { bay } else { bay.inset(0.0008, 0.0, 0.0008) };
        builder.block(board, tray.with_y([y - 0.02, y]), 0.004);
        let rail = tray.inset(0.004, 0.0, 0.004).with_y([y + 0.03, y + 0.036]);
        for side in [Side::Front, Side::Back] {
            builder.cuboid(post, rail.slab(side, 0.006).inset(0.0006, 0.0, 0.0));
        }
        for side in [Side::Left, Side::Right] {
            builder.cuboid(post, rail.slab(side, 0.006).inset(0.0, 0.0004, 0.003));
        }
        goods(builder, tray.with_y([y - SINK, (y + 0.12).min(bay.high.y)]), index + look);
    }
}

/// Bottles, cups and a bowl on a tray.
fn goods(builder: &mut Builder, tray: Bay, seed: usize) {
    let y = tray.low.y;
    let tall = tray.height().min(0.22);
    for index in 0..3 {
        let x = tray.width() * [-0.3, -0.05, 0.24][index];
        let z = tray.depth() * [0.1, -0.14, 0.05][index];
        let (slot, profile): (&'static str, Vec<(f64, f64)>) = match (index + seed) % 3 {
            0 => (
                "glass",
                vec![(0.034, y), (0.035, y + tall * 0.55), (0.013, y + tall * 0.75), (0.012, y + tall)],
            ),
            1 => (
                "ceramic",
                vec![(0.03, y), (0.055, y + tall * 0.5), (0.05, y + tall * 0.5), (0.028, y + tall * 0.1)],
            ),
            _ => (
                "ceramic",
                vec![(0.06, y), (0.1, y + tall * 0.2), (0.095, y + tall * 0.22), (0.055, y + tall * 0.06)],
            ),
        };
        builder.add(slot, lathe(&profile, 10).moved(x, 0.0, z));
    }
}
