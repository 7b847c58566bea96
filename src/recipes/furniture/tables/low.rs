//! Low tables before sofas (0.35 to 0.5 m high) and narrow ones against walls.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use super::{OVERHANG, TOP, apron, top_board, top_of};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{CONE, Fronts, LegKind, leg, legs_at_corners, slab_top, slanted_leg};
use crate::recipes::furniture::seating::depth_slats;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, cylinder, loft, pipe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of a leg.
const LEG: f64 = 0.05;
/// Metres of the lip of a tray.
const LIP: f64 = 0.008;

/// A low table.
pub(in super::super) static COFFEE_TABLE: Recipe = Recipe::furniture("coffee_table", [1.1, 0.6, 0.42])
    .plain(|draft, builder| plain(draft, builder, draft.form()))
    .traditional(|draft, builder| traditional(draft, builder, draft.form()))
    .industrial(|draft, builder| industrial(draft, builder, draft.form()))
    .budget(|draft, builder| budget(draft, builder, draft.form()));

/// A top of its own thickness and the space under it.
fn topped(draft: &Draft, builder: &mut Builder, thickness: f64) -> Bay {
    let bay = builder.bay();
    let top = thickness.min(bay.height() * 0.3);
    top_board(draft, builder, bay.slab(Side::Above, top));
    let overhang = if draft.is_traditional() { 0.014 } else { OVERHANG };
    bay.without(Side::Above, top - SINK).inset(overhang, 0.0, overhang)
}

fn shelf(builder: &mut Builder, slot: Slot, under: Bay, rise: f64, inset: f64) {
    let y = under.low.y + under.height() * rise;
    builder.block(slot, under.with_y([y, y + 0.018]).inset(inset, 0.0, inset), 0.003);
}

fn plain(draft: &Draft, builder: &mut Builder, form: usize) {
    match form {
        0 => on_tapered_legs(draft, builder),
        1 => pebble(builder),
        2 => pane_on_frames(builder),
        _ => open_case(builder),
    }
}

/// An open case with a drawer in one half.
fn open_case(builder: &mut Builder) {
    let bay = builder.bay();
    let slab = 0.03_f64.min(bay.height() * 0.1);
    builder.block(Slot::Painted, bay.slab(Side::Above, slab), 0.004);
    builder.cuboid(Slot::WoodDark, bay.slab(Side::Below, 0.04).inset(0.05, 0.0, 0.05));
    let body = bay.with_y([0.04 - SINK, bay.high.y - slab + SINK]).inset(0.003, 0.0, 0.003);
    builder.block(Slot::Painted, body.slab(Side::Below, slab), 0.004);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::Painted, body.slab(side, 0.025).inset(0.0, slab - 4.0 * SINK, 0.002));
    }
    let inner = body.inset(0.025 - SINK, slab - 2.0 * SINK, 0.004);
    builder.cuboid(Slot::Wood, inner.slab(Side::Left, inner.width() * 0.45).without(Side::Front, 0.006));
    let gap = inner.without(Side::Left, inner.width() * 0.5).slab(Side::Below, 0.03);
    builder.block(Slot::Book, gap.inset(0.06, 0.0, gap.depth() * 0.2), 0.003);
}

/// A pane of glass on two frames of wood.
fn pane_on_frames(builder: &mut Builder) {
    let bay = builder.bay();
    builder.block(Slot::Glass, bay.slab(Side::Above, 0.012), 0.003);
    let under = bay.without(Side::Above, 0.012 - SINK).inset(bay.width() * 0.12, 0.0, 0.03);
    for side in [Side::Left, Side::Right] {
        let frame = under.slab(side, 0.05);
        for end in [Side::Front, Side::Back] {
            builder.block(Slot::Wood, frame.slab(end, 0.05), 0.005);
        }
        builder.block(Slot::Wood, frame.slab(Side::Above, 0.05).inset(0.002, 0.001, 0.05 - SINK), 0.004);
        builder.block(
            Slot::Wood,
            frame.slab(Side::Below, 0.04).moved(0.0, 0.002, 0.0).inset(0.002, 0.0, 0.05 - SINK),
            0.004,
        );
    }
    let rail = under.inset(0.05 - SINK, 0.0, under.depth() / 2.0 - 0.025);
    builder.block(Slot::Wood, rail.with_y([0.004, 0.04]), 0.004);
}

