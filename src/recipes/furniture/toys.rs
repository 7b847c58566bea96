//! Toys: 0.15 to 0.25 m, without small parts (EN 71-1).

use std::f64::consts::FRAC_PI_2;

use glam::{DVec2, DVec3};

use super::parts::turned_forward;
use crate::geometry::Side;
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Slice, Solid, cuboid, cylinder, extrude, lathe, loft, sweep,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// A toy: bricks, a car or rings on a stick; an engine of wood; a robot of tin; a bucket for the sand.
pub(super) static TOY: Recipe = Recipe::accessory("toy", [0.25, 0.2, 0.25]).every_set(toy);

fn toy(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let form = draft.form();
    match draft.set() {
        GeometrySet::Plain => match draft.sampler().count(0, 2) {
            0 => bricks(builder, bay),
            1 => car(builder, bay),
            _ => rings(builder, bay),
        },
        GeometrySet::Traditional if form == 3 => rings(builder, bay),
        GeometrySet::Traditional => engine(builder, bay, form),
        GeometrySet::Industrial if form == 3 => car(builder, bay),
        GeometrySet::Industrial => robot(builder, bay, form),
        GeometrySet::Budget if form == 3 => bricks(builder, bay),
        GeometrySet::Budget => bucket(builder, bay, form),
    }
}

/// A railway engine: a boiler along x, a cab at the left, a funnel, six wheels.
fn engine(builder: &mut Builder, bay: Bay, form: usize) {
    let (slot, boiler) =
        [(Slot::Book, Slot::Wood), (Slot::Wood, Slot::Leaf), (Slot::WoodDark, Slot::PaintedAccent)][form];
    let (width, high, depth) = (bay.width(), bay.high.y, bay.depth());
    let wheel = (high * 0.16).min(width * 0.14);
    let frame = bay.with_y([wheel, wheel + high * 0.12]).inset(0.0, 0.0, depth * 0.155);
    builder.cuboid(slot, frame);
    let radius = (depth * 0.3).min(high * 0.22);
    let middle = frame.high.y + radius * 0.9;
    let drum = cylinder(radius, [-width * 0.14, width * 0.46], 10).turned_z(-FRAC_PI_2);
    builder.add(boiler, drum.moved(0.0, middle, 0.0));
    let cab = Bay::new(
        [-width * 0.46, -width * 0.12],
        [frame.high.y - SINK, high * 0.86],
        [-depth * 0.32, depth * 0.32],
    );
    builder.cuboid(slot, cab);
    let roof = Bay::new(
        [-width * 0.5, -width * 0.08],
        [cab.high.y - SINK, cab.high.y + high * 0.06],
        [-depth * 0.36, depth * 0.36],
    );
    builder.cuboid(Slot::WoodDark, roof);
    let top = middle + radius * 0.9;
    let funnel = [
        (radius * 0.3, top - radius * 0.2),
        (radius * 0.3, high * 0.84),
        (radius * 0.5, high * 0.92),
        (radius * 0.5, high),
    ];
    builder.add(Slot::MetalDark, lathe(&funnel, 8).moved(width * 0.32, 0.0, 0.0));
    for (x, share) in [(-0.32, 1.0), (-0.02, 1.0), (0.28, 1.0)] {
        let disc = turned_forward(cylinder(wheel * share, [0.0, depth * 0.16], 8));
        for z in [-depth / 2.0, depth / 2.0 - depth * 0.16] {
            builder.add(Slot::WoodLight, disc.clone().moved(x * width, wheel, z));
        }
    }
}

