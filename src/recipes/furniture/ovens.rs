//! Cooking: hobs, ovens, hoods.

use glam::{DVec2, DVec3};

use super::parts::{Fittings, HandleForm, HandleKind, handle, turned_forward};
use crate::geometry::Side;
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, cuboid, cylinder, extrude, lathe, loft, loft_ring, sweep,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres by which handles and knobs stand out.
const REACH: f64 = 0.028;

/// Metres by which a hob stands over the top: glass, or gas with its grates.
pub(super) fn hob_height(set: GeometrySet) -> f64 {
    match set {
        GeometrySet::Plain => 0.004,
        GeometrySet::Budget => 0.012,
        _ => 0.028,
    }
}

/// Four cooking zones on a top: glass with rings, gas burners under grates, or cast plates.
pub(super) fn hob(draft: &Draft, builder: &mut Builder, top: Bay) {
    let set = draft.set();
    // Usual hobs are 0.58 × 0.51.
    let width = (top.width() - 0.06).min(0.58);
    let depth = (top.depth() - 0.08).min(0.51);
    let (surface, lift) = (top.high.y, hob_height(set));
    let radius = width.min(depth) * 0.19;
    let plate = Bay::around(top.center(), width, 0.004, depth);
    let slot = if set == GeometrySet::Plain { Slot::Screen } else { Slot::Metal };
    builder.cuboid(slot, plate.with_y([surface - SINK, surface + (lift * 0.4).min(0.004)]));
    let base = surface + (lift * 0.4).min(0.004);
    for x in [-1.0, 1.0] {
        for z in [-1.0, 1.0] {
            let size = radius * if x * z > 0.0 { 1.0 } else { 0.8 };
            let at = DVec3::new(x * width * 0.25, 0.0, z * depth * 0.25);
            match set {
                GeometrySet::Plain => ring_on_glass(builder, at, [base, surface + lift], size),
                GeometrySet::Budget => {
                    let heights = [base - SINK, surface + lift * 0.8, surface + lift * 0.85, surface + lift];
                    cast_plate(builder, at, heights, size);
                }
                GeometrySet::Traditional | GeometrySet::Industrial => {
                    burner(builder, at, [base, surface + lift], size);
                }
            }
        }
    }
    if set == GeometrySet::Plain {
        let keys = plate.slab(Side::Front, depth * 0.07).inset(width * 0.34, 0.0, 0.004);
        for key in keys.columns(4, width * 0.03) {
            builder.cuboid(Slot::Metal, key.with_y([base - SINK, base + 0.0006]));
        }
    }
}

/// A cooking zone that is drawn on glass as a thin ring.
fn ring_on_glass(builder: &mut Builder, at: DVec3, [base, high]: [f64; 2], size: f64) {
    let ring = [(base - SINK, 1.0), (high, 1.0), (high, 0.93), (base - SINK, 0.93)];
    let slices = ring.map(|(y, share)| Slice::round(y, size * share));
    builder.add(Slot::Metal, loft_ring(&Outline::Round(16), &slices).moved(at.x, 0.0, at.z));
}

/// A plate of cast iron: its foot, its edge, the hollow in its middle and its top.
fn cast_plate(builder: &mut Builder, at: DVec3, [foot, edge, hollow, top]: [f64; 4], size: f64) {
    let cast = [(size, foot), (size, edge), (size * 0.94, top), (size * 0.3, top), (size * 0.26, hollow)];
    builder.add(Slot::MetalDark, lathe(&cast, 14).moved(at.x, 0.0, at.z));
}

/// A gas burner under a grate of cast bars.
fn burner(builder: &mut Builder, at: DVec3, [low, high]: [f64; 2], size: f64) {
    let tall = high - low;
    let crown = [
        (size * 0.5, low - SINK),
        (size * 0.46, low + tall * 0.4),
        (size * 0.4, low + tall * 0.42),
        (size * 0.36, low + tall * 0.62),
    ];
    builder.add(Slot::MetalDark, lathe(&crown, 10).moved(at.x, 0.0, at.z));
    let bar = 0.008;
    for turn in [0.0, std::f64::consts::FRAC_PI_2] {
        // One of the crossing bars lies a hair lower.
        let top = high - if turn > 0.0 { 0.0006 } else { 0.0 };
        let across = Bay::new([-size * 1.15, size * 1.15], [top - bar, top], [-bar / 2.0, bar / 2.0]);
        builder.add(Slot::MetalDark, cuboid(across).turned_y(turn).moved(at.x, 0.0, at.z));
        for end in [-1.0, 1.0] {
            let foot = Bay::around(DVec3::new(end * size * 1.08, 0.0, 0.0), bar * 0.9, 1.0, bar * 0.9);
            let foot = foot.with_y([low - SINK, top - bar * 0.5]);
            builder.add(Slot::MetalDark, cuboid(foot).turned_y(turn).moved(at.x, 0.0, at.z));
        }
    }
}

