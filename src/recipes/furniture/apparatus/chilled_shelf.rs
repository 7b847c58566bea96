//! Open refrigerators of shops: 1.25, 1.87 or 2.5 m wide, 0.8 to 0.9 deep, 2.0 high, four or five shelves.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{
    HandleForm, HandleKind, LegKind, across, cornice, handle, legs_at_corners, raised_panel, slab_top,
};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, Sampler, extrude, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of the ends.
const END: f64 = 0.03;
/// Shelves over the foot.
const SHELVES: u32 = 4;
/// Metres of a shelf.
const BOARD: f64 = 0.014;
/// Metres that one row of goods takes.
const GOODS: f64 = 0.13;

/// A refrigerator of a shop: open, with shelves of goods under a lit canopy between glass ends; a case of wood with doors; posts
/// with the motor on top; a tub under an open box.
pub(in super::super) static CHILLED_SHELF: Recipe =
    Recipe::furniture("chilled_shelf", [1.25, 0.85, 2.0]).every_set(chilled_shelf);

fn chilled_shelf(draft: &Draft, builder: &mut Builder) {
    let mut sampler = draft.sampler();
    let look = draft.form();
    let slot = [Slot::PlasticDark, Slot::Painted, Slot::Metal, Slot::PaintedAccent][look];
    match draft.set() {
        GeometrySet::Plain => canopied(builder, &mut sampler, slot, look),
        GeometrySet::Traditional => {
            glazed(builder, &mut sampler, [Slot::Wood, Slot::WoodDark, Slot::Painted, Slot::WoodLight][look]);
        }
        GeometrySet::Industrial => motor_on_top(builder, &mut sampler),
        GeometrySet::Budget => tub(
            builder,
            &mut sampler,
            [Slot::Painted, Slot::Plastic, Slot::PaintedAccent, Slot::Painted][look],
        ),
    }
}

fn canopied(builder: &mut Builder, sampler: &mut Sampler, slot: Slot, look: usize) {
    let bay = builder.bay();
    let (foot, head) = (bay.height() * 0.24, bay.height() * 0.9);
    let body = bay.inset(END, 0.0, 0.0);
    builder.add(slot, extrude(&side_view(bay, foot, head), Axis::X, body.x()));
    ends(builder, if look.is_multiple_of(2) { Slot::Glass } else { slot }, foot);
    let front = bay.high.z;
    builder.cuboid(
        Slot::Lamp,
        body.inset(0.04, 0.0, 0.0)
            .with_y([head - 0.012, head + SINK])
            .with_z([front - bay.depth() * 0.4, front - bay.depth() * 0.34]),
    );
    builder.cuboid(
        Slot::Screen,
        body.inset(body.width() * 0.3, 0.0, 0.0)
            .with_y([foot * 0.3, foot * 0.5])
            .with_z([front - 0.0005, front + 0.0008]),
    );
    for shelf in 0..=SHELVES {
        let step = (head - foot) / f64::from(SHELVES + 1);
        let low = foot * 0.95 + (head - foot) * f64::from(shelf) / f64::from(SHELVES + 1);
        let deep = bay.depth() * (0.66 - 0.05 * f64::from(shelf));
        let back = bay.low.z + 0.085;
        let board = body.inset(0.012, 0.0, 0.0).with_y([low, low + BOARD]).with_z([back, back + deep]);
        if shelf > 0 {
            board_with_prices(builder, board);
        }
        let goods = board.with_y([low + BOARD - SINK, low + step - 0.03]).inset(0.02, 0.0, 0.02);
        row_of_goods(builder, sampler, goods);
    }
}

/// Seen from the right: a deep foot, a thin back, a canopy.
fn side_view(bay: Bay, foot: f64, head: f64) -> [DVec2; 10] {
    let (back, front) = (bay.low.z, bay.high.z);
    [
        (front, 0.0),
        (front, foot * 0.86),
        (front - 0.05, foot),
        (back + 0.1, foot * 0.92),
        (back + 0.08, head),
        (front - bay.depth() * 0.3, head),
        (front - bay.depth() * 0.26, head + 0.05),
        (front - bay.depth() * 0.3, bay.high.y),
        (back, bay.high.y),
        (back, 0.0),
    ]
    .map(DVec2::from)
}

