//! Mattress, blanket with its folds, and pillows.

use glam::DVec3;

use super::Bed;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, Sampler, pillow, skin};

/// Where the corners of a blanket's cross-section lie, as shares of half its width, and metres under its top; the hem
/// is below both ends.
const ACROSS: [(f64, f64); 11] = [
    (-1.0, 0.06),
    (-0.975, 0.018),
    (-0.9, 0.0),
    (-0.62, 0.0),
    (-0.3, 0.0),
    (0.0, 0.0),
    (0.3, 0.0),
    (0.62, 0.0),
    (0.9, 0.0),
    (0.975, 0.018),
    (1.0, 0.06),
];

/// A blanket laid over a mattress.
struct Cloth {
    /// From hem to top; hems hang down at the left, right and front.
    bay: Bay,
    /// Metres by which it waves.
    wave: f64,
    /// Where its waves begin.
    phase: f64,
    /// Whether its front end hangs down, too.
    has_front: bool,
}

/// Cloth in one closed body whose hems wave: rings from the head to the foot.
fn drape(builder: &mut Builder, slot: Slot, cloth: &Cloth) {
    let bay = cloth.bay;
    let (half, deep) = (bay.width() / 2.0, bay.depth());
    let along = [0.0, 0.012, 0.05, 0.24, 0.42, 0.6, 0.8, 1.0];
    let edge = (deep * 0.2).min(0.05);
    let mut stations: Vec<(f64, f64)> = along
        .iter()
        .map(|share| {
            (bay.low.z + share * (deep - edge), [0.05, 0.012, 0.0][((share * 60.0) as usize).min(2)])
        })
        .collect();
    let drop = if cloth.has_front { [0.012, 0.045] } else { [0.012, 0.05] };
    stations.extend([(bay.high.z - edge * 0.3, drop[0]), (bay.high.z, drop[1])]);
    let ring = |&(z, sunk): &(f64, f64)| {
        let swell = |x: f64| {
            let first = libm::sin(7.0 * x / half + 9.0 * z + cloth.phase);
            let second = libm::sin(3.1 * x / half - 13.0 * z + 2.0 * cloth.phase);
            cloth.wave * (0.5 * first * second - 0.5)
        };
        let point = |&(share, under): &(f64, f64)| {
            let x = share * half;
            let side = if share.abs() >= 1.0 {
                cloth.wave * (0.6 + 0.4 * libm::sin(11.0 * z + cloth.phase))
            } else {
                0.0
            };
            DVec3::new(x - side * share, bay.high.y - under - sunk + swell(x), z)
        };
        let hem = |share: f64| {
            let wave = libm::sin(17.0 * z + 3.0 * share + cloth.phase);
            let x = share * (half - cloth.wave * 0.5 * (1.0 - wave));
            DVec3::new(x, bay.low.y + cloth.wave * (1.0 + wave), z)
        };
        let mut points = vec![hem(-1.0)];
        points.extend(ACROSS.iter().map(point));
        points.push(hem(1.0));
        points
    };
    let rings: Vec<Vec<DVec3>> = stations.iter().map(ring).collect();
    builder.add(slot, skin(&rings, 58.0));
}

/// Everything on the slats of a bed, with `count` pillows side by side.
pub(super) fn make(bed: &Bed, builder: &mut Builder, sampler: &mut Sampler, count: u32) {
    let whole = bed.body();
    let mattress = whole.with_y([bed.frame - 0.002, bed.lying - 0.025]).inset(0.022, 0.0, 0.0);
    builder.cushion(Slot::Mattress, mattress.without(Side::Front, 0.026).without(Side::Back, 0.006), 0.035);
    let start = [0.3, 0.34, 0.44, 0.27][bed.form as usize] * whole.depth();
    let slot = [Slot::FabricLight, Slot::Fabric, Slot::Linen, Slot::FabricAccent][bed.form as usize];
    let phase = sampler.between(0.0, 6.0);
    let hem = bed.frame - [0.02, 0.05, 0.0, 0.09][bed.form as usize] * (bed.lying / 0.55);
    let bay = whole.with_y([hem, bed.lying]).without(Side::Back, start);
    // What is folded over it hangs outside of it, wherever both wave.
    let cover = bay.inset(0.012, 0.0, 0.0);
    drape(builder, slot, &Cloth { bay: cover, wave: 0.008, phase, has_front: true });
    let fold = bay.slab(Side::Back, [0.26, 0.2, 0.34, 0.16][bed.form as usize]).moved(0.0, 0.012, -0.03);
    let fold = fold.with_y([hem + 0.05, fold.high.y]).inset(0.001, 0.0, 0.0);
    let under = if bed.form == 2 { Slot::FabricAccent } else { Slot::Linen };
    drape(builder, under, &Cloth { bay: fold, wave: 0.01, phase: phase + 1.0, has_front: false });
    if bed.form == 1 {
        let throw = whole.slab(Side::Front, whole.depth() * 0.26).without(Side::Front, whole.depth() * 0.07);
        let throw = throw.with_y([hem - 0.03, bed.lying + 0.007]).inset(0.0005, 0.0, 0.0);
        drape(
            builder,
            Slot::FabricAccent,
            &Cloth { bay: throw, wave: 0.007, phase: phase + 2.0, has_front: false },
        );
    }
    pillows(bed, builder, sampler, mattress, count);
}

/// Pillows at the head: flat ones, with more leaning on the headboard before some looks.
fn pillows(bed: &Bed, builder: &mut Builder, sampler: &mut Sampler, mattress: Bay, count: u32) {
    let depth = (mattress.depth() * 0.22).min(0.42);
    for column in mattress.inset(0.03, 0.0, 0.0).columns(count, 0.04) {
        let width = column.width().min(0.78);
        let middle = column.center().x;
        let soft = |thick: f64| pillow(width * sampler_width(bed), thick, depth);
        let tilt = 0.14 + sampler.between(0.0, 0.1);
        let turn = sampler.between(-0.05, 0.05);
        let at = mattress.low.z + depth * 0.56 + 0.02;
        let place = soft(0.17).turned_x(tilt).turned_y(turn);
        builder.add(Slot::Linen, place.moved(middle, mattress.high.y + 0.062, at));
        if bed.form >= 2 {
            let upright = pillow(width * 0.86, 0.15, depth * 0.9).turned_x(1.05).turned_y(-turn);
            let slot = if bed.form == 2 { Slot::FabricLight } else { Slot::Linen };
            builder.add(slot, upright.moved(middle, mattress.high.y + 0.2, at + 0.02));
        }
    }
    if bed.form == 3 {
        let small = pillow(0.42, 0.13, 0.3).turned_x(0.85);
        builder
            .add(Slot::FabricAccent, small.moved(0.0, mattress.high.y + 0.17, mattress.low.z + depth + 0.13));
    }
}

/// Share of the space that pillows take.
fn sampler_width(bed: &Bed) -> f64 {
    if bed.form == 1 { 0.92 } else { 1.0 }
}
