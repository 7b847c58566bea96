//! What hangs on the walls of bathrooms.

use glam::DVec3;

use super::input::{Draft, GeometrySet};
use super::parts::turned_forward;
use crate::catalog::Side;
use crate::model::kit::{Bay, Builder, SINK, cylinder, sweep};

/// A rail on a wall with a towel over it; a ladder of rails where it is high.
pub(super) fn towel_rail(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let radius = 0.009_f64.min(bay.depth() * 0.15);
    let z = bay.high.z - bay.depth() * 0.3;
    let rows = (bay.height() / 0.18).round().clamp(1.0, 8.0) as u32;
    let is_ladder = rows > 3;
    if is_ladder {
        for side in [Side::Left, Side::Right] {
            let post = bay.slab(side, radius * 2.0).center();
            builder.add("chrome", cylinder(radius, bay.y(), 8).moved(post.x, 0.0, z));
            let bracket = Bay::new(
                [post.x - radius * 0.6, post.x + radius * 0.6],
                [bay.high.y * 0.85, bay.high.y * 0.85 + radius],
                [bay.low.z, z],
            );
            builder.cuboid("chrome", bracket);
        }
        for row in bay.inset(0.0, 0.03, 0.0).rows(rows, 0.0) {
            let bar = [
                DVec3::new(bay.low.x + radius, row.center().y, z),
                DVec3::new(bay.high.x - radius, row.center().y, z),
            ];
            builder.add("chrome", sweep(&bar, radius * 0.75, 6));
        }
    } else {
        let y = bay.high.y - bay.height() * 0.12;
        let back = bay.low.z;
        let path = [
            DVec3::new(bay.low.x + radius, y, back),
            DVec3::new(bay.low.x + radius, y, z),
            DVec3::new(bay.high.x - radius, y, z),
            DVec3::new(bay.high.x - radius, y, back),
        ];
        builder.add("chrome", sweep(&path, radius, 6));
    }
    let y = if is_ladder { bay.high.y * 0.72 } else { bay.high.y };
    let drop = if is_ladder { bay.height() * 0.4 } else { bay.height() };
    let width = (bay.width() * 0.55).min(0.5);
    let x = draft.sampler().between(-0.3, 0.3) * (bay.width() - width) * 0.5;
    let towel =
        Bay::new([x - width / 2.0, x + width / 2.0], [y - drop, y], [z - bay.depth() * 0.2, bay.high.z]);
    let [slot, border] = towel_slots(draft);
    builder.cushion(slot, towel, bay.depth() * 0.2);
    let low = y - drop + (drop * 0.1).min(0.06);
    let strip = towel.inset(-0.0006, 0.0, -0.0006).with_y([low, low + (drop * 0.06).min(0.03)]);
    builder.cuboid(border, strip);
}

/// A paper or soap dispenser on a wall.
pub(super) fn dispenser(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = draft.sampler().pick(&["plastic", "metal"]);
    builder.block(
        slot,
        bay.without(Side::Below, bay.height() * 0.1).without(Side::Front, bay.depth() * 0.06),
        bay.depth() * 0.15,
    );
    let mouth =
        bay.slab(Side::Below, bay.height() * 0.1 + SINK).inset(bay.width() * 0.25, 0.0, bay.depth() * 0.3);
    builder.cuboid("paper", mouth);
    let window =
        bay.inset(bay.width() * 0.42, bay.height() * 0.25, 0.0).slab(Side::Front, bay.depth() * 0.08);
    builder.cuboid("plastic_dark", window);
}

/// Materials of a towel and of its border, which differ so that both show on white.
fn towel_slots(draft: &Draft) -> [&'static str; 2] {
    let form = draft.input.look as usize % 4;
    match draft.set() {
        GeometrySet::Plain => {
            [["fabric_accent", "linen"], ["fabric", "linen"], ["linen", "fabric_accent"], ["leaf", "linen"]]
                [form]
        }
        GeometrySet::Traditional => {
            [["linen", "fabric_accent"], ["book", "brass"], ["fabric_light", "leather"], ["fabric", "linen"]]
                [form]
        }
        GeometrySet::Industrial => [
            ["fabric", "metal_dark"],
            ["leather", "linen"],
            ["concrete", "leather"],
            ["fabric_accent", "linen"],
        ][form],
        GeometrySet::Budget => {
            [["fabric_accent", "plastic"], ["leaf", "paper"], ["book", "paper"], ["paper", "fabric_accent"]]
                [form]
        }
    }
}

/// Metres of a towel's border and of its distance from the hem.
const BORDER: [f64; 2] = [0.02, 0.03];

/// A towel: folded in layers, with a border across, rolled, or folded thin.
pub(super) fn towel(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let [slot, border] = towel_slots(draft);
    if draft.set() == GeometrySet::Industrial {
        rolls(builder, bay, [slot, border]);
        return;
    }
    let most = if draft.set() == GeometrySet::Budget { 2 } else { 3 };
    let count = ((bay.height() / 0.03).round() as u32).clamp(1, most);
    for (index, layer) in bay.rows(count, -0.001).into_iter().enumerate() {
        let back = if index % 2 == 0 { 0.0 } else { bay.width() * 0.015 };
        let slot = if draft.set() == GeometrySet::Plain && index == 1 { border } else { slot };
        let radius = layer.height() * 0.4;
        if index == 0 {
            builder.block(slot, layer.inset(back, 0.0, back), radius);
        } else {
            builder.cushion(slot, layer.inset(back, 0.0, back), radius);
        }
    }
    if draft.set() != GeometrySet::Plain {
        let strip = bay.slab(Side::Above, 0.004).moved(0.0, 0.0006, 0.0).inset(bay.height() * 0.06, 0.0, 0.0);
        let [wide, from] = BORDER;
        let front = bay.high.z - from.min(bay.depth() * 0.3);
        builder.cuboid(border, strip.with_z([front - wide.min(bay.depth() * 0.2), front]));
    }
}

/// Towels rolled up side by side, the end of the roll showing.
fn rolls(builder: &mut Builder, bay: Bay, [slot, border]: [&'static str; 2]) {
    let count = (bay.width() / bay.height()).round().clamp(1.0, 4.0) as u32;
    for cell in bay.columns(count, 0.002) {
        let half = cell.extent() / 2.0;
        for (slot, share, reach) in [(slot, 1.0, half.z - 0.0012), (border, 0.4, half.z)] {
            let roll = turned_forward(cylinder(1.0, [-reach, reach], 10)).stretched(DVec3::new(
                half.x * share,
                half.y * share,
                1.0,
            ));
            let middle = cell.center();
            builder.add(slot, roll.moved(middle.x, middle.y, middle.z));
        }
    }
}
