//! Dumbbell racks: two or three tiers 0.3 m apart; heads of weights 0.1 to 0.16 m across.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{ball, turned_forward};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, lathe, pipe, sweep};
use crate::recipes::{Recipe, Slot};

/// Metres from one dumbbell to the next.
const PITCH: f64 = 0.22;

/// Weights on a frame: round ones on boards; globes and kettlebells in a case of wood; hexagons on tilted rails; coloured
/// ones on a low bent tube.
pub(in super::super) static DUMBBELL_RACK: Recipe = Recipe::furniture("dumbbell_rack", [1.4, 0.55, 0.9])
    .plain(|_, builder| boards(builder))
    .traditional(|_, builder| case(builder))
    .industrial(|_, builder| rails(builder))
    .budget(|_, builder| tube_stand(builder));

/// One of the two weights of a dumbbell.
struct Weight {
    head: Head,
    radius: f64,
}

/// The heads of a dumbbell.
#[derive(Clone, Copy)]
enum Head {
    Globe,
    Sides(usize),
}

/// A dumbbell from back to front with heads of a slot, its grip around a point.
fn dumbbell(builder: &mut Builder, slot: Slot, weight: Weight, at: DVec3, reach: f64) {
    let Weight { head, radius } = weight;
    let grip = turned_forward(cylinder(0.016, [-reach, reach], 8));
    builder.add(Slot::Chrome, grip.moved(at.x, at.y, at.z));
    for end in [-reach, reach] {
        let weight = match head {
            Head::Globe => ball(radius, 8),
            Head::Sides(sides) => turned_forward(cylinder(radius, [-0.05, 0.05], sides)),
        };
        builder.add(slot, weight.moved(at.x, at.y, at.z + end * 0.72));
    }
}

fn boards(builder: &mut Builder) {
    let bay = builder.bay();
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::MetalDark, bay.slab(side, 0.05));
    }
    let pieces = (bay.width() / PITCH).floor().max(1.0) as u32;
    for share in [0.28, 0.72] {
        let y = bay.high.y * share;
        let board = bay.inset(0.05 - SINK, 0.0, 0.01).with_y([y - 0.03, y]);
        builder.cuboid(Slot::Metal, board);
        for cell in board.columns(pieces, 0.02) {
            let radius = (cell.width() * 0.35).min(0.075);
            let at = DVec3::new(cell.center().x, y + radius - SINK, 0.0);
            dumbbell(builder, Slot::Rubber, Weight { head: Head::Sides(8), radius }, at, bay.depth() * 0.3);
        }
    }
}

/// A case of wood: kettlebells below, globes above, a moulded board on top.
fn case(builder: &mut Builder) {
    let bay = builder.bay();
    let board = 0.04;
    for side in [Side::Left, Side::Right] {
        builder.block(
            Slot::WoodDark,
            bay.slab(side, board).inset(0.0, 0.0, 0.01).without(Side::Above, 0.03),
            0.006,
        );
    }
    builder.block(Slot::WoodDark, bay.slab(Side::Above, board).without(Side::Front, 0.02), 0.01);
    let inner = bay.inset(board - SINK, 0.0, 0.02);
    builder.cuboid(Slot::Wood, inner.slab(Side::Back, 0.02).with_y([0.05, bay.high.y - board + SINK]));
    let pieces = (bay.width() / PITCH).floor().clamp(1.0, 7.0) as u32;
    let (floor, shelf) = (0.12, bay.high.y * 0.56);
    for y in [floor, shelf] {
        builder.block(Slot::Wood, inner.with_y([y - 0.03, y]).without(Side::Back, 0.018), 0.004);
        let lip = inner.slab(Side::Front, 0.02).with_y([y - 0.028, y + 0.03]).moved(0.0, 0.0, 0.012);
        builder.block(Slot::WoodDark, lip, 0.004);
    }
    for cell in inner.columns(pieces, 0.02) {
        let x = cell.center().x;
        kettlebell(builder, DVec3::new(x, floor, bay.low.z + bay.depth() * 0.5), 0.09);
        let radius = 0.058;
        dumbbell(
            builder,
            Slot::MetalDark,
            Weight { head: Head::Globe, radius },
            DVec3::new(x, shelf + radius, 0.0),
            bay.depth() * 0.26,
        );
    }
}

/// A ball with a flat foot and a bow over it.
fn kettlebell(builder: &mut Builder, foot: DVec3, radius: f64) {
    let profile = [(0.6, 0.0), (0.95, 0.5), (0.95, 1.1), (0.5, 1.75), (0.0, 1.85)]
        .map(|(share, rise)| (share * radius, rise * radius - SINK));
    builder.add(Slot::MetalDark, lathe(&profile, 8).moved(foot.x, foot.y, foot.z));
    let at = |x: f64, y: f64| foot + DVec3::new(x * radius, y * radius, 0.0);
    let bow = [at(-0.5, 1.5), at(-0.62, 2.3), at(0.62, 2.3), at(0.5, 1.5)];
    builder.add(Slot::MetalDark, sweep(&bow, radius * 0.16, 6));
}

