//! Books on a shelf: runs of one height, some leaning, some lying, with gaps and a few other things between them.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, Sampler, cuboid, lathe};

/// Materials of the spines, the first the most frequent.
const SPINES: [Slot; 7] = [
    Slot::Book,
    Slot::Book,
    Slot::PaintedAccent,
    Slot::Leather,
    Slot::Book,
    Slot::FabricLight,
    Slot::WoodDark,
];
/// Metres of air between neighbouring books, so that their covers do not share a plane.
const AIR: f64 = 0.0015;
/// Radians by which the last book of a run leans on its neighbour.
const LEAN: f64 = 0.2;
/// Books that the things between runs cost in triangles.
const THING: u32 = 4;

/// Stands books on the floor of a bay from the left, of varied thickness, height and depth, until `share` of its
/// width is taken or `most` stand.
pub(in super::super) fn fill_with_books(
    builder: &mut Builder,
    sampler: &mut Sampler,
    bay: Bay,
    share: f64,
    most: u32,
) {
    let end = bay.low.x + bay.width() * share;
    // Thick enough on average that `most` books fill the share.
    let mean = (bay.width() * share / f64::from(most.max(1))).max(0.028);
    let mut left = bay.low.x + AIR;
    let mut rest = most;
    while rest > 0 && end - left > mean {
        let room = bay.with_x([left, end]);
        let (next, used) = match sampler.count(0, 7) {
            0 if rest > THING => lying(builder, sampler, room, mean),
            1 if rest > THING && room.width() > 0.14 => thing(builder, sampler, room),
            _ => run(builder, sampler, room, mean, rest),
        };
        left = next;
        rest = rest.saturating_sub(used.max(1));
    }
}

/// Three to nine books of nearly one height; the last may lean. Gives where the next may stand, and how many it took.
fn run(builder: &mut Builder, sampler: &mut Sampler, room: Bay, mean: f64, rest: u32) -> (f64, u32) {
    let height = room.height() * sampler.between(0.6, 0.92);
    let depth = room.depth() * sampler.between(0.6, 0.85);
    let count = sampler.count(3, 9).min(rest);
    let is_leaning = sampler.chance(0.4) && room.width() > mean * f64::from(count + 3);
    let mut left = room.low.x;
    let slot = sampler.pick(&SPINES);
    let is_series = sampler.chance(0.3);
    for index in 0..count {
        let right = left + sampler.between(0.6, 1.4) * mean;
        if right > room.high.x {
            return (room.high.x, index + 1);
        }
        let tall = if is_series { height } else { height * sampler.between(0.86, 1.06) };
        let deep = depth * if is_series { 1.0 } else { sampler.between(0.9, 1.1) };
        let book = room.with_x([left, right - AIR]).slab(Side::Below, tall).slab(Side::Back, deep);
        let slot = if is_series { slot } else { sampler.pick(&SPINES) };
        if is_leaning && index + 1 == count && index > 0 {
            return (lean(builder, slot, book), count);
        }
        builder.cuboid(slot, book);
        left = right;
    }
    (left, count)
}

/// A book that leans to the left on its neighbour, its lower edge on the shelf. Gives its right end.
fn lean(builder: &mut Builder, slot: Slot, book: Bay) -> f64 {
    let (sine, cosine) = libm::sincos(LEAN);
    // Its upper left edge touches where its lower left edge would have stood.
    let foot = book.low.x + book.height() * 0.94 * sine + 0.002;
    let flat = Bay::new([0.0, book.width()], [0.0, book.height() * 0.94], book.z());
    let solid = cuboid(flat.moved(-book.width(), 0.0, 0.0)).turned_z(LEAN);
    let right = foot + book.width() * cosine;
    builder.add(slot, solid.moved(right, book.low.y, 0.0));
    right + book.width() * 0.2
}

/// Two to four books that lie on each other.
fn lying(builder: &mut Builder, sampler: &mut Sampler, room: Bay, mean: f64) -> (f64, u32) {
    let width = (room.height() * sampler.between(0.6, 0.85)).min(room.width());
    let count = sampler.count(2, 4);
    let mut low = room.low.y;
    for _ in 0..count {
        let high = low + mean.min(0.04) * sampler.between(0.7, 1.1);
        if high > room.high.y {
            break;
        }
        let inset = sampler.between(0.0, 0.02);
        let deep = room.depth() * sampler.between(0.6, 0.8);
        let x = [room.low.x + inset, room.low.x + width - sampler.between(0.0, 0.02)];
        let book = Bay::new(x, [low, high - AIR * 0.4], room.z()).slab(Side::Back, deep);
        builder.cuboid(sampler.pick(&SPINES), book.moved(0.0, 0.0, sampler.between(0.0, 0.01)));
        low = high;
    }
    (room.low.x + width + AIR, count)
}

/// A vase, a box or a framed picture.
fn thing(builder: &mut Builder, sampler: &mut Sampler, room: Bay) -> (f64, u32) {
    let wide = sampler.between(0.09, 0.13);
    let middle = DVec3::new(room.low.x + wide * 0.6, room.low.y, room.low.z + room.depth() * 0.5);
    let tall = (room.height() * 0.7).min(sampler.between(0.12, 0.24));
    let radius = (wide * 0.5).min(room.depth() * 0.4);
    match sampler.count(0, 2) {
        0 => {
            let profile = [(0.5, 0.0), (1.0, 0.4), (0.35, 0.8), (0.5, 1.0)];
            let profile = profile.map(|(share, rise)| (share * radius, rise * tall));
            let slot = sampler.pick(&[Slot::Ceramic, Slot::Terracotta, Slot::Glass]);
            builder.add(slot, lathe(&profile, 6).moved(middle.x, middle.y, middle.z));
        }
        1 => {
            let carton = Bay::around(middle + DVec3::Y * tall * 0.3, wide, tall * 0.6, room.depth() * 0.7);
            builder.cuboid(Slot::WoodLight, carton);
        }
        _ => {
            let frame = Bay::around(middle + DVec3::Y * tall * 0.5, wide, tall, 0.012);
            builder.cuboid(Slot::MetalDark, frame);
            builder.cuboid(Slot::Paper, frame.inset(0.012, 0.012, 0.0).moved(0.0, 0.0, 0.001));
        }
    }
    (room.low.x + wide * 1.3, THING)
}
