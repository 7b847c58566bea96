//! Sculptures on plinths: what stands in the middle of exhibitions, to be seen from all sides.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::ball;
use crate::recipes::kit::{Bay, Builder, SINK, lathe, sweep};
use crate::recipes::{Draft, Recipe, Slot};

/// Share of the height that is plinth.
const PLINTH: f64 = 0.5;
/// Profiles of turned bodies: shares of the half of the width, and of the height above the plinth.
const VESSEL: [(f64, f64); 8] =
    [(0.28, 0.0), (0.34, 0.04), (0.62, 0.3), (0.7, 0.5), (0.52, 0.74), (0.2, 0.86), (0.3, 1.0), (0.0, 0.98)];
const TORSO: [(f64, f64); 8] = [
    (0.4, 0.0),
    (0.44, 0.12),
    (0.3, 0.38),
    (0.5, 0.62),
    (0.46, 0.76),
    (0.14, 0.82),
    (0.24, 0.92),
    (0.0, 1.0),
];

/// A block with a vessel, a figure, stones on each other or a bow on it, by the look.
pub(super) static SCULPTURE: Recipe = Recipe::furniture("sculpture", [0.6, 0.6, 1.7]).plain(sculpture);

fn sculpture(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let plinth = bay.with_y([0.0, bay.high.y * PLINTH]);
    builder.block(Slot::Plaster, plinth, 0.004);
    let work = bay.without(Side::Below, plinth.high.y - SINK);
    let half = 0.5 * work.width().min(work.depth());
    let slot = draft.sampler().pick(&[Slot::Stone, Slot::Brass, Slot::MetalDark, Slot::Terracotta]);
    match draft.form() {
        0 => turned(builder, slot, work, half, &VESSEL),
        1 => turned(builder, slot, work, half, &TORSO),
        2 => stones(builder, slot, work, half),
        _ => bow(builder, slot, work, half),
    }
}

/// A body of a profile around the middle.
fn turned(builder: &mut Builder, slot: Slot, work: Bay, half: f64, profile: &[(f64, f64)]) {
    let profile: Vec<(f64, f64)> =
        profile.iter().map(|(radius, height)| (radius * half, height * work.height())).collect();
    builder.add(slot, lathe(&profile, 16).moved(0.0, work.low.y, 0.0));
}

/// Three balls, each smaller than the one below.
fn stones(builder: &mut Builder, slot: Slot, work: Bay, half: f64) {
    // The radii of all three together are half the height, less what they sink into each other.
    let unit = (work.height() / 5.7).min(half / 1.2);
    let mut y = work.low.y - 0.15 * unit;
    for share in [1.2, 1.0, 0.8] {
        let radius = share * unit;
        builder.add(slot, ball(radius, 12).moved(0.0, y + radius, 0.0));
        y += 2.0 * radius - 0.1 * unit;
    }
}

/// An arch of tube.
fn bow(builder: &mut Builder, slot: Slot, work: Bay, half: f64) {
    let radius = 0.14 * half;
    let rise = work.height() - radius;
    let shares = [
        (-0.34, 0.0),
        (-0.74, 0.4),
        (-0.66, 0.78),
        (-0.3, 1.0),
        (0.3, 1.0),
        (0.66, 0.78),
        (0.74, 0.4),
        (0.2, 0.08),
    ];
    let path = shares.map(|(x, height)| DVec3::new(x * half, work.low.y + height * rise, 0.0));
    builder.add(slot, sweep(&path, radius, 8));
}
