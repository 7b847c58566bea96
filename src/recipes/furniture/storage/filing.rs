//! Filing cabinets. Four drawers for A4 hanging files are 0.41 to 0.47 m wide, 0.62 deep and 1.32 high (DIN 4545,
//! typical); card indexes have drawers 0.15 to 0.2 wide.

use glam::{DVec2, DVec3};

use super::{OVERHANG, REACH};
use crate::geometry::Side;
use crate::recipes::furniture::parts::{
    HandleForm, HandleKind, LegKind, REVEAL, handle, legs_at_corners, slab_top, turned_forward,
};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, extrude, lathe};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// Metres of a drawer for hanging files.
const DRAWER: f64 = 0.33;
/// Metres of a card index's drawer.
const CARD_DRAWER: f64 = 0.13;
/// Metres of a front's sheet or board.
const FRONT: f64 = 0.018;
/// Width and height in metres of a label in its holder.
const LABEL: [f64; 2] = [0.08, 0.03];

/// A cabinet with `drawers` for files: flush steel, panelled wood, riveted sheet on legs, or thin boards.
pub(in super::super) static FILING_CABINET: Recipe = Recipe::furniture("filing_cabinet", [0.45, 0.6, 1.3])
    .with(&[("drawers", 0.0)])
    .symbol(Symbol::Doors)
    .every_set(filing_cabinet);

fn filing_cabinet(draft: &Draft, builder: &mut Builder) {
    let height = builder.bay().height();
    let count = draft.count_along("drawers", height, DRAWER, 5);
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => plain(builder, count, form),
        GeometrySet::Traditional => traditional(builder, count, form),
        GeometrySet::Industrial => industrial(builder, count, form),
        GeometrySet::Budget => budget(builder, count, form),
    }
}

/// The body behind fronts that are [`FRONT`] thick with handles of a reach before them; gives the space of the fronts.
fn body(builder: &mut Builder, slot: Slot, bay: Bay, reach: f64) -> Bay {
    builder.cuboid(slot, bay.without(Side::Front, reach + FRONT - SINK));
    bay.without(Side::Front, reach).slab(Side::Front, FRONT).inset(REVEAL, REVEAL / 2.0, 0.0)
}

/// A paper label in a frame of metal on a front.
fn label(builder: &mut Builder, front: Bay, at: DVec3) {
    let [width, height] = [LABEL[0].min(front.width() * 0.5), LABEL[1].min(front.height() * 0.3)];
    let plate = Bay::around(at, width, height, 0.004);
    builder.cuboid(Slot::Metal, plate);
    builder.cuboid(Slot::Paper, plate.inset(0.004, 0.004, 0.0).moved(0.0, 0.0, 0.0012));
}

/// The middle of a front, a share of its height above or below.
fn on_front(front: Bay, share: f64) -> DVec3 {
    let middle = front.center();
    DVec3::new(middle.x, middle.y + share * front.height(), front.high.z)
}

/// Flush fronts of steel with a lip to reach behind, a bar along each front, a shutter, or holes for a finger.
fn plain(builder: &mut Builder, count: u32, form: usize) {
    let slot = [Slot::Painted, Slot::Metal, Slot::Painted, Slot::Wood][form];
    let reach = [0.006, 0.016, 0.02, 0.002][form];
    let bay = builder.bay();
    let plinth = 0.03_f64.min(bay.height() * 0.05);
    builder.cuboid(Slot::MetalDark, bay.slab(Side::Below, plinth + SINK).inset(0.01, 0.0, 0.02));
    let fronts =
        body(builder, if form == 3 { Slot::Painted } else { slot }, bay.without(Side::Below, plinth), reach);
    if form == 2 {
        shutter(builder, fronts, reach);
        return;
    }
    for front in fronts.rows(count, REVEAL) {
        builder.cuboid(slot, front.without(Side::Above, if form == 0 { 0.014 } else { 0.0 }));
        match form {
            0 => {
                let lip = front.slab(Side::Above, 0.03).inset(0.002, 0.0, 0.0).without(Side::Above, 0.012);
                builder.cuboid(Slot::MetalDark, lip.with_z([front.high.z - 0.004, front.high.z + reach]));
            }
            1 => handle(
                builder,
                Slot::MetalDark,
                HandleForm { kind: HandleKind::Level, length: front.width() * 0.8 },
                on_front(front, 0.25),
                reach,
            ),
            _ => {
                let hole = turned_forward(lathe(&[(0.017, -0.004), (0.017, reach)], 12));
                let at = on_front(front, 0.3);
                builder.add(Slot::MetalDark, hole.moved(at.x, at.y, at.z));
            }
        }
        if form == 1 {
            label(builder, front, on_front(front, 0.02));
        }
    }
    let lock = turned_forward(lathe(&[(0.009, -0.003), (0.009, 0.002)], 8));
    builder.add(Slot::Chrome, lock.moved(fronts.high.x - 0.03, fronts.high.y - 0.012, fronts.high.z));
}

