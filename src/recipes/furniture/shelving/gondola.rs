//! Shelves of shops, 1.4 to 1.8 m high.

use glam::{DVec2, DVec3};

use crate::geometry::Side;
use crate::recipes::furniture::parts::{LegKind, legs_at_corners};
use crate::recipes::kit::{Axis, Bay, Builder, SINK, Sampler, extrude, lathe, sweep};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot, Symbol};

/// A shop's shelf full of goods: a foot with a kick plate under a back of sheet; crates on a stand of wood; baskets of wire;
/// sheets on slotted posts.
pub(in super::super) static GONDOLA: Recipe =
    Recipe::furniture("gondola", [1.0, 0.45, 1.4]).symbol(Symbol::Net).every_set(gondola);

fn gondola(draft: &Draft, builder: &mut Builder) {
    let mut sampler = draft.sampler();
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => on_foot(builder, &mut sampler, form),
        GeometrySet::Traditional => crates(builder, &mut sampler, form),
        GeometrySet::Industrial => baskets(builder, &mut sampler),
        GeometrySet::Budget => slotted(builder, &mut sampler, form),
    }
}

fn on_foot(builder: &mut Builder, sampler: &mut Sampler, form: usize) {
    let (bay, slot) = (builder.bay(), Slot::Painted);
    let base = (bay.height() * 0.1).min(0.16);
    builder.block(slot, bay.slab(Side::Below, base).without(Side::Front, 0.01), 0.004);
    builder.cuboid(
        Slot::PlasticDark,
        bay.slab(Side::Below, base * 0.6).inset(0.004, 0.001, 0.0).slab(Side::Front, 0.0105),
    );
    builder.block(
        slot,
        bay.slab(Side::Below, base)
            .inset(0.001, 0.001, 0.0)
            .slab(Side::Front, 0.03)
            .slab(Side::Above, base * 0.35),
        0.003,
    );
    let back = bay.slab(Side::Back, 0.03).without(Side::Below, base - SINK);
    builder.cuboid(slot, back.inset(0.002, 0.0, 0.0));
    let crown = if form.is_multiple_of(2) { 0.12_f64.min(bay.height() * 0.08) } else { 0.0 };
    if crown > 0.0 {
        let sign = bay.slab(Side::Above, crown).inset(0.004, 0.002, 0.0).slab(Side::Back, 0.05);
        builder.cuboid(Slot::PaintedAccent, sign.without(Side::Back, 0.02));
    }
    for side in [Side::Left, Side::Right] {
        builder.cuboid(
            Slot::Metal,
            back.inset(0.001, 0.0, 0.0).slab(side, 0.03).without(Side::Above, 0.003).moved(0.0, 0.0, 0.006),
        );
    }
    let space =
        bay.without(Side::Below, base - 0.012).without(Side::Above, crown).without(Side::Back, 0.03 - SINK);
    let count = (space.height() / [0.34, 0.42, 0.3, 0.38][form]).round().clamp(2.0, 6.0) as u32;
    for (index, row) in space.rows(count, 0.0).into_iter().enumerate() {
        let deep = if index == 0 { row.depth() - 0.012 } else { row.depth() * 0.86 };
        let row = row.slab(Side::Back, deep);
        if index > 0 {
            builder.cuboid(slot, row.slab(Side::Below, 0.02));
            let strip = row.slab(Side::Below, 0.034).slab(Side::Front, 0.006).moved(0.0, -0.004, 0.003);
            builder.cuboid(Slot::Paper, strip.inset(0.006, 0.0, 0.0));
        }
        let floor = if index > 0 { 0.02 - SINK } else { 0.012 - SINK };
        goods(
            builder,
            sampler,
            row.without(Side::Below, floor).without(Side::Above, 0.04).inset(0.012, 0.0, 0.008),
        );
    }
}

