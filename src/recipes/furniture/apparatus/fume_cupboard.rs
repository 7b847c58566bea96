//! Fume cupboards: 1.2 to 1.5 m wide, 0.8 deep, benches 0.9 high, 2.2 to 2.7 m over all (EN 14175).

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::{Fittings, HandleForm, HandleKind, handle, turned_forward};
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, lathe, loft};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Share of the height at which one works.
const BENCH: f64 = 0.4;
/// Metres of the stone top.
const TOP: f64 = 0.03;
/// Metres of the plinth under the cupboards.
const PLINTH: f64 = 0.08;
/// Metres of a hollow wall beside the chamber.
const SIDE_WALL: f64 = 0.09;
/// Metres of the chamber's back.
const BACK_WALL: f64 = 0.03;
/// Metres of the duct over the chamber.
const HEAD: f64 = 0.12;
/// Metres of the hood that hangs from the duct.
const HOOD: f64 = 0.32;

/// A fume cupboard: a bench under a chamber with a sliding pane, a duct and service valves. Plain ones stand on cupboards;
/// traditional ones are joiner's work with a sash window; industrial ones are a steel frame under a hood with a pipe; cheap
/// ones stand on panels and have panes that slide sideways.
pub(in super::super) static FUME_CUPBOARD: Recipe =
    Recipe::furniture("fume_cupboard", [1.5, 0.8, 2.2]).every_set(fume_cupboard);

fn fume_cupboard(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let slot = [Slot::Painted, Slot::Metal, Slot::Laminate, Slot::Painted][look];
    let bench = bay.height() * BENCH;
    let front = [Slot::PaintedAccent, Slot::Laminate, Slot::Painted, Slot::Metal][look];
    match draft.set() {
        GeometrySet::Industrial => frame(builder, bench),
        GeometrySet::Budget => panels(builder, slot, front, bench),
        GeometrySet::Plain | GeometrySet::Traditional => {
            cupboards(builder, slot, front, bench, draft.is_traditional());
        }
    }
    builder.block(Slot::Stone, bay.with_y([bench - TOP - SINK, bench]), 0.004);
    let upper = bay.with_y([bench - SINK, bay.high.y]).inset(0.001, 0.0, 0.001).without(Side::Front, 0.05);
    working_space(draft, builder, slot, upper, bench);
    valves(builder, bay.width(), bench, upper.high.z);
    for (x, tall) in [(-0.2, 0.16), (-0.1, 0.22), (0.18, 0.12)] {
        let glass =
            [(0.05, bench - SINK), (0.055, bench + 0.02), (0.016, bench + tall * 0.6), (0.016, bench + tall)];
        builder.add(Slot::Glass, lathe(&glass, 10).moved(x * bay.width(), 0.0, 0.0));
    }
}

/// What stands on the bench: a hood over a pane, or a chamber behind panes.
fn working_space(draft: &Draft, builder: &mut Builder, slot: Slot, upper: Bay, bench: f64) {
    let look = draft.form();
    // Panes that are lifted stand half open in their frame.
    let open = |low: f64| bench + (low - bench) * (0.25 + 0.12 * look as f64);
    match draft.set() {
        GeometrySet::Industrial => {
            let low = smoke_hood(builder, upper);
            pane(builder, upper, [open(low), low - 0.004]);
        }
        GeometrySet::Budget => {
            let hood = chamber(builder, slot, upper, HOOD * 0.5);
            vents(builder, upper);
            side_panes(builder, upper, [bench + 0.004, hood.high.y - 0.03], look);
        }
        GeometrySet::Plain | GeometrySet::Traditional => {
            let hood = chamber(builder, slot, upper, HOOD);
            let sash = pane(builder, upper, [open(hood.low.y), hood.high.y - 0.06]);
            if draft.is_traditional() {
                cornice(builder, slot, upper);
                glazing_bars(builder, slot, sash);
            } else {
                builder.block(Slot::Metal, upper.slab(Side::Above, HEAD + SINK), 0.006);
            }
        }
    }
}

/// A frame of square tubes with a shelf, on which two bottles of gas stand.
fn frame(builder: &mut Builder, bench: f64) {
    let bay = builder.bay().with_y([0.0, bench - TOP]).inset(0.01, 0.0, 0.01);
    let tube = 0.045;
    for x in [Side::Left, Side::Right] {
        for z in [Side::Front, Side::Back] {
            builder.cuboid(Slot::MetalDark, bay.slab(x, tube).slab(z, tube));
        }
    }
    let rails = bay.inset(0.002, 0.0, 0.002);
    for z in [Side::Front, Side::Back] {
        let rail = rails.slab(z, tube - 0.004).inset(tube - 0.002 - SINK, 0.0, 0.0);
        builder.cuboid(Slot::MetalDark, rail.with_y([bay.high.y - tube, bay.high.y - 0.002]));
    }
    let shelf = bench * 0.22;
    builder.cuboid(Slot::Metal, rails.inset(0.004, 0.0, 0.004).with_y([shelf - 0.02, shelf]));
    let (radius, tall) = (0.09, (bench - TOP - shelf) * 0.86);
    for (x, slot) in [(-0.3, Slot::PaintedAccent), (-0.14, Slot::Metal)] {
        let bottle = [
            (radius, shelf - SINK),
            (radius, shelf + tall * 0.72),
            (radius * 0.45, shelf + tall * 0.86),
            (radius * 0.3, shelf + tall),
        ];
        builder.add(slot, lathe(&bottle, 12).moved(x * bay.width(), 0.0, 0.0));
    }
}

