//! Small things that people leave about.

use glam::{DVec2, DVec3};

use super::parts::turned_forward;
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, Solid, extrude, loft, loft_ring, pillow as soft_pillow,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A pillow: one with pointed corners, one with a flat hem, one with buttoned flat faces, or a plain thick one.
pub(super) static PILLOW: Recipe = Recipe::accessory("pillow", [0.5, 0.4, 0.14])
    .plain(pointed)
    .traditional(hemmed)
    .industrial(buttoned)
    .budget(stuffed);

/// The cloth of a pillow's look.
fn cloth(draft: &Draft) -> Slot {
    draft.sampler().pick(&[Slot::Linen, Slot::FabricLight, Slot::FabricAccent])
}

/// Two crowned faces that meet in pointed corners.
fn pointed(draft: &Draft, builder: &mut Builder) {
    let (extent, middle) = (builder.bay().extent(), builder.bay().center());
    let solid = soft_pillow(extent.x, extent.y, extent.z);
    builder.add(cloth(draft), solid.moved(middle.x, middle.y, middle.z));
}

/// A smaller pillow on a flat hem.
fn hemmed(draft: &Draft, builder: &mut Builder) {
    let (extent, middle, slot) = (builder.bay().extent(), builder.bay().center(), cloth(draft));
    let hem = extent.x.min(extent.z) * 0.1;
    let thin = extent.y * 0.05;
    let slice = |y: f64, back: f64| Slice::new(y, extent.x / 2.0 - back, extent.z / 2.0 - back);
    let flat = [slice(-thin, thin), slice(-thin * 0.3, 0.0), slice(thin * 0.3, 0.0), slice(thin, thin)];
    let inner = soft_pillow(extent.x - hem, extent.y, extent.z - hem);
    for solid in [loft(&Outline::Square, &flat), inner] {
        builder.add(slot, solid.moved(middle.x, middle.y, middle.z));
    }
}

/// Flat faces with two buttons of leather.
fn buttoned(draft: &Draft, builder: &mut Builder) {
    let (bay, slot) = (builder.bay(), cloth(draft));
    let extent = bay.extent();
    let radii = (extent * DVec3::new(0.06, 0.22, 0.06)).min(extent * 0.45);
    builder.rounded(slot, bay.inset(0.0, extent.y * 0.03, 0.0), radii, 1);
    let size = extent.x.min(extent.z) * 0.1;
    for x in [-0.2, 0.2] {
        let button = Bay::around(bay.center() + DVec3::X * x * extent.x, size, extent.y, size);
        builder.cuboid(Slot::Leather, button);
    }
}

/// A plain thick one.
fn stuffed(draft: &Draft, builder: &mut Builder) {
    let (bay, slot) = (builder.bay(), cloth(draft));
    let radii = (bay.extent() * DVec3::new(0.3, 0.45, 0.3)).min(bay.extent() * 0.45);
    builder.rounded(slot, bay, radii, 2);
}

/// What holds a photograph.
struct Holder {
    /// Share of the box's depth that it is thick, and metres of that at most.
    thick: [f64; 2],
    /// Share of half its smaller side that its border is wide.
    border: f64,
    /// Where the photograph begins within it, as a share of the thickness.
    sunk: f64,
}

impl Holder {
    fn of(set: GeometrySet) -> Self {
        match set {
            GeometrySet::Plain => Self { thick: [0.16, 0.012], border: 0.1, sunk: 0.5 },
            GeometrySet::Traditional => Self { thick: [0.28, 0.022], border: 0.3, sunk: 0.3 },
            GeometrySet::Industrial => Self { thick: [0.34, 0.03], border: 0.08, sunk: 0.1 },
            GeometrySet::Budget => Self { thick: [0.07, 0.005], border: 0.0, sunk: 0.6 },
        }
    }
}

/// A photograph that leans on its strut: in a thin frame, in a broad stepped one, deep in a box, or clipped to a board.
pub(super) static PICTURE_FRAME: Recipe =
    Recipe::accessory("picture_frame", [0.15, 0.08, 0.2]).every_set(picture_frame);