/// What an oven or a cooker of a set is made of: its front, and its handle and knobs.
pub(super) fn oven_slots(draft: &Draft) -> [Slot; 2] {
    let look = draft.form();
    let choices = match draft.set() {
        GeometrySet::Plain => [
            [Slot::Metal, Slot::Metal],
            [Slot::PlasticDark, Slot::Metal],
            [Slot::Appliance, Slot::MetalDark],
            [Slot::Metal, Slot::MetalDark],
        ],
        GeometrySet::Traditional => [
            [Slot::Painted, Slot::Brass],
            [Slot::PaintedAccent, Slot::Brass],
            [Slot::MetalDark, Slot::Brass],
            [Slot::Appliance, Slot::Chrome],
        ],
        GeometrySet::Industrial => [
            [Slot::Metal, Slot::MetalDark],
            [Slot::Metal, Slot::Metal],
            [Slot::MetalDark, Slot::Metal],
            [Slot::Metal, Slot::PaintedAccent],
        ],
        GeometrySet::Budget => [
            [Slot::Appliance, Slot::PlasticDark],
            [Slot::Appliance, Slot::Plastic],
            [Slot::Appliance, Slot::Metal],
            [Slot::Plastic, Slot::PlasticDark],
        ],
    };
    choices[look]
}

/// An oven door with a window, a long handle and a strip of knobs; `face` reaches to the tips of the handles.
pub(super) fn oven_front(draft: &Draft, builder: &mut Builder, face: Bay) {
    let [front, metal] = oven_slots(draft);
    let fittings = Fittings { front, handle: metal, reach: REACH, is_traditional: false };
    let strip = face.slab(Side::Above, 0.11_f64.min(face.height() * 0.2));
    let door = face.without(Side::Above, strip.height() + 0.004);
    fittings.panel(builder, strip);
    fittings.panel(builder, door);
    let surface = face.high.z - REACH;
    let wide = if draft.set() == GeometrySet::Plain { 0.06 } else { 0.15 };
    let glass =
        door.inset(door.width() * wide, door.height() * 0.17, 0.0).moved(0.0, -door.height() * 0.05, 0.0);
    if draft.set() != GeometrySet::Plain {
        builder.block(
            metal,
            glass.inset(-0.012, -0.012, 0.0).with_z([surface - SINK, surface + 0.004]),
            0.002,
        );
    }
    builder.cuboid(Slot::Screen, glass.with_z([surface - SINK * 2.0, surface + 0.006]));
    let bar = DVec3::new(0.0, door.high.y - 0.05_f64.min(door.height() * 0.1), surface);
    handle(builder, metal, HandleForm { kind: HandleKind::Level, length: door.width() * 0.82 }, bar, REACH);
    let has_display = matches!(draft.set(), GeometrySet::Plain | GeometrySet::Budget);
    let knob = lathe(&[(0.02, -SINK), (0.021, 0.006), (0.016, 0.008), (0.015, REACH * 0.9)], 10);
    let places: &[f64] =
        if has_display { &[-0.4, -0.27, 0.27, 0.4] } else { &[-0.4, -0.24, -0.08, 0.08, 0.24, 0.4] };
    let size = (strip.height() / 0.06).min(1.0);
    for &place in places {
        let knob = turned_forward(knob.clone()).stretched(DVec3::new(size, size, 1.0));
        builder.add(metal, knob.moved(place * strip.width(), strip.center().y, surface));
        let mark = Bay::around(
            DVec3::new(place * strip.width(), strip.center().y, surface + REACH * 0.9),
            0.003,
            0.026 * size,
            0.002,
        );
        builder.cuboid(Slot::PlasticDark, mark);
    }
    if has_display {
        let display = strip.inset(strip.width() * 0.37, strip.height() * 0.3, 0.0);
        builder.cuboid(Slot::Screen, display.with_z([surface - SINK, surface + 0.002]));
    }
}

/// A cooker hood: a skirt under a chimney, a mantel, a canopy with a duct, or a flat box.
pub(super) static HOOD: Recipe = Recipe::furniture("hood", [0.6, 0.5, 0.7])
    .plain(|draft, builder| skirt(builder, draft.form()))
    .traditional(|draft, builder| mantel(builder, draft.form()))
    .industrial(|draft, builder| canopy(builder, draft.form()))
    .budget(|draft, builder| flat_box(builder, draft.form()));

/// A skirt under a chimney, a pane that leans back over some.
fn skirt(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let slot = [Slot::Metal, Slot::MetalDark, Slot::Painted, Slot::Metal][look];
    let lip = bay.height() * 0.1;
    builder.block(slot, bay.with_y([0.0, lip]), 0.004);
    if look % 2 == 1 {
        // A pane that leans back.
        let pane = [
            Slice::new(lip - SINK, half.x * 0.98, half.z * 0.9).at(0.0, half.z * 0.06),
            Slice::new(bay.height() * 0.5, half.x * 0.98, half.z * 0.5).at(0.0, -half.z * 0.49),
        ];
        builder.add(Slot::Screen, loft(&Outline::Square, &pane));
    }
    chimney(builder, slot, [lip, half.x * 0.36, half.z * 0.46]);
    lights(builder);
}