/// Two ends and a back of panels, with a chest of drawers on one side and room for the knees.
fn panels(builder: &mut Builder, slot: Slot, front: Slot, bench: f64) {
    let bay = builder.bay().with_y([0.0, bench - TOP]).inset(0.004, 0.0, 0.01);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, bay.slab(side, 0.022));
    }
    let back = bay.slab(Side::Back, 0.06).slab(Side::Front, 0.02).inset(0.022 - SINK, 0.0, 0.0);
    builder.cuboid(slot, back.without(Side::Below, bench * 0.3).without(Side::Above, 0.001));
    let fittings = Fittings { front, handle: Slot::Metal, reach: 0.02, is_traditional: false };
    let chest = bay.slab(Side::Right, bay.width() * 0.36).without(Side::Right, 0.02);
    let chest = chest.without(Side::Back, 0.06 - SINK).without(Side::Below, 0.06).without(Side::Above, 0.002);
    fittings.carcass(builder, slot, chest);
    chest.inset(0.004, 0.004, 0.0).rows(4, 0.004).into_iter().for_each(|row| fittings.drawer(builder, row));
}

/// Cupboards with doors on a plinth, up to the bench.
fn cupboards(builder: &mut Builder, slot: Slot, front: Slot, bench: f64, is_traditional: bool) {
    let bay = builder.bay();
    let fittings = Fittings { front, handle: Slot::Metal, reach: 0.025, is_traditional };
    let base = bay.with_y([PLINTH, bench - TOP]).inset(0.002, 0.0, 0.002);
    builder.cuboid(
        Slot::PlasticDark,
        base.with_y([0.0, PLINTH + SINK]).inset(0.01, 0.0, 0.01).without(Side::Front, 0.05),
    );
    fittings.carcass(builder, slot, base);
    let count = (bay.width() / 0.5).round().clamp(1.0, 5.0) as u32;
    for (index, column) in base.inset(0.003, 0.003, 0.0).columns(count, 0.004).into_iter().enumerate() {
        fittings.door(builder, column, if index % 2 == 0 { Side::Left } else { Side::Right }, 0.85);
    }
}

/// Walls, a tiled back and the hood with its lamp, up to the duct; gives the hood.
fn chamber(builder: &mut Builder, slot: Slot, upper: Bay, tall: f64) -> Bay {
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, upper.slab(side, SIDE_WALL).without(Side::Above, HEAD));
    }
    let back = upper.slab(Side::Back, BACK_WALL).inset(SIDE_WALL - SINK, 0.001, 0.0006);
    builder.cuboid(Slot::TileWall, back.without(Side::Above, HEAD));
    let top = upper.high.y;
    let hood = upper.with_y([top - HEAD - tall, top - HEAD]).inset(SIDE_WALL - SINK, 0.0, 0.001);
    builder.cuboid(slot, hood.without(Side::Back, BACK_WALL - SINK).without(Side::Front, 0.002));
    builder.cuboid(Slot::Lamp, hood.with_y([hood.low.y - 0.006, hood.low.y + SINK]).inset(0.08, 0.0, 0.2));
    hood
}

/// A moulding that grows out over the chamber.
fn cornice(builder: &mut Builder, slot: Slot, upper: Bay) {
    let (half, middle, top) = (upper.extent() / 2.0, upper.center(), upper.high.y);
    let slice = |share: f64, back: f64| {
        Slice::new(top - HEAD * share - SINK, half.x - back, half.z - back).at(middle.x, middle.z)
    };
    let slices = [slice(1.0, 0.035), slice(0.62, 0.03), slice(0.34, 0.004), slice(0.3, 0.0)];
    let end = Slice::new(top, half.x, half.z).at(middle.x, middle.z);
    builder.add(slot, loft(&Outline::Square, &[slices.as_slice(), &[end]].concat()));
}