/// A robot of tin with lamps on its chest and a key in its back.
fn robot(builder: &mut Builder, bay: Bay, form: usize) {
    let slot = [Slot::Metal, Slot::PaintedAccent, Slot::MetalDark][form];
    let (width, high, depth) = (bay.width(), bay.high.y, bay.depth());
    let part = |x: [f64; 2], y: [f64; 2], z: [f64; 2]| {
        Bay::new(x.map(|share| share * width), y.map(|share| share * high), z.map(|share| share * depth))
    };
    for side in [-1.0, 1.0] {
        let foot = part([0.06, 0.3], [0.0, 0.1], [-0.4, 0.5]);
        let leg = part([0.1, 0.26], [0.09, 0.32], [-0.2, 0.16]);
        let arm = part([0.38, 0.5], [0.3, 0.66], [-0.14, 0.14]);
        let hand = part([0.36, 0.498], [0.24, 0.31], [-0.12, 0.3]);
        for (slot, piece) in [(Slot::MetalDark, foot), (slot, leg), (slot, arm), (Slot::MetalDark, hand)] {
            let solid = cuboid(piece);
            builder.add(slot, if side < 0.0 { solid.mirrored() } else { solid });
        }
    }
    builder.cuboid(slot, part([-0.34, 0.34], [0.3, 0.7], [-0.3, 0.3]));
    let shoulders = part([-0.42, 0.42], [0.56, 0.63], [-0.06, 0.06]);
    builder.cuboid(Slot::MetalDark, shoulders);
    let chest = part([-0.24, 0.24], [0.4, 0.64], [0.29, 0.33]);
    builder.cuboid(Slot::PlasticDark, chest);
    for (index, lamp) in
        chest.inset(width * 0.04, high * 0.08, 0.0).columns(3, width * 0.04).into_iter().enumerate()
    {
        let slot = [Slot::Book, Slot::Brass, Slot::Leaf][index];
        builder.cuboid(slot, lamp.slab(Side::Front, depth * 0.02).moved(0.0, 0.0, depth * 0.012));
    }
    builder.cuboid(slot, part([-0.22, 0.22], [0.72, 0.94], [-0.22, 0.22]));
    builder.cuboid(Slot::MetalDark, part([-0.1, 0.1], [0.69, 0.73], [-0.1, 0.1]));
    for x in [-0.11, 0.11] {
        let eye = turned_forward(cylinder(width * 0.05, [-0.002, depth * 0.04], 6));
        builder.add(Slot::Brass, eye.moved(x * width, high * 0.85, depth * 0.22));
    }
    builder.cuboid(Slot::MetalDark, part([-0.015, 0.015], [0.93, 1.0], [-0.015, 0.015]));
    builder.cuboid(Slot::Brass, part([-0.12, 0.12], [0.46, 0.52], [-0.5, -0.46]));
    builder.cuboid(Slot::Brass, part([-0.02, 0.02], [0.47, 0.51], [-0.48, -0.29]));
}

/// A bucket with its handle up, a spade in it, and a ball beside.
fn bucket(builder: &mut Builder, bay: Bay, form: usize) {
    let slots = [
        [Slot::PaintedAccent, Slot::Brass, Slot::Book],
        [Slot::Book, Slot::Leaf, Slot::Paper],
        [Slot::Leaf, Slot::Book, Slot::PaintedAccent],
    ][form];
    let (width, high, depth) = (bay.width(), bay.high.y, bay.depth());
    let half = (width * 0.34).min(depth * 0.5);
    let (x, z, rim) = (bay.low.x + half, bay.low.z + half, high * 0.62);
    let wall = [
        (half * 0.72, 0.0),
        (half * 0.96, rim * 0.94),
        (half, rim),
        (half * 0.92, rim),
        (half * 0.68, rim * 0.08),
    ];
    builder.add(slots[0], lathe(&wall, 10).moved(x, 0.0, z));
    let bow = [
        (-0.97, rim * 0.94),
        (-0.8, high * 0.84),
        (0.0, high - 0.004),
        (0.8, high * 0.84),
        (0.97, rim * 0.94),
    ];
    let bow = bow.map(|(share, y)| DVec3::new(x + share * half * 0.98, y, z));
    builder.add(Slot::Plastic, sweep(&bow, 0.004, 4));
    let spade = [
        DVec3::new(x + half * 0.3, rim * 0.2, z + half * 0.2),
        DVec3::new(x + half * 0.62, high * 0.88, z + half * 0.3),
    ];
    builder.add(slots[1], sweep(&spade, 0.006, 5));
    let grip = Bay::around(spade[1], half * 0.44, 0.012, 0.012);
    builder.cuboid(slots[1], grip);
    ball(builder, slots[2], bay.high.x, bay.high.z);
}

