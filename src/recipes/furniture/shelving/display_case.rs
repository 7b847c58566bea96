//! Show cases. Museums and shops: base 0.8 m or plinth 0.3 m, glass to 1.8 or 2.0 m, shelves of glass 0.3 to 0.4 m apart.

use glam::DVec3;

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, cornice, legs_at_corners, slab_top};
use crate::recipes::kit::{Bay, Builder, SINK, Sampler, cylinder, lathe};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a pane.
const PANE: f64 = 0.006;
/// Metres of a shelf of glass.
const SHELF: f64 = 0.008;
/// Metres between shelves.
const SPACING: f64 = 0.38;
/// The most triangles that one thing on show takes, and how many stand on a shelf.
const THINGS: u32 = 3;

/// A glazed case: frameless on a plinth, a cabinet with glazing bars, a frame of angles, or thin profiles on a base.
pub(in super::super) static DISPLAY_CASE: Recipe =
    Recipe::furniture("display_case", [1.0, 0.5, 1.6]).symbol(Symbol::Frame).every_set(display_case);

fn display_case(draft: &Draft, builder: &mut Builder) {
    let form = draft.form();
    let inner = match draft.set() {
        GeometrySet::Plain => plain(builder, form),
        GeometrySet::Traditional => traditional(builder, form),
        GeometrySet::Industrial => industrial(builder, form),
        GeometrySet::Budget => budget(builder, form),
    };
    let mut sampler = draft.sampler();
    let slot = [Slot::Glass, Slot::Wood, Slot::Metal, Slot::Glass][draft.set() as usize];
    let board = if slot == Slot::Glass { SHELF } else { SHELF * 2.0 };
    let count = (inner.height() / SPACING).round().clamp(1.0, 4.0) as u32;
    for (index, row) in inner.rows(count, 0.0).into_iter().enumerate() {
        if index > 0 {
            builder.cuboid(slot, row.slab(Side::Below, board).inset(0.0, 0.0, 0.001));
        }
        let floor = if index > 0 { board } else { 0.0 };
        on_show(builder, &mut sampler, row.without(Side::Below, floor - SINK));
    }
}

/// Vases, bowls, busts on blocks, framed pictures in a row.
fn on_show(builder: &mut Builder, sampler: &mut Sampler, row: Bay) {
    let cells = ((row.width() / 0.28).floor() as u32).clamp(1, THINGS);
    for cell in row.inset(0.03, 0.0, 0.03).columns(cells, 0.06) {
        let tall = (row.height() * sampler.between(0.35, 0.65)).min(0.34);
        let radius = (cell.width().min(cell.depth()) / 2.0).min(tall * 0.42);
        let middle = cell.center();
        let (y, slot) =
            (cell.low.y, sampler.pick(&[Slot::Ceramic, Slot::Brass, Slot::Terracotta, Slot::PaintedAccent]));
        let profile: &[(f64, f64)] = match sampler.count(0, 3) {
            0 => &[(0.5, 0.0), (1.0, 0.4), (0.3, 0.8), (0.5, 1.0)],
            1 => &[(0.4, 0.0), (0.3, 0.2), (1.0, 0.55), (0.9, 0.55), (0.2, 0.26)],
            2 => &[(0.7, 0.0), (0.7, 0.2), (0.3, 0.24), (0.28, 0.45), (0.55, 0.7), (0.3, 0.98)],
            _ => {
                let card =
                    Bay::around(DVec3::new(middle.x, y + tall * 0.5, middle.z), radius * 1.5, tall, 0.012);
                builder.cuboid(Slot::WoodDark, card);
                builder.cuboid(Slot::Paper, card.inset(0.016, 0.016, 0.0).moved(0.0, 0.0, 0.001));
                continue;
            }
        };
        let profile: Vec<(f64, f64)> =
            profile.iter().map(|&(r, rise)| (r * radius, y + rise * tall)).collect();
        builder.add(slot, lathe(&profile, 8).moved(middle.x, 0.0, middle.z));
    }
}

