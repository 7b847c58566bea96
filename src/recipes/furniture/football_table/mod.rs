//! Table football: tables of cafés are 1.4 to 1.5 m long, 0.75 wide over the grips and 0.9 high; the field is 1.2 m by
//! 0.7, with eight rods of 16 mm and eleven figures a team (ITSF).

mod bodies;

use glam::DVec3;

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{Bay, Builder, Outline, SINK, Slice, Solid, cylinder, lathe, loft, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres of the side boards.
const WALL: f64 = 0.035;
/// Metres of the field under the rim.
const SUNK: f64 = 0.16;
/// Figures on each rod, from one goal to the other; each team has four rods.
const FIGURES: [u32; 8] = [1, 2, 3, 5, 5, 3, 2, 1];

/// Rods with figures and grips over a green field: a shallow body on splayed legs; a cabinet with a moulded rim on turned
/// legs; planks between angles of steel; a box on two panels.
pub(super) static FOOTBALL_TABLE: Recipe =
    Recipe::furniture("football_table", [1.4, 0.75, 0.9]).every_set(football_table);

fn football_table(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let set = draft.set();
    // The rods stick out to the players, along z.
    let grips = (bay.depth() * 0.16).min(0.12);
    // What stands out of the ends of a body has room there.
    let aside = if matches!(set, GeometrySet::Traditional | GeometrySet::Budget) { 0.03 } else { 0.0 };
    let body = bay.inset(aside, 0.0, grips);
    let field = bay.high.y - SUNK;
    let low = match set {
        GeometrySet::Plain => bodies::splayed(builder, body, look),
        GeometrySet::Traditional => bodies::cabinet(builder, body, look),
        GeometrySet::Industrial => bodies::planks(builder, body, look),
        GeometrySet::Budget => bodies::panels(builder, body, look),
    };
    goals(builder, body, field);
    let floor = body.inset(WALL, 0.0, WALL - SINK * 2.0).with_y([low + 0.02, field]);
    markings(builder, floor);
    for rod in 0..FIGURES.len() {
        let x = body.low.x + body.width() * (rod as f64 + 1.0) / (FIGURES.len() as f64 + 1.0);
        let rod = Rod { number: rod, x, grips };
        self::rod(builder, floor, &rod, set == GeometrySet::Traditional);
    }
}

/// Boards around the field, from a height to the rim.
fn boards(builder: &mut Builder, slot: Slot, body: Bay, [low, high]: [f64; 2]) {
    for side in [Side::Front, Side::Back] {
        builder.block(slot, body.slab(side, WALL).with_y([low, high]), 0.004);
    }
    for side in [Side::Left, Side::Right] {
        let end = body.slab(side, WALL * 1.6).inset(0.0, 0.0, WALL - SINK);
        builder.cuboid(slot, end.with_y([low + 0.001, high - 0.001]));
    }
}

/// The dark mouths of the goals in the short boards.
fn goals(builder: &mut Builder, body: Bay, field: f64) {
    let inner = body.inset(WALL * 1.6, 0.0, body.depth() * 0.34).with_y([field - 0.002, field + 0.07]);
    builder.cuboid(Slot::PlasticDark, inner.slab(Side::Left, 0.002).moved(-0.0012, 0.0, 0.0));
    builder.cuboid(Slot::PlasticDark, inner.slab(Side::Right, 0.002).moved(0.0012, 0.0, 0.0));
}

/// The green field, its middle line and circle.
fn markings(builder: &mut Builder, floor: Bay) {
    let field = floor.high.y;
    builder.cuboid(Slot::Leaf, floor);
    builder.cuboid(
        Slot::Linen,
        Bay::new([-0.004, 0.004], [field - SINK, field + 0.0008], floor.inset(0.0, 0.0, 0.02).z()),
    );
    let ring = lathe(
        &[(0.09, field - SINK), (0.09, field + 0.0012), (0.082, field + 0.0012), (0.08, field - SINK * 0.4)],
        12,
    );
    builder.add(Slot::Linen, ring);
}

/// A rod of the table.
struct Rod {
    number: usize,
    /// Metres along the table.
    x: f64,
    /// Metres that stick out.
    grips: f64,
}

/// A rod with its grip, turned or straight, and its figures.
fn rod(builder: &mut Builder, floor: Bay, rod: &Rod, is_turned: bool) {
    let &Rod { number: rod, x, grips } = rod;
    let bay = builder.bay();
    let y = floor.high.y + 0.09;
    let is_near = rod.is_multiple_of(2);
    let reach = [
        if is_near { bay.low.z + grips * 0.7 } else { bay.low.z + 0.02 },
        if is_near { bay.high.z - 0.02 } else { bay.high.z - grips * 0.7 },
    ];
    builder.add(Slot::Chrome, sweep(&[DVec3::new(x, y, reach[0]), DVec3::new(x, y, reach[1])], 0.007, 4));
    let long = grips * 0.8;
    let (slot, grip) = if is_turned {
        (Slot::Wood, lathe(&[(0.011, 0.0), (0.018, long * 0.35), (0.013, long * 0.7), (0.018, long)], 6))
    } else {
        (Slot::Rubber, cylinder(0.016, [0.0, long], 6))
    };
    let at = if is_near { bay.high.z - long } else { bay.low.z };
    builder.add(slot, turned_forward(grip).moved(x, y, at));
    let team = if matches!(rod, 0 | 1 | 3 | 5) { Slot::Book } else { Slot::PaintedAccent };
    for figure in 0..FIGURES[rod] {
        let z = floor.low.z + floor.depth() * (f64::from(figure) + 1.0) / (f64::from(FIGURES[rod]) + 1.0);
        builder.add(team, figure_at(y).moved(x, 0.0, z));
    }
}

/// A figure on a rod at a height: feet, body, shoulders, head.
fn figure_at(y: f64) -> Solid {
    let man = [
        Slice::new(y - 0.075, 0.01, 0.014),
        Slice::new(y - 0.055, 0.008, 0.012),
        Slice::new(y + 0.028, 0.014, 0.022),
        Slice::new(y + 0.03, 0.009, 0.009),
        Slice::new(y + 0.052, 0.009, 0.009),
    ];
    loft(&Outline::Square, &man)
}