/// A ball on the floor in a corner.
fn ball(builder: &mut Builder, slot: Slot, right: f64, front: f64) {
    let radius = (right * 0.36).min(front * 0.5);
    let ring = |turn: f64| {
        let (sine, cosine) = libm::sincos(turn);
        (radius * sine, radius * (1.0 - cosine))
    };
    let profile: Vec<(f64, f64)> = [0.5, 1.05, 1.57, 2.1, 2.64].into_iter().map(ring).collect();
    builder.add(slot, sphere(&profile, radius).moved(right - radius, 0.0, front - radius));
}

/// A round body with both ends closed by tips.
fn sphere(profile: &[(f64, f64)], radius: f64) -> Solid {
    let mut closed = vec![(0.0, 0.0)];
    closed.extend_from_slice(profile);
    closed.push((0.0, radius * 2.0));
    lathe(&closed, 8)
}

const TOY_COLORS: [Slot; 4] = [Slot::FabricAccent, Slot::PaintedAccent, Slot::Leaf, Slot::Book];

fn bricks(builder: &mut Builder, bay: Bay) {
    let lower = bay.slab(Side::Below, bay.height() * 0.36);
    for (index, column) in lower.columns(2, bay.width() * 0.08).into_iter().enumerate() {
        builder.block(TOY_COLORS[index], column, 0.004);
    }
    let middle = bay.with_y([lower.high.y - SINK, bay.height() * 0.7]).inset(
        bay.width() * 0.2,
        0.0,
        bay.depth() * 0.12,
    );
    builder.block(TOY_COLORS[2], middle, 0.004);
    let top =
        bay.with_y([bay.height() * 0.7 - SINK, bay.high.y]).inset(bay.width() * 0.28, 0.0, bay.depth() * 0.3);
    let roof = [(top.low.x, top.low.y), (top.high.x, top.low.y), (0.0, top.high.y)].map(DVec2::from);
    builder.add(TOY_COLORS[3], extrude(&roof, Axis::Z, top.z()));
}

fn car(builder: &mut Builder, bay: Bay) {
    let wheel = (bay.height() * 0.2).min(bay.width() * 0.18);
    let body = bay.with_y([wheel * 0.7, bay.height() * 0.6]).inset(0.0, 0.0, bay.depth() * 0.06);
    builder.block(TOY_COLORS[0], body, bay.height() * 0.06);
    let cabin = body.with_y([bay.height() * 0.6 - SINK, bay.high.y]).inset(
        bay.width() * 0.22,
        0.0,
        bay.depth() * 0.04,
    );
    builder.block(Slot::Glass, cabin.without(Side::Above, cabin.height() * 0.2), bay.height() * 0.04);
    builder.block(TOY_COLORS[0], cabin.slab(Side::Above, cabin.height() * 0.2 + SINK), bay.height() * 0.03);
    for x in [-0.3, 0.3] {
        for (z, out) in [(bay.low.z, 0.0), (bay.high.z - bay.depth() * 0.16, 0.0)] {
            let disc = turned_forward(cylinder(wheel, [0.0, bay.depth() * 0.16], 10));
            builder.add(Slot::Rubber, disc.moved(x * bay.width(), wheel, z + out));
        }
    }
}

fn rings(builder: &mut Builder, bay: Bay) {
    let half = bay.extent() / 2.0;
    builder.add(
        Slot::WoodLight,
        loft(
            &Outline::Round(12),
            &[Slice::new(0.0, half.x, half.z), Slice::new(bay.height() * 0.1, half.x, half.z)],
        ),
    );
    for (index, row) in
        bay.with_y([bay.height() * 0.1 - SINK, bay.height() * 0.88]).rows(4, -SINK).into_iter().enumerate()
    {
        let shrink = 0.92 - 0.17 * index as f64;
        let slices = [(0.0, 0.88), (0.5, 1.0), (1.0, 0.88)];
        let slices = slices.map(|(share, bulge)| {
            Slice::new(row.low.y + share * row.height(), half.x * shrink * bulge, half.z * shrink * bulge)
        });
        builder.add(TOY_COLORS[index], loft(&Outline::Round(8), &slices));
    }
    let knob = half.x * 0.22;
    builder.add(
        Slot::WoodLight,
        lathe(
            &[(knob * 0.6, bay.height() * 0.87), (knob, bay.height() * 0.94), (knob * 0.5, bay.height())],
            8,
        ),
    );
}
