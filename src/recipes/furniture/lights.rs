//! Lamps that hang, and the parts of all lamps.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use crate::recipes::kit::{
    Bay, Builder, Outline, SINK, Slice, Solid, cylinder, lathe, loft, loft_ring, sweep,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Corners of shades and feet.
pub(super) const SIDES: usize = 12;
/// Metres of a flex.
const FLEX: f64 = 0.004;

/// A lamp shade, open above and below, by radii and heights.
pub(super) fn shade(radii: [f64; 2], y: [f64; 2]) -> Solid {
    tube(&Outline::Round(SIDES), radii, y)
}

/// A shade of cloth in pleats: its outline is a star of an even number of corners.
pub(super) fn pleated(radii: [f64; 2], y: [f64; 2], corners: usize) -> Solid {
    let corner = |step: usize| {
        let (sine, cosine) = libm::sincos(TAU * step as f64 / corners as f64);
        DVec2::new(cosine, -sine) * if step.is_multiple_of(2) { 1.0 } else { 0.93 }
    };
    tube(&Outline::Points((0..corners).map(corner).collect()), radii, y).smooth(20.0)
}

fn tube(outline: &Outline, radii: [f64; 2], y: [f64; 2]) -> Solid {
    let wall = 0.004_f64.min(radii[0].min(radii[1]) * 0.1);
    let slices = [
        Slice::round(y[0], radii[0]),
        Slice::round(y[1], radii[1]),
        Slice::round(y[1], radii[1] - wall),
        Slice::round(y[0], radii[0] - wall),
    ];
    loft_ring(outline, &slices)
}

/// A ball by its middle, cut off below and above at shares of its radius.
pub(super) fn globe(middle: f64, radius: f64, ends: [f64; 2], sides: usize) -> Solid {
    let steps = 5;
    let slice = |step: usize| {
        let rise = ends[0] + (ends[1] - ends[0]) * step as f64 / f64::from(steps);
        (radius * libm::sqrt((1.0 - rise * rise).max(0.0)).max(0.08), middle + radius * rise)
    };
    lathe(&(0..=steps as usize).map(slice).collect::<Vec<_>>(), sides)
}

/// A bulb with its socket above (+1) or below (−1) it.
pub(super) fn bulb(builder: &mut Builder, middle: DVec3, radius: f64, socket: f64) {
    let half = [(0.0, -1.0), (0.8, -0.55), (0.95, 0.1), (0.5, 0.85), (0.32, 1.2)];
    let profile = half.map(|(share, rise)| (share * radius, rise * radius * socket));
    builder.add(Slot::Lamp, lathe(&profile, 6).moved(middle.x, middle.y, middle.z));
    let ends = [1.15 * radius * socket, 2.2 * radius * socket];
    let ends = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    builder.add(Slot::MetalDark, cylinder(radius * 0.45, ends, 6).moved(middle.x, middle.y, middle.z));
}

/// A cage of wires around a bulb: `ribs` meridians and a ring, hanging from its top.
pub(super) fn cage(builder: &mut Builder, slot: Slot, radius: f64, y: [f64; 2], ribs: u32) {
    let (low, high) = (y[0], y[1]);
    let tall = high - low;
    let wire = (radius * 0.04).clamp(0.0015, 0.003);
    for rib in 0..ribs {
        let (sine, cosine) = libm::sincos(TAU * f64::from(rib) / f64::from(ribs));
        let at = |share: f64, y: f64| {
            DVec3::new(cosine * (radius - wire) * share, y, sine * (radius - wire) * share)
        };
        let path =
            [at(0.12, low + wire), at(1.0, low + tall * 0.3), at(1.0, low + tall * 0.55), at(0.3, high)];
        builder.add(slot, sweep(&path, wire, 3));
    }
    let ring = |y: f64| tube(&Outline::Round(8), [radius, radius], [y, y + wire * 2.5]);
    builder.add(slot, ring(low + tall * 0.42));
}

/// A lamp flat under the ceiling: a bowl of glass, a drum, a bulkhead with a guard, or a plastic dish.
pub(super) static CEILING_LAMP: Recipe = Recipe::accessory("ceiling_lamp", [0.4, 0.4, 0.12])
    .plain(bowl_on_rim)
    .traditional(moulded_bowl)
    .industrial(|draft, builder| bulkhead(builder, draft.form()))
    .budget(dish_in_clips);