/// A pane or a board at both ends, with a bumper of metal at its foot.
fn ends(builder: &mut Builder, slot: Slot, foot: f64) {
    let bay = builder.bay();
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            slot,
            bay.slab(side, END + SINK)
                .inset(0.0, 0.002, 0.002)
                .with_z([bay.low.z + 0.002, bay.high.z - bay.depth() * 0.12]),
        );
        builder.cuboid(
            Slot::Metal,
            bay.slab(side, END + SINK * 4.0).with_y([0.0005, foot * 0.6]).inset(0.0006, 0.0, 0.001),
        );
    }
}

/// A shelf with a strip for prices along its front.
fn board_with_prices(builder: &mut Builder, board: Bay) {
    builder.cuboid(Slot::Metal, board);
    let strip = board.slab(Side::Front, 0.004).inset(0.001, 0.0, 0.0).moved(0.0, 0.003, 0.0035);
    builder.cuboid(Slot::Paper, strip.with_y([board.low.y - 0.012, board.low.y + 0.026]));
}

/// Cartons and pairs of bottles side by side.
fn row_of_goods(builder: &mut Builder, sampler: &mut Sampler, goods: Bay) {
    let columns = (goods.width() / GOODS).round().clamp(2.0, 9.0) as u32;
    for column in goods.columns(columns, 0.012) {
        let tall = goods.height() * sampler.between(0.5, 0.85);
        let slot = sampler.pick(&[
            Slot::Book,
            Slot::Paper,
            Slot::FabricAccent,
            Slot::Leaf,
            Slot::Linen,
            Slot::PaintedAccent,
        ]);
        if !sampler.chance(0.35) {
            builder.cuboid(slot, column.slab(Side::Below, tall));
            continue;
        }
        let (radius, y, middle) = (column.width() * 0.42, column.low.y, column.center());
        let bottle =
            [(radius, y), (radius, y + tall * 0.6), (radius * 0.4, y + tall * 0.8), (radius * 0.4, y + tall)];
        for z in [0.24, -0.2] {
            builder.add(slot, lathe(&bottle, 6).moved(middle.x, 0.0, middle.z + z * column.depth()));
        }
    }
}

/// What all forms share: where shelves are, and what they are made of.
struct Case {
    body: Bay,
    foot: f64,
    head: f64,
}

impl Case {
    /// Rows of goods from the foot to the head, on boards of a slot.
    fn fill(&self, builder: &mut Builder, sampler: &mut Sampler, board: Slot, z: [f64; 2]) {
        let step = (self.head - self.foot) / f64::from(SHELVES + 1);
        for shelf in 0..=SHELVES {
            let low = self.foot + step * f64::from(shelf);
            let piece = self.body.with_y([low, low + BOARD]).with_z(z);
            if shelf > 0 {
                builder.cuboid(board, piece);
            }
            let goods = piece.with_y([low + BOARD - SINK, low + step - 0.03]).inset(0.02, 0.0, 0.02);
            row_of_goods(builder, sampler, goods);
        }
    }
}