/// Goods in blocks of one kind: cartons, bottles, jars.
fn goods(builder: &mut Builder, sampler: &mut Sampler, shelf: Bay) {
    for cell in shelf.columns((shelf.width() / 0.28).round().clamp(2.0, 5.0) as u32, 0.012) {
        let tall = shelf.height() * sampler.between(0.5, 0.92);
        let block = cell.slab(Side::Below, tall).without(Side::Back, sampler.between(0.0, 0.06));
        let slot = sampler.pick(&[
            Slot::PaintedAccent,
            Slot::Paper,
            Slot::Book,
            Slot::Plastic,
            Slot::Leaf,
            Slot::Glass,
            Slot::Terracotta,
        ]);
        let count = sampler.count(2, 4);
        if sampler.chance(0.5) {
            for carton in block.columns(count, 0.004) {
                builder.cuboid(slot, carton.slab(Side::Front, carton.depth() * 0.6));
            }
            continue;
        }
        for jar in block.columns(count, 0.006) {
            let middle = jar.center();
            let radius = (jar.width() / 2.0).min(jar.depth() / 2.0).min(0.045);
            let at = |share: f64, rise: f64| (radius * share, jar.low.y + rise * jar.height());
            let body = lathe(&[at(1.0, 0.0), at(1.0, 0.62), at(0.42, 0.8), at(0.42, 1.0)], 6);
            builder.add(slot, body.moved(middle.x, 0.0, jar.high.z - radius - 0.01));
        }
    }
}

/// Crates that slope towards the buyer, on a stand of wood under a striped valance.
fn crates(builder: &mut Builder, sampler: &mut Sampler, form: usize) {
    let bay = builder.bay();
    let wood = [Slot::Wood, Slot::WoodLight, Slot::WoodDark, Slot::Wood][form];
    let (post, high) = (0.045, bay.height());
    for side in [Side::Left, Side::Right] {
        let end = bay.slab(side, post);
        builder.cuboid(wood, end.slab(Side::Back, post).with_y([0.0, high - 0.004]));
        builder.cuboid(wood, end.slab(Side::Front, post).with_y([0.0, high * 0.3]));
        builder.cuboid(wood, end.inset(0.008, 0.0, 0.01).with_y([0.06, 0.12]));
    }
    let inner = bay.inset(post * 0.6, 0.0, 0.0);
    builder.cuboid(
        wood,
        inner.slab(Side::Back, 0.016).moved(0.0, 0.0, 0.012).with_y([high * 0.12, high - 0.03]),
    );
    let tiers = (high / 0.42).round().clamp(2.0, 4.0) as u32;
    let shelf = bay.with_y([0.08, high * 0.9]);
    for (index, row) in shelf.rows(tiers, 0.0).into_iter().enumerate() {
        let deep = bay.depth() * (0.92 - 0.36 * index as f64 / f64::from(tiers));
        let zone = row.slab(Side::Back, deep).without(Side::Back, 0.03).inset(post * 0.7, 0.0, 0.0);
        for (place, cell) in
            zone.columns((bay.width() / 0.46).round().clamp(1.0, 4.0) as u32, 0.016).into_iter().enumerate()
        {
            crate_of_fruit(builder, sampler, wood, cell, place);
        }
    }
    let valance = bay.slab(Side::Above, 0.14).slab(Side::Back, 0.06).without(Side::Back, 0.002);
    builder.cuboid(wood, valance.slab(Side::Above, 0.02).inset(0.002, 0.0, 0.0));
    let stripes = valance.slab(Side::Front, 0.008).without(Side::Above, 0.02 - SINK).inset(0.004, 0.0, 0.0);
    let count = (bay.width() / 0.1).round().clamp(4.0, 20.0) as u32;
    for (index, stripe) in stripes.columns(count, 0.0012).into_iter().enumerate() {
        let slot = if index % 2 == 0 { Slot::Leaf } else { Slot::Linen };
        builder.cuboid(slot, stripe.moved(0.0, 0.0, -0.004).without(Side::Below, 0.012 * (index % 2) as f64));
    }
}

