//! Couches for examination and massage: 0.60 to 0.75 m wide, 1.90 to 2.00 long, 0.5 to 0.85 high, the head end raised
//! (typical of makers).

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::{
    HandleForm, HandleKind, LegKind, handle, legs_at_corners, turned_forward,
};
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Bay, Builder, SINK, cylinder, lathe, rounded_box, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Share of the height at which the patient lies.
const LYING: f64 = 0.84;
/// Share of the length that the head end takes.
const HEAD: f64 = 0.3;

/// The measures that all couches share.
struct Couch {
    bay: Bay,
    /// Metres of the top of the flat part over the floor.
    lying: f64,
    /// Metres of the upholstery.
    pad: f64,
    form: usize,
}

impl Couch {
    /// Upholstery: a flat part, and a head end that is raised to the top of the box.
    fn pads(&self, builder: &mut Builder, slot: Slot, radius: f64) {
        let (bay, head) = (self.bay, self.head());
        let flat = bay.with_y([self.lying - self.pad, self.lying]).without(Side::Back, head);
        builder.add(slot, rounded_box(flat, DVec3::splat(radius), 2));
        let slope = libm::asin(((bay.high.y - self.lying) / head).clamp(0.0, 0.9));
        let rest = Bay::new(bay.x(), [-self.pad, 0.0], [-head, -0.012]);
        let rest = rounded_box(rest, DVec3::splat(radius), 2).turned_x(slope);
        builder.add(slot, rest.moved(0.0, self.lying, bay.low.z + head));
    }

    fn head(&self) -> f64 {
        self.bay.depth() * HEAD
    }

    /// Height of the underside of the upholstery.
    fn under(&self) -> f64 {
        self.lying - self.pad
    }

    /// A frame under the upholstery.
    fn frame(&self, builder: &mut Builder, slot: Slot, height: f64) -> Bay {
        let frame = self.bay.with_y([self.under() - height, self.under() + SINK]).inset(0.05, 0.0, 0.06);
        builder.cuboid(slot, frame);
        frame
    }

    /// A roll of paper under the head end.
    fn roll(&self, builder: &mut Builder) {
        let radius = 0.045;
        let width = self.bay.width() * 0.7;
        let roll = turned_forward(cylinder(radius, [0.0, width], 10)).turned_y(FRAC_PI_2);
        let at = DVec3::new(-width / 2.0, self.under() - radius - 0.004, self.bay.low.z + radius + 0.002);
        builder.add(Slot::Paper, roll.moved(at.x, at.y, at.z));
        for side in [-1.0, 1.0] {
            let holder =
                Bay::around(at + DVec3::X * (width * (0.5 + 0.5 * side) + side * 0.003), 0.008, 0.05, 0.05);
            builder.cuboid(Slot::MetalDark, holder.without(Side::Above, -0.06));
        }
    }
}

/// A couch with its head raised: on columns, on turned legs, on steel tube with wheels, or folding.
pub(in super::super) static TREATMENT_BED: Recipe =
    Recipe::furniture("treatment_bed", [0.7, 1.95, 0.85]).symbol(Symbol::Bed).every_set(treatment_bed);

fn treatment_bed(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let couch =
        Couch { bay, lying: bay.height() * LYING, pad: (bay.height() * 0.11).min(0.09), form: draft.form() };
    match draft.set() {
        GeometrySet::Plain => plain(&couch, builder),
        GeometrySet::Traditional => traditional(&couch, builder),
        GeometrySet::Industrial => industrial(&couch, builder),
        GeometrySet::Budget => budget(&couch, builder),
    }
}