/// Panes between posts of a thickness, on all four sides of a bay.
fn glazing(builder: &mut Builder, bay: Bay, frame: f64) {
    let inset = ((frame - PANE) / 2.0).max(0.0);
    for side in [Side::Front, Side::Back] {
        builder.cuboid(Slot::Glass, bay.slab(side, frame.max(PANE)).inset(frame - SINK, 0.0, inset));
    }
    for side in [Side::Left, Side::Right] {
        builder
            .cuboid(Slot::Glass, bay.slab(side, frame.max(PANE)).inset(inset, 0.0, frame.max(PANE) - SINK));
    }
}

/// Panes glued edge to edge on a plinth with a shadow gap: low, high, between two slabs, or with a back of board.
fn plain(builder: &mut Builder, form: usize) -> Bay {
    let bay = builder.bay();
    let slot = [Slot::Painted, Slot::Wood, Slot::MetalDark, Slot::WoodLight][form];
    let base = (bay.height() * [0.14, 0.34, 0.05, 0.45][form]).max(0.03);
    builder.block(slot, bay.slab(Side::Below, base), 0.003);
    let gap = bay.with_y([base - SINK, base + 0.012]).inset(0.025, 0.0, 0.025);
    builder.cuboid(Slot::MetalDark, gap);
    let cover = [0.012, 0.012, 0.04, 0.012][form];
    let lid = bay.slab(Side::Above, cover);
    builder.cuboid(
        if form == 2 { slot } else { Slot::Glass },
        if form == 2 { lid } else { lid.inset(0.0008, 0.0, 0.0008) },
    );
    let glazed = bay.with_y([base + 0.012 - SINK, bay.high.y - cover + SINK]).inset(0.003, 0.0, 0.003);
    glazing(builder, glazed, PANE);
    let floor = glazed.slab(Side::Below, 0.012).inset(PANE + 0.001, 0.0, PANE + 0.001);
    builder.cuboid(slot, floor);
    if form == 3 {
        builder.cuboid(
            slot,
            glazed.slab(Side::Back, 0.02).inset(PANE + 0.002, 0.004, 0.0).moved(0.0, 0.0, PANE + 0.0015),
        );
    }
    let inner = glazed.inset(PANE + 0.003, 0.0, PANE + 0.003).without(Side::Below, 0.012);
    if form == 3 { inner.without(Side::Back, 0.02) } else { inner }
}

/// A cabinet of wood: cornice, doors below, glazing bars above.
fn traditional(builder: &mut Builder, form: usize) -> Bay {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Wood, Slot::WoodDark][form];
    let bay = builder.bay();
    let (crown, base) = (0.07_f64.min(bay.height() * 0.08), bay.height() * [0.32, 0.12, 0.42, 0.3][form]);
    cornice(builder, slot, bay.slab(Side::Above, crown), 0.03);
    let case = bay.inset(0.03, 0.0, 0.0).without(Side::Back, 0.002).without(Side::Front, 0.016);
    slab_top(
        builder,
        slot,
        case.inset(-0.012, 0.0, 0.0).without(Side::Front, -0.012).slab(Side::Below, 0.06),
        true,
    );
    let foot = case.with_y([0.06 - SINK, base]);
    builder.cuboid(slot, foot);
    slab_top(
        builder,
        slot,
        case.inset(-0.01, 0.0, 0.0).without(Side::Front, -0.01).with_y([base - SINK, base + 0.025]),
        true,
    );
    if base > 0.3 {
        for door in foot.inset(0.03, 0.03, 0.0).columns(2, 0.02) {
            builder.block(slot, door.slab(Side::Front, 0.01).moved(0.0, 0.0, 0.008), 0.004);
            let knob = DVec3::new(
                if door.center().x < 0.0 { door.high.x - 0.02 } else { door.low.x + 0.02 },
                door.center().y,
                door.high.z + 0.014,
            );
            builder.cuboid(Slot::Brass, Bay::around(knob, 0.016, 0.016, 0.016));
        }
    }
    let upper = case.with_y([base + 0.025 - SINK, bay.high.y - crown + SINK]).inset(0.004, 0.0, 0.004);
    legs_at_corners(builder, slot, upper, 0.04, LegKind::Square);
    glazing(builder, upper, 0.04);
    bars(
        builder,
        slot,
        upper.inset(0.04 - SINK, 0.0, 0.0).slab(Side::Front, 0.03).without(Side::Front, 0.008),
        form,
    );
    upper.inset(0.042, 0.0, 0.042)
}