/// A crate whose front is lower than its back, with round goods in it.
fn crate_of_fruit(builder: &mut Builder, sampler: &mut Sampler, wood: Slot, cell: Bay, place: usize) {
    let (drop, wall) = ((cell.height() * 0.3).min(0.12), (cell.height() * 0.3).min(0.1));
    let (low, back, front) = (cell.low.y, cell.low.z, cell.high.z);
    let side =
        [(back, low + drop), (front, low), (front, low + wall), (back, low + drop + wall)].map(DVec2::from);
    for x in [[cell.low.x, cell.low.x + 0.012], [cell.high.x - 0.012, cell.high.x]] {
        builder.add(wood, extrude(&side, Axis::X, x));
    }
    let floor = [
        (back + 0.001, low + drop + 0.002),
        (front - 0.001, low + 0.002),
        (front - 0.001, low + wall * 0.6),
        (back + 0.001, low + drop + wall * 0.6),
    ];
    let slot = sampler.pick(&[Slot::Leaf, Slot::Book, Slot::Brass, Slot::Terracotta, Slot::Leaf]);
    let inner = [cell.low.x + 0.012 - SINK, cell.high.x - 0.012 + SINK];
    builder.add(Slot::WoodLight, extrude(&floor.map(DVec2::from), Axis::X, inner));
    builder.cuboid(
        wood,
        cell.with_y([low - 0.004, low + wall + 0.004])
            .slab(Side::Front, 0.012)
            .inset(0.001, 0.0, 0.0)
            .moved(0.0, 0.0, 0.01),
    );
    let columns = (cell.width() / 0.11).floor().clamp(1.0, 4.0) as u32;
    let rows = (cell.depth() / 0.12).floor().clamp(1.0, 3.0) as u32;
    for row in 0..rows {
        for (index, column) in cell.inset(0.02, 0.0, 0.0).columns(columns, 0.0).into_iter().enumerate() {
            let share = (f64::from(row) + 0.5) / f64::from(rows);
            let radius = 0.042 + 0.004 * ((index + place + row as usize) % 3) as f64;
            let y = low + drop * (1.0 - share) + wall * 0.6 + radius * 0.5;
            let fruit = [(0.0, -1.0), (0.95, -0.42), (0.95, 0.36), (0.0, 0.95)];
            let fruit = lathe(&fruit.map(|(share, y)| (share * radius, y * radius)), 6);
            builder.add(slot, fruit.moved(column.center().x, y, back + share * cell.depth()));
        }
    }
}

/// Wire baskets on angles with holes, over crossed rods.
fn baskets(builder: &mut Builder, sampler: &mut Sampler) {
    let bay = builder.bay();
    let high = bay.height();
    legs_at_corners(builder, Slot::MetalDark, bay, 0.04, LegKind::Angle);
    let z = bay.low.z + 0.012;
    for ends in [[0.08, 0.92], [0.92, 0.08]] {
        let x = bay.high.x - 0.02;
        let rod = [DVec3::new(-x, ends[0] * high, z), DVec3::new(x, ends[1] * high, z)];
        let shift = if ends[0] > 0.5 { 0.009 } else { 0.0 };
        builder.add(Slot::Metal, sweep(&rod, 0.005, 6).moved(0.0, 0.0, shift));
    }
    let tiers = (high / 0.38).round().clamp(2.0, 4.0) as u32;
    for row in bay.inset(0.012, 0.0, 0.012).without(Side::Below, 0.05).rows(tiers, 0.0) {
        let basket = row.without(Side::Back, 0.02).slab(Side::Below, (row.height() * 0.42).min(0.16));
        wires(builder, basket.slab(Side::Front, 0.006).inset(0.0015, 0.0, 0.0));
        for edge in [Side::Above, Side::Below] {
            builder.cuboid(
                Slot::Metal,
                basket.slab(Side::Back, 0.006).slab(edge, 0.008).inset(0.0015, 0.0, 0.0),
            );
        }
        for side in [Side::Left, Side::Right] {
            let end = basket.slab(side, 0.006).inset(0.0, 0.0, 0.005);
            builder.cuboid(Slot::Metal, end.slab(Side::Above, 0.008).inset(0.0, 0.0008, 0.0));
            builder.cuboid(Slot::Metal, end.slab(Side::Below, 0.008).inset(0.0, 0.0008, 0.0));
        }
        let floor = basket.slab(Side::Below, 0.006).inset(0.003, 0.0012, 0.003);
        builder.cuboid(Slot::Metal, floor);
        let inside = row
            .without(Side::Back, 0.02)
            .without(Side::Below, 0.006)
            .without(Side::Above, 0.08)
            .inset(0.02, 0.0, 0.02);
        goods(builder, sampler, inside);
    }
}

