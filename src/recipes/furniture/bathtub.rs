//! Bathtubs.

use glam::DVec3;

use super::parts::{Tap, tap, wall_panel};
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, lathe, loft};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// The forms of a tub.
#[derive(Clone, Copy, PartialEq)]
enum Tub {
    /// Built in, with a panel below the rim.
    BuiltIn,
    /// One oval body on the floor.
    Oval,
    /// A rolled rim, standing on feet.
    OnFeet,
    /// Straight sides in a frame of steel.
    Framed,
}

fn tub_form(draft: &Draft) -> Tub {
    match (draft.set(), draft.input.look % 4) {
        (GeometrySet::Plain, 1 | 3) => Tub::Oval,
        (GeometrySet::Traditional, 0 | 1 | 3) => Tub::OnFeet,
        (GeometrySet::Industrial, 0 | 2) => Tub::Framed,
        (GeometrySet::Industrial, 1) => Tub::Oval,
        _ => Tub::BuiltIn,
    }
}

/// A bathtub: built in, oval, on feet or in a frame; the tap is at its left end, and the long side is whichever is
/// longer. Usual ones are 1.70 × 0.75 with a rim 0.45-0.55 over the floor (EN 232).
pub(super) static BATHTUB: Recipe =
    Recipe::furniture("bathtub", [1.7, 0.75, 0.7]).symbol(Symbol::Tub).every_set(bathtub);

fn bathtub(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = tub_form(draft);
    let tap_height = (bay.height() * 0.22).min(0.13);
    let rim = bay.high.y - tap_height;
    let border = 0.05_f64.min((bay.extent() / 2.0).min_element() * 0.3);
    let slot = match (draft.set(), draft.form()) {
        (GeometrySet::Industrial, 1) => Slot::Stone,
        (GeometrySet::Industrial, _) => Slot::Metal,
        _ => Slot::Ceramic,
    };
    builder.add(slot, loft(&Outline::Soft(4), &tub_slices(&form, bay, rim, border)));
    match form {
        Tub::OnFeet => feet(draft, builder, rim),
        Tub::Framed => frame(builder, rim),
        Tub::BuiltIn => panels(draft, builder, rim),
        Tub::Oval => {}
    }
    end_fittings(draft, builder, rim, tap_height, border);
}

/// A tub from below upwards outside, and down again inside.
fn tub_slices(form: &Tub, bay: Bay, rim: f64, border: f64) -> Vec<Slice> {
    let half = bay.extent() / 2.0;
    let corner = half.x.min(half.z) * if matches!(form, Tub::Oval | Tub::OnFeet) { 0.9 } else { 0.5 };
    let inside = [
        (1.0, border, corner - border),
        (0.93, border * 1.15, corner - border),
        (0.35, border * 2.0, corner - border * 1.5),
        (0.28, border * 3.0, corner - border * 2.5),
    ];
    let places = tub_outside(form, border, corner).into_iter().chain(inside);
    places
        .map(|(share, back, radius)| Slice::new(share * rim, half.x - back, half.z - back).softened(radius))
        .collect()
}

/// Share of the rim's height, metres in from the box, and the radius of the corners.
fn tub_outside(form: &Tub, border: f64, corner: f64) -> Vec<(f64, f64, f64)> {
    match form {
        Tub::OnFeet => vec![
            (0.2, border * 3.0, corner - border * 2.0),
            (0.26, border * 2.0, corner - border),
            (0.6, border * 0.9, corner),
            (0.91, border * 0.5, corner),
            (0.93, border * 0.08, corner),
            (0.965, 0.0, corner),
            (1.0, border * 0.2, corner),
        ],
        Tub::Oval => vec![
            (0.0, border * 1.8, corner - border),
            (0.04, border * 1.5, corner - border),
            (0.97, 0.0, corner),
            (1.0, 0.006, corner),
        ],
        Tub::Framed => vec![(0.2, 0.03, 0.05), (0.95, 0.012, 0.05), (0.951, 0.0, 0.05), (1.0, 0.0, 0.05)],
        Tub::BuiltIn => vec![(0.0, 0.03, 0.012), (0.93, 0.03, 0.012), (0.931, 0.0, 0.02), (1.0, 0.0, 0.02)],
    }
}

