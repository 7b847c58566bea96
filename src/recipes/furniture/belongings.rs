//! Small things that people leave about.

use glam::{DVec2, DVec3};

use super::parts::turned_forward;
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, Solid, extrude, loft, loft_ring, pillow as soft_pillow,
};
use crate::recipes::{Draft, GeometrySet, Recipe};

/// A pillow: one with pointed corners, one with a flat hem, one with buttoned flat faces, or a plain thick one.
pub(super) static PILLOW: Recipe = Recipe::accessory("pillow", [0.5, 0.4, 0.14]).every_set(pillow);

fn pillow(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let (extent, middle) = (bay.extent(), bay.center());
    let slot = draft.sampler().pick(&["linen", "fabric_light", "fabric_accent"]);
    let put = |solid: Solid| solid.moved(middle.x, middle.y, middle.z);
    match draft.set() {
        GeometrySet::Plain => builder.add(slot, put(soft_pillow(extent.x, extent.y, extent.z))),
        GeometrySet::Traditional => {
            let hem = extent.x.min(extent.z) * 0.1;
            let thin = extent.y * 0.05;
            let slice = |y: f64, back: f64| Slice::new(y, extent.x / 2.0 - back, extent.z / 2.0 - back);
            let flat =
                [slice(-thin, thin), slice(-thin * 0.3, 0.0), slice(thin * 0.3, 0.0), slice(thin, thin)];
            builder.add(slot, put(loft(&Outline::Square, &flat)));
            builder.add(slot, put(soft_pillow(extent.x - hem, extent.y, extent.z - hem)));
        }
        GeometrySet::Industrial => {
            let radii = (extent * DVec3::new(0.06, 0.22, 0.06)).min(extent * 0.45);
            builder.rounded(slot, bay.inset(0.0, extent.y * 0.03, 0.0), radii, 1);
            let size = extent.x.min(extent.z) * 0.1;
            for x in [-0.2, 0.2] {
                let button = Bay::around(middle + DVec3::X * x * extent.x, size, extent.y, size);
                builder.cuboid("leather", button);
            }
        }
        GeometrySet::Budget => {
            let radii = (extent * DVec3::new(0.3, 0.45, 0.3)).min(extent * 0.45);
            builder.rounded(slot, bay, radii, 2);
        }
    }
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
    let bay = builder.bay();
    let holder = Holder::of(draft.set());
    let slot =
        if draft.is_traditional() { "brass" } else { draft.sampler().pick(&["wood", "metal", "painted"]) };
    let thick = (bay.depth() * holder.thick[0]).min(holder.thick[1]);
    let lean = libm::atan2(bay.depth() * 0.55, bay.height());
    let height = bay.height() / libm::cos(lean) - thick * libm::tan(lean);
    let half = DVec2::new(bay.width() / 2.0, height / 2.0);
    let border = half.min_element() * holder.border;
    let slice = |rise: f64, back: f64| Slice::new(thick * rise, half.x - back, half.y - back);
    // Upright on its lower edge, then leant back about it.
    let place = |solid: Solid| {
        let upright = turned_forward(solid).moved(0.0, half.y, -thick);
        upright.turned_x(-lean).moved(0.0, thick * libm::sin(lean), bay.high.z)
    };
    let board =
        |rises: [f64; 2], back: f64| place(loft(&Outline::Square, &rises.map(|rise| slice(rise, back))));
    let ring = |profile: &[(f64, f64)]| {
        let slices: Vec<Slice> = profile.iter().map(|&(rise, share)| slice(rise, border * share)).collect();
        place(loft_ring(&Outline::Square, &slices))
    };
    // Over the upper or lower edge, at a share of the half width.
    let clip = |sign: f64, share: f64| {
        let size = half.min_element() * 0.09;
        let slices = [-0.2, 1.0].map(|rise| {
            Slice::new(thick * rise, size, size * 0.8).at(half.x * share, sign * (half.y - size * 0.8 + SINK))
        });
        place(loft(&Outline::Square, &slices))
    };
    match draft.set() {
        GeometrySet::Traditional => {
            // The outer edge lies back, the moulding rises to a bead and falls to the picture.
            let profile = [
                (0.0, 0.0),
                (0.45, 0.0),
                (0.55, 0.3),
                (1.0, 0.42),
                (1.0, 0.62),
                (0.6, 0.74),
                (0.5, 1.0),
                (0.0, 1.0),
            ];
            builder.add(slot, ring(&profile));
        }
        GeometrySet::Plain | GeometrySet::Industrial => {
            builder.add(slot, ring(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]));
        }
        GeometrySet::Budget => builder.add(slot, board([0.0, 0.65], 0.0)),
    }
    // A sheet under the photograph, which lies a little higher.
    let mount = (border - SINK).max(half.min_element() * 0.02);
    builder.add("paper", board([holder.sunk * 0.4, holder.sunk + 0.1], mount));
    let photo = mount + half.min_element() * 0.12;
    builder.add("fabric_accent", board([holder.sunk, holder.sunk + 0.2], photo));
    if border == 0.0 {
        let ends = [(-1.0, -0.5), (-1.0, 0.5), (1.0, -0.5), (1.0, 0.5)];
        ends.into_iter().for_each(|(sign, share)| builder.add("metal", clip(sign, share)));
    }
    let top = bay.height() * 0.7;
    let at = bay.high.z - top * libm::tan(lean) - thick * 0.8;
    let strut = [(bay.low.z, 0.0), (bay.low.z + 0.006, 0.0), (at, top), (at - 0.004, top)].map(DVec2::from);
    let width = bay.width() * 0.12;
    builder.add(slot, extrude(&strut, Axis::X, [-width, width]));
}