/// Slices of a round lamp: shares of the box's height and width.
fn slices_of<const N: usize>(bay: Bay, shares: [(f64, f64); N]) -> [Slice; N] {
    let half = bay.extent() / 2.0;
    shares.map(|(rise, shrink)| Slice::new(rise * bay.height(), half.x * shrink, half.z * shrink))
}

/// A round body of a lamp.
fn round_body<const N: usize>(bay: Bay, sides: usize, shares: [(f64, f64); N]) -> Solid {
    loft(&Outline::Round(sides), &slices_of(bay, shares))
}

/// A bowl of glass, or a flat pane, in a rim.
fn bowl_on_rim(draft: &Draft, builder: &mut Builder) {
    let (bay, look) = (builder.bay(), draft.form());
    let slot = [Slot::Metal, Slot::Painted, Slot::MetalDark, Slot::WoodLight][look];
    let low = if look.is_multiple_of(2) { 0.08 } else { 0.0 };
    builder.add(slot, round_body(bay, 16, [(low, 0.99), (low + 0.04, 1.0), (1.0, 1.0)]));
    let glass = if low > 0.0 {
        round_body(bay, 16, [(0.0, 0.86), (0.1, 0.92), (0.3, 0.94)])
    } else {
        round_body(bay, 16, [(0.0, 0.72), (0.06, 0.74)]).moved(0.0, -0.0004, 0.0)
    };
    builder.add(Slot::Lamp, glass);
}

/// A bowl under a moulded plate, with a finial.
fn moulded_bowl(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let slot = [Slot::Brass, Slot::Brass, Slot::WoodDark, Slot::MetalDark][draft.form()];
    let plate = [(0.72, 0.96), (0.76, 1.0), (0.86, 1.0), (0.9, 0.8), (1.0, 0.74)];
    builder.add(slot, round_body(bay, 12, plate));
    builder.add(Slot::Lamp, round_body(bay, 12, [(0.08, 0.3), (0.16, 0.62), (0.42, 0.88), (0.78, 0.93)]));
    let height = bay.height();
    builder.add(slot, lathe(&[(0.004, 0.0), (0.014, height * 0.05), (0.006, height * 0.12)], 8));
}

/// A plastic dish in three clips.
fn dish_in_clips(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let (half, height) = (bay.extent() / 2.0, bay.height());
    builder.add(Slot::Plastic, round_body(bay, 16, [(0.8, 0.8), (1.0, 0.8)]));
    let swell = [0.72, 0.9, 0.6, 0.85][draft.form()];
    let dish = [(0.0, swell * 0.6), (0.14, swell), (0.5, 1.0), (0.86, 0.97)];
    builder.add(Slot::Lamp, round_body(bay, 16, dish));
    for turn in 0..3 {
        let (sine, cosine) = libm::sincos(TAU * f64::from(turn) / 3.0 + 0.4);
        let at = DVec3::new(cosine * half.x * 0.92, height * 0.72, sine * half.z * 0.92);
        builder.cuboid(Slot::Metal, Bay::around(at, half.x * 0.1, height * 0.2, half.x * 0.1));
    }
}

/// A ring of metal around glass with bars before it.
fn bulkhead(builder: &mut Builder, look: usize) {
    let bay = builder.bay();
    let (half, height) = (bay.extent() / 2.0, bay.height());
    let slice = |share: f64, shrink: f64| Slice::new(share * height, half.x * shrink, half.z * shrink);
    let slot = [Slot::MetalDark, Slot::Metal, Slot::PaintedAccent, Slot::MetalDark][look];
    builder.add(
        slot,
        loft(&Outline::Round(16), &[slice(0.5, 1.0), slice(0.6, 1.0), slice(0.65, 0.94), slice(1.0, 0.94)]),
    );
    builder
        .add(Slot::Lamp, loft(&Outline::Round(12), &[slice(0.1, 0.4), slice(0.22, 0.68), slice(0.52, 0.8)]));
    let wire = (height * 0.035).min(0.005);
    let bars = if look.is_multiple_of(2) { 2 } else { 3 };
    for bar in 0..bars {
        let turn = std::f64::consts::PI * f64::from(bar) / f64::from(bars);
        let (sine, cosine) = libm::sincos(turn);
        let lift = wire * 0.3 * f64::from(bar);
        let at = |share: f64, y: f64| DVec3::new(cosine * half.x * share, y + lift, sine * half.z * share);
        let path = [at(-0.86, height * 0.52), at(-0.6, wire), at(0.6, wire), at(0.86, height * 0.52)];
        builder.add(slot, sweep(&path, wire, 4));
    }
}

