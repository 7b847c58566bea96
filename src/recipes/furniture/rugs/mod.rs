//! Rugs: a backing with panels and bands on it, which meet in carved grooves.
//!
//! Seen from above, field and bands part the rug between them: neighbours sink into each other by less than their edges
//! are rounded, so that no two tops share a place. Every rug is laid with its long side along x and turned if need be.

mod budget;
mod industrial;
mod plain;
#[cfg(test)]
mod tests;
mod traditional;

use std::f64::consts::FRAC_PI_2;

use crate::geometry::Size;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, Solid, THINNEST, loft, loft_ring};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres that the upper edges of panels and bands are rounded by; more than they sink into each other.
const BEVEL: f64 = 0.001_2;
/// Share of the height at which panels and bands begin, inside the backing.
const ROOT: f64 = 0.35;
/// Share of the height that the backing has.
const BACKING: f64 = 0.7;
/// Share of the depth that one band may take at most.
const WIDEST_BAND: f64 = 0.17;

/// A rug: bound pile; a field with borders and fringes; woven strips of different lengths, or a hide; thin with round
/// corners.
pub(super) static RUG: Recipe =
    Recipe::furniture("rug", [2.4, 1.7, 0.012]).symbol(Symbol::Rug).every_set(rug);

fn rug(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    if bay.width() >= bay.depth() {
        lay(draft, builder);
        return;
    }
    let size = Size { width: bay.depth(), depth: bay.width(), height: bay.height() };
    let mut turned = Builder::new(size);
    lay(draft, &mut turned);
    for (slot, solid) in turned.into_parts() {
        builder.add(slot, solid.turned_y(FRAC_PI_2));
    }
}

fn lay(draft: &Draft, builder: &mut Builder) {
    let mut sampler = draft.sampler();
    let form = Form { look: draft.form(), scale: sampler.between(0.85, 1.15) };
    match draft.set() {
        GeometrySet::Budget => budget::rug(builder, form),
        GeometrySet::Industrial => industrial::rug(builder, form),
        GeometrySet::Plain => plain::rug(builder, form),
        GeometrySet::Traditional => traditional::rug(builder, form),
    }
}

/// Which of the four forms of its set a rug has.
#[derive(Clone, Copy)]
struct Form {
    look: usize,
    /// Factor of the widths of bands.
    scale: f64,
}

impl Form {
    /// Metres of a band on a rug: those given, or as many as there is room for.
    fn band(self, bay: Bay, wide: f64) -> f64 {
        (wide * self.scale).min(bay.depth() * WIDEST_BAND)
    }
}

/// A piece of a rug's box up to a share of its height: from the ground, or from inside the backing.
fn layer(bay: Bay, from: f64, to: f64) -> Bay {
    let height = |share: f64| bay.low.y + share * bay.height();
    bay.with_y([height(from), height(to)])
}

fn cut(bay: Bay, y: f64, back: f64) -> Slice {
    let (half, middle) = (bay.extent() / 2.0, bay.center());
    Slice::new(y, half.x - back, half.z - back).at(middle.x, middle.z)
}

fn bevel(bay: Bay, wide: f64) -> f64 {
    BEVEL.min(bay.height() * 0.4).min(wide * 0.3)
}

/// Adds a rectangle with rounded upper edges: 20 triangles.
fn add_panel(builder: &mut Builder, slot: Slot, bay: Bay) {
    if bay.extent().min_element() > THINNEST {
        let edge = bevel(bay, bay.width().min(bay.depth()));
        let top = bay.high.y;
        let slices = [cut(bay, bay.low.y, 0.0), cut(bay, top - edge, 0.0), cut(bay, top, edge)];
        builder.add(slot, loft(&Outline::Square, &slices));
    }
}

/// Adds a band along the four sides of a piece, inside it, with rounded upper edges (48 triangles), and gives what it goes
/// round, which reaches under the band.
fn add_band(builder: &mut Builder, slot: Slot, bay: Bay, wide: f64) -> Bay {
    builder.add(slot, band(bay, wide));
    bay.inset(wide - SINK, 0.0, wide - SINK)
}

fn band(bay: Bay, wide: f64) -> Solid {
    let edge = bevel(bay, wide);
    let (low, shoulder, top) = (bay.low.y, bay.high.y - edge, bay.high.y);
    let profile =
        [(low, 0.0), (shoulder, 0.0), (top, edge), (top, wide - edge), (shoulder, wide), (low, wide)];
    loft_ring(&Outline::Square, &profile.map(|(y, back)| cut(bay, y, back)))
}

/// Pieces from left to right in proportion to their widths, each of which reaches under its neighbours' edges. Every other
/// one is a little less deep, so that the ends of neighbours share no plane.
fn strips(bay: Bay, widths: &[f64]) -> Vec<Bay> {
    let sum: f64 = widths.iter().sum();
    let mut left = bay.low.x;
    let mut strip = |(index, &wide): (usize, &f64)| {
        let right = left + bay.width() * wide / sum;
        let shy = if index % 2 == 0 { 0.0 } else { SINK };
        let strip = bay.inset(0.0, 0.0, shy).with_x([left - SINK / 2.0, right + SINK / 2.0]);
        left = right;
        strip
    };
    widths.iter().enumerate().map(&mut strip).collect()
}