/// Glazing bars before a pane: a cross of them, and a middle post between two doors.
fn bars(builder: &mut Builder, slot: Slot, field: Bay, form: usize) {
    let middle = field.center();
    builder.cuboid(slot, Bay::around(middle, 0.036, field.height(), field.depth()));
    for half in [-0.25, 0.25] {
        let at = middle + DVec3::X * half * field.width();
        builder.cuboid(slot, Bay::around(at, 0.014, field.height(), field.depth() - 0.006));
    }
    let count = if form.is_multiple_of(2) { 2 } else { 3 };
    for step in 1..=count {
        let y = field.low.y + field.height() * f64::from(step) / f64::from(count + 1);
        builder.cuboid(
            slot,
            Bay::around(DVec3::new(middle.x, y, middle.z), field.width(), 0.014, field.depth() - 0.009),
        );
    }
}

/// Angles of steel around panes, on legs or over a drawer.
fn industrial(builder: &mut Builder, form: usize) -> Bay {
    let bay = builder.bay();
    let iron = 0.03_f64.min(bay.width() * 0.06);
    legs_at_corners(builder, Slot::MetalDark, bay, iron, LegKind::Angle);
    let base = bay.height() * [0.18, 0.3, 0.1, 0.24][form];
    let frame = bay.inset(0.007, 0.0, 0.007);
    let floor = frame.with_y([base, base + 0.03]);
    builder.cuboid(if form == 2 { Slot::Metal } else { Slot::Wood }, floor);
    if form % 2 == 1 {
        let drawer = frame.with_y([base - 0.12, base + SINK]).inset(0.012, 0.0, 0.012);
        builder.cuboid(Slot::Metal, drawer);
        let grip = Bay::around(DVec3::new(0.0, drawer.center().y, drawer.high.z + 0.006), 0.12, 0.02, 0.014);
        builder.cuboid(Slot::MetalDark, grip);
    }
    builder.cuboid(Slot::MetalDark, frame.slab(Side::Above, 0.02).without(Side::Above, 0.002));
    let glazed = frame.with_y([base + 0.03 - SINK, frame.high.y - 0.02 + SINK]);
    glazing(builder, glazed.inset(0.0005, 0.0, 0.0005), PANE);
    let rail = glazed.inset(0.001, 0.0, 0.0);
    let y = glazed.center().y;
    for side in [Side::Front, Side::Back] {
        builder.cuboid(
            Slot::MetalDark,
            rail.with_y([y - 0.012, y + 0.012]).slab(side, 0.004).moved(
                0.0,
                0.0,
                if side == Side::Front { 0.003 } else { -0.003 },
            ),
        );
    }
    glazed.inset(PANE + 0.004, 0.0, PANE + 0.004)
}

/// Round profiles of aluminium with plastic corners around glass, over a cupboard of board.
fn budget(builder: &mut Builder, form: usize) -> Bay {
    let bay = builder.bay();
    let base = bay.height() * [0.36, 0.12, 0.24, 0.46][form];
    let slot = [Slot::Laminate, Slot::Laminate, Slot::PaintedAccent, Slot::WoodLight][form];
    builder.cuboid(slot, bay.slab(Side::Below, base).without(Side::Below, 0.04).inset(0.002, 0.0, 0.002));
    builder.cuboid(Slot::PlasticDark, bay.slab(Side::Below, 0.041).inset(0.02, 0.0, 0.03));
    for door in bay.slab(Side::Below, base).inset(0.02, 0.055, 0.0).columns(2, 0.01) {
        if base > 0.3 {
            builder.cuboid(slot, door.slab(Side::Front, 0.004).moved(0.0, 0.0, 0.0015));
        }
    }
    let cover = bay.slab(Side::Above, 0.03);
    builder.cuboid(Slot::PlasticDark, cover);
    let radius = 0.013;
    let glazed = bay.with_y([base - SINK, cover.low.y + SINK]).inset(0.003, 0.0, 0.003);
    for x in [glazed.low.x + radius, glazed.high.x - radius] {
        for z in [glazed.low.z + radius, glazed.high.z - radius] {
            builder.add(Slot::Metal, cylinder(radius, glazed.y(), 6).moved(x, 0.0, z));
        }
    }
    glazing(builder, glazed, radius * 2.0);
    glazed.inset(radius * 2.0 + 0.002, 0.0, radius * 2.0 + 0.002)
}