/// What hangs on a flex.
#[derive(Clone, Copy)]
enum Hanging {
    Drum,
    Globe,
    Bell,
    Dome,
    Cone,
    Pleats,
    Arms,
    Cage,
}

/// A shade on a cord.
pub(super) static PENDANT: Recipe = Recipe::furniture("pendant", [0.4, 0.4, 0.9]).round().every_set(pendant);

fn pendant(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let radius = bay.width().min(bay.depth()) / 2.0;
    let (form, slot) = match draft.set() {
        GeometrySet::Plain => [
            (Hanging::Drum, Slot::Shade),
            (Hanging::Globe, Slot::Lamp),
            (Hanging::Bell, Slot::PaintedAccent),
            (Hanging::Cone, Slot::WoodLight),
        ][look],
        GeometrySet::Traditional => [
            (Hanging::Pleats, Slot::Shade),
            (Hanging::Arms, Slot::Brass),
            (Hanging::Bell, Slot::Brass),
            (Hanging::Globe, Slot::Glass),
        ][look],
        GeometrySet::Industrial => [
            (Hanging::Dome, Slot::MetalDark),
            (Hanging::Cage, Slot::MetalDark),
            (Hanging::Cone, Slot::Metal),
            (Hanging::Dome, Slot::PaintedAccent),
        ][look],
        GeometrySet::Budget => [
            (Hanging::Globe, Slot::Shade),
            (Hanging::Cone, Slot::Plastic),
            (Hanging::Drum, Slot::Shade),
            (Hanging::Dome, Slot::Plastic),
        ][look],
    };
    let tall = (bay.height() * 0.55).min(radius * 1.5);
    let metal = if draft.is_traditional() { Slot::Brass } else { Slot::MetalDark };
    let top = hang(builder, form, slot, radius, tall);
    builder.add(metal, cylinder(FLEX, [top, bay.high.y - 0.01], 6));
    let canopy =
        [(radius * 0.35, bay.high.y), (radius * 0.32, bay.high.y - 0.022), (0.008, bay.high.y - 0.032)];
    builder.add(metal, lathe(&canopy.map(|(radius, y)| (radius.min(0.06), y)), 10));
}

/// What hangs, before it is built.
struct Shade {
    form: Hanging,
    slot: Slot,
    radius: f64,
    tall: f64,
}

/// Builds the shade with its bulb upwards from 0; gives where the flex starts.
fn hang(builder: &mut Builder, form: Hanging, slot: Slot, radius: f64, tall: f64) -> f64 {
    let shade = Shade { form, slot, radius, tall };
    match form {
        Hanging::Drum | Hanging::Pleats | Hanging::Cone => shade.of_cloth(builder),
        Hanging::Globe => shade.globe(builder),
        Hanging::Bell | Hanging::Dome => shade.of_sheet(builder),
        Hanging::Cage => shade.cage(builder),
        Hanging::Arms => shade.arms(builder),
    }
}

impl Shade {
    /// Radius of the bulb.
    fn small(&self) -> f64 {
        (self.radius * 0.3).min(0.035)
    }

    /// A frame under cloth, straight or narrower above, held by a bar.
    fn of_cloth(&self, builder: &mut Builder) -> f64 {
        let (radius, small) = (self.radius, self.small());
        let narrow = match self.form {
            Hanging::Drum => 0.96,
            Hanging::Pleats => 0.5,
            _ => 0.16,
        };
        let tall = self.tall * if matches!(self.form, Hanging::Drum) { 0.62 } else { 0.8 };
        let body = if matches!(self.form, Hanging::Pleats) {
            pleated([radius, radius * narrow], [0.0, tall], 24)
        } else {
            shade([radius, radius * narrow], [0.0, tall])
        };
        builder.add(self.slot, body);
        let y = tall * 0.94;
        let across = radius * (1.0 - (1.0 - narrow) * 0.94) * 0.985;
        builder.cuboid(Slot::MetalDark, Bay::new([-across, across], [y - 0.003, y + 0.003], [-0.003, 0.003]));
        bulb(builder, DVec3::new(0.0, y - small * 2.0, 0.0), small, 1.0);
        y
    }