/// Slats of a shutter that rolls up, with its grip near the floor.
fn shutter(builder: &mut Builder, field: Bay, reach: f64) {
    let inner = field.inset(0.02, 0.001, 0.0);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(Slot::Painted, field.slab(side, 0.022));
    }
    for slat in
        inner.without(Side::Front, 0.005).rows((inner.height() / 0.045).round().max(4.0) as u32, 0.006)
    {
        builder.cuboid(Slot::Metal, slat);
    }
    let grip = on_front(inner.slab(Side::Below, 0.12), 0.1) - DVec3::Z * 0.006;
    handle(
        builder,
        Slot::Metal,
        HandleForm { kind: HandleKind::Level, length: inner.width() * 0.6 },
        grip,
        reach + 0.006,
    );
}

/// Oak with a moulded top: drawers with brass pulls under labels, or a card index of two columns.
fn traditional(builder: &mut Builder, count: u32, form: usize) {
    let slot = [Slot::Wood, Slot::WoodDark, Slot::Wood, Slot::WoodDark][form];
    let bay = builder.bay();
    let (top, plinth) = (0.03_f64.min(bay.height() * 0.05), 0.07_f64.min(bay.height() * 0.08));
    slab_top(builder, slot, bay.slab(Side::Above, top), true);
    slab_top(builder, slot, bay.slab(Side::Below, plinth).inset(0.002, 0.0, 0.002), true);
    let case =
        bay.without(Side::Above, top - SINK).without(Side::Below, plinth - SINK).inset(0.015, 0.0, 0.003);
    let fronts = body(builder, slot, case, REACH);
    side_panels(builder, slot, case.without(Side::Front, REACH + FRONT), form);
    let (rows, columns) = if form >= 2 {
        ((case.height() / CARD_DRAWER).round().clamp(2.0, 10.0) as u32, 2)
    } else {
        (count, 1)
    };
    for row in fronts.inset(0.018, 0.012, 0.0).rows(rows, 0.008) {
        for front in row.columns(columns, 0.008) {
            pulled_drawer(builder, slot, front);
        }
    }
}

/// A drawer whose label sits in a brass frame over a cup to pull.
fn pulled_drawer(builder: &mut Builder, slot: Slot, front: Bay) {
    builder.block(slot, front, 0.005);
    let width = LABEL[0].min(front.width() * 0.5);
    let is_low = front.height() < 0.2;
    if !is_low {
        let plate = Bay::around(on_front(front, 0.24), width, LABEL[1], 0.004);
        builder.cuboid(Slot::Brass, plate);
        builder.cuboid(Slot::Paper, plate.inset(0.004, 0.004, 0.0).moved(0.0, 0.0, 0.0012));
    }
    cup(builder, Slot::Brass, on_front(front, if is_low { 0.0 } else { -0.02 }), width, REACH);
}

/// A cup handle: a quarter of a tube, open below.
fn cup(builder: &mut Builder, slot: Slot, at: DVec3, width: f64, reach: f64) {
    let tall = reach * 1.4;
    let profile = [(-SINK, 0.0), (-SINK, tall), (reach * 0.5, tall * 0.9), (reach, tall * 0.3), (reach, 0.0)];
    let solid = extrude(&profile.map(DVec2::from), Axis::X, [-width / 2.0, width / 2.0]);
    builder.add(slot, solid.moved(at.x, at.y - tall / 2.0, at.z));
}

/// Frames of boards on both sides of a body, one or two fields over each other.
fn side_panels(builder: &mut Builder, slot: Slot, case: Bay, form: usize) {
    let stile = 0.05_f64.min(case.depth() * 0.15);
    for side in [Side::Left, Side::Right] {
        let out = if side == Side::Left { -1.0 } else { 1.0 };
        let skin = case.slab(side, 0.008).moved(out * 0.006, 0.0, 0.0).inset(0.0, 0.002, 0.001);
        for end in [Side::Front, Side::Back] {
            builder.cuboid(slot, skin.slab(end, stile));
        }
        let between = skin.inset(0.0, 0.0, stile - SINK);
        for rail in 0..=form % 2 + 1 {
            let share = rail as f64 / (form % 2 + 1) as f64;
            let low = skin.low.y + share * (skin.height() - stile);
            builder.cuboid(slot, between.with_y([low + 0.001, low + stile - 0.001]).inset(0.0004, 0.0, 0.0));
        }
    }
}