/// A top without corners on slanted legs.
fn pebble(builder: &mut Builder) {
    let bay = builder.bay();
    let half = bay.extent() / 2.0;
    let soft = half.x.min(half.z) * 0.96;
    let slice = |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back).softened(soft - back);
    let slices = [slice(bay.high.y - 0.028, 0.012), slice(bay.high.y - 0.012, 0.0), slice(bay.high.y, 0.0)];
    builder.add(Slot::Wood, loft(&Outline::Soft(6), &slices));
    for z in [-1.0, 1.0] {
        let at = |share: f64, y: f64| DVec3::new(half.x * share, y, z * half.z * share);
        builder
            .add_pair(Slot::Wood, slanted_leg([at(0.72, 0.0), at(0.56, bay.high.y - 0.02)], 0.02, &CONE, 10));
    }
}

/// Tapered legs and a shelf.
fn on_tapered_legs(draft: &Draft, builder: &mut Builder) {
    let under = topped(draft, builder, TOP * 0.8);
    legs_at_corners(builder, Slot::Wood, under, LEG * 0.9, LegKind::Tapered);
    shelf(builder, Slot::Wood, under, 0.35, LEG * 0.3);
}

fn traditional(draft: &Draft, builder: &mut Builder, form: usize) {
    let under = topped(draft, builder, top_of(builder.bay()));
    match form {
        2 => trunk_fronts(draft, builder, under),
        _ => {
            let kind = [LegKind::Turned, LegKind::Baluster, LegKind::Square, LegKind::Spade][form];
            let slot = if form == 1 { Slot::WoodDark } else { Slot::Wood };
            legs_at_corners(builder, slot, under, LEG, kind);
            apron(builder, slot, under, LEG, under.height() * 0.16);
            match form {
                0 => shelf(builder, slot, under, 0.22, LEG * 0.3),
                1 => {
                    let y = under.height() * 0.16;
                    let at = |x: f64, z: f64| {
                        DVec3::new(x * (under.high.x - LEG / 2.0), y, z * (under.high.z - LEG / 2.0))
                    };
                    builder.add(slot, sweep(&[at(-1.0, -1.0), at(1.0, 1.0)], 0.012, 6));
                    builder.add(slot, sweep(&[at(1.0, -1.0), at(-1.0, 1.0)], 0.0115, 6));
                    builder.add(
                        slot,
                        crate::recipes::kit::lathe(
                            &[(0.02, y - 0.025), (0.035, y), (0.02, y + 0.025), (0.006, y + 0.045)],
                            8,
                        ),
                    );
                }
                _ => {}
            }
        }
    }
}

/// Drawers on both long sides over a plinth.
fn trunk_fronts(draft: &Draft, builder: &mut Builder, under: Bay) {
    let plinth = under.height() * 0.16;
    slab_top(builder, Slot::Wood, under.slab(Side::Below, plinth), true);
    let body = under.without(Side::Below, plinth - SINK).inset(0.014, 0.0, 0.014);
    let fittings = Fronts::new(draft, Slot::Wood, Slot::Brass, 0.018);
    fittings.carcass(builder, Slot::Wood, body);
    for column in body.inset(0.02, 0.012, 0.0).columns(2, 0.02) {
        fittings.drawer(builder, column);
    }
}

fn industrial(draft: &Draft, builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    let slot = Slot::MetalDark;
    match form {
        0 => pallet_on_wheels(builder),
        1 => {
            let under = topped(draft, builder, TOP);
            for side in [Side::Left, Side::Right] {
                let x = under.slab(side, 0.08).center().x;
                let z = [under.low.z + 0.04, under.high.z - 0.04];
                for z in z {
                    leg(
                        builder,
                        slot,
                        Bay::new([x - 0.03, x + 0.03], under.y(), [z - 0.03, z + 0.03]),
                        LegKind::Pipe,
                    );
                }
                let y = under.height() * 0.3;
                builder.add(slot, sweep(&[DVec3::new(x, y, z[0]), DVec3::new(x, y, z[1])], 0.012, 6));
            }
            let y = under.height() * 0.3 + 0.009;
            for slat in depth_slats(under.with_y([y, y + 0.022]).inset(0.02, 0.0, 0.05), 3, 0.004) {
                builder.block(Slot::Wood, slat, 0.003);
            }
        }
        2 => chest(builder, slot),
        _ => {
            let under = bay.inset(OVERHANG, 0.0, OVERHANG);
            legs_at_corners(builder, slot, under.without(Side::Above, 0.006), 0.04, LegKind::Angle);
            builder.block(Slot::Glass, bay.slab(Side::Above, 0.012), 0.003);
            let ring = under.without(Side::Above, 0.011).slab(Side::Above, 0.035).inset(0.006, 0.0, 0.006);
            for side in [Side::Front, Side::Back] {
                builder.cuboid(slot, ring.slab(side, 0.006));
            }
            for side in [Side::Left, Side::Right] {
                builder.cuboid(slot, ring.slab(side, 0.006).inset(0.0, 0.002, 0.002));
            }
            let mesh =
                under.inset(0.012, 0.0, 0.012).with_y([under.height() * 0.28, under.height() * 0.28 + 0.006]);
            for slat in mesh.columns((mesh.width() / 0.06).round().clamp(6.0, 24.0) as u32, 0.03) {
                builder.cuboid(Slot::Metal, slat);
            }
            for side in [Side::Front, Side::Back] {
                builder.cuboid(slot, mesh.slab(side, 0.01).inset(0.001, 0.0, 0.001).moved(0.0, 0.004, 0.0));
            }
        }
    }
}

