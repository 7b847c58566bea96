//! Doors and drawers in the manner of each geometry set.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use super::handles::{HandleForm, HandleKind, handle};
use super::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, lathe, loft, loft_ring};
use crate::recipes::{Draft, GeometrySet, Slot};

/// Metres of a front's thickness: board of 16 to 19 mm.
const THICKNESS: f64 = 0.018;
/// Metres of the frame around a panel: 55 to 70 mm on doors of kitchens and wardrobes.
const STILE: f64 = 0.055;

/// How the doors and drawers of one piece look.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Fronts {
    set: GeometrySet,
    form: usize,
    /// Material of the fronts.
    pub(in super::super) front: Slot,
    /// Material of the handles.
    pub(in super::super) handle: Slot,
    /// Metres by which handles stand out; none without handles.
    pub(in super::super) reach: f64,
}

impl Fronts {
    /// Of the set and look that are asked for; some have no handles but a gap to reach into.
    pub(in super::super) fn new(draft: &Draft, front: Slot, handle: Slot, reach: f64) -> Self {
        let form = draft.form();
        let has_no_handles =
            matches!((draft.set(), form), (GeometrySet::Plain, 0) | (GeometrySet::Budget, 2));
        Self { set: draft.set(), form, front, handle, reach: if has_no_handles { 0.0 } else { reach } }
    }

    /// Depth that fronts and handles take from a box.
    pub(in super::super) fn depth(&self) -> f64 {
        self.reach + THICKNESS
    }

    /// The carcass behind the fronts, which sink into it; `bay` reaches to the tips of the handles.
    pub(in super::super) fn carcass(&self, builder: &mut Builder, slot: Slot, bay: Bay) {
        builder.cuboid(slot, bay.without(Side::Front, self.depth() - SINK));
    }

    /// A drawer front with its handle; `bay` reaches to the tip of the handle.
    pub(in super::super) fn drawer(&self, builder: &mut Builder, bay: Bay) {
        let bay =
            if self.reach > 0.0 { bay } else { bay.without(Side::Above, (bay.height() * 0.15).min(0.016)) };
        self.panel(builder, bay, false);
        let length = (bay.width() * 0.3).clamp(0.04, 0.25);
        let middle = DVec3::new(bay.center().x, bay.center().y, bay.high.z - self.reach);
        if self.set == GeometrySet::Plain && self.form == 3 {
            self.edge_pull(builder, bay, length);
            return;
        }
        if bay.width() > 0.6 && self.set != GeometrySet::Plain {
            for share in [-0.28, 0.28] {
                let at = middle + DVec3::X * share * bay.width();
                self.grip(builder, HandleForm { kind: self.kind(HandleKind::Level), length: 0.09 }, at, bay);
            }
        } else {
            self.grip(builder, HandleForm { kind: self.kind(HandleKind::Level), length }, middle, bay);
        }
    }

    /// A door with its handle on the side away from the hinge, at a share of its height.
    pub(in super::super) fn door(&self, builder: &mut Builder, bay: Bay, hinge: Side, rise: f64) {
        self.panel(builder, bay, true);
        let inwards = (bay.width() * 0.12).clamp(0.02, 0.045);
        let x = if hinge == Side::Left { bay.high.x - inwards } else { bay.low.x + inwards };
        let length = (bay.height() * [0.2, 0.2, 0.12, 0.3][self.form]).clamp(0.04, 0.4);
        let at = DVec3::new(x, bay.low.y + rise * bay.height(), bay.high.z - self.reach);
        self.grip(builder, HandleForm { kind: self.kind(HandleKind::Upright), length }, at, bay);
        if matches!(self.set, GeometrySet::Industrial | GeometrySet::Traditional) && self.form != 0 {
            self.hinges(builder, bay, hinge);
        }
    }

    fn kind(&self, bar: HandleKind) -> HandleKind {
        match (self.set, self.form) {
            (GeometrySet::Plain, 2) | (GeometrySet::Traditional, 0 | 2) | (GeometrySet::Budget, 0 | 3) => {
                HandleKind::Knob
            }
            _ => bar,
        }
    }

