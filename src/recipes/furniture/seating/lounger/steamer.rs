//! The deck chair of steamers: slats of teak, arm rests, two wheels at the head and handles at the foot.

use glam::DVec3;

use super::Lounger;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::furniture::parts::turned_forward;
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Bay, Builder, SINK, cuboid, cylinder, lathe, rounded_box, sweep};

/// Metres of the rails' and arm rests' width, and of a slat.
const RAIL: f64 = 0.04;
const ARM: f64 = 0.055;
const SLAT: f64 = 0.018;

pub(super) fn build(lounger: &Lounger, builder: &mut Builder, look: usize) {
    let bay = lounger.bay;
    let wood = [Slot::Wood, Slot::WoodDark, Slot::Wood, Slot::WoodDark][look];
    let under = lounger.lying - SLAT;
    let inner = bay.inset(0.0, 0.0, ARM * 0.4);
    for end in [Side::Front, Side::Back] {
        let rail = inner.slab(end, RAIL).with_y([under - 0.055, under + SINK]);
        builder.block(wood, rail.without(Side::Left, bay.width() * 0.06), 0.01);
    }
    // The rails go on behind the slats as handles.
    let handles = bay.width() * 0.07;
    let slats = lounger.flat(SLAT).inset(0.0, 0.0, ARM * 0.4 + 0.002).without(Side::Right, handles);
    for slat in slats.columns(11, 0.02) {
        builder.cuboid(wood, slat);
    }
    head(lounger, builder, wood);
    let wheel = (bay.height() * 0.24).min(bay.width() * 0.06);
    let x = bay.low.x + wheel * 2.4;
    for z in [inner.low.z + 0.005, inner.high.z - 0.035] {
        let disc = turned_forward(cylinder(wheel, [0.0, 0.03], 12));
        builder.add(wood, disc.moved(x, wheel, z));
        let hub = turned_forward(cylinder(wheel * 0.25, [-0.003, 0.033], 6));
        builder.add(Slot::Brass, hub.moved(x, wheel, z));
        let bearing = Bay::new([x - 0.02, x + 0.02], [wheel * 0.8, under - 0.05], [z + 0.004, z + 0.026]);
        builder.cuboid(wood, bearing);
    }
    let foot = bay.high.x - handles - 0.05;
    let thick = RAIL * 0.5;
    let profile = [(0.6, 0.0), (1.0, 0.15), (0.6, 0.3), (1.0, 0.7), (0.7, 1.0)]
        .map(|(share, rise)| (thick * share, rise * (under - 0.05)));
    for z in [inner.low.z + thick, inner.high.z - thick] {
        builder.add(wood, lathe(&profile, 6).moved(foot, 0.0, z));
    }
    let bar = [inner.low.z + thick, inner.high.z - thick].map(|z| DVec3::new(foot, under * 0.4, z));
    builder.add(wood, sweep(&bar, 0.012, 4));
    arm_rests(lounger, builder, wood);
    if look >= 2 {
        let pad = lounger.flat(0.03).inset(0.0, 0.0, ARM * 1.6).without(Side::Right, handles * 1.4);
        builder.block(Slot::FabricLight, pad.moved(-0.01, 0.03 - SINK, 0.0), 0.012);
    }
}

/// A frame with slats, held up by a bar.
fn head(lounger: &Lounger, builder: &mut Builder, wood: Slot) {
    let head = lounger.head(SLAT).inset(0.0, 0.0, ARM * 1.1);
    let frame = head.without(Side::Right, 0.01);
    for end in [Side::Front, Side::Back] {
        builder.add(
            wood,
            lounger.raised(cuboid(frame.without(Side::Left, 0.002).slab(end, 0.04).moved(
                0.0,
                -SLAT * 0.5,
                0.0,
            ))),
        );
    }
    let top = rounded_box(frame.slab(Side::Left, 0.06).inset(0.0, 0.0, 0.001), DVec3::splat(0.006), 1);
    builder.add(wood, lounger.raised(top));
    for slat in depth_slats(frame.without(Side::Left, 0.058).inset(0.0, 0.001, 0.055), 5, 0.025) {
        builder.add(wood, lounger.raised(cuboid(slat)));
    }
    let low = frame.slab(Side::Right, 0.05).inset(0.0, 0.001, 0.002).moved(-0.004, -SLAT * 0.6, 0.0);
    builder.add(wood, lounger.raised(cuboid(low)));
    let x = lounger.knee - lounger.length * 0.55;
    for z in [frame.low.z + 0.02, frame.high.z - 0.02] {
        let prop =
            [DVec3::new(x + 0.06, lounger.lying - 0.05, z), DVec3::new(x, lounger.height_at(x) - SLAT, z)];
        builder.add(wood, sweep(&prop, 0.01, 4));
    }
}

/// Flat arm rests, on two posts each, which end with the box above.
fn arm_rests(lounger: &Lounger, builder: &mut Builder, wood: Slot) {
    let bay = lounger.bay;
    let x = [lounger.knee - bay.width() * 0.06, lounger.knee + bay.width() * 0.26];
    let rests = bay.slab(Side::Above, 0.022).with_x(x);
    for end in [Side::Front, Side::Back] {
        let rest = rests.slab(end, ARM);
        builder.block(wood, rest, 0.01);
        for share in [0.14, 0.82] {
            let at = DVec3::new(x[0] + share * (x[1] - x[0]), 0.0, rest.center().z);
            let post = Bay::around(at, 0.035, 1.0, 0.025);
            builder.cuboid(wood, post.with_y([lounger.lying - SLAT - 0.04, rest.low.y + 0.004]));
        }
    }
}