/// A mantel of mouldings that narrows upwards.
fn mantel(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let slot = [Slot::Wood, Slot::Painted, Slot::WoodDark, Slot::Plaster][look];
    let at = |share: f64, x: f64, z: f64| {
        Slice::new(bay.height() * share, half.x * x, half.z * z).at(0.0, -half.z * (1.0 - z))
    };
    let mantel = [
        at(0.0, 0.96, 0.96),
        at(0.05, 0.96, 0.96),
        at(0.07, 1.0, 1.0),
        at(0.2, 1.0, 1.0),
        at(0.22, 0.94, 0.94),
        at(0.5, 0.7, 0.72),
        at(0.86, 0.56, 0.62),
        at(0.88, 0.64, 0.7),
        at(1.0, 0.64, 0.7),
    ];
    builder.add(slot, loft(&Outline::Square, &mantel));
}

/// A canopy of sheet under a duct with rings, a rail along its front.
fn canopy(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let slot = [Slot::Metal, Slot::MetalDark, Slot::Metal, Slot::Metal][look];
    let at = |share: f64, x: f64, z: f64, back: f64| {
        Slice::new(bay.height() * share, half.x * x, half.z * z).at(0.0, -half.z * back)
    };
    builder.add(
        slot,
        loft(&Outline::Square, &[at(0.0, 1.0, 1.0, 0.0), at(0.16, 1.0, 1.0, 0.0), at(0.5, 0.42, 0.5, 0.5)]),
    );
    let radius = half.x.min(half.z) * 0.4;
    let (low, high) = (bay.height() * 0.5, bay.height());
    let mut duct = vec![(radius, low - 0.01)];
    for ring in 0..4 {
        let y = low + (high - low) * (0.15 + 0.22 * f64::from(ring));
        duct.extend([(radius, y), (radius * 1.06, y + 0.006), (radius, y + 0.012)]);
    }
    duct.push((radius, high));
    builder.add(Slot::Metal, lathe(&duct, 14).moved(0.0, 0.0, -half.z * 0.5));
    let rail = [
        DVec3::new(-half.x * 0.9, bay.height() * 0.08, half.z - 0.012),
        DVec3::new(half.x * 0.9, bay.height() * 0.08, half.z - 0.012),
    ];
    builder.add(Slot::MetalDark, sweep(&rail.map(|point| point - DVec3::Z * 0.001), 0.012, 6));
}

/// A flat box with a slanted front, a visor and keys under a round duct.
fn flat_box(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let slot = [Slot::Painted, Slot::Metal, Slot::Appliance, Slot::Plastic][look];
    let lip = bay.height() * 0.28;
    let slant = [
        (half.z - SINK, 0.0),
        (half.z - SINK, lip * 0.35),
        (half.z * 0.6, lip),
        (-half.z, lip),
        (-half.z, 0.0),
    ]
    .map(DVec2::from);
    builder.add(slot, extrude(&slant, Axis::X, bay.x()));
    let visor = bay.with_y([lip * 0.06, lip * 0.3]).slab(Side::Front, 0.006).inset(0.02, 0.0, 0.0);
    builder.cuboid(Slot::Glass, visor);
    let radius = half.x.min(half.z) * 0.3;
    builder.add(Slot::Metal, cylinder(radius, [lip - SINK, bay.high.y], 12).moved(0.0, 0.0, -half.z * 0.4));
    for (index, x) in [-0.5, -0.42, -0.34].into_iter().enumerate() {
        let key = Bay::around(DVec3::new(x * half.x, lip * 0.5, half.z * 0.9), 0.012, 0.012, 0.02);
        builder.cuboid(if index == 0 { Slot::Lamp } else { Slot::PlasticDark }, key);
    }
}

fn chimney(builder: &mut Builder, slot: Slot, [low, x, z]: [f64; 3]) {
    let bay = builder.bay();
    let back = bay.low.z + 0.001;
    builder.cuboid(slot, Bay::new([-x, x], [low - SINK, bay.height() * 0.72], [back, back + z * 2.0]));
    builder.cuboid(
        slot,
        Bay::new(
            [-x + 0.006, x - 0.006],
            [bay.height() * 0.7, bay.high.y],
            [back + 0.001, back + z * 2.0 - 0.006],
        ),
    );
}

/// Two lamps and a filter in the underside, keys in the front.
fn lights(builder: &mut Builder) {
    let bay = builder.bay();
    for x in [-0.34, 0.34] {
        let lamp = cylinder(0.028, [-0.0, 0.004], 10);
        builder.add(Slot::Lamp, lamp.moved(x * bay.width(), 0.0007, bay.high.z - 0.08));
    }
    let keys =
        Bay::around(DVec3::new(0.0, bay.height() * 0.05, bay.high.z), 0.16, bay.height() * 0.03, 0.0012);
    for key in keys.columns(4, 0.02) {
        builder.cuboid(Slot::Screen, key);
    }
}