    /// A ball under a neck, with its bulb where one sees through.
    fn globe(&self, builder: &mut Builder) -> f64 {
        let radius = self.radius;
        builder.add(self.slot, globe(radius, radius, [-1.0, 0.93], SIDES));
        if self.slot == Slot::Glass {
            bulb(builder, DVec3::new(0.0, radius, 0.0), self.small(), 1.0);
        }
        let neck = radius * 1.9;
        builder.add(
            Slot::Brass,
            lathe(&[(radius * 0.4, neck), (radius * 0.38, neck + 0.015), (0.012, neck + 0.04)], 8),
        );
        neck + 0.03
    }

    /// Sheet metal or glass with a wall, under a cap.
    fn of_sheet(&self, builder: &mut Builder) -> f64 {
        let (radius, small) = (self.radius, self.small());
        let is_bell = matches!(self.form, Hanging::Bell);
        let top = self.tall * if is_bell { 0.85 } else { 0.6 };
        let profile = if is_bell {
            [(1.0, 0.0), (0.72, top * 0.16), (0.55, top * 0.5), (0.42, top * 0.8), (0.16, top)]
        } else {
            [(1.0, 0.0), (0.97, top * 0.2), (0.8, top * 0.6), (0.5, top * 0.85), (0.16, top)]
        };
        builder.add(self.slot, self.hollow(&profile));
        bulb(builder, DVec3::new(0.0, top * 0.42, 0.0), small, 1.0);
        let cap = [(radius * 0.17, top - 0.004), (radius * 0.17, top + 0.03), (0.01, top + 0.05)];
        builder.add(Slot::MetalDark, lathe(&cap, 8));
        builder.add(Slot::MetalDark, cylinder(0.008, [top * 0.42 + small * 2.0, top], 6));
        top + 0.04
    }

    /// A wall along a profile of (share of the radius, height) pairs.
    fn hollow(&self, outer: &[(f64, f64)]) -> Solid {
        let radius = self.radius;
        let wall = (radius * 0.03).min(0.004);
        let inner = outer.iter().rev().map(|&(share, y)| (radius * share - wall, y - wall * 0.5));
        let outer: Vec<(f64, f64)> = outer.iter().map(|&(share, y)| (radius * share, y)).collect();
        let slices: Vec<Slice> =
            outer.iter().copied().chain(inner).map(|(radius, y)| Slice::round(y.max(0.0), radius)).collect();
        loft_ring(&Outline::Round(SIDES), &slices)
    }

    /// Wires around a bulb.
    fn cage(&self, builder: &mut Builder) -> f64 {
        let (slot, radius, tall, small) = (self.slot, self.radius, self.tall, self.small());
        cage(builder, slot, radius, [0.0, tall * 0.9], 4);
        bulb(builder, DVec3::new(0.0, tall * 0.45, 0.0), small * 1.3, 1.0);
        let y = tall * 0.45 + small * 2.7;
        let cap = [(radius * 0.34, tall * 0.88), (radius * 0.32, tall * 0.94), (0.012, tall)];
        builder.add(slot, cylinder(0.01, [y, tall * 0.9], 6));
        builder.add(slot, lathe(&cap, 8));
        tall * 0.97
    }

    /// A turned stem with four candles on bent arms.
    fn arms(&self, builder: &mut Builder) -> f64 {
        let (slot, tall) = (self.slot, self.tall);
        let hub = tall * 0.3;
        let stem = [
            (0.006, 0.0),
            (0.022, hub * 0.3),
            (0.03, hub * 0.8),
            (0.012, hub * 1.3),
            (0.02, hub * 1.8),
            (0.006, tall),
        ];
        builder.add(slot, lathe(&stem, 6));
        for arm in 0..4 {
            let (sine, cosine) = libm::sincos(TAU * f64::from(arm) / 4.0);
            let cup = (self.radius * 0.16).min(0.035);
            let at = |out: f64, y: f64| DVec3::new(cosine * out, y, sine * out);
            let out = self.radius - cup;
            let path = [at(0.01, hub), at(out * 0.6, hub * 0.4), at(out, hub * 0.8), at(out, hub * 1.1)];
            builder.add(slot, sweep(&path, 0.005, 4));
            let end = at(out, 0.0);
            let candle =
                [(cup, hub * 1.1 - SINK), (cup * 0.4, hub * 1.2), (cup * 0.35, hub * 2.0), (0.0, hub * 2.8)];
            builder.add(Slot::Lamp, lathe(&candle, 4).moved(end.x, 0.0, end.z));
        }
        tall * 0.98
    }
}
