//! Pots and what grows in them.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::recipes::kit::{Blade, Builder, Outline, SINK, Sampler, Slice, Solid, blade, lathe, loft, sweep};
use crate::recipes::{GeometrySet, Slot};

/// The growth of a plant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Species {
    /// Broad leaves on short stems in a dense ball, as of a rubber plant or a peace lily.
    Bush,
    /// Long arching fronds from one place.
    Palm,
    /// Stiff upright swords.
    Sword,
    /// A stem with a crown of oval leaves, as of a fig.
    Tree,
}

/// Leaves that grow from one place.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Foliage {
    /// How it grows.
    pub(in super::super) species: Species,
    /// Where the stems leave the soil.
    pub(in super::super) root: DVec3,
    /// How many leaves.
    pub(in super::super) count: u32,
    /// Metres from the root to the tips, measured level.
    pub(in super::super) spread: f64,
    /// Metres from the root to the highest tip.
    pub(in super::super) height: f64,
    /// Whether each leaf is bent in three places instead of two (18 triangles instead of 12).
    pub(in super::super) is_fine: bool,
}

/// The golden angle in turns: neighbouring leaves never lie over each other (as in real plants).
const GOLDEN_TURN: f64 = 0.381_966_011_25;
/// Metres of a leaf at its rib.
const THICKNESS: f64 = 0.002;

/// Leaves in a spiral: the first grow upright and high, the last low and wide; with a stem where there is one.
pub(in super::super) fn grow(builder: &mut Builder, sampler: &mut Sampler, foliage: &Foliage) {
    let start = sampler.between(0.0, 1.0);
    let mut leaves = Vec::new();
    for index in 0..foliage.count {
        let age = f64::from(index) / f64::from(foliage.count.max(2) - 1);
        // The last four reach the four sides, the others stay in the circle between them.
        let outermost = (index + 4).checked_sub(foliage.count);
        let free_turn = TAU * (start + f64::from(index) * GOLDEN_TURN) + sampler.between(-0.2, 0.2);
        let turn = outermost.map_or(free_turn, |side| TAU / 4.0 * f64::from(side));
        let size = if outermost.is_some() { 1.0 } else { sampler.between(0.82, 1.0) };
        leaves.push(leaf(foliage, age, turn, size));
    }
    fill(&mut leaves, foliage);
    leaves.into_iter().for_each(|leaf| builder.add(Slot::Leaf, leaf));
    if foliage.species == Species::Tree {
        stem(builder, sampler, foliage);
    }
}

/// The rib of a leaf as (out, up) shares of the spread and height, and the share of the spread that is half its width.
fn rib_of(species: Species, age: f64) -> ([(f64, f64); 5], f64) {
    match species {
        Species::Bush => {
            let (out, up) = (0.42 + 0.58 * age, 1.0 - 0.62 * age);
            let rib = [
                (0.04, -0.02),
                (out * 0.36, up * 0.62),
                (out * 0.6, up * 0.9),
                (out * 0.82, up * 0.98),
                (out, up * (0.9 - 0.3 * age)),
            ];
            (rib, 0.2)
        }
        Species::Palm => {
            let (out, up) = (0.35 + 0.65 * age, 1.0 - 0.5 * age);
            let rib = [
                (0.02, -0.02),
                (out * 0.14, up * 0.5),
                (out * 0.4, up * 0.9),
                (out * 0.75, up * 0.92),
                (out, up * (0.72 - 0.3 * age)),
            ];
            (rib, 0.085)
        }
        Species::Sword => {
            let (out, up) = (0.12 + 0.88 * age * age, 1.0 - 0.42 * age);
            let rib = [
                (0.05 + 0.25 * age, -0.02),
                (0.08 + out * 0.4, up * 0.3),
                (0.08 + out * 0.52, up * 0.62),
                (0.06 + out * 0.7, up * 0.88),
                (out, up),
            ];
            (rib, 0.16)
        }
        Species::Tree => {
            // Leaves leave the stem between half and the whole height.
            let base = 0.98 - 0.5 * age;
            let out = 0.4 + 0.6 * libm::sin(std::f64::consts::PI * (0.25 + 0.55 * age));
            let rib = [
                (0.03, base - 0.04),
                (out * 0.22, base - 0.01),
                (out * 0.5, base + 0.05),
                (out * 0.8, base + 0.03),
                (out, base - 0.05),
            ];
            (rib, 0.24)
        }
    }
}

/// One leaf of an age, 0 for the first and 1 for the last.
fn leaf(foliage: &Foliage, age: f64, turn: f64, size: f64) -> Solid {
    let (sine, cosine) = libm::sincos(turn);
    let (spread, height) = (foliage.spread * size, foliage.height * size);
    let (rib, share) = rib_of(foliage.species, age);
    let width = spread * share;
    let point = |(out, up): (f64, f64)| {
        foliage.root + DVec3::new(cosine * spread * out, height * up, sine * spread * out)
    };
    let shape = if foliage.species == Species::Sword { [0.8, 1.0, 0.6] } else { [0.3, 1.0, 0.72] };
    let fine = rib.map(point);
    let coarse = [rib[0], rib[1], rib[3], rib[4]].map(point);
    let widths = shape.map(|share| share * width);
    let coarse_widths = [width * shape[0].max(0.6), width * 0.8];
    let (rib, half_widths): (&[DVec3], &[f64]) =
        if foliage.is_fine { (&fine, &widths) } else { (&coarse, &coarse_widths) };
    blade(&Blade {
        rib,
        half_widths,
        thickness: THICKNESS,
        fold: if foliage.species == Species::Sword { 0.05 } else { 0.25 },
    })
}