/// Three tiers of tilted angle rails between slanting posts, with hexagonal weights.
fn rails(builder: &mut Builder) {
    let bay = builder.bay();
    let (depth, high, post) = (bay.depth(), bay.high.y, 0.06);
    let side = |shares: [(f64, f64); 4], inset: f64| {
        let profile = shares.map(|(z, y)| DVec2::new(bay.low.z + z * depth, y * high));
        extrude(&profile, Axis::X, [bay.high.x - post + inset, bay.high.x - inset])
    };
    builder.add_pair(Slot::MetalDark, side([(0.12, 0.04), (0.26, 0.04), (0.14, 1.0), (0.0, 1.0)], 0.004));
    builder.add_pair(Slot::MetalDark, side([(0.0, 0.0), (1.0, 0.0), (1.0, 0.06), (0.0, 0.06)], 0.0));
    let pieces = ((bay.width() - 0.14) / PITCH).floor().clamp(1.0, 9.0) as u32;
    for (tier, (y, z)) in [(0.24, 0.42), (0.56, 0.33), (0.86, 0.25)].into_iter().enumerate() {
        let middle = DVec3::new(0.0, high * y, bay.low.z + depth * (z + 0.14));
        let reach = depth * 0.22;
        for (end, drop) in [(-1.0, 0.055), (1.0, -0.055)] {
            let rail = middle + DVec3::new(0.0, drop - 0.06, end * reach * 0.75);
            builder.cuboid(Slot::Metal, Bay::around(rail, bay.width() - post * 2.0 + SINK * 2.0, 0.03, 0.05));
        }
        let arm = [middle + DVec3::new(0.0, 0.0, -reach), middle + DVec3::new(0.0, -0.13, reach)];
        for x in [-bay.high.x + post * 0.5, bay.high.x - post * 0.5] {
            let path = arm.map(|point| DVec3::new(x, point.y - 0.05, point.z));
            builder.add(Slot::MetalDark, sweep(&path, 0.022, 4));
        }
        let zone = bay.inset(post + 0.01, 0.0, 0.0);
        for cell in zone.columns(pieces, 0.02) {
            let radius = 0.055 + 0.008 * (2 - tier) as f64;
            for (end, drop) in [(-1.0, 0.05), (1.0, -0.05)] {
                let weight = turned_forward(cylinder(radius, [-0.05, 0.05], 6)).turned_x(0.42);
                let at = middle + DVec3::new(cell.center().x, drop, end * reach * 0.62);
                builder.add(Slot::Rubber, weight.moved(at.x, at.y, at.z));
            }
            let grip = turned_forward(cylinder(0.016, [-reach * 0.6, reach * 0.6], 6)).turned_x(0.42);
            builder.add(Slot::Chrome, grip.moved(cell.center().x, middle.y, middle.z));
        }
    }
}

/// Two bows of tube with one tier of coloured weights, and balls on the floor below.
fn tube_stand(builder: &mut Builder) {
    let bay = builder.bay();
    let (tube, high) = (0.016, bay.high.y);
    let x = bay.high.x - tube;
    for z in [bay.low.z + tube, bay.high.z - tube] {
        let at = |x: f64, y: f64| DVec3::new(x, y, z);
        builder.add(
            Slot::Metal,
            pipe(&[at(-x, 0.0), at(-x, high - tube), at(x, high - tube), at(x, 0.0)], tube, 0.1),
        );
    }
    for y in [0.12, 0.5] {
        for x in [-x, x] {
            let [back, front] = [bay.low.z, bay.high.z].map(|z| DVec3::new(x, high * y, z * 0.94));
            builder.add(Slot::Metal, sweep(&[back, front], tube * 0.8, 6));
        }
    }
    let (level, reach) = (high * 0.62, bay.depth() * 0.3);
    for z in [-0.5, 0.5] {
        let ends = [-x, x].map(|x| DVec3::new(x, level, z * bay.depth() * 0.5));
        builder.add(Slot::Metal, sweep(&ends, tube * 0.8, 6));
    }
    for x in [-x, x] {
        let ends = [bay.low.z, bay.high.z].map(|z| DVec3::new(x, level, z * 0.94));
        builder.add(Slot::Metal, sweep(&ends, tube * 0.82, 6));
    }
    let pieces = (bay.width() / (PITCH * 0.8)).floor().max(1.0) as u32;
    let slots = [Slot::PaintedAccent, Slot::Leaf, Slot::Book, Slot::Brass];
    for (index, cell) in bay.inset(0.06, 0.0, 0.0).columns(pieces, 0.02).into_iter().enumerate() {
        let at = DVec3::new(cell.center().x, level + 0.058, 0.0);
        dumbbell(builder, slots[index % 4], Weight { head: Head::Sides(6), radius: 0.052 }, at, reach);
    }
    for (index, share) in [-0.64, -0.2, 0.24, 0.66].into_iter().enumerate() {
        let radius = 0.12 - 0.012 * index as f64;
        let middle = DVec3::new(share * bay.high.x, radius, 0.02 * (index % 2) as f64);
        builder.add(
            [Slot::Leather, Slot::Book, Slot::Leaf, Slot::Leather][index],
            ball(radius, 12).moved(middle.x, middle.y, middle.z),
        );
    }
}