fn feet(draft: &Draft, builder: &mut Builder, rim: f64) {
    let half = builder.bay().extent() / 2.0;
    let slot = [Slot::Brass, Slot::Chrome, Slot::Brass, Slot::MetalDark][draft.form()];
    let claw =
        [(0.026, 0.0), (0.036, 0.02), (0.03, 0.045), (0.018, 0.06), (0.022, rim * 0.16), (0.04, rim * 0.23)];
    for x in [-1.0, 1.0] {
        for z in [-1.0, 1.0] {
            let foot = lathe(&claw.map(|(radius, y)| (radius, y.min(rim * 0.23))), 8);
            builder.add(slot, foot.moved(x * (half.x * 0.62), 0.0, z * (half.z * 0.52)));
        }
    }
}

fn frame(builder: &mut Builder, rim: f64) {
    let bay = builder.bay().inset(0.05, 0.0, 0.05);
    let thick = 0.035;
    super::parts::legs_at_corners(
        builder,
        Slot::MetalDark,
        bay.with_y([0.0, rim * 0.5]),
        thick,
        super::parts::LegKind::Square,
    );
    let y = [rim * 0.16, rim * 0.16 + thick];
    for side in [Side::Front, Side::Back] {
        builder.cuboid(
            Slot::MetalDark,
            bay.slab(side, thick * 0.9).inset(0.002, 0.0, 0.0).with_y(y).inset(0.0, 0.0, 0.001),
        );
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            Slot::MetalDark,
            bay.slab(side, thick * 0.9).inset(0.001, 0.0, 0.004).with_y([y[0] + 0.001, y[1] - 0.001]),
        );
    }
}

/// Panels under the rim of a tub that is built in, before and at the right.
fn panels(draft: &Draft, builder: &mut Builder, rim: f64) {
    let bay = builder.bay();
    let slot = match draft.set() {
        GeometrySet::Traditional => Slot::Painted,
        GeometrySet::Industrial => Slot::TileWall,
        GeometrySet::Budget => [Slot::Plastic, Slot::TileWall, Slot::Plastic, Slot::Laminate][draft.form()],
        GeometrySet::Plain => [Slot::Ceramic, Slot::Wood, Slot::TileWall, Slot::Wood][draft.form()],
    };
    let face = bay.with_y([rim * 0.04, rim * 0.925]).inset(0.035, 0.0, 0.0);
    let front = face.slab(Side::Front, 0.03 + SINK).without(Side::Front, 0.012);
    let count = match draft.set() {
        GeometrySet::Traditional => 3,
        GeometrySet::Budget => 2,
        _ => 1,
    };
    for column in front.columns(count, 0.006) {
        wall_panel(builder, draft.set(), slot, column);
    }
    let foot = bay.with_y([0.001, rim * 0.05]).inset(0.032, 0.0, 0.0).slab(Side::Front, 0.036);
    builder.cuboid(Slot::PlasticDark, foot.without(Side::Front, 0.024));
}

/// Tap, overflow and drain at the left end, or at the back of a deep tub.
fn end_fittings(draft: &Draft, builder: &mut Builder, rim: f64, tap_height: f64, border: f64) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let is_wide = bay.width() >= bay.depth();
    let (end, turn) =
        if is_wide { (DVec3::X * -half.x, std::f64::consts::FRAC_PI_2) } else { (DVec3::Z * -half.z, 0.0) };
    // Built with the end of the tub behind, its middle in front, and the rim at the origin.
    let mut parts = builder.empty();
    let foot = DVec3::new(0.0, 0.0, border * 0.5);
    tap(
        &mut parts,
        draft.set(),
        Tap { foot, height: tap_height, reach: (border * 2.6).max(0.09).min(half.min_element() * 0.5) },
    );
    let slot = if draft.is_traditional() { Slot::Brass } else { Slot::Chrome };
    let disc = |radius: f64| lathe(&[(radius, 0.0), (radius, 0.012), (radius * 0.7, 0.016)], 12);
    let overflow = disc(0.034).turned_x(std::f64::consts::FRAC_PI_2);
    parts.add(slot, overflow.moved(0.0, -rim * 0.25, border * 1.35));
    parts.add(slot, disc(0.035).moved(0.0, rim * (0.28 - 1.0) - 0.009, border * 3.0 + 0.12));
    for (slot, solid) in parts.into_parts() {
        builder.add(slot, solid.turned_y(turn).moved(end.x, rim, end.z));
    }
}