/// The stem under a crown, a little crooked.
fn stem(builder: &mut Builder, sampler: &mut Sampler, foliage: &Foliage) {
    let lean = foliage.spread * 0.08;
    let at = |share: f64, x: f64, z: f64| foliage.root + DVec3::new(x, foliage.height * share, z);
    let (x, z) = (sampler.between(-lean, lean), sampler.between(-lean, lean));
    let path = [at(-0.03, 0.0, 0.0), at(0.3, x, z), at(0.62, -x * 0.5, z * 0.4), at(0.93, 0.0, 0.0)];
    builder.add(Slot::WoodDark, sweep(&path, (foliage.height * 0.014).max(0.004), 6));
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

/// Pots with many rings, as (radius, height) shares: a tub with bands, an urn on a foot, a drum with beads.
const BANDED: [(f64, f64); 8] =
    [(0.8, 0.0), (0.94, 0.24), (0.9, 0.26), (0.98, 0.5), (0.94, 0.52), (1.0, 0.76), (0.96, 0.78), (1.0, 1.0)];
const URN: [(f64, f64); 7] =
    [(0.62, 0.0), (0.62, 0.06), (0.34, 0.14), (0.38, 0.24), (0.86, 0.5), (0.82, 0.9), (1.0, 1.0)];
const DRUM: [(f64, f64); 8] =
    [(0.7, 0.0), (0.8, 0.3), (0.84, 0.31), (0.84, 0.34), (0.81, 0.35), (0.95, 0.93), (1.0, 0.95), (1.0, 1.0)];

/// Material and outside of a pot, as (radius, height) shares.
fn pot_form(set: GeometrySet, look: usize) -> (Slot, Vec<(f64, f64)>) {
    match set {
        GeometrySet::Plain => (
            [Slot::Ceramic, Slot::Concrete, Slot::PaintedAccent, Slot::Ceramic][look],
            match look {
                0 => vec![(0.92, 0.0), (0.98, 0.04), (1.0, 1.0)],
                1 => vec![(0.7, 0.0), (1.0, 0.96), (1.0, 1.0)],
                2 => vec![(0.6, 0.0), (0.92, 0.3), (1.0, 0.62), (0.9, 1.0)],
                _ => vec![(0.78, 0.0), (0.8, 0.03), (1.0, 1.0)],
            },
        ),
        GeometrySet::Traditional => (
            [Slot::Terracotta, Slot::WoodLight, Slot::Ceramic, Slot::Terracotta][look],
            match look {
                1 => BANDED.to_vec(),
                2 => URN.to_vec(),
                _ => vec![(0.66, 0.0), (0.88, 0.74), (1.0, 0.76), (1.0, 1.0)],
            },
        ),
        GeometrySet::Industrial => (
            [Slot::Metal, Slot::Concrete, Slot::MetalDark, Slot::Metal][look],
            match look {
                1 => vec![(1.0, 0.0), (1.0, 1.0)],
                _ => DRUM.to_vec(),
            },
        ),
        GeometrySet::Budget => (
            [Slot::PlasticDark, Slot::Terracotta, Slot::Plastic, Slot::PaintedAccent][look],
            vec![(0.72, 0.02), (0.9, 0.8), (0.98, 0.82), (1.0, 1.0)],
        ),
    }
}

/// Metres of a pot.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct PotSize {
    /// At the rim.
    pub(in super::super) radius: f64,
    pub(in super::super) height: f64,
}

/// A pot around the y axis from its underside, filled with soil, of a geometry set and
/// a look. In the traditional set clay and wicker, in the industrial zinc and concrete, in the budget set plastic.
pub(in super::super) fn pot(builder: &mut Builder, set: GeometrySet, look: u32, size: PotSize, sides: usize) {
    let PotSize { radius, height } = size;
    let wall = radius * 0.08;
    let look = look as usize % 4;
    let (slot, outside) = pot_form(set, look);
    // Corners: few where concrete is cast square.
    let outline =
        if set == GeometrySet::Industrial && look == 1 { Outline::Soft(1) } else { Outline::Round(sides) };
    let soil = height * 0.84;
    let size = if matches!(outline, Outline::Soft(_)) { 0.8 } else { 1.0 };
    let slices: Vec<Slice> = outside
        .iter()
        .map(|&(share, y)| Slice::round(y * height, radius * share * size))
        .chain([
            Slice::round(height, radius * size * outside[outside.len() - 1].0 - wall),
            Slice::round(soil * 0.88, radius * size * 0.84 - wall),
        ])
        .collect();
    builder.add(slot, loft(&outline, &slices));
    let inner = radius * size * 0.86 - wall;
    builder.add(
        Slot::Soil,
        lathe(&[(inner * 0.8, soil * 0.88 - SINK), (inner, soil), (0.0, soil * 1.04)], sides.min(10)),
    );
    if set == GeometrySet::Budget {
        let saucer = [(0.76, 0.0), (0.95, 0.08), (0.9, 0.085), (0.7, 0.03)]
            .map(|(share, y)| (radius * share, y * height));
        builder.add(Slot::Plastic, lathe(&saucer, sides.min(10)));
    }
}