/// A case of wood with a cornice and a panelled foot, behind two glazed doors.
fn glazed(builder: &mut Builder, sampler: &mut Sampler, wood: Slot) {
    let bay = builder.bay();
    let high = bay.height();
    let (foot, crown) = (high * 0.2, 0.1);
    cornice(builder, wood, bay.slab(Side::Above, crown), 0.03);
    let case = bay.inset(0.03, 0.0, 0.002).without(Side::Front, 0.03).without(Side::Above, crown - SINK);
    for side in [Side::Left, Side::Right] {
        builder.cuboid(wood, case.slab(side, 0.04).without(Side::Below, 0.005));
    }
    builder.cuboid(
        Slot::Painted,
        case.inset(0.04 - SINK, 0.0, 0.0)
            .slab(Side::Back, 0.03)
            .without(Side::Below, foot - 0.02)
            .moved(0.0, 0.0, 0.004),
    );
    let base = case.slab(Side::Below, foot).inset(0.002, 0.0, 0.002);
    builder.cuboid(wood, base.without(Side::Front, 0.004).without(Side::Below, 0.003));
    slab_top(
        builder,
        wood,
        bay.slab(Side::Below, 0.1).inset(0.012, 0.0, 0.004).without(Side::Back, 0.003),
        true,
    );
    let panels = base
        .without(Side::Below, 0.1)
        .inset(0.05, 0.03, 0.0)
        .with_z([base.high.z - 0.01, base.high.z + 0.012]);
    for panel in panels.columns(2, 0.06) {
        raised_panel(builder, wood, panel);
    }
    let inner = Case { body: case.inset(0.04 - SINK, 0.0, 0.0), foot, head: case.high.y - 0.03 };
    let z = [case.low.z + 0.04, case.high.z - 0.08];
    inner.fill(builder, sampler, Slot::Glass, z);
    builder
        .cuboid(Slot::Lamp, inner.body.slab(Side::Above, 0.02).inset(0.06, 0.0, 0.3).moved(0.0, -0.012, 0.0));
    let doors = case.without(Side::Below, foot + 0.004).without(Side::Above, 0.004).inset(0.006, 0.0, 0.0);
    for (index, door) in doors.columns(2, 0.006).into_iter().enumerate() {
        let door = door.with_z([case.high.z - 0.03, case.high.z + 0.006]);
        framed_pane(builder, wood, door, 0.06);
        let x = if index == 0 { door.high.x - 0.03 } else { door.low.x + 0.03 };
        handle(
            builder,
            Slot::Brass,
            HandleForm { kind: HandleKind::Upright, length: 0.16 },
            DVec3::new(x, door.center().y, door.high.z),
            0.022,
        );
    }
}

/// A pane in a frame of a width.
fn framed_pane(builder: &mut Builder, slot: Slot, door: Bay, frame: f64) {
    for side in [Side::Left, Side::Right] {
        builder.cuboid(slot, door.slab(side, frame));
    }
    let inner = door.inset(frame - SINK, 0.0, 0.0015);
    for side in [Side::Below, Side::Above] {
        builder.cuboid(slot, inner.slab(side, frame).inset(0.0, 0.0008, 0.0));
    }
    builder.cuboid(Slot::Glass, inner.inset(0.0, frame - SINK * 2.0, door.depth() * 0.36));
}

/// Posts of angle with wire shelves behind sliding panes, under a box with the motor and its grille.
fn motor_on_top(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let high = bay.height();
    let top = high * 0.83;
    let frame = bay.with_y([0.0, top + SINK]).inset(0.006, 0.0, 0.006);
    legs_at_corners(builder, Slot::MetalDark, frame, 0.05, LegKind::Square);
    let motor = bay.with_y([top - 0.004, high]);
    builder.block(Slot::Metal, motor, 0.01);
    for slot in motor.inset(bay.width() * 0.1, 0.06, 0.0).rows(6, 0.018) {
        builder.cuboid(Slot::MetalDark, slot.with_z([motor.high.z - 0.006, motor.high.z + 0.003]));
    }
    let floor = frame.with_y([0.14, 0.2]).inset(0.012, 0.0, 0.012);
    builder.cuboid(Slot::MetalDark, floor);
    builder.cuboid(
        Slot::Metal,
        frame.slab(Side::Back, 0.02).with_y([0.18, top]).inset(0.049, 0.0, 0.0).moved(0.0, 0.0, 0.014),
    );
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            Slot::Glass,
            frame.slab(side, 0.008).with_y([0.19, top]).inset(0.012, 0.0, 0.049).moved(
                if side == Side::Left { 0.012 } else { -0.012 },
                0.0,
                0.0,
            ),
        );
    }
    let inner = Case { body: frame.inset(0.035, 0.0, 0.0), foot: 0.19, head: top };
    inner.fill(builder, sampler, Slot::Metal, [frame.low.z + 0.04, frame.high.z - 0.09]);
    builder.cuboid(
        Slot::Lamp,
        frame
            .inset(0.08, 0.0, 0.0)
            .with_y([top - 0.02, top + SINK])
            .with_z([frame.high.z - 0.14, frame.high.z - 0.11]),
    );
    sliding_panes(builder, frame.with_y([0.2 - SINK, top]).inset(0.048, 0.0, 0.0));
    let pipe = [0.3, 0.36].map(|share| DVec3::new(share * bay.width(), 0.1, bay.low.z + 0.004));
    for at in pipe {
        builder.add(
            Slot::Brass,
            sweep(&[at, DVec3::new(at.x, top + 0.02, at.z)], 0.006, 6).moved(0.0, 0.0, 0.004),
        );
    }
}

