//! Clocks on walls.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use super::Dial;
use crate::recipes::Slot;
use crate::recipes::furniture::hangings::{framed, plate};
use crate::recipes::kit::{Bay, Builder, Outline, SINK};

/// The dial of a face at a share of the depth, whose radius is what a border leaves.
fn dial(bay: Bay, share: f64, border: f64) -> Dial {
    let half = bay.extent() / 2.0;
    Dial {
        middle: DVec3::new(0.0, bay.center().y, bay.low.z + share * bay.depth()),
        radius: half.x.min(half.y) - border,
        layer: bay.depth() * (1.0 - share) * 0.3,
    }
}

fn border(bay: Bay, share: f64) -> f64 {
    bay.width().min(bay.height()) / 2.0 * share
}

/// A face that fills a dish, which is smaller at the wall; one mark at twelve.
pub(super) fn slim(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let outline = [Outline::Round(16), Outline::Soft(2), Outline::Round(16), Outline::Square][look].clone();
    let slot = [Slot::MetalDark, Slot::Painted, Slot::Wood, Slot::Metal][look];
    let border = border(bay, 0.05);
    builder.add(slot, framed(&outline, bay, &[(0.0, border * 5.0), (0.6, 0.0), (0.82, border)]));
    builder.add(Slot::Paper, plate(&outline, bay, &[(0.3, border * 3.0), (0.78, border - SINK)]));
    let dial = dial(bay, 0.78, border);
    dial.hands(builder, Slot::PlasticDark, 0.03);
    dial.marks(builder, Slot::PlasticDark, 1, 0.03);
}

/// An outline of eight sides that stands on one of them.
fn octagon() -> Outline {
    let corner = |step: u32| {
        let (sine, cosine) = libm::sincos(TAU * (f64::from(step) + 0.5) / 8.0);
        DVec2::new(cosine, -sine) / libm::cos(PI / 8.0)
    };
    Outline::Points((0..8).map(corner).collect())
}

/// A round face in a frame with a moulding, of eight sides with a ring of brass as in schools, round, or square.
pub(super) fn framed_in_wood(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let round = Outline::Round(16);
    let outline = [octagon(), round.clone(), Outline::Square, round.clone()][look].clone();
    let slot = [Slot::WoodDark, Slot::Brass, Slot::Wood, Slot::WoodDark][look];
    let border = border(bay, 0.26);
    let moulding = [(0.0, 0.0), (0.5, 0.0), (0.86, border * 0.3), (0.5, border), (0.0, border)];
    if look % 2 == 1 {
        builder.add(slot, framed(&round, bay, &moulding[..4]));
        builder.add(Slot::Paper, plate(&round, bay, &[(0.1, border * 1.4), (0.4, border * 0.8)]));
    } else {
        // What the ring leaves of the board behind it is seen in the corners.
        builder.add(slot, plate(&outline, bay, &[(0.0, border * 0.5), (0.4, border * 0.5)]));
        builder
            .add(slot, framed(&outline, bay, &[(0.02, 0.0), (0.6, 0.0), (0.8, border * 0.4), (0.3, border)]));
        let ring = [(0.3, border * 0.8), (0.7, border * 0.9), (0.42, border * 1.25)];
        builder.add(Slot::Brass, framed(&Outline::Round(12), bay, &ring));
        builder
            .add(Slot::Paper, plate(&Outline::Round(12), bay, &[(0.2, border * 1.3), (0.45, border * 1.2)]));
    }
    let share = if look % 2 == 1 { 0.4 } else { 0.45 };
    let dial = Dial { layer: bay.depth() * (1.0 - share) * 0.33, ..dial(bay, share, border * 1.25) };
    dial.hands(builder, Slot::PlasticDark, 0.05);
    dial.marks(builder, Slot::PlasticDark, 4, 0.05);
}

/// Two rings and bars instead of numbers, through which one sees the wall; its works are in a box in the middle.
pub(super) fn wheel(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let slot = [Slot::MetalDark, Slot::Metal, Slot::Brass, Slot::Metal][look];
    let half = bay.width().min(bay.height()) / 2.0;
    let (wide, inside) = (half * 0.07, half * 0.44);
    let ring = |back: f64| [(0.2, back), (0.52, back + wide * 0.5), (0.2, back + wide)];
    builder.add(slot, framed(&Outline::Round(16), bay, &ring(0.0)));
    builder.add(slot, framed(&Outline::Round(8), bay, &ring(inside)));
    let dial = Dial { layer: bay.depth() * 0.16, ..dial(bay, 0.5, 0.0) };
    for spoke in 0..8 {
        let wide = if spoke % 2 == 0 { 0.045 } else { 0.025 };
        let turn = TAU * f64::from(spoke) / 8.0;
        let bar = dial.bar([0.5, 0.95], wide, -1.3, turn);
        builder.add(slot, bar);
    }
    let works = Bay::around(dial.middle, half * 0.5, half * 0.5, 0.0);
    builder.cuboid(slot, works.with_z([bay.low.z, dial.middle.z]));
    dial.hands(builder, Slot::PaintedAccent, 0.05);
}

/// A deep drum with a dark face and broad bars, as on platforms.
pub(super) fn drum(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let outline = if look == 1 { Outline::Round(16) } else { Outline::Soft(1) };
    let border = border(bay, 0.1);
    let slot = [Slot::MetalDark, Slot::Brass][look / 2];
    builder.add(slot, framed(&outline, bay, &[(0.0, 0.0), (1.0, 0.0), (0.5, border)]));
    builder.add(Slot::MetalDark, plate(&outline, bay, &[(0.1, border * 2.0), (0.55, border * 0.9)]));
    let dial = dial(bay, 0.55, border);
    dial.hands(builder, Slot::Paper, 0.06);
    dial.marks(builder, Slot::Paper, 4, 0.06);
}

/// A broad rim of plastic that bulges around a face that lies deep, with a hand of seconds.
pub(super) fn moulded(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let outline = [Outline::Round(16), Outline::Soft(2), Outline::Round(16), Outline::Square][look].clone();
    let slot = [Slot::Plastic, Slot::PlasticDark, Slot::PaintedAccent, Slot::Plastic][look];
    let border = border(bay, 0.24);
    builder.add(
        slot,
        framed(&outline, bay, &[(0.0, border * 0.2), (0.3, 0.0), (1.0, border * 0.5), (0.3, border)]),
    );
    builder.add(Slot::Paper, plate(&outline, bay, &[(0.0, border * 1.5), (0.36, border * 0.9)]));
    let dial = dial(bay, 0.36, border);
    dial.hands(builder, Slot::PlasticDark, 0.045);
    dial.seconds(builder);
    dial.marks(builder, Slot::PlasticDark, 4, 0.035);
}