/// Columns or a scissor lift on a base with castors, or a chest of drawers.
fn plain(couch: &Couch, builder: &mut Builder) {
    couch.pads(
        builder,
        [Slot::Leather, Slot::FabricAccent, Slot::PlasticDark, Slot::PaintedAccent][couch.form],
        0.025,
    );
    couch.roll(builder);
    let frame = couch.frame(builder, Slot::Painted, 0.04);
    if couch.form == 2 {
        chest(builder, frame);
        return;
    }
    let base = frame.with_y([0.07, 0.12]).inset(0.03, 0.0, 0.12);
    builder.block(Slot::Painted, base, 0.012);
    for x in [base.low.x + 0.02, base.high.x - 0.02] {
        for z in [base.low.z + 0.05, base.high.z - 0.05] {
            let castor = cylinder(0.04, [-0.014, 0.014], 10).turned_z(FRAC_PI_2);
            builder.add(Slot::Rubber, castor.moved(x, 0.04, z));
        }
    }
    let lift = [base.high.y - SINK, frame.low.y + SINK];
    if couch.form == 1 {
        let (low, high) = (base.low.z + 0.1, base.high.z - 0.1);
        for (x, from, to) in [(base.high.x - 0.06, low, high), (base.high.x - 0.11, high, low)] {
            let arm = [DVec3::new(x, lift[0], from), DVec3::new(x, lift[1], to)];
            builder.add_pair(Slot::MetalDark, sweep(&arm, 0.024, 4));
        }
    } else {
        let spots: &[f64] = if couch.form == 0 { &[-0.5, 0.5] } else { &[0.0] };
        for share in spots {
            let z = share * base.depth() * 0.7;
            let half = if couch.form == 0 { 0.07 } else { 0.13 };
            let post = Bay::new([-half, half], lift, [z - half, z + half]);
            builder.block(Slot::Metal, post.with_y([lift[0], lift[1] * 0.62]), 0.01);
            builder.cuboid(Slot::MetalDark, post.inset(0.015, 0.0, 0.015));
        }
    }
}

/// Drawers on one side under the couch, doors beside them.
fn chest(builder: &mut Builder, frame: Bay) {
    let plinth = frame.with_y([0.0, 0.09]).inset(0.03, 0.0, 0.03);
    builder.cuboid(Slot::MetalDark, plinth);
    let body = frame.with_y([0.089, frame.low.y + SINK]).inset(0.008, 0.0, 0.004);
    builder.cuboid(Slot::Painted, body);
    let side = body.slab(Side::Right, 0.004).moved(0.008, 0.0, 0.0);
    let columns = depth_slats(side.inset(0.0, 0.01, 0.01), 3, 0.008);
    for (index, column) in columns.into_iter().enumerate() {
        let rows = if index == 1 { column.rows(1, 0.0) } else { column.rows(3, 0.008) };
        for front in rows {
            builder.cuboid(Slot::Laminate, front.slab(Side::Right, 0.012));
            let grip =
                Bay::around(front.center().with_x(front.high.x + 0.007), 0.016, 0.012, front.depth() * 0.4);
            builder.cuboid(Slot::Metal, grip);
        }
    }
}

/// A couch of wood on turned legs with a shelf, nailed leather, a bolster.
fn traditional(couch: &Couch, builder: &mut Builder) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::WoodDark, Slot::Wood][couch.form];
    couch.pads(builder, if couch.form == 3 { Slot::FabricAccent } else { Slot::Leather }, 0.03);
    let frame = couch.frame(builder, slot, 0.09);
    let legs = frame.with_y([0.0, frame.low.y + SINK]).inset(0.002, 0.0, 0.002);
    let kind = [LegKind::Turned, LegKind::Baluster, LegKind::Spade, LegKind::Turned][couch.form];
    legs_at_corners(builder, slot, legs, 0.075, kind);
    if couch.form.is_multiple_of(2) {
        let shelf = legs.inset(0.012, 0.0, 0.012).with_y([0.16, 0.185]);
        builder.block(slot, shelf, 0.006);
    }
    // Drawers with knobs on the right.
    let side = frame.slab(Side::Right, 0.004).moved(0.008, 0.0, 0.0).inset(0.0, 0.012, 0.06);
    for front in depth_slats(side, 3, 0.03) {
        builder.cuboid(slot, front.slab(Side::Right, 0.012));
        let knob = lathe(&[(0.006, 0.0), (0.013, 0.014), (0.009, 0.02)], 8).turned_z(-FRAC_PI_2);
        let at = front.center();
        builder.add(Slot::Brass, knob.moved(front.high.x - SINK, at.y, at.z));
    }
    // A bolster for the neck.
    let radius = 0.05;
    let neck = turned_forward(cylinder(radius, [0.0, couch.bay.width() * 0.86], 12)).turned_y(FRAC_PI_2);
    let z = couch.bay.low.z + couch.head() * 0.34;
    let y = couch.lying + (couch.bay.high.y - couch.lying) * 0.66 - radius * 0.3;
    builder.add(Slot::Linen, neck.moved(-couch.bay.width() * 0.43, y.min(couch.bay.high.y - radius), z));
}

