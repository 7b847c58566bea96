//! Trays and baskets.

use glam::DVec3;

use super::{Profile, SIDES, turned, turned_coarse};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, Solid, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A tray: with a soft rim; an oval one with two bows; a crate of boards with slots to reach through; one of plastic with a
/// broad lip.
pub(in super::super) static TRAY: Recipe = Recipe::accessory("tray", [0.4, 0.3, 0.04])
    .plain(|draft, builder| {
        builder.add(
            draft.sampler().pick(&[Slot::Wood, Slot::Metal, Slot::PlasticDark]),
            soft_tray(builder.bay()),
        )
    })
    .traditional(|draft, builder| {
        oval_tray(builder, draft.sampler().pick(&[Slot::Wood, Slot::Metal, Slot::PlasticDark]))
    })
    .industrial(|draft, builder| {
        crate_of_boards(builder, draft.sampler().pick(&[Slot::Wood, Slot::Metal, Slot::PlasticDark]))
    })
    .budget(|draft, builder| {
        builder.add(
            draft.sampler().pick(&[Slot::Wood, Slot::Metal, Slot::PlasticDark]),
            lipped_tray(builder.bay()),
        )
    });

/// Metres of the walls of a tray.
fn wall(bay: Bay) -> f64 {
    0.012_f64.min(bay.width().min(bay.depth()) * 0.1)
}

fn soft_tray(bay: Bay) -> Solid {
    let (half, wall) = (bay.extent() / 2.0, wall(bay));
    let slice = |share: f64, back: f64| {
        Slice::new(bay.height() * share, half.x - back, half.z - back)
            .softened((half.x.min(half.z) * 0.25 - back).max(0.004))
    };
    let slices = [slice(0.0, wall), slice(1.0, 0.0), slice(1.0, wall * 0.7), slice(0.25, wall * 1.6)];
    loft(&Outline::Soft(2), &slices)
}

/// Walls that slant under a lip, which lies flat.
fn lipped_tray(bay: Bay) -> Solid {
    let (half, wall) = (bay.extent() / 2.0, wall(bay) * 2.0);
    let slice = |share: f64, back: f64| {
        Slice::new(bay.height() * share, half.x - back, half.z - back).softened(half.x.min(half.z) * 0.12)
    };
    let slices = [
        slice(0.0, wall * 1.6),
        slice(0.8, wall),
        slice(0.84, 0.0),
        slice(1.0, 0.0),
        slice(1.0, wall * 1.1),
        slice(0.16, wall * 1.8),
    ];
    loft(&Outline::Soft(1), &slices)
}

/// An oval with a low gallery and a bow of brass at each end.
fn oval_tray(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let dish = bay.slab(Side::Below, bay.height() * 0.55);
    let profile = [(0.0, 0.9), (0.3, 0.94), (1.0, 1.0), (1.0, 0.96), (0.4, 0.88)];
    builder.add(slot, turned_coarse(dish, &profile, SIDES));
    let radius = bay.height() * 0.09;
    let (inside, z) = (bay.high.x * 0.93, bay.depth() * 0.16);
    let point = |x: f64, share: f64, z: f64| DVec3::new(x, bay.height() * share, z);
    let top = 1.0 - radius / bay.height();
    let bow = [
        point(inside * 0.97, 0.4, -z),
        point(inside, top, -z * 0.7),
        point(inside, top, z * 0.7),
        point(inside * 0.97, 0.4, z),
    ];
    builder.add_pair(Slot::Brass, sweep(&bow, radius, 4));
}

