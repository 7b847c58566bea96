//! Lamps for desks.

use glam::DVec3;

use super::lamps::squat;
use super::lights::SIDES;
use crate::recipes::kit::{Bay, Builder, SINK, Solid, cylinder, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Radians by which the head of a jointed lamp looks forward.
const TILT: f64 = 0.35;

/// A lamp for a desk: jointed arms with springs, a banker's lamp, a cage on an arm, or a clamp with a flexible neck.
pub(super) static DESK_LAMP: Recipe = Recipe::accessory("desk_lamp", [0.2, 0.3, 0.45]).every_set(desk_lamp);

fn desk_lamp(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    if bay.height() < bay.width() * 0.8 || (draft.is_traditional() && bay.height() < bay.width()) {
        return squat(draft, builder);
    }
    match draft.set() {
        GeometrySet::Traditional => bankers_lamp(builder, look),
        GeometrySet::Plain if look == 2 => bar_lamp(builder),
        set => {
            let slot = match set {
                GeometrySet::Industrial => {
                    [Slot::Metal, Slot::MetalDark, Slot::PaintedAccent, Slot::MetalDark]
                }
                GeometrySet::Budget => [Slot::Plastic, Slot::PlasticDark, Slot::PaintedAccent, Slot::Metal],
                _ => [Slot::MetalDark, Slot::PaintedAccent, Slot::Metal, Slot::Painted],
            }[look];
            jointed_lamp(builder, set, slot, look);
        }
    }
}

/// A foot, what carries the head, and the head.
fn jointed_lamp(builder: &mut Builder, set: GeometrySet, slot: Slot, look: usize) {
    let jointed = Jointed::new(builder.bay(), slot, look);
    jointed.foot(builder, set == GeometrySet::Budget && look % 2 == 1);
    if set == GeometrySet::Budget {
        jointed.flexible_neck(builder);
    } else {
        jointed.arms(builder);
    }
    jointed.head(builder, set == GeometrySet::Industrial);
}

/// The measures that the parts of a jointed lamp share.
struct Jointed {
    bay: Bay,
    slot: Slot,
    /// Radius of the foot, front to back.
    foot: f64,
    /// Where the foot's middle is, front to back.
    base: f64,
    /// Radius and length of the shade, before it is tilted.
    wide: f64,
    long: f64,
    /// Where the shade hangs, front to back.
    head: f64,
    /// Where the arm ends.
    neck: DVec3,
    /// Radius of the rods.
    rod: f64,
}

impl Jointed {
    fn new(bay: Bay, slot: Slot, look: usize) -> Self {
        let (width, height, depth) = (bay.width(), bay.height(), bay.depth());
        let foot = (width / 2.0).min(depth * 0.36);
        let (sine, cosine) = libm::sincos(TILT);
        let wide = foot * [0.62, 0.6, 0.58, 0.64][look];
        let long = foot * 0.8;
        let head = bay.high.z - long * sine - wide * cosine;
        let rise = foot * 0.24 + wide * 0.3 * sine;
        let neck = DVec3::new(0.0, height - rise, head - foot * 0.2);
        let rod = (height * 0.016).min(0.008);
        Self { bay, slot, foot, base: bay.low.z + foot, wide, long, head, neck, rod }
    }

    /// A clamp's block, or a disc.
    fn foot(&self, builder: &mut Builder, is_clamp: bool) {
        let (bay, foot) = (self.bay, self.foot);
        let (width, height) = (bay.width(), bay.height());
        if is_clamp {
            let z = [bay.low.z, bay.low.z + foot * 1.4];
            builder.block(self.slot, Bay::new([-width / 2.0, width / 2.0], [0.0, height * 0.06], z), 0.003);
        } else {
            let disc = lathe(&[(foot, 0.0), (foot, height * 0.03), (foot * 0.85, height * 0.05)], SIDES);
            let disc = disc.stretched(DVec3::new(width / 2.0 / foot, 1.0, 1.0));
            builder.add(self.slot, disc.moved(0.0, 0.0, self.base));
        }
    }

    /// One flexible neck instead of arms.
    fn flexible_neck(&self, builder: &mut Builder) {
        let (height, base, neck) = (self.bay.height(), self.base, self.neck);
        let at = |rise: f64, out: f64| {
            let y = height * 0.5 + (neck.y - height * 0.5) * rise;
            DVec3::new(0.0, y, base + (neck.z - base) * out)
        };
        let path = [DVec3::new(0.0, height * 0.04, base), at(0.0, 0.0), at(0.7, 0.15), at(0.95, 0.5), neck];
        builder.add(Slot::Metal, sweep(&path, self.rod * 1.1, 6));
    }

    /// Two pairs of rods with joints and a spring.
    fn arms(&self, builder: &mut Builder) {
        let (height, neck, rod) = (self.bay.height(), self.neck, self.rod);
        let elbow = DVec3::new(0.0, height * 0.55, self.bay.low.z + rod * 2.0);
        let start = DVec3::new(0.0, height * 0.04, self.base);
        for x in [-1.0, 1.0] {
            let aside = DVec3::X * rod * 1.6 * x;
            builder.add(self.slot, sweep(&[start + aside, elbow + aside], rod * 0.6, 4));
            builder.add(self.slot, sweep(&[elbow + aside, neck + aside], rod * 0.6, 4));
        }
        for joint in [start + DVec3::Y * height * 0.03, elbow, neck] {
            builder.cuboid(Slot::MetalDark, Bay::around(joint, rod * 5.5, rod * 2.6, rod * 2.6));
        }
        let spring = [start.lerp(elbow, 0.2), start.lerp(elbow, 0.6)];
        builder.add(Slot::Chrome, sweep(&spring, rod * 0.8, 4));
    }

    /// A shade, hollow from below, with its bulb; a bell, or a plain cone. Looks forward and down.
    fn head(&self, builder: &mut Builder, is_bell: bool) {
        let (foot, wide, long) = (self.foot, self.wide, self.long);
        let cone = if is_bell {
            vec![
                (wide, -long),
                (wide * 0.85, -long * 0.5),
                (wide * 0.5, -long * 0.15),
                (wide * 0.3, 0.0),
                (wide * 0.25, foot * 0.3),
            ]
        } else {
            vec![
                (wide, -long),
                (wide * 0.5, -long * 0.15),
                (wide * 0.36, foot * 0.05),
                (wide * 0.3, foot * 0.3),
            ]
        };
        let inside = [(wide * 0.3, -long * 0.2), (wide * 0.94, -long)];
        let profile: Vec<(f64, f64)> = inside.into_iter().chain(cone).collect();
        let tilted = |solid: Solid| solid.turned_x(-TILT).moved(0.0, self.neck.y - foot * 0.05, self.head);
        builder.add(self.slot, tilted(lathe(&profile, 8)));
        let bulb = [(0.0, -long * 0.85), (wide * 0.42, -long * 0.6), (wide * 0.2, -long * 0.25)];
        builder.add(Slot::Lamp, tilted(lathe(&bulb, 6)));
    }
}

/// A long shade of glass on a stem of brass.
fn bankers_lamp(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let (width, height, depth) = (bay.width(), bay.height(), bay.depth());
    let base = width.min(depth) * 0.36;
    let foot = [
        (base, 0.0),
        (base, height * 0.03),
        (base * 0.5, height * 0.06),
        (base * 0.14, height * 0.09),
        (base * 0.1, height * 0.3),
        (base * 0.2, height * 0.38),
        (base * 0.1, height * 0.46),
        (base * 0.1, height * 0.74),
    ];
    builder.add(Slot::Brass, lathe(&foot, 8).moved(0.0, 0.0, -depth * 0.08));
    let radius = depth / 2.0;
    let slot = [Slot::PaintedAccent, Slot::Glass, Slot::Leaf, Slot::Shade][look];
    // Half a tube, open below.
    let arc = |radius: f64, steps: u32, is_back: bool| {
        (0..=steps).map(move |step| {
            let share = f64::from(if is_back { steps - step } else { step }) / f64::from(steps);
            let (sine, cosine) = libm::sincos(std::f64::consts::PI * (0.04 + 0.92 * share));
            glam::DVec2::new(-cosine * radius, sine * radius)
        })
    };
    let thick = radius * 0.06;
    let profile: Vec<glam::DVec2> = arc(1.0, 6, false)
        .map(|point| point * radius)
        .chain(arc(1.0, 6, true).map(|point| point * (radius - thick)))
        .map(|point| glam::DVec2::new(point.x, height * 0.72 + point.y / radius * height * 0.28))
        .collect();
    builder.add(
        slot,
        crate::recipes::kit::extrude(&profile, crate::recipes::kit::Axis::X, [-width / 2.0, width / 2.0]),
    );
    let tube = Bay::around(DVec3::new(0.0, height * 0.8, 0.0), width * 0.7, height * 0.06, height * 0.06);
    builder.cuboid(Slot::Lamp, tube);
    let chain = cylinder(width * 0.008, [height * 0.55, height * 0.8], 4);
    builder.add(Slot::Brass, chain.moved(width * 0.25, 0.0, depth * 0.1));
    builder.add(
        Slot::Brass,
        lathe(&[(0.0, height * 0.52), (width * 0.025, height * 0.54), (0.0, height * 0.56)], 6).moved(
            width * 0.25,
            0.0,
            depth * 0.1,
        ),
    );
}

/// A bar of light on a bent rod.
fn bar_lamp(builder: &mut Builder) {
    let bay = builder.bay();
    let (width, height) = (bay.width(), bay.height());
    let foot = bay.slab(crate::geometry::Side::Back, bay.depth() * 0.5);
    builder.block(Slot::MetalDark, foot.with_y([0.0, height * 0.03]).inset(width * 0.12, 0.0, 0.0), 0.003);
    let rod = (height * 0.018).min(0.008);
    let z = foot.center().z;
    let path = [
        DVec3::new(0.0, 0.004, z),
        DVec3::new(0.0, height - rod * 2.5, z),
        DVec3::new(0.0, height - rod * 1.3, bay.high.z - width * 0.2),
    ];
    builder.add(Slot::MetalDark, sweep(&path, rod, 6));
    let head = bay.with_y([height - rod * 2.6, height]).with_z([bay.high.z - width * 0.25, bay.high.z]);
    builder.block(Slot::MetalDark, head, rod * 0.4);
    let strip = head.inset(width * 0.05, 0.0, width * 0.05);
    builder.cuboid(Slot::Lamp, strip.with_y([head.low.y - rod * 0.5, head.low.y + SINK]));
}
