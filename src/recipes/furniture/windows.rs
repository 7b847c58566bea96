//! Curtains and blinds, which hang before windows.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::kit::{
    Axis, Bay, Builder, Level, Outline, SINK, Slice, Solid, cylinder, extrude, hung, lathe, loft_ring, sweep,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of cloth for one fold.
const FOLD: f64 = 0.16;

/// What a curtain hangs from and how.
#[derive(Clone, Copy, PartialEq)]
enum Hanging {
    /// A rod with rings.
    Rod,
    /// A board with a valance of cloth; the curtains are tied back.
    Pelmet,
    /// A flat rail under a slim cover.
    Rail,
    /// Slats drawn up, cords at the side.
    Blind,
}

/// Two curtains drawn aside, or a blind that is drawn up.
pub(super) static CURTAIN: Recipe = Recipe::furniture("curtain", [1.6, 0.15, 2.3]).every_set(curtain);

fn curtain(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let look = draft.form();
    let hanging = match draft.set() {
        GeometrySet::Plain => [Hanging::Rod, Hanging::Rail, Hanging::Rod, Hanging::Rail],
        GeometrySet::Traditional => [Hanging::Pelmet, Hanging::Pelmet, Hanging::Rod, Hanging::Pelmet],
        GeometrySet::Industrial => [Hanging::Rod, Hanging::Blind, Hanging::Rod, Hanging::Blind],
        GeometrySet::Budget => [Hanging::Rail, Hanging::Blind, Hanging::Rail, Hanging::Rod],
    }[look];
    if hanging == Hanging::Blind {
        blind(draft, builder);
        return;
    }
    let head = match hanging {
        Hanging::Rod => rod(draft, builder),
        Hanging::Pelmet => pelmet(builder, look),
        _ => {
            let rail = bay.slab(Side::Above, (bay.height() * 0.03).min(0.025));
            builder.cuboid(Slot::Painted, rail.inset(0.0, 0.0, bay.depth() * 0.25));
            rail.low.y + SINK
        }
    };
    let width = bay.width() * sampler.between(0.24, 0.285);
    let cloth = bay.with_x([bay.high.x - width, bay.high.x - 0.012]).with_y([0.0, head]);
    let slot =
        [Slot::Fabric, Slot::FabricLight, Slot::FabricAccent, Slot::Linen][(look + draft.set() as usize) % 4];
    let count = (width / FOLD).round().clamp(2.0, 9.0) as u32;
    let is_tied = hanging == Hanging::Pelmet && bay.height() > 0.9;
    builder.add_pair(slot, drape(cloth, count, if is_tied { Some(0.4) } else { None }));
    if is_tied {
        let y = bay.height() * 0.4;
        let tie = Bay::new(
            [bay.high.x - width * 0.56, bay.high.x],
            [y - 0.03, y + 0.03],
            [-bay.depth() * 0.42, bay.depth() * 0.42],
        );
        builder.add_pair(Slot::FabricAccent, crate::recipes::kit::cuboid(tie));
    }
    if hanging == Hanging::Rail && look % 2 == 1 {
        // A net curtain hangs behind.
        let net = bay.with_y([0.001, head]).with_x([bay.high.x - width * 1.02, bay.high.x - 0.02]);
        builder.add_pair(Slot::Linen, drape(net.slab(Side::Back, bay.depth() * 0.12), count + 1, None));
    }
}

/// A rod with rings and finials; gives how high the cloth reaches.
fn rod(draft: &Draft, builder: &mut Builder) -> f64 {
    let bay = builder.bay();
    let slot = match draft.set() {
        GeometrySet::Traditional => Slot::Brass,
        GeometrySet::Budget => Slot::Painted,
        GeometrySet::Plain => [Slot::MetalDark, Slot::Metal, Slot::WoodLight, Slot::Metal][draft.form()],
        GeometrySet::Industrial => Slot::MetalDark,
    };
    let radius = (bay.depth() * 0.1).min(if draft.set() == GeometrySet::Industrial { 0.017 } else { 0.013 });
    let ring = radius * 1.8;
    let y = bay.high.y - ring;
    let bar = [DVec3::new(bay.low.x + 0.01, y, 0.0), DVec3::new(bay.high.x - 0.01, y, 0.0)];
    builder.add(slot, sweep(&bar, radius, 8));
    let ends: &[(f64, f64)] = match draft.set() {
        GeometrySet::Traditional => {
            &[(1.0, 0.0), (1.2, 0.1), (0.9, 0.2), (1.7, 0.55), (1.5, 0.8), (0.4, 1.0)]
        }
        GeometrySet::Industrial => &[(1.3, 0.0), (1.3, 0.6), (1.8, 0.62), (1.8, 1.0)],
        _ => &[(1.25, 0.0), (1.25, 1.0)],
    };
    let profile: Vec<(f64, f64)> = ends.iter().map(|&(share, out)| (share * radius, out * 0.045)).collect();
    let end = lathe(&profile, 8).turned_z(-std::f64::consts::FRAC_PI_2);
    builder.add_pair(slot, end.moved(bay.high.x - 0.045, y, 0.0));
    for side in [-1.0, 1.0] {
        let bracket =
            Bay::around(DVec3::new(side * bay.width() * 0.42, y, bay.low.z / 2.0), 0.012, 0.012, -bay.low.z);
        builder.cuboid(slot, bracket);
    }
    let hoop = |x: f64| {
        let slices = [Slice::round(-0.003, ring), Slice::round(0.003, ring), Slice::round(0.0, ring * 0.76)];
        loft_ring(&Outline::Round(8), &slices).turned_z(std::f64::consts::FRAC_PI_2).moved(x, y, 0.0)
    };
    let count = 5;
    for index in 0..count {
        let x = bay.high.x - 0.05 - bay.width() * 0.22 * f64::from(index) / f64::from(count - 1);
        builder.add_pair(slot, hoop(x));
    }
    y - radius * 1.2
}