fn picture_frame(draft: &Draft, builder: &mut Builder) {
    let holder = Holder::of(draft.set());
    let slot = if draft.is_traditional() {
        Slot::Brass
    } else {
        draft.sampler().pick(&[Slot::Wood, Slot::Metal, Slot::Painted])
    };
    let leaning = Leaning::of(builder.bay(), &holder);
    match draft.set() {
        GeometrySet::Traditional => builder.add(slot, leaning.ring(&MOULDING)),
        GeometrySet::Plain | GeometrySet::Industrial => {
            builder.add(slot, leaning.ring(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]));
        }
        GeometrySet::Budget => builder.add(slot, leaning.board([0.0, 0.65], 0.0)),
    }
    leaning.photograph(builder, holder.sunk);
    if leaning.border == 0.0 {
        let ends = [(-1.0, -0.5), (-1.0, 0.5), (1.0, -0.5), (1.0, 0.5)];
        ends.into_iter().for_each(|(sign, share)| builder.add(Slot::Metal, leaning.clip(sign, share)));
    }
    builder.add(slot, leaning.strut());
}

/// A broad moulding: its outer edge lies back, it rises to a bead and falls to the picture.
const MOULDING: [(f64, f64); 8] =
    [(0.0, 0.0), (0.45, 0.0), (0.55, 0.3), (1.0, 0.42), (1.0, 0.62), (0.6, 0.74), (0.5, 1.0), (0.0, 1.0)];

/// A flat thing that leans back so that it fills a box with its strut.
struct Leaning {
    bay: Bay,
    thick: f64,
    /// Radians.
    lean: f64,
    half: DVec2,
    border: f64,
}

impl Leaning {
    fn of(bay: Bay, holder: &Holder) -> Self {
        let thick = (bay.depth() * holder.thick[0]).min(holder.thick[1]);
        let lean = libm::atan2(bay.depth() * 0.55, bay.height());
        let height = bay.height() / libm::cos(lean) - thick * libm::tan(lean);
        let half = DVec2::new(bay.width() / 2.0, height / 2.0);
        Self { bay, thick, lean, half, border: half.min_element() * holder.border }
    }

    /// A slice of the thing as it lies, at a share of its thickness.
    fn slice(&self, rise: f64, back: f64) -> Slice {
        Slice::new(self.thick * rise, self.half.x - back, self.half.y - back)
    }

    /// Upright on its lower edge, then leant back about it.
    fn place(&self, solid: Solid) -> Solid {
        let upright = turned_forward(solid).moved(0.0, self.half.y, -self.thick);
        upright.turned_x(-self.lean).moved(0.0, self.thick * libm::sin(self.lean), self.bay.high.z)
    }

    fn board(&self, rises: [f64; 2], back: f64) -> Solid {
        self.place(loft(&Outline::Square, &rises.map(|rise| self.slice(rise, back))))
    }

    /// A frame of a profile: shares of the thickness and of the border.
    fn ring(&self, profile: &[(f64, f64)]) -> Solid {
        let slices: Vec<Slice> =
            profile.iter().map(|&(rise, share)| self.slice(rise, self.border * share)).collect();
        self.place(loft_ring(&Outline::Square, &slices))
    }

    /// Over the upper or lower edge, at a share of the half width.
    fn clip(&self, sign: f64, share: f64) -> Solid {
        let size = self.half.min_element() * 0.09;
        let slices = [-0.2, 1.0].map(|rise| {
            Slice::new(self.thick * rise, size, size * 0.8)
                .at(self.half.x * share, sign * (self.half.y - size * 0.8 + SINK))
        });
        self.place(loft(&Outline::Square, &slices))
    }

    /// A sheet, and the photograph on it, which lies a little higher.
    fn photograph(&self, builder: &mut Builder, sunk: f64) {
        let mount = (self.border - SINK).max(self.half.min_element() * 0.02);
        builder.add(Slot::Paper, self.board([sunk * 0.4, sunk + 0.1], mount));
        let photo = mount + self.half.min_element() * 0.12;
        builder.add(Slot::FabricAccent, self.board([sunk, sunk + 0.2], photo));
    }

    fn strut(&self) -> Solid {
        let bay = self.bay;
        let top = bay.height() * 0.7;
        let at = bay.high.z - top * libm::tan(self.lean) - self.thick * 0.8;
        let side =
            [(bay.low.z, 0.0), (bay.low.z + 0.006, 0.0), (at, top), (at - 0.004, top)].map(DVec2::from);
        let width = bay.width() * 0.12;
        extrude(&side, Axis::X, [-width, width])
    }
}