/// Glass between posts, a tiled back, and a hood that narrows to a pipe; gives the height of its rim.
fn smoke_hood(builder: &mut Builder, upper: Bay) -> f64 {
    let top = upper.high.y;
    let hood = [top - upper.height() * 0.4, top - upper.height() * 0.34];
    let low = upper.with_y([upper.low.y, hood[1]]);
    let post = 0.05;
    for x in [Side::Left, Side::Right] {
        for z in [Side::Front, Side::Back] {
            builder.cuboid(Slot::MetalDark, low.slab(x, post).slab(z, post).inset(0.002, 0.0, 0.002));
        }
        let pane = low.slab(x, 0.026).inset(0.01, 0.0, post - 0.002 - SINK);
        builder.cuboid(Slot::Glass, pane);
    }
    let back = low.slab(Side::Back, BACK_WALL).inset(post - 0.002 - SINK, 0.001, 0.006);
    builder.cuboid(Slot::TileWall, back);
    let (half, middle) = (upper.extent() / 2.0, upper.center());
    let pipe = half.x.min(half.z) * 0.36;
    let slice = |y: f64, x: f64, z: f64| Slice::new(y, x, z).at(middle.x, middle.z);
    let neck = top - upper.height() * 0.12;
    let slices = [
        slice(hood[0], half.x, half.z),
        slice(hood[1] + 0.02, half.x, half.z),
        slice(neck, pipe * 1.3, pipe * 1.3),
    ];
    builder.add(Slot::Metal, loft(&Outline::Square, &slices));
    builder.add(Slot::Metal, cylinder(pipe, [neck - SINK, top], 16).moved(middle.x, 0.0, middle.z));
    let lamp = upper.with_y([hood[0] - 0.006, hood[0] + SINK]).inset(0.15, 0.0, 0.2);
    builder.cuboid(Slot::Lamp, lamp);
    hood[0]
}

/// A flat lid with two connections for ducts.
fn vents(builder: &mut Builder, upper: Bay) {
    let lid = upper.with_y([upper.high.y - HEAD - SINK, upper.high.y - HEAD * 0.75]).inset(0.002, 0.0, 0.002);
    builder.cuboid(Slot::Metal, lid);
    for side in [-0.24, 0.24] {
        let at = upper.center() + DVec3::X * side * upper.width();
        let vent = Bay::around(at, upper.width() * 0.22, 1.0, upper.depth() * 0.4);
        builder.block(Slot::Plastic, vent.with_y([lid.high.y - SINK, upper.high.y]), 0.006);
    }
}

/// The pane in a frame that fills the opening between two heights.
fn pane_bay(upper: Bay, y: [f64; 2]) -> Bay {
    let pane = upper.slab(Side::Front, 0.02).inset(SIDE_WALL * 0.7, 0.0, 0.0).moved(0.0, 0.0, 0.012);
    pane.with_y(y)
}

/// A pane between two rails with a handle to lift it; gives its box.
fn pane(builder: &mut Builder, upper: Bay, y: [f64; 2]) -> Bay {
    let pane = pane_bay(upper, y);
    builder.cuboid(Slot::Glass, pane.inset(0.004, 0.004, 0.006));
    for edge in [Side::Below, Side::Above] {
        builder.cuboid(Slot::Metal, pane.slab(edge, 0.025));
    }
    let at = DVec3::new(0.0, pane.low.y + 0.0125, pane.high.z);
    handle(
        builder,
        Slot::MetalDark,
        HandleForm { kind: HandleKind::Level, length: pane.width() * 0.3 },
        at,
        0.016,
    );
    pane
}

/// Stiles and bars that divide a sash into six panes.
fn glazing_bars(builder: &mut Builder, slot: Slot, sash: Bay) {
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, sash.slab(side, 0.03).inset(0.001, 0.002, 0.001));
    }
    let bars = sash.inset(0.01, 0.01, 0.003);
    for share in [-1.0, 1.0] {
        let x = share * sash.width() / 6.0;
        builder.cuboid(slot, bars.with_x([x - 0.009, x + 0.009]));
    }
    let y = sash.center().y;
    builder.cuboid(slot, bars.inset(0.0, 0.0, 0.001).with_y([y - 0.009, y + 0.009]));
}

/// Two panes behind each other, one of them pushed aside by as much as the look says.
fn side_panes(builder: &mut Builder, upper: Bay, y: [f64; 2], look: usize) {
    let whole = pane_bay(upper, y);
    for rail in [Side::Below, Side::Above] {
        builder.cuboid(Slot::Metal, whole.slab(rail, 0.022));
    }
    let half = whole.inset(0.004, 0.02, 0.0).slab(Side::Left, whole.width() * 0.52);
    let pushed = whole.width() * (0.1 + 0.08 * look as f64);
    for (x, z) in [(0.0, 0.004), (pushed, 0.011)] {
        let pane = half.with_z([whole.low.z + z, whole.low.z + z + 0.005]).moved(x, 0.0, 0.0);
        builder.cuboid(Slot::Glass, pane);
        builder.cuboid(Slot::Metal, pane.slab(Side::Right, 0.016).inset(-0.001, 0.001, -0.001));
    }
}

/// Taps for gas, water, air and vacuum on both walls, each of its colour.
fn valves(builder: &mut Builder, width: f64, bench: f64, front: f64) {
    for (index, x) in [-0.47, -0.455, 0.455, 0.47].into_iter().enumerate() {
        let at = DVec3::new(x * width * 0.985, bench + 0.14 + 0.12 * (index % 2) as f64, front);
        let valve = turned_forward(lathe(&[(0.01, -SINK), (0.01, 0.02), (0.02, 0.022), (0.018, 0.045)], 8));
        builder.add(
            [Slot::Book, Slot::Leaf, Slot::PaintedAccent, Slot::Brass][index],
            valve.moved(at.x, at.y, at.z),
        );
    }
}