/// A board with a scalloped valance; gives how high the cloth reaches.
fn pelmet(builder: &mut Builder, look: usize) -> f64 {
    let bay = builder.bay();
    let board = (bay.height() * 0.04).min(0.03);
    builder.block(
        [Slot::WoodDark, Slot::Brass, Slot::Wood, Slot::WoodDark][look],
        bay.slab(Side::Above, board),
        0.006,
    );
    let fall = (bay.height() * 0.14).min(0.105);
    let (top, low) = (bay.high.y - board + SINK, bay.high.y - board - fall);
    let room = bay.inset(0.006, 0.0, 0.0);
    let scallops = (bay.width() / 0.26).round().clamp(2.0, 14.0) as u32;
    let mut edge = vec![DVec2::new(room.high.x, top), DVec2::new(room.low.x, top)];
    let wide = room.width() / f64::from(scallops);
    for scallop in 0..scallops {
        let left = room.low.x + wide * f64::from(scallop);
        for (share, drop) in [(0.02, 0.55), (0.28, 0.9), (0.5, 1.0), (0.72, 0.9), (0.98, 0.55)] {
            edge.push(DVec2::new(left + wide * share, top - (top - low) * drop));
        }
    }
    builder.add(Slot::FabricAccent, extrude(&edge, Axis::Z, [bay.high.z - 0.014, bay.high.z - 0.004]));
    builder.cuboid(
        Slot::Brass,
        bay.with_y([top - 0.018, top - 0.008])
            .inset(0.005, 0.0, 0.0)
            .slab(Side::Front, 0.006)
            .moved(0.0, 0.0, -0.001),
    );
    top - board * 0.2
}

/// Cloth that hangs in a bay: pressed together at its head, wider at the hem, and drawn to its outer edge at a height
/// where it is tied.
fn drape(bay: Bay, count: u32, tie: Option<f64>) -> Solid {
    let tied = |share: f64| tie.map_or(1.0, |at| 0.5 + 0.5 * libm::fabs(share - at).min(0.35) / 0.35);
    // Between these, cloth hangs straight.
    let shares: &[f64] = if tie.is_some() { &[0.0, 0.34, 0.4, 0.46, 1.0] } else { &[0.0, 1.0] };
    let middle = bay.center();
    let level = |share: f64| {
        let width = tied(share) * (1.0 - 0.05 * share);
        let depth = if share > 0.97 { 0.55 } else { 1.0 - 0.25 * share } * (0.4 + 0.6 * tied(share));
        Level {
            at: bay.low.y + share * bay.height(),
            scale: DVec2::new(width, depth),
            shift: DVec2::new(bay.width() / 2.0 * (1.0 - width), 0.0),
        }
    };
    let levels: Vec<Level> = shares.iter().map(|&share| level(share)).collect();
    let (line, thickness) = wave(Bay::around(DVec3::ZERO, bay.width(), 1.0, bay.depth()), count);
    hung(&line, thickness, &levels).moved(middle.x, 0.0, middle.z)
}

/// Cloth in folds that fills a bay.
pub(super) fn folds(bay: Bay, count: u32) -> Solid {
    let (line, thickness) = wave(bay, count);
    hung(&line, thickness, &bay.y().map(|at| Level { at, scale: DVec2::ONE, shift: DVec2::ZERO }))
}