    fn grip(&self, builder: &mut Builder, form: HandleForm, at: DVec3, bay: Bay) {
        let fits = bay.width().min(bay.height()) > self.reach && bay.depth() > self.reach;
        if self.reach > SINK && fits {
            handle(builder, self.handle, form, at, self.reach);
        }
    }

    /// A thin angle over the upper edge of a drawer.
    fn edge_pull(&self, builder: &mut Builder, bay: Bay, length: f64) {
        let lip = bay.slab(Side::Front, self.reach + 0.004).slab(Side::Above, 0.02);
        let x = bay.center().x;
        let lip = lip.with_x([x - length * 0.5, x + length * 0.5]).moved(0.0, -0.004, 0.0);
        builder.block(self.handle, lip.slab(Side::Above, 0.006), 0.003);
    }

    /// Knuckles of two hinges on the edge of a door.
    fn hinges(&self, builder: &mut Builder, bay: Bay, hinge: Side) {
        if bay.height() < 0.3 || self.reach <= 0.0 {
            return;
        }
        let x = if hinge == Side::Left { bay.low.x + 0.006 } else { bay.high.x - 0.006 };
        for rise in [0.14, 0.86] {
            let y = bay.low.y + rise * bay.height();
            let pin = lathe(&[(0.006, y - 0.03), (0.006, y + 0.03)], 6);
            builder.add(self.handle, pin.moved(x, 0.0, bay.high.z - self.reach));
        }
    }

    /// A front without a handle.
    fn panel(&self, builder: &mut Builder, bay: Bay, is_door: bool) {
        let panel = bay.without(Side::Front, self.reach).slab(Side::Front, THICKNESS);
        if panel.width().min(panel.height()) < 0.08 {
            builder.cuboid(self.front, panel);
            return;
        }
        match self.set {
            GeometrySet::Plain => builder.block(self.front, panel, 0.003),
            GeometrySet::Traditional => self.framed(builder, panel, is_door),
            GeometrySet::Industrial => self.steel(builder, panel, is_door),
            GeometrySet::Budget => {
                // The edge strip of another colour shows around the face.
                builder.cuboid(Slot::WoodLight, panel.without(Side::Front, 0.003 - SINK));
                builder.cuboid(self.front, panel.slab(Side::Front, 0.003).inset(0.0015, 0.0015, 0.0));
            }
        }
    }

    /// A frame with a raised field in it; two fields over each other in tall doors.
    fn framed(&self, builder: &mut Builder, panel: Bay, is_door: bool) {
        let is_tall = is_door && panel.height() > panel.width() * 2.2 && self.form != 2;
        let parts = if is_tall { panel.rows(2, 0.0) } else { vec![panel] };
        let split = if is_tall { panel.height() * 0.12 } else { 0.0 };
        for (index, part) in parts.into_iter().enumerate() {
            let part = if index == 0 {
                part.without(Side::Above, split + 0.0006)
            } else {
                part.without(Side::Below, -split)
            };
            self.framed_field(builder, part);
        }
    }

    fn framed_field(&self, builder: &mut Builder, panel: Bay) {
        let half = panel.extent() / 2.0;
        let stile = STILE.min(half.x * 0.45).min(half.y * 0.45);
        let slope = stile * 0.2;
        let z = |share: f64| panel.low.z + share * panel.depth();
        let ring = [
            Slice::new(z(0.0), half.x, half.y),
            Slice::new(z(0.85), half.x, half.y),
            Slice::new(z(1.0), half.x - 0.003, half.y - 0.003),
            Slice::new(z(1.0), half.x - stile, half.y - stile),
            Slice::new(z(0.4), half.x - stile - slope, half.y - stile - slope),
            Slice::new(z(0.0), half.x - stile - slope, half.y - stile - slope),
        ];
        let middle = panel.center();
        let frame = turned_forward(loft_ring(&Outline::Square, &ring));
        builder.add(self.front, frame.moved(middle.x, middle.y, 0.0));
        let (x, y) = (half.x - stile - slope * 0.7, half.y - stile - slope * 0.7);
        let field = if self.form == 3 {
            vec![Slice::new(z(0.05), x, y), Slice::new(z(0.45), x, y)]
        } else {
            let bevel = (stile * 0.5).min(x * 0.5).min(y * 0.5);
            vec![
                Slice::new(z(0.05), x, y),
                Slice::new(z(0.42), x, y),
                Slice::new(z(0.85), x - bevel, y - bevel),
            ]
        };
        builder
            .add(self.front, turned_forward(loft(&Outline::Square, &field)).moved(middle.x, middle.y, 0.0));
    }

