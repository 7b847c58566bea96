//! Small things that people leave about.

use glam::{DVec2, DVec3};

use super::input::Draft;
use super::parts::turned_forward;
use crate::catalog::Side;
use crate::model::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, cylinder, extrude, lathe, loft, loft_ring, rounded_box,
};

/// A pillow, thick in the middle.
pub(super) fn pillow(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let extent = bay.extent();
    let slot = draft.sampler().pick(&["linen", "fabric_light", "fabric_accent"]);
    let thin = extent.min_element();
    let radii = DVec3::splat(extent.max_element() * 0.22).min(extent * 0.45).max(DVec3::splat(thin * 0.45));
    builder.add(slot, rounded_box(bay, radii, 3));
}

/// A toy: building bricks, a car, or rings on a stick.
pub(super) fn toy(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    match draft.sampler().count(0, 2) {
        0 => bricks(builder, bay),
        1 => car(builder, bay),
        _ => rings(builder, bay),
    }
}

const TOY_COLORS: [&str; 4] = ["fabric_accent", "painted_accent", "leaf", "book"];

fn bricks(builder: &mut Builder, bay: Bay) {
    let lower = bay.slab(Side::Below, bay.height() * 0.36);
    for (index, column) in lower.columns(2, bay.width() * 0.08).into_iter().enumerate() {
        builder.block(TOY_COLORS[index], column, 0.004);
    }
    let middle = bay.with_y([lower.high.y - SINK, bay.height() * 0.7]).inset(
        bay.width() * 0.2,
        0.0,
        bay.depth() * 0.12,
    );
    builder.block(TOY_COLORS[2], middle, 0.004);
    let top =
        bay.with_y([bay.height() * 0.7 - SINK, bay.high.y]).inset(bay.width() * 0.28, 0.0, bay.depth() * 0.3);
    let roof = [(top.low.x, top.low.y), (top.high.x, top.low.y), (0.0, top.high.y)].map(DVec2::from);
    builder.add(TOY_COLORS[3], extrude(&roof, Axis::Z, top.z()));
}

fn car(builder: &mut Builder, bay: Bay) {
    let wheel = (bay.height() * 0.2).min(bay.width() * 0.18);
    let body = bay.with_y([wheel * 0.7, bay.height() * 0.6]).inset(0.0, 0.0, bay.depth() * 0.06);
    builder.block(TOY_COLORS[0], body, bay.height() * 0.06);
    let cabin = body.with_y([bay.height() * 0.6 - SINK, bay.high.y]).inset(
        bay.width() * 0.22,
        0.0,
        bay.depth() * 0.04,
    );
    builder.block("glass", cabin.without(Side::Above, cabin.height() * 0.2), bay.height() * 0.04);
    builder.block(TOY_COLORS[0], cabin.slab(Side::Above, cabin.height() * 0.2 + SINK), bay.height() * 0.03);
    for x in [-0.3, 0.3] {
        for (z, out) in [(bay.low.z, 0.0), (bay.high.z - bay.depth() * 0.16, 0.0)] {
            let disc = turned_forward(cylinder(wheel, [0.0, bay.depth() * 0.16], 10));
            builder.add("rubber", disc.moved(x * bay.width(), wheel, z + out));
        }
    }
}

fn rings(builder: &mut Builder, bay: Bay) {
    let half = bay.extent() / 2.0;
    builder.add(
        "wood_light",
        loft(
            &Outline::Round(12),
            &[Slice::new(0.0, half.x, half.z), Slice::new(bay.height() * 0.1, half.x, half.z)],
        ),
    );
    for (index, row) in
        bay.with_y([bay.height() * 0.1 - SINK, bay.height() * 0.88]).rows(4, -SINK).into_iter().enumerate()
    {
        let shrink = 0.92 - 0.17 * index as f64;
        let slices = [(0.0, 0.88), (0.5, 1.0), (1.0, 0.88)];
        let slices = slices.map(|(share, bulge)| {
            Slice::new(row.low.y + share * row.height(), half.x * shrink * bulge, half.z * shrink * bulge)
        });
        builder.add(TOY_COLORS[index], loft(&Outline::Round(8), &slices));
    }
    let knob = half.x * 0.22;
    builder.add(
        "wood_light",
        lathe(
            &[(knob * 0.6, bay.height() * 0.87), (knob, bay.height() * 0.94), (knob * 0.5, bay.height())],
            8,
        ),
    );
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