/// Steel tube on wheels with a rail around, a prop under the head end, a step that folds out.
fn industrial(couch: &Couch, builder: &mut Builder) {
    let tube = [Slot::Chrome, Slot::MetalDark, Slot::Metal, Slot::Chrome][couch.form];
    couch.pads(
        builder,
        [Slot::Leather, Slot::Leather, Slot::PlasticDark, Slot::FabricAccent][couch.form],
        0.02,
    );
    let frame = couch.frame(builder, Slot::MetalDark, 0.02);
    let radius = 0.016;
    let (x, high) = (frame.high.x - radius, frame.low.y - 0.002);
    let wheel: f64 = if couch.form.is_multiple_of(2) { 0.06 } else { 0.0 };
    for z in [frame.low.z + 0.14, frame.high.z - 0.14] {
        let bow = [
            DVec3::new(-x, wheel.max(0.01), z),
            DVec3::new(-x, high, z),
            DVec3::new(x, high, z),
            DVec3::new(x, wheel.max(0.01), z),
        ];
        builder.add(tube, sweep(&bow, radius, 6));
        for x in [-x, x] {
            let foot = if wheel > 0.0 {
                cylinder(wheel * 0.58, [-0.014, 0.014], 10).turned_z(FRAC_PI_2).moved(x, wheel * 0.58, z)
            } else {
                cylinder(radius * 1.3, [0.0, 0.03], 8).moved(x, 0.0, z)
            };
            builder.add(Slot::Rubber, foot);
        }
    }
    let low = couch.bay.height() * 0.26;
    let side = [DVec3::new(x, low, frame.low.z + 0.14), DVec3::new(x, low, frame.high.z - 0.14)];
    builder.add_pair(tube, sweep(&side, radius * 0.8, 6));
    if couch.form % 2 == 1 {
        let deck = frame.inset(0.03, 0.0, 0.15).with_y([low - 0.006, low + 0.012]);
        builder.cuboid(Slot::Metal, deck);
    }
    let prop_z = couch.bay.low.z + couch.head() * 0.4;
    let prop = [
        DVec3::new(x * 0.7, high, couch.bay.low.z + couch.head() * 1.1),
        DVec3::new(x * 0.7, couch.under() + (couch.bay.high.y - couch.lying) * 0.5, prop_z),
    ];
    builder.add_pair(tube, sweep(&prop, radius * 0.6, 5));
    couch.roll(builder);
}

/// A folding table for massage: thin pads, legs with stays, cables below.
fn budget(couch: &Couch, builder: &mut Builder) {
    let slot = [Slot::PlasticDark, Slot::PaintedAccent, Slot::Leather, Slot::Fabric][couch.form];
    let wood = [Slot::WoodLight, Slot::Metal, Slot::WoodLight, Slot::Metal][couch.form];
    couch.pads(builder, slot, 0.014);
    let frame = couch.frame(builder, wood, 0.05);
    let seam = Bay::around(
        DVec3::new(0.0, couch.lying - couch.pad * 0.5, frame.center().z),
        couch.bay.width() - 0.004,
        couch.pad + 0.002,
        0.008,
    );
    builder.cuboid(Slot::Rubber, seam);
    let (x, high) = (frame.high.x - 0.03, frame.low.y + 0.02);
    let reach = frame.depth() / 2.0 - 0.05;
    for end in [-1.0, 1.0] {
        let middle = frame.center().z;
        let leg = [
            DVec3::new(x, 0.0, middle + end * reach),
            DVec3::new(x * 0.94, high, middle + end * reach * 0.84),
        ];
        builder.add_pair(wood, sweep(&leg, 0.02, 4));
        let stay = [
            DVec3::new(x * 0.95, high, middle + end * reach * 0.24),
            DVec3::new(x * 0.99, high * 0.42, middle + end * reach * 0.93),
        ];
        builder.add_pair(wood, sweep(&stay, 0.013, 4));
        let y = high * 0.42;
        let bar = Bay::around(DVec3::new(0.0, y, middle + end * reach * 0.93), x * 2.0, 0.05, 0.02);
        builder.cuboid(wood, bar);
        let cable = [DVec3::new(x * 0.9, y, middle + end * reach * 0.92), DVec3::new(x * 0.9, high, middle)];
        builder.add_pair(Slot::MetalDark, sweep(&cable, 0.003, 4));
    }
    handle(
        builder,
        Slot::PlasticDark,
        HandleForm { kind: HandleKind::Level, length: 0.14 },
        DVec3::new(0.0, frame.center().y, frame.high.z),
        0.03,
    );
}