/// Riveted sheet on legs of angle: files, flat drawers for plans, or a card index.
fn industrial(builder: &mut Builder, count: u32, form: usize) {
    let slot = [Slot::Metal, Slot::MetalDark, Slot::Metal, Slot::PaintedAccent][form];
    let bay = builder.bay();
    let leg = bay.height() * [0.09, 0.14, 0.12, 0.09][form];
    let frame = bay.without(Side::Front, REACH);
    legs_at_corners(builder, Slot::MetalDark, frame, 0.035, LegKind::Angle);
    let case = bay.inset(0.007, 0.0, 0.0).without(Side::Back, 0.007).without(Side::Below, leg);
    let fronts = body(
        builder,
        if form == 3 { Slot::MetalDark } else { slot },
        case.without(Side::Above, 0.004),
        REACH,
    );
    let fronts = fronts.inset(0.026, 0.014, 0.0);
    let (rows, columns) = match form {
        1 => ((case.height() / 0.1).round().clamp(3.0, 12.0) as u32, 1),
        2 => ((case.height() / CARD_DRAWER).round().clamp(2.0, 9.0) as u32, 2),
        _ => (count, 1),
    };
    for row in fronts.rows(rows, 0.008) {
        for front in row.columns(columns, 0.008) {
            builder.cuboid(slot, front);
            let tall = front.height() > 0.2;
            if form != 1 {
                label(builder, front, on_front(front, if tall { 0.22 } else { 0.16 }));
            }
            let width = front.width() * if form == 1 { 0.22 } else { 0.3 };
            for share in if form == 1 { &[-0.26, 0.26][..] } else { &[0.0] } {
                let at = on_front(front, if tall { 0.02 } else { -0.2 }) + DVec3::X * *share * front.width();
                cup(builder, if form == 1 { Slot::Metal } else { Slot::MetalDark }, at, width, REACH);
            }
            if tall {
                rivets(builder, front);
            }
        }
    }
}

/// A rivet in each corner of a front.
fn rivets(builder: &mut Builder, front: Bay) {
    let inner = front.inset(0.02, 0.02, 0.0);
    for x in inner.x() {
        for y in inner.y() {
            let rivet = turned_forward(lathe(&[(0.007, -0.003), (0.005, 0.004)], 6));
            builder.add(Slot::MetalDark, rivet.moved(x, y, front.high.z));
        }
    }
}

/// Thin sheet with plastic grips, laminated boards with knobs or cut-outs, or a tower of plastic boxes.
fn budget(builder: &mut Builder, count: u32, form: usize) {
    let bay = builder.bay();
    if form == 2 {
        tower(builder, bay, count);
        return;
    }
    let castor = 0.05_f64.min(bay.height() * 0.08);
    let feet = bay.slab(Side::Below, castor + SINK).inset(0.02, 0.0, 0.03);
    legs_at_corners(builder, Slot::PlasticDark, feet, 0.045, LegKind::Round);
    let reach = [0.012, 0.022, 0.0, 0.001][form];
    let case = bay.without(Side::Below, castor);
    let (slot, front_slot) = match form {
        0 => (Slot::Metal, Slot::Metal),
        1 => (Slot::Laminate, Slot::Laminate),
        _ => (Slot::WoodLight, Slot::Laminate),
    };
    let fronts = body(
        builder,
        slot,
        case.without(Side::Above, 0.016 - SINK).without(Side::Back, 0.001).inset(OVERHANG, 0.0, 0.0),
        reach,
    );
    builder.cuboid(if form == 0 { slot } else { Slot::WoodLight }, case.slab(Side::Above, 0.016));
    for front in fronts.rows(count, REVEAL * 1.5) {
        builder.cuboid(front_slot, front);
        let at = on_front(front, 0.28);
        match form {
            0 => {
                let grip =
                    Bay::around(at + DVec3::Z * reach / 2.0, front.width() * 0.36, 0.036, reach + SINK);
                builder.cuboid(Slot::PlasticDark, grip.moved(0.0, 0.0, -SINK / 2.0));
                builder.cuboid(Slot::Paper, Bay::around(on_front(front, 0.1), 0.07, 0.024, 0.002));
            }
            1 => handle(
                builder,
                Slot::PlasticDark,
                HandleForm { kind: HandleKind::Knob, length: 0.0 },
                at,
                reach,
            ),
            _ => {
                let gap = Bay::around(at, front.width() * 0.3, 0.026, 0.002);
                builder.cuboid(Slot::PlasticDark, gap);
            }
        }
    }
}

/// Boxes of plastic that slide in a frame of the same, on castors.
fn tower(builder: &mut Builder, bay: Bay, count: u32) {
    let castor = 0.05_f64.min(bay.height() * 0.08);
    legs_at_corners(builder, Slot::PlasticDark, bay.slab(Side::Below, castor + SINK), 0.045, LegKind::Round);
    let frame = bay.without(Side::Below, castor);
    builder.block(Slot::Plastic, frame.slab(Side::Above, 0.025), 0.01);
    builder.cuboid(Slot::Plastic, frame.slab(Side::Below, 0.02).inset(0.003, 0.0, 0.003));
    let posts = frame.inset(0.004, 0.01, 0.004);
    legs_at_corners(builder, Slot::Plastic, posts, 0.025, LegKind::Square);
    for (index, row) in posts.inset(0.014, 0.016, 0.01).rows(count, 0.02).into_iter().enumerate() {
        let slot = [Slot::PaintedAccent, Slot::Plastic][index % 2];
        let drawer = row.inset(0.0, 0.0, 0.006);
        builder.cuboid(slot, drawer);
        let lip = drawer.slab(Side::Above, 0.03).inset(drawer.width() * 0.25, 0.0, 0.0);
        builder.cuboid(
            Slot::PlasticDark,
            lip.with_z([drawer.high.z - SINK, drawer.high.z + 0.01]).moved(0.0, -0.02, 0.0),
        );
    }
}