    /// Folded sheet with louvres, planks under straps, a grid of bars, or sheet with rivets.
    fn steel(&self, builder: &mut Builder, panel: Bay, is_door: bool) {
        match self.form {
            1 => self.planks(builder, panel, is_door),
            2 if is_door && panel.height() > 0.3 => self.bars(builder, panel),
            0 if is_door && panel.height() > 0.3 => self.louvres(builder, panel),
            _ => self.riveted(builder, panel),
        }
    }

    /// Sheet with rivets near its corners.
    fn riveted(&self, builder: &mut Builder, panel: Bay) {
        builder.block(self.front, panel, 0.003);
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let at = panel.center()
                + DVec3::new(x * (panel.width() / 2.0 - 0.018), y * (panel.height() / 2.0 - 0.018), 0.0);
            let rivet = lathe(&[(0.007, -0.003), (0.005, 0.003)], 6).turned_x(FRAC_PI_2);
            builder.add(Slot::MetalDark, rivet.moved(at.x, at.y, panel.high.z));
        }
    }

    /// Folded sheet with louvres near its top.
    fn louvres(&self, builder: &mut Builder, panel: Bay) {
        builder.block(self.front, panel, 0.003);
        let field = panel.inset(panel.width() * 0.22, 0.0, 0.0).without(Side::Above, panel.height() * 0.06);
        for slot in field.slab(Side::Above, panel.height() * 0.12).rows(4, panel.height() * 0.014) {
            builder.cuboid(Slot::MetalDark, slot.slab(Side::Front, 0.002).moved(0.0, 0.0, 0.0015));
        }
    }

    /// A frame with bars before a dark sheet.
    fn bars(&self, builder: &mut Builder, panel: Bay) {
        let half = panel.extent() / 2.0;
        let rim = 0.03_f64.min(half.x * 0.4);
        let middle = panel.center();
        let ring = [(0.0, 0.0), (1.0, 0.0), (1.0, rim), (0.0, rim)]
            .map(|(z, back)| Slice::new(panel.low.z + z * panel.depth(), half.x - back, half.y - back));
        builder.add(
            self.front,
            turned_forward(loft_ring(&Outline::Square, &ring)).moved(middle.x, middle.y, 0.0),
        );
        let inner = panel.inset(rim - SINK, rim - SINK, 0.006).without(Side::Back, 0.001);
        builder.cuboid(Slot::MetalDark, inner.slab(Side::Back, 0.004));
        for bar in inner.columns((inner.width() / 0.05).round().clamp(3.0, 9.0) as u32, 0.03) {
            builder.cuboid(
                Slot::Metal,
                Bay::around(bar.center() + DVec3::Z * 0.0015, 0.008, bar.height(), 0.0055),
            );
        }
    }

    /// Planks, on doors under straps.
    fn planks(&self, builder: &mut Builder, panel: Bay, is_door: bool) {
        builder.cuboid(self.front, panel.without(Side::Front, 0.006));
        let count = (panel.width() / 0.12).round().clamp(2.0, 6.0) as u32;
        for plank in panel.inset(0.001, 0.001, 0.0).slab(Side::Front, 0.007).columns(count, 0.003) {
            builder.cuboid(Slot::Wood, plank.without(Side::Front, 0.001));
        }
        if is_door && panel.height() > 0.3 {
            for y in [panel.low.y + panel.height() * 0.14, panel.high.y - panel.height() * 0.14] {
                let strap = panel.with_y([y - 0.02, y + 0.02]).slab(Side::Front, 0.004);
                builder.cuboid(Slot::MetalDark, strap.inset(0.004, 0.0, 0.0));
            }
        }
    }
}
