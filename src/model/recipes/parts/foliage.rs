//! Pots and what grows in them.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::model::kit::{Blade, Builder, SINK, Sampler, Solid, blade, lathe};

/// Leaves that grow from one place.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Foliage {
    /// Where the stems leave the soil.
    pub(in super::super) root: DVec3,
    /// How many leaves.
    pub(in super::super) count: u32,
    /// Metres from the root to the tips, measured level.
    pub(in super::super) spread: f64,
    /// Metres from the root to the highest tip.
    pub(in super::super) height: f64,
    /// Half the width of a leaf in metres.
    pub(in super::super) half_width: f64,
    /// Whether each leaf is bent in three places instead of two (24 triangles instead of 16).
    pub(in super::super) is_fine: bool,
}

/// The golden angle in turns: neighbouring leaves never lie over each other (as in real plants).
const GOLDEN_TURN: f64 = 0.381_966_011_25;
/// Metres of a leaf at its rib.
const THICKNESS: f64 = 0.002;

/// Leaves in a spiral: the first grow upright and high, the last low and wide.
pub(in super::super) fn grow(builder: &mut Builder, sampler: &mut Sampler, foliage: &Foliage) {
    let mut leaves = Vec::new();
    let start = sampler.between(0.0, 1.0);
    for index in 0..foliage.count {
        let age = f64::from(index) / f64::from(foliage.count.max(2) - 1);
        // The last four reach the four sides, the others stay in the circle between them.
        let outermost = (index + 4).checked_sub(foliage.count);
        let free_turn = TAU * (start + f64::from(index) * GOLDEN_TURN) + sampler.between(-0.2, 0.2);
        let turn = outermost.map_or(free_turn, |side| TAU / 4.0 * f64::from(side));
        let free_reach = foliage.spread * (0.5 + 0.5 * age) * sampler.between(0.85, 1.0);
        let reach = if outermost.is_some() { foliage.spread } else { free_reach };
        let rise = foliage.height * (1.0 - 0.6 * age) * sampler.between(0.9, 1.0);
        let (sine, cosine) = libm::sincos(turn);
        let point = |out: f64, up: f64| {
            foliage.root + DVec3::new(cosine * reach * out, rise * up, sine * reach * out)
        };
        let droop = 0.82 - 0.42 * age;
        let width = foliage.half_width;
        let fine =
            [point(0.02, -0.02), point(0.2, 0.42), point(0.48, 0.84), point(0.78, 0.98), point(1.0, droop)];
        let coarse = [point(0.02, -0.02), point(0.3, 0.6), point(0.68, 1.0), point(1.0, droop)];
        let (rib, half_widths): (&[DVec3], &[f64]) = match foliage.is_fine {
            true => (&fine, &[width * 0.6, width, width * 0.75]),
            false => (&coarse, &[width, width * 0.85]),
        };
        let leaf = Blade { rib, half_widths, thickness: THICKNESS, fold: 0.2 };
        leaves.push(blade(&leaf));
    }
    fill(&mut leaves, foliage);
    leaves.into_iter().for_each(|leaf| builder.add("leaf", leaf));
}

/// Stretches leaves away from the root so that the outermost tips lie `spread` and `height` from it.
fn fill(leaves: &mut [Solid], foliage: &Foliage) {
    let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let bounds = leaves.iter().map(Solid::bounds).fold(start, |a, b| (a.0.min(b.0), a.1.max(b.1)));
    let reach = DVec3::new(foliage.spread, foliage.height, foliage.spread);
    let (low, high) = (foliage.root - bounds.0, bounds.1 - foliage.root);
    for point in leaves.iter_mut().flat_map(|leaf| &mut leaf.points) {
        let mut from_root = *point - foliage.root;
        for axis in 0..3 {
            let side = if from_root[axis] < 0.0 { low[axis] } else { high[axis] };
            // Stems go a little into the soil; they stay as they are.
            let is_below = axis == 1 && from_root.y < 0.0;
            from_root[axis] *= if is_below { 1.0 } else { reach[axis] / side.max(reach[axis] * 0.1) };
        }
        *point = foliage.root + from_root;
    }
}

/// A pot around the y axis from its underside, filled with soil: by radius at the rim and height.
pub(in super::super) fn pot(
    builder: &mut Builder,
    slot: &'static str,
    (radius, height): (f64, f64),
    sides: usize,
) {
    let wall = radius * 0.1;
    let soil = height * 0.86;
    let profile = [
        (radius * 0.72, 0.0),
        (radius * 0.94, height * 0.82),
        (radius, height * 0.83),
        (radius, height),
        (radius - wall, height),
        (radius * 0.86 - wall, soil * 0.9),
    ];
    builder.add(slot, lathe(&profile, sides));
    let inner = radius * 0.9 - wall;
    builder.add("soil", lathe(&[(inner * 0.8, soil * 0.9 - SINK), (inner, soil), (0.0, soil * 1.04)], sides));
}
