//! Lecterns: 1.10 to 1.20 m high, the desk 0.5 to 0.6 m wide, sloping 15 to 25 degrees towards the speaker.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners, raised_panel, slab_top};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, cuboid, extrude, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of a desk's board.
const BOARD: f64 = 0.03;

/// What all lecterns share: the box, and the height of the desk's lower edge, at which the speaker stands.
struct Desk {
    bay: Bay,
    front: f64,
}

impl Desk {
    /// y of the underside of the desk at a share of the depth from back to front.
    fn under(&self, forward: f64) -> f64 {
        self.bay.high.y + (self.front - self.bay.high.y) * forward - BOARD
    }

    /// The sloping board, and the ledge that keeps papers from sliding.
    fn board(&self, builder: &mut Builder, slot: Slot, ledge: Slot) {
        let (low, high, y) = (self.bay.low.z, self.bay.high.z, self.front);
        let top = [(high, y - BOARD), (high, y), (low, self.bay.high.y), (low, self.bay.high.y - BOARD)];
        builder.add(slot, extrude(&top.map(DVec2::from), Axis::X, self.bay.x()));
        let rest = Bay::new(self.bay.x(), [y - 0.002, y + 0.02], [high - 0.012, high - 0.001]);
        builder.cuboid(ledge, rest.inset(0.02, 0.0, 0.0));
    }

    /// A microphone on a gooseneck.
    fn microphone(&self, builder: &mut Builder) {
        let foot = DVec3::new(
            self.bay.width() * 0.2,
            self.under(0.2) + BOARD * 0.6,
            self.bay.low.z + 0.2 * self.bay.depth(),
        );
        let top = self.bay.high.y - 0.004;
        let neck = [
            foot,
            DVec3::new(foot.x, top - 0.02, foot.z + 0.004),
            DVec3::new(foot.x * 0.9, top - 0.012, foot.z + 0.06),
        ];
        builder.add(Slot::MetalDark, sweep(&neck, 0.004, 5));
    }
}

/// A speaker's desk: a slab, a column, panes, or legs; a panelled case; angles of steel; a thin stand.
pub(in super::super) static LECTERN: Recipe =
    Recipe::furniture("lectern", [0.6, 0.5, 1.15]).every_set(lectern);

fn lectern(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let rise = (bay.height() * 0.16).min(bay.depth() * 0.4);
    let desk = Desk { bay, front: bay.high.y - rise };
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => plain(&desk, builder, form),
        GeometrySet::Traditional => traditional(&desk, builder, form),
        GeometrySet::Industrial => industrial(&desk, builder, form),
        GeometrySet::Budget => budget(&desk, builder, form),
    }
}

/// Two cheeks with a front between them, a column on a plate, panes of glass, or a slab off the middle.
fn plain(desk: &Desk, builder: &mut Builder, form: usize) {
    let bay = desk.bay;
    let slot = [Slot::Wood, Slot::Painted, Slot::Glass, Slot::WoodLight][form];
    desk.board(builder, if form == 2 { Slot::Wood } else { slot }, Slot::MetalDark);
    desk.microphone(builder);
    builder.block(Slot::MetalDark, bay.slab(Side::Below, 0.02).inset(0.015, 0.0, 0.015), 0.004);
    match form {
        0 | 2 => {
            let thick = if form == 0 { 0.025 } else { 0.014 };
            let (back, front) = (bay.low.z + 0.06 * bay.depth(), bay.high.z - 0.2 * bay.depth());
            let cheek = [
                (front, 0.02 - SINK),
                (front, desk.under(0.8) + SINK),
                (back, desk.under(0.06) + SINK),
                (back, 0.02 - SINK),
            ];
            let x = bay.high.x - 0.06;
            builder.add_pair(slot, extrude(&cheek.map(DVec2::from), Axis::X, [x - thick, x]));
            let screen = Bay::new(
                [SINK - x + thick, x - thick - SINK],
                [0.12, desk.under(0.12) - 0.03],
                [back + 0.02, back + 0.02 + thick],
            );
            builder
                .cuboid(if form == 2 { Slot::MetalDark } else { slot }, screen.inset(-2.0 * SINK, 0.0, 0.0));
        }
        1 => {
            let middle = DVec3::new(0.0, desk.under(0.5) / 2.0, 0.0);
            builder.block(Slot::Metal, Bay::around(middle, 0.1, desk.under(0.5) + 0.02, 0.1), 0.008);
        }
        _ => {
            let slab =
                Bay::new([-0.18 * bay.width(), 0.3 * bay.width()], [0.0195, desk.under(0.36)], [-0.06, 0.0]);
            builder.block(Slot::WoodDark, slab.moved(0.0, 0.0, -0.06), 0.004);
            let post = Bay::new(
                [-0.34 * bay.width(), -0.28 * bay.width()],
                [0.0195, desk.under(0.5)],
                [-0.03, 0.03],
            );
            builder.cuboid(Slot::MetalDark, post);
        }
    }
}

