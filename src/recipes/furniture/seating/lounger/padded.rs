//! Thick cushions on a low frame with tapered legs.

use super::Lounger;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners, turned_forward};
use crate::recipes::kit::{Builder, SINK, crowned, cuboid, cylinder};

/// Metres of the cushions, and of the frame below them.
const CUSHION: f64 = 0.07;
const FRAME: f64 = 0.05;

pub(super) fn build(lounger: &Lounger, builder: &mut Builder, look: usize) {
    let bay = lounger.bay;
    let (frame, cover) = [
        (Slot::Wood, Slot::FabricLight),
        (Slot::MetalDark, Slot::Fabric),
        (Slot::Painted, Slot::FabricAccent),
        (Slot::Wood, Slot::Fabric),
    ][look];
    let top = lounger.lying - CUSHION;
    let ring = bay.inset(0.004, 0.0, 0.0).with_y([top - FRAME, top]);
    for end in [Side::Front, Side::Back] {
        builder.cuboid(frame, ring.slab(end, 0.04).inset(0.001, 0.0, 0.0));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(frame, ring.slab(side, 0.04).inset(0.0, 0.001, 0.04 - SINK));
    }
    let legs = ring.inset(0.0, 0.0, 0.0015).with_y([0.0, ring.low.y + SINK]).without(Side::Left, 0.1);
    legs_at_corners(builder, frame, legs, 0.05, LegKind::Tapered);
    let deck = ring.inset(0.038, 0.0, 0.038).with_y([top - 0.02, top - 0.002]);
    builder.cuboid(frame, deck);
    let flat = lounger.flat(CUSHION + SINK).inset(0.0, 0.0, 0.006);
    builder.add(cover, crowned(flat, 0.03, 0.012));
    let head = lounger.head(CUSHION).inset(0.0, 0.0, 0.006).without(Side::Left, 0.03);
    builder.add(cover, lounger.raised(crowned(head, 0.03, 0.012)));
    let board = head.inset(0.02, 0.0, 0.03).with_y([-CUSHION - 0.015, -CUSHION + SINK]);
    builder.add(frame, lounger.raised(cuboid(board)));
    let half = bay.depth() * 0.36;
    // The roll ends with the box above.
    let roll = turned_forward(cylinder(0.05, [-half, half], 8));
    let at = lounger.length - 0.09;
    let sunk = lounger.bay.high.y - lounger.height_at(lounger.knee - at * libm::cos(lounger.slope)) - 0.05;
    let roll = lounger.raised(roll.moved(-at, 0.0, 0.0)).moved(0.0, sunk, 0.0);
    builder.add(if look == 2 { Slot::FabricLight } else { Slot::FabricAccent }, roll);
    for z in [-half * 0.7, half * 0.7] {
        let prop = cuboid(super::Bay::new([-0.02, 0.02], [-0.1, 0.0], [z - 0.015, z + 0.015]));
        let x = bay.low.x + 0.12;
        builder.add(frame, prop.moved(x, lounger.height_at(x) - CUSHION - 0.01, 0.0));
    }
}
