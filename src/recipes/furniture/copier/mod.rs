//! Copiers: 0.6 m wide without the tray, 0.65 deep, 1.0 to 1.2 high with the feeder; tables for small ones 0.5 to 0.65
//! high.

mod cassette_copier;
mod desktop;
mod finisher;

use glam::DVec2;

use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, extrude};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// What a copier is made of: its shell and what is dark on it.
type Slots = (Slot, Slot);

/// A copier: on drawers of paper with a tray at its side; with a lid and a sorter of many bins on a cupboard; with a
/// tower that staples; a small one on a table with paper under it.
pub(super) static COPIER: Recipe = Recipe::furniture("copier", [0.62, 0.64, 1.05]).every_set(copier);

fn copier(draft: &Draft, builder: &mut Builder) {
    let look = draft.form();
    let slots = [
        (Slot::Plastic, Slot::PlasticDark),
        (Slot::Appliance, Slot::MetalDark),
        (Slot::Plastic, Slot::MetalDark),
        (Slot::PlasticDark, Slot::PlasticDark),
    ][look];
    match draft.set() {
        GeometrySet::Plain => cassette_copier::cassette_copier(builder, slots, draft.input.look),
        GeometrySet::Traditional => finisher::with_sorter(builder, slots),
        GeometrySet::Industrial => finisher::with_tower(builder, slots),
        GeometrySet::Budget => desktop::desktop(builder, slots),
    }
}

/// How thick a sheet or shelf is, and between which depths it lies.
struct Stretch {
    thickness: f64,
    z: [f64; 2],
}

/// A sheet or shelf that rises outwards, between two ends along x and depths, with a thickness.
fn slope(builder: &mut Builder, slot: Slot, [from, to]: [(f64, f64); 2], stretch: Stretch) {
    let Stretch { thickness, z } = stretch;
    let outline = [from, to, (to.0, to.1 + thickness), (from.0, from.1 + thickness)].map(DVec2::from);
    builder.add(slot, extrude(&outline, Axis::Z, z));
}

/// Keys and a small screen on a panel that lies flat before a scanner.
fn keys(builder: &mut Builder, (shell, dark): Slots, panel: Bay) {
    builder.block(dark, panel, 0.003);
    let on_top = panel.inset(0.012, 0.0, 0.01).with_y([panel.high.y - SINK, panel.high.y + 0.003]);
    builder.cuboid(Slot::Screen, on_top.slab(Side::Left, on_top.width() * 0.4));
    let field = on_top.slab(Side::Right, on_top.width() * 0.5);
    for column in field.columns(4, 0.008) {
        for z in [Side::Back, Side::Front] {
            builder.cuboid(
                if shell == dark { Slot::Metal } else { shell },
                column.slab(z, field.depth() * 0.36),
            );
        }
    }
    let start = field.slab(Side::Right, 0.018).moved(0.024, 0.0, 0.0);
    builder.cuboid(Slot::Leaf, start.inset(0.0, 0.0, start.depth() * 0.2));
}