/// A panelled case with pilasters on a plinth, or a turned column on three feet.
fn traditional(desk: &Desk, builder: &mut Builder, form: usize) {
    let bay = desk.bay;
    let slot = [Slot::Wood, Slot::WoodDark, Slot::WoodDark, Slot::Wood][form];
    desk.board(builder, slot, Slot::Brass);
    let skirt = bay.inset(0.03, 0.0, 0.03).with_y([desk.front - 0.12, desk.front - BOARD * 0.5]);
    if form % 2 == 1 {
        pedestal(desk, builder, slot);
        builder.block(slot, skirt.inset(0.08, 0.02, 0.08), 0.008);
        return;
    }
    builder.block(slot, skirt, 0.01);
    slab_top(builder, slot, bay.inset(0.02, 0.0, 0.02).slab(Side::Below, 0.09), true);
    let case = bay.inset(0.07, 0.0, 0.06).with_y([0.09 - SINK, skirt.low.y + SINK]);
    builder.cuboid(slot, case.without(Side::Front, 0.05));
    for x in [case.low.x, case.high.x - 0.05] {
        // The audience sees the back: pilasters and a panel with its emblem are there.
        let pilaster = case.with_x([x - 0.003, x + 0.053]).slab(Side::Back, 0.04).moved(0.0, 0.0, -0.016);
        builder.block(slot, pilaster, 0.008);
    }
    let field = case.inset(0.08, 0.08, 0.0);
    let back = Bay::new(field.x(), field.y(), [-case.low.z - SINK, 0.012 - case.low.z]);
    let mut panel = builder.empty();
    raised_panel(&mut panel, slot, back);
    raised_panel(
        &mut panel,
        Slot::Brass,
        back.inset(field.width() * 0.36, field.height() * 0.42, 0.0).moved(0.0, field.height() * 0.1, 0.01),
    );
    for (slot, solid) in panel.into_parts() {
        builder.add(slot, solid.turned_y(std::f64::consts::PI));
    }
}

/// A turned column on three feet that curve outwards.
fn pedestal(desk: &Desk, builder: &mut Builder, slot: Slot) {
    let bay = desk.bay;
    let high = desk.under(0.5) - 0.03;
    let radius = (bay.width() * 0.1).min(0.06);
    let profile: Vec<(f64, f64)> = [
        (0.7, 0.1),
        (1.0, 0.13),
        (1.0, 0.22),
        (0.6, 0.25),
        (0.5, 0.4),
        (0.85, 0.6),
        (0.55, 0.72),
        (0.9, 0.76),
        (0.55, 0.8),
        (0.9, 1.0),
    ]
    .iter()
    .map(|&(share, rise)| (share * radius, rise * high))
    .collect();
    builder.add(slot, lathe(&profile, 10));
    let reach = bay.width().min(bay.depth()) / 2.0 - 0.02;
    for step in 0..4 {
        let foot = [
            DVec3::new(0.0, high * 0.19, radius * 0.6),
            DVec3::new(0.0, high * 0.16, reach * 0.55),
            DVec3::new(0.0, 0.016, reach * 1.2),
        ];
        let turn = std::f64::consts::FRAC_PI_4 + std::f64::consts::FRAC_PI_2 * f64::from(step);
        builder.add(slot, sweep(&foot, 0.02, 6).turned_y(turn));
    }
}

