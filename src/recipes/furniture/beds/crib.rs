//! Cots: lying 0.60 by 1.20 m, bars 45 to 65 mm apart, sides 0.60 m over the mattress at its lowest (EN 716-1).

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cuboid, cylinder, extrude, lathe, rounded_box, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Share of the height at which the child lies.
const LYING: f64 = 0.42;
/// Metres of a mattress.
const MATTRESS: f64 = 0.1;
/// Metres from bar to bar; with bars of 15 to 20 mm it leaves the gap that is allowed.
const BARS: f64 = 0.085;

/// A side of a cot with bars, and metres of its top.
struct Rail {
    side: Side,
    top: f64,
}

/// What all cots share.
struct Cot {
    bay: Bay,
    post: f64,
    /// Metres of the top of the mattress's support.
    bed: f64,
    form: usize,
}

impl Cot {
    /// How many bars a length has room for, few enough for the triangles of a cot.
    fn bar_count(&self, length: f64) -> u32 {
        (length / BARS).round().clamp(4.0, 14.0) as u32
    }

    /// The space of one long side between the posts.
    fn side(&self, side: Side, thickness: f64) -> Bay {
        let outer = self.bay.inset(self.post * 0.2, 0.0, self.post - SINK);
        outer.slab(side, thickness)
    }

    /// A board that carries the mattress, the mattress, and a blanket turned down.
    fn bedding(&self, builder: &mut Builder, slot: Slot) {
        let inner = self.bay.inset(self.post * 0.8, 0.0, self.post * 0.9);
        let mattress = inner.with_y([self.bed, self.bed + MATTRESS]);
        builder.add(Slot::Mattress, rounded_box(mattress, DVec3::splat(0.025), 1));
        let blanket = mattress.slab(Side::Front, mattress.depth() * 0.6).inset(-0.003, 0.0, 0.0);
        let blanket =
            blanket.without(Side::Front, 0.002).with_y([mattress.high.y - 0.03, mattress.high.y + 0.02]);
        builder.add(slot, rounded_box(blanket, DVec3::new(0.02, 0.018, 0.02), 2));
        let pillow = Bay::around(
            DVec3::new(0.0, mattress.high.y + 0.016, mattress.low.z + 0.14),
            mattress.width() * 0.6,
            0.05,
            0.2,
        );
        builder.add(Slot::Linen, rounded_box(pillow, DVec3::new(0.05, 0.022, 0.05), 2));
    }

    /// Two rails with bars between them along a long side.
    fn fence(&self, builder: &mut Builder, slot: Slot, rail: Rail, bar: f64) {
        let field = self.side(rail.side, 0.022).with_y([self.bed - 0.06, rail.top]);
        builder.cuboid(slot, field.slab(Side::Above, 0.035));
        builder.cuboid(slot, field.slab(Side::Below, 0.035));
        let between = field.inset(0.0, 0.035 - SINK, 0.0);
        let count = self.bar_count(between.depth());
        for step in 0..count {
            let share = (f64::from(step) + 0.5) / f64::from(count);
            let z = between.low.z + share * between.depth();
            let at = DVec3::new(between.center().x, between.center().y, z);
            builder.cuboid(slot, Bay::around(at, bar, between.height(), bar));
        }
    }

    /// Bars along both ends.
    fn end_bars(&self, builder: &mut Builder, slot: Slot, top: f64, bar: f64) {
        let inner = self.bay.inset(self.post - SINK, 0.0, self.post * 0.3);
        for side in [Side::Front, Side::Back] {
            let field = inner.slab(side, 0.022).with_y([self.bed - 0.06, top]);
            builder.cuboid(slot, field.slab(Side::Above, 0.035));
            builder.cuboid(slot, field.slab(Side::Below, 0.035));
            let between = field.inset(0.0, 0.035 - SINK, 0.0);
            let count = self.bar_count(between.width());
            for column in between.columns(count, 0.0) {
                builder.cuboid(slot, Bay::around(column.center(), bar, between.height(), bar));
            }
        }
    }
}

/// A child's bed behind bars, or behind net.
pub(in super::super) static CRIB: Recipe =
    Recipe::furniture("crib", [0.7, 1.3, 1.0]).symbol(Symbol::Bed).every_set(crib);

fn crib(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let cot = Cot { bay, post: 0.04, bed: bay.height() * LYING - MATTRESS, form: draft.form() };
    match draft.set() {
        GeometrySet::Plain => plain(&cot, builder),
        GeometrySet::Traditional => traditional(&cot, builder),
        GeometrySet::Industrial => industrial(&cot, builder),
        GeometrySet::Budget => budget(&cot, builder),
    }
}

