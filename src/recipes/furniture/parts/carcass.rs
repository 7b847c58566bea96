//! Cabinets: fronts of doors and drawers before a carcass, and what crowns it.

use glam::DVec3;

use super::handles::{HandleForm, HandleKind, handle};
use super::turned_forward;
use crate::geometry::Side;
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, loft};

/// Metres between neighbouring doors and drawers.
pub(in super::super) const REVEAL: f64 = 0.004;
/// Metres of a front's thickness.
const THICKNESS: f64 = 0.018;
/// Metres between the edge of a traditional front and its raised field.
const FIELD_MARGIN: f64 = 0.045;
/// Metres of the slope around a raised field.
const FIELD_SLOPE: f64 = 0.015;

/// How the fronts of one piece of furniture look.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Fittings {
    /// Material of the fronts.
    pub(in super::super) front: Slot,
    /// Material of the handles.
    pub(in super::super) handle: Slot,
    /// Metres by which handles stand out.
    pub(in super::super) reach: f64,
    /// Raised fields and knobs.
    pub(in super::super) is_traditional: bool,
}

impl Fittings {
    /// Depth that fronts and handles take from a box.
    pub(in super::super) fn depth(&self) -> f64 {
        self.reach + THICKNESS
    }

    /// The carcass behind the fronts, which sink into it; `bay` reaches to the tips of the handles.
    pub(in super::super) fn carcass(&self, builder: &mut Builder, slot: Slot, bay: Bay) {
        builder.cuboid(slot, bay.without(Side::Front, self.depth() - SINK));
    }

    /// A drawer front with one handle; `bay` reaches to the tip of the handle.
    pub(in super::super) fn drawer(&self, builder: &mut Builder, bay: Bay) {
        self.panel(builder, bay);
        let kind = if self.is_traditional { HandleKind::Knob } else { HandleKind::Level };
        let length = (bay.width() * 0.3).clamp(0.04, 0.25);
        let middle = bay.center();
        self.handle(
            builder,
            HandleForm { kind, length },
            DVec3::new(middle.x, middle.y, bay.high.z - self.reach),
            bay,
        );
    }

    /// A door with its handle on the side away from the hinge, at a share of its height.
    pub(in super::super) fn door(&self, builder: &mut Builder, bay: Bay, hinge: Side, rise: f64) {
        self.panel(builder, bay);
        let kind = if self.is_traditional { HandleKind::Knob } else { HandleKind::Upright };
        let inwards = (bay.width() * 0.12).clamp(0.02, 0.05);
        let x = if hinge == Side::Left { bay.high.x - inwards } else { bay.low.x + inwards };
        let length = (bay.height() * 0.2).clamp(0.04, 0.3);
        let y = bay.low.y + rise * bay.height();
        self.handle(builder, HandleForm { kind, length }, DVec3::new(x, y, bay.high.z - self.reach), bay);
    }

    /// A front without a handle.
    pub(in super::super) fn panel(&self, builder: &mut Builder, bay: Bay) {
        let panel = bay.without(Side::Front, self.reach).slab(Side::Front, THICKNESS);
        let margin = FIELD_MARGIN.min(panel.width() * 0.2).min(panel.height() * 0.2);
        if !self.is_traditional || margin < FIELD_SLOPE {
            builder.cuboid(self.front, panel);
            return;
        }
        let ground = panel.without(Side::Front, THICKNESS / 3.0);
        builder.cuboid(self.front, ground);
        let half = panel.extent() / 2.0 - DVec3::new(margin, margin, 0.0);
        let slices = [
            Slice::new(ground.high.z - SINK, half.x, half.y),
            Slice::new(panel.high.z, half.x - FIELD_SLOPE, half.y - FIELD_SLOPE),
        ];
        let field = turned_forward(loft(&Outline::Square, &slices));
        let middle = panel.center();
        builder.add(self.front, field.moved(middle.x, middle.y, 0.0));
    }

    fn handle(&self, builder: &mut Builder, form: HandleForm, at: DVec3, bay: Bay) {
        let fits = bay.width().min(bay.height()) > self.reach && bay.depth() > self.reach;
        if self.reach > SINK && fits {
            handle(builder, self.handle, form, at, self.reach);
        }
    }
}

/// A moulding that crowns a piece: widens upwards from a body to the sides of `bay`, but not at the back, which
/// stands against a wall.
pub(in super::super) fn cornice(builder: &mut Builder, slot: Slot, bay: Bay, overhang: f64) {
    let (center, half) = (bay.center(), bay.extent() / 2.0);
    let slice = |share: f64, back: f64| {
        let slice = Slice::new(bay.low.y + share * bay.height(), half.x - back, half.z - back / 2.0);
        slice.at(center.x, center.z - back / 2.0)
    };
    let slices = [
        slice(0.0, overhang + 0.003),
        slice(0.2, overhang + 0.003),
        slice(0.45, overhang * 0.4),
        slice(0.7, overhang * 0.3),
        slice(0.8, 0.0),
        slice(1.0, 0.0),
    ];
    builder.add(slot, loft(&Outline::Square, &slices));
}
