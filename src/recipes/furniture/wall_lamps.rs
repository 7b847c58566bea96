//! Lamps on walls.

use glam::DVec3;

use super::lights::{bulb, cage, globe, pleated, shade};
use super::parts::turned_forward;
use crate::recipes::kit::{Builder, cylinder, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A lamp on a wall: a shade on an arm, a lantern, a caged bulb, or a plastic globe.
pub(super) static WALL_LAMP: Recipe = Recipe::accessory("wall_lamp", [0.2, 0.2, 0.3]).every_set(wall_lamp);

fn wall_lamp(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = frame_slot(draft);
    let (half_width, height) = (bay.width() / 2.0, bay.height());
    let radius = half_width.min(bay.depth() * 0.42);
    let z = bay.high.z - radius;
    let plate = (height * 0.18).min(half_width * 0.9);
    let disc = turned_forward(cylinder(plate, [0.0, 0.015_f64.min(bay.depth() * 0.1)], 8));
    builder.add(slot, disc.moved(0.0, height * 0.35, bay.low.z));
    let at = |y: f64, z: f64| DVec3::new(0.0, height * y, z);
    let arm = [at(0.35, bay.low.z + 0.005), at(0.16, (bay.low.z + z) / 2.0), at(0.16, z), at(0.42, z)];
    builder.add(slot, sweep(&arm, radius * 0.07, 6));
    builder.add(
        slot,
        lathe(&[(radius * 0.2, 0.0), (radius * 0.12, height * 0.14), (radius * 0.2, height * 0.2)], 6)
            .moved(0.0, 0.0, z),
    );
    let head = head(draft, builder.empty(), slot, [radius, height]);
    for (slot, solid) in head.into_parts() {
        builder.add(slot, solid.stretched(DVec3::new(half_width / radius, 1.0, 1.0)).moved(0.0, 0.0, z));
    }
}

/// The material of plate, arm and neck.
fn frame_slot(draft: &Draft) -> Slot {
    let look = draft.form();
    match draft.set() {
        GeometrySet::Traditional => Slot::Brass,
        GeometrySet::Industrial => [Slot::MetalDark, Slot::Metal, Slot::MetalDark, Slot::PaintedAccent][look],
        GeometrySet::Budget => [Slot::Plastic, Slot::Metal, Slot::PlasticDark, Slot::Painted][look],
        GeometrySet::Plain => [Slot::Metal, Slot::MetalDark, Slot::Brass, Slot::Painted][look],
    }
}

/// What gives the light, above the end of the arm: so wide and high, around the origin.
fn head(draft: &Draft, head: Builder, slot: Slot, size: [f64; 2]) -> Builder {
    match (draft.set(), draft.form()) {
        (GeometrySet::Plain, 1 | 3) | (GeometrySet::Budget, _) => ball(head, slot, size),
        (GeometrySet::Industrial, _) => caged_bulb(head, slot, size),
        (GeometrySet::Traditional, _) => pleated_shade(head, size),
        _ => plain_shade(head, size),
    }
}

/// A ball on a short neck.
fn ball(mut head: Builder, slot: Slot, [radius, height]: [f64; 2]) -> Builder {
    let squat = (height * 0.3).min(radius);
    let ball = globe(height - squat, squat, [-0.9, 1.0], 10);
    head.add(Slot::Lamp, ball.stretched(DVec3::new(radius / squat, 1.0, radius / squat)));
    head.add(slot, cylinder(radius * 0.4, [height * 0.36, height - squat * 1.8], 8));
    head
}

/// A bulb in a cage of wire, which opens upwards.
fn caged_bulb(mut head: Builder, slot: Slot, [radius, height]: [f64; 2]) -> Builder {
    cage(&mut head, slot, radius, [0.0, height * 0.62], 3);
    bulb(&mut head, DVec3::new(0.0, height * 0.3, 0.0), radius * 0.38, -1.0);
    mirrored_up(head, height)
}

/// A bulb under cloth in folds.
fn pleated_shade(mut head: Builder, [radius, height]: [f64; 2]) -> Builder {
    head.add(Slot::Shade, pleated([radius, radius * 0.55], [height * 0.4, height], 16));
    bulb(&mut head, DVec3::new(0.0, height * 0.66, 0.0), radius * 0.26, -1.0);
    head
}

/// A bulb under smooth cloth.
fn plain_shade(mut head: Builder, [radius, height]: [f64; 2]) -> Builder {
    head.add(Slot::Shade, shade([radius, radius * 0.85], [height * 0.36, height]));
    bulb(&mut head, DVec3::new(0.0, height * 0.66, 0.0), radius * 0.26, -1.0);
    head
}

/// Parts turned upside down under a height.
fn mirrored_up(parts: Builder, height: f64) -> Builder {
    let mut turned = parts.empty();
    for (slot, solid) in parts.into_parts() {
        turned.add(slot, solid.turned_z(std::f64::consts::PI).moved(0.0, height, 0.0));
    }
    turned
}