/// Straight posts, thin bars; ends of bars or of one board.
fn plain(cot: &Cot, builder: &mut Builder) {
    let slot = [Slot::WoodLight, Slot::Painted, Slot::Wood, Slot::Painted][cot.form];
    let posts = if cot.form == 1 { Slot::WoodLight } else { slot };
    legs_at_corners(
        builder,
        posts,
        cot.bay,
        cot.post,
        if cot.form == 2 { LegKind::Round } else { LegKind::Tapered },
    );
    let top = cot.bay.high.y - 0.02;
    for side in [Side::Left, Side::Right] {
        cot.fence(builder, slot, Rail { side, top }, 0.014);
    }
    if cot.form.is_multiple_of(2) {
        cot.end_bars(builder, slot, top, 0.014);
    } else {
        for side in [Side::Front, Side::Back] {
            let end = cot.bay.inset(cot.post - SINK, 0.0, cot.post * 0.3).slab(side, 0.02);
            builder.block(slot, end.with_y([cot.bed - 0.1, top]), 0.006);
        }
    }
    cot.bedding(builder, [Slot::FabricAccent, Slot::Fabric, Slot::FabricLight, Slot::FabricAccent][cot.form]);
}

/// Turned posts with knobs, an arched head and foot, turned bars.
fn traditional(cot: &Cot, builder: &mut Builder) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::Wood][cot.form];
    let bay = cot.bay;
    let knob = 0.05;
    let posts = bay.without(Side::Above, knob);
    legs_at_corners(builder, slot, posts, cot.post, LegKind::Square);
    for x in [bay.low.x + cot.post / 2.0, bay.high.x - cot.post / 2.0] {
        for z in [bay.low.z + cot.post / 2.0, bay.high.z - cot.post / 2.0] {
            let y = posts.high.y;
            let ball =
                [(0.01, y - SINK), (0.012, y + knob * 0.2), (0.021, y + knob * 0.6), (0.008, y + knob)];
            builder.add(slot, lathe(&ball, 8).moved(x, 0.0, z));
        }
    }
    let top = posts.high.y - 0.06;
    for side in [Side::Left, Side::Right] {
        cot.fence(builder, slot, Rail { side, top }, 0.017);
    }
    for side in [Side::Front, Side::Back] {
        let end = bay.inset(cot.post - SINK, 0.0, cot.post * 0.28).slab(side, 0.022);
        arch(builder, slot, end.with_y([cot.bed - 0.1, bay.high.y - 0.008]), cot.form);
    }
    cot.bedding(builder, [Slot::FabricLight, Slot::FabricAccent, Slot::FabricAccent, Slot::Fabric][cot.form]);
}

/// A board whose upper edge rises to its middle, or a bowed rail over bars.
fn arch(builder: &mut Builder, slot: Slot, bay: Bay, form: usize) {
    let half = bay.width() / 2.0;
    let (rise, steps) = (bay.height() * 0.16, 8);
    let upper = |step: i32, drop: f64| {
        let share = f64::from(step) / f64::from(steps);
        DVec2::new(half - share * 2.0 * half, bay.high.y - drop - rise * (1.0 - libm::sin(PI * share)))
    };
    let low = if form.is_multiple_of(2) { bay.low.y } else { bay.high.y - rise - 0.06 };
    let mut profile = vec![DVec2::new(-half, low), DVec2::new(half, low)];
    profile.extend((0..=steps).map(|step| upper(step, 0.0)));
    builder.add(slot, extrude(&profile, Axis::Z, bay.z()));
    if form % 2 == 1 {
        builder.cuboid(slot, bay.slab(Side::Below, 0.05));
        for column in bay.with_y([bay.low.y + 0.05 - SINK, low + SINK]).columns(6, 0.0) {
            builder.cuboid(slot, Bay::around(column.center(), 0.018, column.height(), 0.017));
        }
    }
}