/// A side of a basket: two bars and wires between them.
fn wires(builder: &mut Builder, side: Bay) {
    builder.cuboid(Slot::Metal, side.slab(Side::Above, 0.008));
    builder.cuboid(Slot::Metal, side.slab(Side::Below, 0.008));
    let count = (side.width() / 0.2).round().clamp(3.0, 6.0) as u32;
    let gap = (side.width() - 0.005 * f64::from(count)) / f64::from(count.max(2) - 1);
    for wire in side.inset(0.001, 0.007, 0.001).columns(count, gap) {
        builder.cuboid(Slot::Metal, wire);
    }
}

/// Thin sheets hooked into two slotted posts on feet like a T; a board with the prices on top.
fn slotted(builder: &mut Builder, sampler: &mut Sampler, form: usize) {
    let bay = builder.bay();
    let high = bay.height();
    let slot = [Slot::Laminate, Slot::Painted, Slot::PaintedAccent, Slot::Laminate][form];
    for side in [Side::Left, Side::Right] {
        let post = bay.inset(bay.width() * 0.1, 0.0, 0.0).slab(side, 0.03);
        builder.cuboid(
            Slot::Metal,
            post.slab(Side::Back, 0.05).with_y([0.03, high * 0.94]).moved(0.0, 0.0, 0.002),
        );
        builder.block(Slot::Metal, post.inset(-0.006, 0.0, 0.0).with_y([0.0, 0.035]), 0.004);
        for hole in 0..8 {
            let y = high * (0.14 + 0.1 * f64::from(hole));
            let at = DVec3::new(post.center().x, y, bay.low.z + 0.052);
            builder.cuboid(Slot::PlasticDark, Bay::around(at, 0.01, 0.03, 0.002));
        }
    }
    let sign = bay.slab(Side::Above, 0.13).inset(bay.width() * 0.06, 0.0, 0.0).slab(Side::Back, 0.04);
    builder.block(Slot::PaintedAccent, sign.without(Side::Back, 0.006), 0.006);
    let text = sign.slab(Side::Front, 0.004).inset(0.06, 0.035, 0.0).moved(0.0, 0.0, 0.0016);
    builder.cuboid(Slot::Paper, text.with_x([text.low.x, text.low.x + text.width() * 0.6]));
    let tiers = (high / 0.34).round().clamp(2.0, 5.0) as u32;
    let space = bay.without(Side::Below, 0.08).without(Side::Above, 0.15).without(Side::Back, 0.05 - SINK);
    for (index, row) in space.rows(tiers, 0.0).into_iter().enumerate() {
        let shelf = row.slab(Side::Back, row.depth() * if index == 0 { 0.98 } else { 0.8 });
        builder.cuboid(slot, shelf.slab(Side::Below, 0.008));
        let lip = shelf.slab(Side::Front, 0.003).with_y([shelf.low.y - 0.024, shelf.low.y + 0.012]);
        builder.cuboid(Slot::Paper, lip.inset(0.001, 0.0, 0.0).moved(0.0, 0.0, 0.002));
        for side in [Side::Left, Side::Right] {
            let bracket = shelf.inset(bay.width() * 0.1 + 0.002, 0.0, 0.0).slab(side, 0.006);
            let (y, z) = (shelf.low.y + SINK, shelf.low.z);
            let profile =
                [(z, y - 0.05), (z + shelf.depth() * 0.7, y - 0.012), (z + shelf.depth() * 0.7, y), (z, y)];
            builder.add(Slot::Metal, extrude(&profile.map(DVec2::from), Axis::X, bracket.x()));
        }
        goods(
            builder,
            sampler,
            shelf.without(Side::Below, 0.008 - SINK).without(Side::Above, 0.07).inset(0.02, 0.0, 0.01),
        );
    }
}