/// A pallet on four castors.
fn pallet_on_wheels(builder: &mut Builder) {
    let bay = builder.bay();
    let wheel = (bay.height() * 0.22).min(0.09);
    let stack = bay.without(Side::Below, wheel - 0.004);
    let board = stack.height() * 0.14;
    for slat in depth_slats(stack.slab(Side::Above, board), 5, 0.02) {
        builder.block(Slot::Wood, slat, 0.004);
    }
    for slat in depth_slats(stack.slab(Side::Below, board), 3, stack.depth() * 0.15) {
        builder.block(Slot::Wood, slat.inset(0.004, 0.0, 0.0), 0.004);
    }
    let blocks = stack.inset(0.008, board - SINK, 0.008);
    for column in blocks.columns(3, blocks.width() * 0.28) {
        for part in depth_slats(column, 2, column.depth() * 0.5) {
            builder.cuboid(Slot::Wood, part);
        }
    }
    for x in [-1.0, 1.0] {
        for z in [-1.0, 1.0] {
            let at = DVec3::new(x * (bay.high.x - 0.09), 0.0, z * (bay.high.z - 0.08));
            let tyre = cylinder(wheel * 0.42, [-0.014, 0.014], 12).turned_z(FRAC_PI_2);
            builder.add(Slot::Rubber, tyre.moved(at.x, wheel * 0.42, at.z));
            builder.cuboid(Slot::Metal, Bay::around(at + DVec3::Y * wheel * 0.68, 0.04, wheel * 0.6, 0.03));
        }
    }
}

/// A travelling chest with iron corners and straps.
fn chest(builder: &mut Builder, slot: Slot) {
    let bay = builder.bay();
    builder.block(
        Slot::Wood,
        bay.inset(0.003, 0.0, 0.003).without(Side::Below, 0.01).without(Side::Above, 0.002),
        0.004,
    );
    for x in [Side::Left, Side::Right] {
        for z in [Side::Front, Side::Back] {
            let corner = bay.slab(x, 0.05).slab(z, 0.05);
            builder.block(slot, corner.slab(Side::Above, 0.05), 0.004);
            builder.block(slot, corner.slab(Side::Below, 0.06), 0.004);
        }
    }
    for share in [-0.25, 0.25] {
        let strap = bay.with_x([share * bay.width() - 0.02, share * bay.width() + 0.02]);
        builder.cuboid(
            slot,
            strap.inset(0.0, 0.0, 0.001).without(Side::Below, 0.009).without(Side::Above, 0.0005),
        );
    }
    let lock = Bay::around(DVec3::new(0.0, bay.high.y * 0.7, bay.high.z - 0.004), 0.06, 0.08, 0.008);
    builder.block(Slot::Brass, lock, 0.003);
}