/// A hospital's cot: bent steel tube, round bars, large castors, sides that slide down.
fn industrial(cot: &Cot, builder: &mut Builder) {
    let slot = [Slot::Metal, Slot::Painted, Slot::MetalDark, Slot::Chrome][cot.form];
    let (bay, tube) = (cot.bay, 0.014);
    let castor = 0.05;
    let (x, top) = (bay.high.x - tube, bay.high.y - tube);
    for end in [-1.0, 1.0] {
        let z = end * (bay.high.z - tube);
        let bow = [
            DVec3::new(-x, castor, z),
            DVec3::new(-x, top - 0.05, z),
            DVec3::new(-x + 0.05, top, z),
            DVec3::new(x - 0.05, top, z),
            DVec3::new(x, top - 0.05, z),
            DVec3::new(x, castor, z),
        ];
        builder.add(slot, sweep(&bow, tube, 6));
        let low = [DVec3::new(-x, cot.bed, z), DVec3::new(x, cot.bed, z)];
        builder.add(slot, sweep(&low, tube * 0.8, 6));
        for step in 0..6 {
            let at = x * (f64::from(step) / 3.5 - 5.0 / 7.0);
            let bar = Bay::new([at - 0.005, at + 0.005], [cot.bed, top], [z - 0.005, z + 0.005]);
            builder.cuboid(slot, bar);
        }
        for wheel_x in [-x, x] {
            let wheel = cylinder(castor * 0.9, [-0.012, 0.012], 8).turned_z(FRAC_PI_2);
            builder.add(Slot::Rubber, wheel.moved(wheel_x, castor * 0.9, z * 0.97));
        }
    }
    let inner = Cot { bay, post: 0.03, bed: cot.bed, form: cot.form };
    for side in [Side::Left, Side::Right] {
        inner.fence(builder, slot, Rail { side, top: top - 0.03 }, 0.01);
    }
    builder.cuboid(Slot::MetalDark, bay.inset(0.04, 0.0, 0.04).with_y([cot.bed - 0.02, cot.bed + 0.002]));
    inner
        .bedding(builder, [Slot::FabricLight, Slot::FabricAccent, Slot::Fabric, Slot::FabricLight][cot.form]);
}

/// A travelling cot with sides of net between padded rails, or one of laminated boards.
fn budget(cot: &Cot, builder: &mut Builder) {
    if cot.form % 2 == 1 {
        boards(cot, builder);
        return;
    }
    let (bay, radius) = (cot.bay, 0.022);
    let cloth = if cot.form == 0 { Slot::FabricAccent } else { Slot::PaintedAccent };
    let (x, z, top) = (bay.high.x - radius, bay.high.z - radius, bay.high.y - radius);
    for end in [-1.0, 1.0] {
        let post = [DVec3::new(x, 0.02, end * z), DVec3::new(x, bay.high.y - 0.01, end * z)];
        builder.add_pair(Slot::PlasticDark, sweep(&post, radius * 0.8, 6));
        let shoe = Bay::around(DVec3::new(x, 0.02, end * z), radius * 2.0, 0.04, radius * 2.0);
        builder.add_pair(Slot::PlasticDark, cuboid(shoe));
        let rail = [DVec3::new(-x, top, end * z), DVec3::new(x, top, end * z)];
        builder.add(cloth, sweep(&rail, radius, 6));
    }
    let rail = [DVec3::new(x, top - 0.0008, -z), DVec3::new(x, top - 0.0008, z)];
    builder.add_pair(cloth, sweep(&rail, radius * 0.98, 6));
    let low = cot.bed - 0.02;
    for side in [Side::Left, Side::Right] {
        let wall = bay.inset(radius - 0.004, 0.0, radius).slab(side, 0.008);
        builder.cuboid(Slot::FabricLight, wall.with_y([low + 0.1, top]));
        builder.cuboid(cloth, wall.inset(-0.001, 0.0, 0.001).with_y([low - 0.05, low + 0.101]));
    }
    for side in [Side::Front, Side::Back] {
        let wall = bay.inset(radius, 0.0, radius - 0.004).slab(side, 0.008);
        builder.cuboid(cloth, wall.with_y([low - 0.049, top - 0.002]));
    }
    builder.cuboid(Slot::PlasticDark, bay.inset(radius, 0.0, radius).with_y([low - 0.03, low + 0.03]));
    cot.bedding(builder, Slot::Fabric);
}

/// Ends of laminated board with rounded tops, bars of wood between rails.
fn boards(cot: &Cot, builder: &mut Builder) {
    let slot = if cot.form == 1 { Slot::Laminate } else { Slot::WoodLight };
    for side in [Side::Front, Side::Back] {
        let end = cot.bay.slab(side, 0.018);
        builder.block(slot, end.without(Side::Below, 0.05), 0.006);
        for foot in [Side::Left, Side::Right] {
            builder.cuboid(
                Slot::PlasticDark,
                end.slab(foot, 0.06).slab(Side::Below, 0.052).inset(0.006, 0.0, 0.001),
            );
        }
        let cut = end
            .inset(cot.bay.width() * 0.3, 0.0, -0.0008)
            .with_y([cot.bay.high.y - 0.12, cot.bay.high.y - 0.07]);
        builder.cuboid(Slot::PaintedAccent, cut);
    }
    let slim = Cot { bay: cot.bay, post: 0.018, bed: cot.bed, form: cot.form };
    for side in [Side::Left, Side::Right] {
        slim.fence(builder, Slot::Painted, Rail { side, top: cot.bay.high.y - 0.03 }, 0.012);
    }
    cot.bedding(builder, Slot::FabricAccent);
}