/// The line of cloth in folds, seen from above, and its thickness.
fn wave(bay: Bay, count: u32) -> (Vec<DVec2>, f64) {
    let thickness = (bay.depth() * 0.08).min(0.006);
    let swing = (bay.depth() - thickness) / 2.0;
    let middle = bay.center().z;
    let wave = bay.width() / f64::from(count);
    // Flat crests and troughs, so that no three corners lie in line.
    let mut line: Vec<DVec2> = Vec::new();
    for fold in 0..count {
        for (share, side) in [(0.1, 1.0), (0.4, 1.0), (0.6, -1.0), (0.9, -1.0)] {
            line.push(DVec2::new(bay.low.x + wave * (f64::from(fold) + share), middle + swing * side));
        }
    }
    (line, thickness)
}

/// A blind of slats, or of cloth rolled up, with its cords.
fn blind(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let is_industrial = draft.set() == GeometrySet::Industrial;
    let fall = (bay.height() * 0.14).min(0.11);
    let case = bay.slab(Side::Above, fall * 0.35);
    if is_industrial && look == 1 {
        rolled_up(builder, fall);
        cords(builder, case.low.y);
        return;
    }
    let slot = if is_industrial { Slot::Metal } else { Slot::Painted };
    slats(builder, case, fall, [slot, if look == 3 { Slot::Wood } else { slot }]);
    cords(builder, case.low.y);
    // The brackets reach the wall and the room.
    for (side, inwards) in [(Side::Left, 0.0006), (Side::Right, -0.0006)] {
        let bracket = bay.slab(side, 0.006).with_y([case.low.y + 0.004, bay.high.y - 0.002]);
        builder.cuboid(Slot::Metal, bracket.moved(inwards, 0.0, 0.0));
    }
}

/// Cloth on a roller, the last of it hanging `fall` metres.
fn rolled_up(builder: &mut Builder, fall: f64) {
    let bay = builder.bay();
    let radius = (bay.depth() * 0.4).min(fall * 0.5);
    let y = bay.high.y - radius;
    let roll = [DVec3::new(bay.low.x + 0.012, y, 0.0), DVec3::new(bay.high.x - 0.012, y, 0.0)];
    builder.add(Slot::FabricLight, sweep(&roll, radius * 1.04, 12));
    let sheet =
        bay.inset(0.02, 0.0, 0.0).with_y([bay.high.y - fall, y]).with_z([-radius - 0.001, -radius + 0.002]);
    builder.cuboid(Slot::FabricLight, sheet);
    let hem = sheet.slab(Side::Below, 0.012).inset(-0.004, 0.0, -0.006);
    builder.cuboid(Slot::Metal, hem.moved(0.0, -0.002, 0.0));
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::MetalDark, bay.slab(side, 0.014).slab(Side::Above, fall));
    }
}

/// Slats drawn up under their case, with tapes and a heavier slat below; `slot` is of the case, `of_slats` of most slats.
fn slats(builder: &mut Builder, case: Bay, fall: f64, [slot, of_slats]: [Slot; 2]) {
    let bay = builder.bay();
    builder.block(slot, case.inset(0.0, 0.0, bay.depth() * 0.1), 0.003);
    let slats = bay.with_y([bay.high.y - fall, case.low.y]).inset(0.01, 0.0, bay.depth() * 0.14);
    for slat in slats.rows(7, slats.height() * 0.06) {
        builder.cuboid(of_slats, slat.inset(0.0, slat.height() * 0.12, 0.0));
    }
    let last = slats.slab(Side::Below, 0.014).inset(-0.003, 0.0, -0.003);
    builder.cuboid(slot, last.moved(0.0, -0.006, 0.0));
    for x in [-0.32, 0.32] {
        let tape = Bay::around(slats.center(), 0.012, slats.height(), slats.depth() + 0.009);
        builder.cuboid(Slot::Linen, tape.moved(x * bay.width(), 0.002, 0.0));
    }
}

/// Cords with a weight at the right, a wand at the left; both end at the sill.
fn cords(builder: &mut Builder, top: f64) {
    let bay = builder.bay();
    let x = bay.high.x - bay.width() * 0.06;
    let z = bay.high.z - bay.depth() * 0.2;
    let cord = [DVec3::new(x, 0.03, z), DVec3::new(x, top + 0.004, z)];
    builder.add(Slot::Linen, sweep(&cord, 0.0025, 4));
    let weight = lathe(&[(0.007, 0.0), (0.009, 0.012), (0.003, 0.035)], 6);
    builder.add(Slot::Plastic, weight.moved(x, 0.0, z));
    builder.add(Slot::Plastic, cylinder(0.004, [bay.height() * 0.3, top + 0.004], 6).moved(-x, 0.0, z));
}
