//! Televisions, and what all screens are made of.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cylinder, extrude, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of depth from which a television stands on a foot; a flatter one hangs on the wall.
const STANDING_FROM: f64 = 0.13;

/// The dark body of a screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shell {
    /// Its material.
    pub(super) slot: Slot,
    /// Metres around the lit area.
    pub(super) border: f64,
}

/// A flat display: a dark body with a lit area in front, `bay` deep, and a border.
pub(super) fn display(builder: &mut Builder, bay: Bay, shell: Shell) {
    let Shell { slot, border } = shell;
    let glass = 0.004_f64.min(bay.depth() * 0.2);
    builder.block(slot, bay.without(Side::Front, glass), bay.depth().min(0.02) * 0.2);
    let border = border.min(bay.width() * 0.08).min(bay.height() * 0.1);
    builder.cuboid(Slot::Screen, bay.slab(Side::Front, glass + SINK).inset(border, border, 0.0));
}

/// Body and border of a screen, in metres (thin modern bezels: 0.008; older ones 0.03).
pub(super) fn body(draft: &Draft) -> Shell {
    let look = draft.form();
    let (slot, border) = match draft.set() {
        GeometrySet::Plain => {
            ([Slot::PlasticDark, Slot::MetalDark, Slot::Metal, Slot::PlasticDark][look], 0.007)
        }
        GeometrySet::Traditional => {
            ([Slot::WoodDark, Slot::PlasticDark, Slot::Wood, Slot::WoodDark][look], 0.03)
        }
        GeometrySet::Industrial => {
            ([Slot::MetalDark, Slot::Metal, Slot::MetalDark, Slot::PlasticDark][look], 0.014)
        }
        GeometrySet::Budget => {
            ([Slot::PlasticDark, Slot::PlasticDark, Slot::Plastic, Slot::PlasticDark][look], 0.024)
        }
    };
    Shell { slot, border }
}

/// A television, on a foot or on a wall bracket by its depth.
pub(super) static TV: Recipe = Recipe::accessory("tv", [1.2, 0.22, 0.75]).every_set(tv);

fn tv(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let shell = body(draft);
    if bay.depth() < STANDING_FROM {
        let thick = (bay.depth() * 0.55).min(0.045);
        display(builder, bay.slab(Side::Front, thick), shell);
        let bracket =
            bay.without(Side::Front, thick - SINK).inset(bay.width() * 0.3, bay.height() * 0.3, 0.0);
        builder.cuboid(Slot::MetalDark, bracket);
        let bulge = bay.without(Side::Front, thick - SINK * 2.0).slab(Side::Front, bay.depth() * 0.2);
        builder.block(
            Slot::PlasticDark,
            bulge.inset(bay.width() * 0.12, 0.0, 0.0).with_y([bay.height() * 0.08, bay.height() * 0.4]),
            0.004,
        );
        return;
    }
    let lift = bay.height() * 0.1;
    let middle = bay.center().z;
    display(builder, bay.without(Side::Below, lift).with_z([middle - 0.02, middle + 0.025]), shell);
    let bulge = Bay::new(
        [-bay.width() * 0.36, bay.width() * 0.36],
        [lift + bay.height() * 0.06, bay.height() * 0.5],
        [middle - 0.045, middle - 0.02 + SINK],
    );
    builder.block(Slot::PlasticDark, bulge, 0.006);
    let sensor = Bay::around(DVec3::new(bay.width() * 0.42, lift + 0.004, middle + 0.02), 0.02, 0.005, 0.006);
    builder.cuboid(Slot::Lamp, sensor);
    match (draft.set(), draft.input.look % 2) {
        (GeometrySet::Plain, 0) | (GeometrySet::Budget, _) => plate_foot(builder, lift, middle),
        (GeometrySet::Industrial, _) => tube_foot(builder, lift, middle),
        _ => splayed_feet(builder, shell.slot, lift, middle),
    }
    let cable = [
        DVec3::new(0.03, lift + bay.height() * 0.1, middle - 0.04),
        DVec3::new(0.04, lift * 0.5, bay.low.z * 0.7),
        DVec3::new(0.1, 0.005, bay.low.z * 0.85),
    ];
    builder.add(Slot::PlasticDark, sweep(&cable, 0.004, 4));
}

fn plate_foot(builder: &mut Builder, lift: f64, middle: f64) {
    let bay = builder.bay();
    builder.block(
        Slot::PlasticDark,
        Bay::new([-bay.width() * 0.2, bay.width() * 0.2], [0.0, 0.012], bay.z()),
        0.004,
    );
    let neck = Bay::new(
        [-bay.width() * 0.05, bay.width() * 0.05],
        [0.012 - SINK, lift + 0.05],
        [middle - 0.018, middle],
    );
    builder.cuboid(Slot::PlasticDark, neck);
}

fn tube_foot(builder: &mut Builder, lift: f64, middle: f64) {
    let bay = builder.bay();
    let radius = (lift * 0.14).min(0.011);
    for side in [-1.0, 1.0] {
        let x = side * bay.width() * 0.3;
        let at = |y: f64, z: f64| DVec3::new(x, y, z);
        let path = [at(radius, bay.low.z), at(radius, bay.high.z)];
        builder.add(Slot::MetalDark, sweep(&path, radius * 1.05, 6));
        builder.add(Slot::MetalDark, cylinder(radius, [radius, lift + 0.02], 6).moved(x, 0.0, middle));
    }
    let bar = [DVec3::new(-bay.width() * 0.3, radius, middle), DVec3::new(bay.width() * 0.3, radius, middle)];
    builder.add(Slot::MetalDark, sweep(&bar, radius * 0.9, 6));
}

fn splayed_feet(builder: &mut Builder, slot: Slot, lift: f64, middle: f64) {
    let bay = builder.bay();
    for x in [-0.36, 0.36] {
        let (x, peak) = (x * bay.width(), lift + 0.01);
        let foot = [
            (bay.high.z, 0.0),
            (bay.high.z, 0.012),
            (middle + 0.01, peak),
            (middle - 0.01, peak),
            (bay.low.z, 0.012),
            (bay.low.z, 0.0),
        ];
        builder.add(slot, extrude(&foot.map(DVec2::from), Axis::X, [x - 0.012, x + 0.012]));
    }
}
