//! Small things that people leave about.

use glam::{DVec2, DVec3};

use super::input::Draft;
use super::parts::turned_forward;
use crate::model::kit::{Axis, Builder, Outline, SINK, Slice, extrude, loft, loft_ring, rounded_box};

/// A pillow, thick in the middle.
pub(super) fn pillow(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let extent = bay.extent();
    let slot = draft.sampler().pick(&["linen", "fabric_light", "fabric_accent"]);
    let thin = extent.min_element();
    let radii = DVec3::splat(extent.max_element() * 0.22).min(extent * 0.45).max(DVec3::splat(thin * 0.45));
    builder.add(slot, rounded_box(bay, radii, 3));
}

/// A photograph in a frame that leans on its strut.
pub(super) fn picture_frame(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot =
        if draft.is_traditional() { "brass" } else { draft.sampler().pick(&["wood", "metal", "painted"]) };
    let thick = (bay.depth() * 0.16).min(0.012);
    let lean = libm::atan2(bay.depth() * 0.55, bay.height());
    let height = bay.height() / libm::cos(lean) - thick * libm::tan(lean);
    let (half_width, half_height) = (bay.width() / 2.0, height / 2.0);
    let border = half_width.min(half_height) * 0.16;
    let slice = |z: f64, back: f64| Slice::new(z, half_width - back, half_height - back);
    let ring = [slice(0.0, 0.0), slice(thick, 0.0), slice(thick, border), slice(0.0, border)];
    // Upright on its lower edge, then leant back about it.
    let place = |solid: crate::model::kit::Solid| {
        let upright = turned_forward(solid).moved(0.0, half_height, -thick);
        upright.turned_x(-lean).moved(0.0, thick * libm::sin(lean), bay.high.z)
    };
    builder.add(slot, place(loft_ring(&Outline::Square, &ring)));
    builder.add(
        "paper",
        place(loft(
            &Outline::Square,
            &[slice(thick * 0.2, border - SINK), slice(thick * 0.6, border - SINK)],
        )),
    );
    let photo = border + half_width * 0.12;
    builder.add(
        "fabric_accent",
        place(loft(&Outline::Square, &[slice(thick * 0.5, photo), slice(thick * 0.7, photo)])),
    );
    let top = bay.height() * 0.7;
    let at = bay.high.z - top * libm::tan(lean) - thick * 0.8;
    let strut = [(bay.low.z, 0.0), (bay.low.z + 0.006, 0.0), (at, top), (at - 0.004, top)].map(DVec2::from);
    let width = bay.width() * 0.12;
    builder.add(slot, extrude(&strut, Axis::X, [-width, width]));
}