/// Two panes that slide past each other.
fn sliding_panes(builder: &mut Builder, doors: Bay) {
    for (side, shift) in [(Side::Left, 0.014), (Side::Right, 0.044)] {
        let door = doors.slab(side, doors.width() * 0.53).slab(Side::Front, 0.024).moved(0.0, 0.0, -shift);
        framed_pane(builder, Slot::MetalDark, door, 0.035);
        let x = if side == Side::Left { door.low.x + 0.05 } else { door.high.x - 0.05 };
        let at = DVec3::new(x, door.center().y, door.high.z);
        handle(
            builder,
            Slot::Chrome,
            HandleForm { kind: HandleKind::Upright, length: 0.4 },
            at - DVec3::Z * 0.002,
            0.014,
        );
    }
}

/// An open box with straight walls, a tub at its foot, crates on slanting boards, and a blind rolled up at the top.
fn tub(builder: &mut Builder, sampler: &mut Sampler, slot: Slot) {
    let bay = builder.bay();
    let high = bay.height();
    for side in [Side::Left, Side::Right] {
        let (back, front) = (bay.low.z, bay.high.z);
        let cheek = [
            (back, 0.0),
            (front - 0.04, 0.0),
            (front, 0.1 * high),
            (front, 0.34 * high),
            (back + bay.depth() * 0.62, 0.42 * high),
            (back + bay.depth() * 0.62, high),
            (back, high),
        ];
        builder.add(slot, extrude(&cheek.map(DVec2::from), Axis::X, bay.slab(side, 0.035).x()));
    }
    let inner = bay.inset(0.035 - SINK, 0.0, 0.0);
    builder.cuboid(
        Slot::Painted,
        inner.slab(Side::Back, 0.05).with_y([0.1, high - 0.004]).moved(0.0, 0.0, 0.003),
    );
    builder.block(
        slot,
        inner.with_y([0.02, high * 0.2]).without(Side::Back, 0.006).without(Side::Front, 0.03),
        0.02,
    );
    builder.cuboid(
        Slot::PlasticDark,
        inner.slab(Side::Front, 0.024).with_y([high * 0.12, high * 0.31]).moved(0.0, 0.0, -0.008),
    );
    builder.cuboid(
        Slot::Metal,
        inner.slab(Side::Front, 0.04).with_y([high * 0.31 - SINK, high * 0.33]).moved(0.0, 0.0, -0.002),
    );
    let reach = bay.low.z + bay.depth() * 0.6;
    let bin = inner.with_y([high * 0.2 - SINK, high * 0.3]).with_z([reach + 0.02, bay.high.z - 0.06]);
    row_of_goods(builder, sampler, bin.inset(0.02, 0.0, 0.0));
    let case = Case { body: inner, foot: high * 0.2, head: high * 0.9 };
    case.fill(builder, sampler, Slot::Laminate, [bay.low.z + 0.05, reach - 0.03]);
    builder.cuboid(slot, inner.with_y([high * 0.9, high - 0.002]).with_z([bay.low.z + 0.05, reach - 0.06]));
    let blind = across(0.045, inner.inset(-SINK, 0.0, 0.0).x(), 10);
    builder.add(Slot::FabricLight, blind.moved(0.0, high * 0.94, reach - 0.02));
    builder
        .cuboid(Slot::Metal, inner.with_y([high * 0.885, high * 0.897]).with_z([reach - 0.03, reach - 0.01]));
}