/// A floor between four boards, those at the ends with a slot.
fn crate_of_boards(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    let (wall, height) = (wall(bay), bay.height());
    builder.cuboid(slot, bay.with_y([height * 0.04, height * 0.2]).inset(wall * 0.5, 0.0, wall * 0.5));
    for side in [Side::Left, Side::Right] {
        let end = bay.slab(side, wall);
        builder.cuboid(slot, end.slab(Side::Below, height * 0.5));
        builder.cuboid(slot, end.slab(Side::Above, height * 0.22));
        let posts = end.with_y([height * 0.5 - SINK, height * 0.78 + SINK]).inset(SINK, 0.0, SINK);
        for at in [Side::Front, Side::Back] {
            builder.cuboid(slot, posts.slab(at, bay.depth() * 0.3));
        }
    }
    for side in [Side::Front, Side::Back] {
        let board = bay.slab(side, wall).inset(wall - SINK * 2.0, 0.0, SINK * 2.0);
        builder.cuboid(slot, board.with_y([height * 0.02, height * 0.76]));
    }
}

/// A basket with two handles: woven, of wire or sheet, of plastic; with cloth in it where it is high, for laundry.
pub(in super::super) static BASKET: Recipe = Recipe::accessory("basket", [0.35, 0.35, 0.3]).every_set(basket);

fn basket(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let grip = bay.height() * 0.18;
    let body = bay.without(Side::Above, grip);
    let slot = match draft.set() {
        GeometrySet::Plain => [Slot::WoodLight, Slot::FabricLight, Slot::Fabric, Slot::WoodLight],
        GeometrySet::Traditional => [Slot::WoodLight, Slot::Wood, Slot::WoodLight, Slot::WoodDark],
        GeometrySet::Industrial => [Slot::Metal, Slot::MetalDark, Slot::Metal, Slot::Wood],
        GeometrySet::Budget => [Slot::Plastic, Slot::PaintedAccent, Slot::PlasticDark, Slot::Plastic],
    }[look];
    let profile = woven(draft.set());
    builder.add(slot, turned(body, profile));
    if bay.height() > bay.width() {
        let heap = [(0.7, 0.82), (0.92, 0.9), (1.02, 0.6), (1.06, 0.2)];
        builder.add(Slot::Linen, turned_coarse(body, &heap, 6));
    }
    let radius = 0.007_f64.min(bay.width() * 0.04);
    // On the upper edge, wherever the basket ends there.
    let edge = profile.iter().rev().find(|(share, _)| *share >= 1.0).map_or(1.0, |pair| pair.1);
    let x = bay.high.x * (edge + 0.04) - radius;
    let (z, low) = (bay.depth() * 0.16, body.high.y - grip * 0.4);
    let point = |z: f64, y: f64| DVec3::new(x * 0.985, y, z);
    let bow = [
        point(-z, low),
        point(-z * 0.7, bay.high.y - radius),
        point(z * 0.7, bay.high.y - radius),
        point(z, low),
    ];
    let metal = if matches!(draft.set(), GeometrySet::Industrial) { Slot::MetalDark } else { Slot::Wood };
    builder.add_pair(if draft.set() == GeometrySet::Budget { slot } else { metal }, sweep(&bow, radius, 4));
}

/// The outline of a basket: woven in bands, bulging, of sheet, or moulded with a rim.
fn woven(set: GeometrySet) -> Profile {
    match set {
        GeometrySet::Plain => &[
            (0.0, 0.78),
            (0.3, 0.9),
            (0.32, 0.88),
            (0.62, 0.97),
            (0.64, 0.95),
            (1.0, 1.0),
            (1.0, 0.92),
            (0.06, 0.7),
        ],
        GeometrySet::Traditional => {
            &[(0.0, 0.68), (0.2, 0.88), (0.5, 1.0), (0.8, 0.97), (1.0, 0.88), (1.0, 0.8), (0.06, 0.6)]
        }
        GeometrySet::Industrial => {
            &[(0.0, 0.86), (0.04, 0.9), (0.93, 0.96), (0.94, 1.0), (1.0, 1.0), (1.0, 0.94), (0.05, 0.84)]
        }
        GeometrySet::Budget => {
            &[(0.0, 0.8), (0.86, 0.95), (0.88, 1.0), (1.0, 1.0), (1.0, 0.92), (0.05, 0.76)]
        }
    }
}