fn budget(draft: &Draft, builder: &mut Builder, form: usize) {
    let bay = builder.bay();
    match form {
        0 => {
            builder.block(Slot::Laminate, bay.slab(Side::Above, 0.05_f64.min(bay.height() * 0.15)), 0.003);
            let under =
                bay.without(Side::Above, 0.05_f64.min(bay.height() * 0.15) - SINK).inset(0.001, 0.0, 0.001);
            legs_at_corners(builder, Slot::Laminate, under, 0.05, LegKind::Square);
            shelf(builder, Slot::Laminate, under, 0.28, 0.02);
        }
        1 => {
            builder.block(Slot::WoodLight, bay.slab(Side::Above, 0.02), 0.003);
            for side in [Side::Left, Side::Right] {
                let end = bay.without(Side::Above, 0.02 - SINK).inset(0.001, 0.0, 0.002).slab(side, 0.018);
                builder.cuboid(Slot::WoodLight, end);
            }
            let inner =
                bay.inset(0.018, 0.0, 0.004).with_y([bay.height() * 0.12, bay.height() * 0.12 + 0.018]);
            builder.cuboid(Slot::WoodLight, inner);
            let back = bay
                .inset(0.018, 0.0, bay.depth() / 2.0 - 0.006)
                .with_y([inner.high.y - SINK, bay.high.y - 0.02 + SINK]);
            builder.cuboid(Slot::Painted, back);
        }
        2 => {
            let (rim, top) = (0.05_f64.min(bay.height() * 0.2), bay.high.y);
            let half = bay.extent() / 2.0;
            let soft = (half.x.min(half.z) * 0.4).min(0.12);
            let slice =
                |y: f64, back: f64| Slice::new(y, half.x - back, half.z - back).softened(soft - back * 0.5);
            // The lip is low: what stands on the table stands at its top.
            let tray = [slice(top - rim, 0.015), slice(top, 0.0), slice(top, 0.006), slice(top - LIP, 0.02)];
            builder.add(Slot::PaintedAccent, loft(&Outline::Soft(3), &tray));
            let z = [bay.low.z + 0.04, bay.high.z - 0.04];
            let x = bay.high.x - 0.05;
            for z in z {
                let y = top - rim - 0.006;
                let path =
                    [(-x, 0.0), (-x + 0.04, y), (x - 0.04, y), (x, 0.0)].map(|(x, y)| DVec3::new(x, y, z));
                builder.add(Slot::Metal, pipe(&path, 0.009, 0.04));
            }
        }
        _ => {
            let under = topped(draft, builder, 0.02);
            legs_at_corners(builder, Slot::MetalDark, under, 0.034, LegKind::Hairpin);
            apron(builder, Slot::MetalDark, under, 0.03, 0.02);
        }
    }
}

/// A narrow table against a wall, with drawers; `knees` leaves the space under them free.
pub(in super::super) static CONSOLE_TABLE: Recipe =
    Recipe::furniture("console_table", [1.1, 0.35, 0.8]).with(&[("knees", 0.0)]).every_set(console_table);

fn console_table(draft: &Draft, builder: &mut Builder) {
    let form = draft.form();
    let set = draft.set();
    let under =
        topped(draft, builder, top_of(builder.bay()) * if set == GeometrySet::Budget { 0.6 } else { 1.0 });
    let (slot, kind) = console_legs(set, form);
    let thick = if set == GeometrySet::Budget { 0.03 } else { 0.04 };
    legs_at_corners(builder, slot, under, thick, kind);
    let has_drawers = !matches!((set, form), (GeometrySet::Industrial, 1 | 3) | (GeometrySet::Budget, 1 | 2));
    if has_drawers || draft.is_set("knees") {
        drawers_under(draft, builder, under);
    } else {
        apron(builder, slot, under, thick, 0.03);
    }
    if form % 2 == 1 && !draft.is_set("knees") {
        shelf(
            builder,
            if set == GeometrySet::Industrial { Slot::Wood } else { slot },
            under,
            0.18,
            thick * 0.3,
        );
    }
}

/// Drawers side by side under the top.
fn drawers_under(draft: &Draft, builder: &mut Builder, under: Bay) {
    let (set, form) = (draft.set(), draft.form());
    let share = [0.18, 0.15, 0.2, 0.18][form];
    let chest = under
        .slab(Side::Above, builder.bay().height() * share)
        .without(Side::Above, SINK * 2.0)
        .inset(0.006, 0.0, 0.002);
    let front = if set == GeometrySet::Industrial { Slot::Metal } else { Slot::Wood };
    let fittings = Fronts::new(
        draft,
        front,
        if set == GeometrySet::Traditional { Slot::Brass } else { Slot::MetalDark },
        0.02,
    );
    fittings.carcass(builder, front, chest);
    let count = (chest.width() / [0.45, 0.9, 0.32, 0.6][form]).round().clamp(1.0, 4.0) as u32;
    for drawer in chest.inset(0.045, 0.008, 0.0).columns(count, 0.012) {
        fittings.drawer(builder, drawer);
    }
}

/// Material and kind of the legs.
fn console_legs(set: GeometrySet, form: usize) -> (Slot, LegKind) {
    match set {
        GeometrySet::Plain => {
            (Slot::Wood, [LegKind::Tapered, LegKind::Square, LegKind::Round, LegKind::Tapered][form])
        }
        GeometrySet::Traditional => (
            [Slot::Wood, Slot::WoodDark][form % 2],
            [LegKind::Turned, LegKind::Spade, LegKind::Baluster, LegKind::Turned][form],
        ),
        GeometrySet::Industrial => {
            (Slot::MetalDark, [LegKind::Angle, LegKind::Pipe, LegKind::Square, LegKind::Hairpin][form])
        }
        GeometrySet::Budget => (
            [Slot::Laminate, Slot::Chrome, Slot::Painted, Slot::WoodLight][form],
            [LegKind::Square, LegKind::Pipe, LegKind::Round, LegKind::Square][form],
        ),
    }
}
