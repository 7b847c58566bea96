//! Beds. Mattresses are 0.9 to 1.8 m wide and 2 m long, lying is 0.45 to 0.55 m high (EN 1334, typical).

mod bedding;
mod budget;
mod bunk;
mod crib;
mod hospital;
mod industrial;
mod plain;
mod traditional;
mod treatment;

pub(super) use bunk::BUNK_BED;
pub(super) use crib::CRIB;
pub(super) use hospital::HOSPITAL_BED;
pub(super) use treatment::TREATMENT_BED;

use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, SINK};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a bed's headboard; the shapes in the catalogue are cut for it.
const HEADBOARD: f64 = 0.06;
/// Metres of the top of the bedding over the floor.
const LYING_HEIGHT: f64 = 0.55;
/// The same as a share of the height, where the bed is low.
const LYING_SHARE: f64 = 0.6;
/// Width in metres from which a bed has two pillows.
const DOUBLE_FROM: f64 = 1.3;

/// A bed: frame and headboard of the set, mattress, blanket and pillows; `double` asks for two pillows.
pub(super) static BED: Recipe =
    Recipe::furniture("bed", [1.6, 2.1, 1.0]).with(&[("double", 0.0)]).symbol(Symbol::Bed).every_set(bed);

fn bed(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.input.look % 4;
    let lying = LYING_HEIGHT.min(bay.height() * LYING_SHARE);
    let bed = Bed { bay, head: bay.slab(Side::Back, HEADBOARD), lying, frame: lying * 0.55, form };
    match draft.set() {
        GeometrySet::Plain => plain::frame(&bed, builder),
        GeometrySet::Traditional => traditional::frame(&bed, builder),
        GeometrySet::Industrial => industrial::frame(&bed, builder),
        GeometrySet::Budget => budget::frame(&bed, builder),
    }
    let is_double = draft.is_set("double") || bay.width() >= DOUBLE_FROM;
    bedding::make(&bed, builder, &mut draft.sampler(), if is_double { 2 } else { 1 });
}

/// The measures that all beds share.
struct Bed {
    bay: Bay,
    /// Where the headboard stands.
    head: Bay,
    /// Metres of the top of the bedding over the floor.
    lying: f64,
    /// Metres of the top of the frame.
    frame: f64,
    form: u32,
}

impl Bed {
    /// The space before the headboard.
    fn body(&self) -> Bay {
        self.bay.without(Side::Back, HEADBOARD - SINK)
    }

    /// Four rails around the slats, of a height and a thickness, under the top of the frame.
    fn rails(&self, builder: &mut Builder, slot: Slot, height: f64, thickness: f64) {
        let ring = self.body().with_y([self.frame - height, self.frame]).inset(0.014, 0.0, 0.0);
        let ring = ring.without(Side::Front, 0.016);
        for side in [Side::Left, Side::Right] {
            builder.block(slot, ring.slab(side, thickness).without(Side::Front, thickness - SINK), 0.004);
        }
        builder.block(slot, ring.slab(Side::Front, thickness).inset(0.001, 0.0005, 0.0), 0.004);
        let slats = ring.inset(thickness - SINK, 0.0, 0.0).without(Side::Front, thickness - 3.0 * SINK);
        builder.cuboid(slot, slats.slab(Side::Above, 0.03).moved(0.0, -0.01, 0.0));
    }
}