/// A frame of angles or pipe with planks or sheet before it.
fn industrial(desk: &Desk, builder: &mut Builder, form: usize) {
    let bay = desk.bay;
    desk.board(builder, [Slot::Wood, Slot::Metal, Slot::Wood, Slot::Wood][form], Slot::MetalDark);
    let frame = bay.inset(0.05, 0.0, 0.05).with_y([0.0, desk.under(0.86)]);
    let kind = [LegKind::Angle, LegKind::Square, LegKind::Pipe, LegKind::Angle][form];
    legs_at_corners(builder, Slot::MetalDark, frame, 0.04, kind);
    let rise = bay.inset(0.06, 0.0, 0.0).slab(Side::Back, 0.1).moved(0.0, 0.0, 0.055);
    for side in [Side::Left, Side::Right] {
        let stay =
            rise.slab(side, 0.02).slab(Side::Back, 0.02).with_y([frame.high.y - 0.01, desk.under(0.14)]);
        builder.cuboid(Slot::MetalDark, stay);
    }
    let band = frame.inset(0.008, 0.0, 0.008);
    for y in [0.1, frame.high.y - 0.05] {
        for side in [Side::Left, Side::Right] {
            builder
                .cuboid(Slot::MetalDark, band.slab(side, 0.012).inset(0.0, 0.0, 0.03).with_y([y, y + 0.04]));
        }
        builder.cuboid(
            Slot::MetalDark,
            band.slab(Side::Back, 0.012).inset(0.03, 0.0, 0.0).with_y([y + 0.001, y + 0.039]),
        );
    }
    let screen = band
        .slab(Side::Back, 0.02)
        .moved(0.0, 0.0, 0.013)
        .inset(0.03, 0.0, 0.0)
        .with_y([0.16, frame.high.y - 0.06]);
    match form {
        1 => builder.cuboid(Slot::Metal, screen.slab(Side::Back, 0.004)),
        2 => screen.columns(6, screen.width() * 0.1).into_iter().for_each(|bar| {
            builder.cuboid(Slot::Metal, Bay::around(bar.center(), 0.01, bar.height() + 0.14, 0.01));
        }),
        _ => screen
            .rows(if form == 0 { 5 } else { 3 }, 0.008)
            .into_iter()
            .for_each(|plank| builder.cuboid(Slot::Wood, plank)),
    }
    builder.cuboid(
        Slot::Wood,
        band.inset(0.012, 0.0, 0.012)
            .with_y([0.45 * bay.height(), 0.45 * bay.height() + 0.02])
            .without(Side::Back, 0.03),
    );
}

/// A post on a cross of tube like a music stand's, or a box of laminated board on castors.
fn budget(desk: &Desk, builder: &mut Builder, form: usize) {
    let bay = desk.bay;
    desk.board(
        builder,
        [Slot::Laminate, Slot::PlasticDark, Slot::Laminate, Slot::MetalDark][form],
        Slot::PlasticDark,
    );
    if form.is_multiple_of(2) {
        let foot = 0.06;
        legs_at_corners(
            builder,
            Slot::PlasticDark,
            bay.inset(0.05, 0.0, 0.04).slab(Side::Below, foot + SINK),
            0.045,
            LegKind::Round,
        );
        let (back, front) = (bay.low.z + 0.02, bay.high.z - 0.12);
        let side =
            [(front, foot), (front, desk.under(0.76) + SINK), (back, desk.under(0.04) + SINK), (back, foot)];
        let x = bay.high.x - 0.02;
        builder.add_pair(Slot::Laminate, extrude(&side.map(DVec2::from), Axis::X, [x - 0.016, x]));
        let inner =
            Bay::new([0.0155 - x, x - 0.0155], [foot + 0.002, desk.under(0.08)], [back + 0.004, back + 0.02]);
        builder.cuboid(if form == 0 { Slot::Laminate } else { Slot::PaintedAccent }, inner);
        let shelves: &[f64] = if form == 0 { &[0.08, 0.5] } else { &[0.08, 0.36, 0.64] };
        for rise in shelves {
            let y = rise * bay.height();
            builder
                .cuboid(Slot::WoodLight, Bay::new(inner.x(), [y, y + 0.016], [back + 0.019, front - 0.01]));
        }
        return;
    }
    let slot = if form == 1 { Slot::Chrome } else { Slot::MetalDark };
    let post = [DVec3::new(0.0, 0.04, 0.0), DVec3::new(0.0, desk.under(0.5) + 0.01, 0.0)];
    builder.add(slot, sweep(&post, 0.02, 8));
    let collar = [(0.026, bay.height() * 0.5), (0.032, bay.height() * 0.52), (0.026, bay.height() * 0.56)];
    builder.add(Slot::PlasticDark, lathe(&collar, 8));
    let (x, z) = (bay.high.x - 0.04, bay.high.z - 0.03);
    for corner in [[x, z], [x, -z]] {
        let foot = [DVec3::new(0.0, 0.045, 0.0), DVec3::new(corner[0], 0.02, corner[1])];
        builder.add_pair(slot, sweep(&foot, 0.014, 6));
        let shoe = Bay::around(DVec3::new(corner[0], 0.018, corner[1]), 0.04, 0.036, 0.04);
        builder.add_pair(Slot::Rubber, cuboid(shoe));
    }
    let bracket = Bay::around(DVec3::new(0.0, desk.under(0.5) - 0.008, 0.0), 0.16, 0.03, 0.1);
    builder.cuboid(slot, bracket);
}
