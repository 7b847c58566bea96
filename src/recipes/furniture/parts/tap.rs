//! Water taps.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use glam::DVec3;

use super::turned_forward;
use crate::recipes::kit::{Bay, Builder, SINK, cuboid, cylinder, lathe, sweep};
use crate::recipes::{GeometrySet, Slot};

/// Corners of a pipe.
const SIDES: usize = 8;
/// Metres of height from which an industrial tap has a spring around its hose.
const SPRING_FROM: f64 = 0.15;

/// Where a tap stands and how large it is, in metres. Usual ones: spout 0.11-0.15 out of the body, which is 0.045
/// thick.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Tap {
    /// On the surface.
    pub(in super::super) foot: DVec3,
    /// From the surface to the highest point.
    pub(in super::super) height: f64,
    /// From the foot to the front of the spout.
    pub(in super::super) reach: f64,
}

impl Tap {
    fn point(&self, y: f64, z: f64) -> DVec3 {
        self.foot + DVec3::new(0.0, y, z)
    }

    fn radius(&self) -> f64 {
        (self.height * 0.14).min(self.reach * 0.16).min(0.022)
    }
}

/// A mixer tap of a geometry set: single lever, cross handles, spring or hand wheel, or a knob.
pub(in super::super) fn tap(builder: &mut Builder, set: GeometrySet, tap: Tap) {
    match set {
        GeometrySet::Plain => single_lever(builder, tap),
        GeometrySet::Traditional => cross_handled(builder, tap),
        GeometrySet::Industrial if tap.height > SPRING_FROM => spring(builder, tap),
        GeometrySet::Industrial => hand_wheel(builder, tap),
        GeometrySet::Budget => knob(builder, tap),
    }
}

/// A bow of pipe from upright to hanging: points around a middle, in the plane of the spout.
fn bow(middle: DVec3, radius: f64, steps: u32) -> impl Iterator<Item = DVec3> {
    (0..=steps).map(move |step| {
        let (sine, cosine) = libm::sincos(PI * f64::from(step) / f64::from(steps));
        middle + DVec3::new(0.0, sine * radius, -cosine * radius)
    })
}

fn single_lever(builder: &mut Builder, tap: Tap) {
    let radius = tap.radius();
    let lever = (tap.height * 0.08).min(radius * 0.5);
    let body = tap.height - lever * 1.6;
    let profile =
        [(radius * 1.2, -SINK), (radius * 1.2, radius * 0.25), (radius, radius * 0.3), (radius, body)];
    builder.add(Slot::Chrome, lathe(&profile, 12).moved(tap.foot.x, tap.foot.y, tap.foot.z));
    let pipe = radius * 0.62;
    let (low, high) = (tap.height * 0.5, tap.height * 0.62);
    let path = [
        tap.point(low, 0.0),
        tap.point(high, tap.reach * 0.6),
        tap.point(high, tap.reach - pipe * 1.6),
        tap.point(high - pipe * 2.4, tap.reach - pipe),
    ];
    builder.add(Slot::Chrome, sweep(&path, pipe, SIDES));
    let top =
        [(radius * 0.96, body - SINK), (radius * 0.96, tap.height - lever * 0.5), (radius * 0.6, tap.height)];
    builder.add(Slot::Chrome, lathe(&top, 12).moved(tap.foot.x, tap.foot.y, tap.foot.z));
    let middle = tap.point(tap.height - lever * 0.85, radius + tap.reach * 0.12);
    builder.cuboid(Slot::Chrome, Bay::around(middle, radius * 0.7, lever * 0.6, radius + tap.reach * 0.3));
}

/// Two pillars with cross handles beside a swan neck.
fn cross_handled(builder: &mut Builder, tap: Tap) {
    let pipe = tap.radius() * 0.5;
    let bend = (tap.reach - pipe) / 2.0;
    let stem = (tap.height - bend - pipe).max(tap.height * 0.3);
    let bend = (tap.height - stem - pipe) / bend;
    let arch = bow(DVec3::ZERO, (tap.reach - pipe) / 2.0, 6)
        .map(|point| tap.point(stem + point.y * bend, point.z + (tap.reach - pipe) / 2.0));
    let mut path = vec![tap.point(-SINK, 0.0)];
    path.extend(arch);
    path.push(tap.point(stem - tap.height * 0.08, tap.reach - pipe));
    builder.add(Slot::Brass, sweep(&path, pipe, SIDES));
    // All within 0.04 m of the middle where it is as large as basins have them: soap stands beside it.
    let aside = tap.radius() * 1.2;
    let rise = tap.height * 0.45;
    let pillar = [
        (pipe * 1.6, -SINK),
        (pipe * 1.5, pipe * 0.5),
        (pipe * 1.1, pipe * 1.4),
        (pipe * 1.3, rise * 0.55),
        (pipe * 0.7, rise * 0.7),
        (pipe * 0.7, rise),
        (pipe * 0.3, rise + pipe * 0.7),
    ];
    for side in [-1.0, 1.0] {
        let at = tap.foot + DVec3::X * aside * side;
        builder.add(Slot::Brass, lathe(&pillar, SIDES).moved(at.x, at.y, at.z));
        let middle = at + DVec3::Y * rise * 0.86;
        let (long, thin) = (pipe * 3.9, pipe * 0.8);
        for bar in [DVec3::new(long, thin, thin), DVec3::new(thin * 0.99, thin * 1.02, long)] {
            let bar = Bay::around(DVec3::ZERO, bar.x, bar.y, bar.z);
            builder.add(Slot::Ceramic, cuboid(bar).turned_y(FRAC_PI_4).moved(middle.x, middle.y, middle.z));
        }
    }
    let bridge = [-1.0, 1.0].map(|side| tap.point(rise * 0.3, 0.0) + DVec3::X * aside * side);
    builder.add(Slot::Brass, sweep(&bridge, pipe * 0.7, 6));
}

/// A hose in a spring over a high bow, as in restaurant kitchens.
fn spring(builder: &mut Builder, tap: Tap) {
    let radius = tap.radius();
    let pipe = radius * 0.5;
    let bend = ((tap.reach - radius) / 2.0).min(tap.height * 0.35);
    let stem = tap.height - bend - radius * 0.7;
    let low = tap.height * 0.3;
    let base = [(radius * 1.2, -SINK), (radius, radius * 0.4), (radius, low), (pipe, low + pipe)];
    builder.add(Slot::Chrome, lathe(&base, 10).moved(tap.foot.x, tap.foot.y, tap.foot.z));
    let mut path = vec![tap.point(low, 0.0)];
    path.extend(bow(tap.point(stem, bend), bend, 6));
    path.push(tap.point(stem - tap.height * 0.12, bend * 2.0));
    builder.add(Slot::MetalDark, sweep(&path, pipe, 6));
    // Windings stand for the spring.
    let turns = 7;
    for turn in 0..turns {
        let y = low + pipe * 1.6 + (stem - low - pipe * 1.6) * f64::from(turn) / f64::from(turns);
        let ring = cylinder(radius * 0.7, [y, y + (stem - low) / f64::from(turns) * 0.5], 6);
        builder.add(Slot::Chrome, ring.moved(tap.foot.x, tap.foot.y, tap.foot.z));
    }
    for (index, point) in bow(tap.point(stem, bend), bend, 6).skip(1).take(5).enumerate() {
        let ring = Bay::around(point, radius * 1.4 + 0.0006 * index as f64, radius * 0.55, radius * 1.4);
        builder.cuboid(Slot::Chrome, ring);
    }
    let spray = stem - tap.height * 0.12;
    let head = [
        (radius * 0.95, spray - tap.height * 0.16),
        (radius * 0.7, spray - tap.height * 0.05),
        (pipe, spray),
    ];
    builder.add(Slot::Metal, lathe(&head, SIDES).moved(tap.foot.x, tap.foot.y, tap.foot.z + bend * 2.0));
    let arm = [tap.point(low * 0.8, 0.0), tap.point(spray - tap.height * 0.03, bend * 2.0)];
    builder.add(Slot::Chrome, sweep(&arm, pipe * 0.5, 4));
    let lever =
        [tap.point(low * 0.5, 0.0), tap.point(low * 0.5, 0.0) + DVec3::new(radius * 3.2, radius * 0.6, 0.0)];
    builder.add(Slot::Chrome, sweep(&lever, pipe * 0.7, 6));
}

/// A bent pipe with a valve that is turned by a wheel.
fn hand_wheel(builder: &mut Builder, tap: Tap) {
    let pipe = tap.radius() * 0.62;
    let bend = tap.height * 0.68;
    let path = [
        tap.point(-SINK, 0.0),
        tap.point(bend, 0.0),
        tap.point(bend, tap.reach - pipe),
        tap.point(bend * 0.66, tap.reach - pipe),
    ];
    builder.add(Slot::Metal, sweep(&path, pipe, SIDES));
    for (y, share) in [(0.0, 1.7), (bend * 0.45, 1.5)] {
        let sleeve = cylinder(pipe * share, [y - SINK, y + pipe * 1.4], 6);
        builder.add(Slot::MetalDark, sleeve.moved(tap.foot.x, tap.foot.y, tap.foot.z));
    }
    let wheel = tap.height - bend;
    builder.add(
        Slot::Metal,
        cylinder(pipe * 0.5, [bend, tap.height - SINK * 2.0], 6).moved(tap.foot.x, tap.foot.y, tap.foot.z),
    );
    let rim = [
        (pipe * 2.4, tap.height - wheel * 0.25),
        (pipe * 2.6, tap.height - wheel * 0.12),
        (pipe * 2.3, tap.height),
        (pipe * 0.6, tap.height - wheel * 0.05),
    ];
    builder.add(Slot::PaintedAccent, lathe(&rim, SIDES).moved(tap.foot.x, tap.foot.y, tap.foot.z));
}

/// A low body with a short spout and a plastic knob on top.
fn knob(builder: &mut Builder, tap: Tap) {
    let radius = tap.radius() * 0.9;
    let body = tap.height * 0.6;
    let profile =
        [(radius * 1.5, -SINK), (radius * 1.4, radius * 0.3), (radius, body * 0.5), (radius * 0.8, body)];
    builder.add(Slot::Chrome, lathe(&profile, SIDES).moved(tap.foot.x, tap.foot.y, tap.foot.z));
    let path = [
        tap.point(body * 0.6, 0.0),
        tap.point(body * 0.72, tap.reach - radius * 0.9),
        tap.point(body * 0.4, tap.reach - radius * 0.55),
    ];
    builder.add(Slot::Chrome, sweep(&path, radius * 0.5, 6));
    let grip = [
        (radius * 0.6, body - SINK),
        (radius * 1.35, body + (tap.height - body) * 0.3),
        (radius * 1.25, tap.height * 0.96),
        (radius * 0.8, tap.height),
    ];
    builder.add(Slot::Plastic, lathe(&grip, 6).moved(tap.foot.x, tap.foot.y, tap.foot.z));
}

/// A tap for a bath or a shower: a body along x on a wall or rim with a spout and two handles; `middle` is that of
/// the body, whose back is at `back`.
pub(in super::super) fn wall_mixer(builder: &mut Builder, set: GeometrySet, middle: DVec3, back: f64) {
    let is_traditional = set == GeometrySet::Traditional;
    let slot = if is_traditional { Slot::Brass } else { Slot::Chrome };
    let (half, radius) = (0.13, 0.02);
    let ends = [-half, half].map(|x| middle + DVec3::X * x);
    builder.add(slot, sweep(&ends, radius, SIDES));
    for side in [-1.0, 1.0] {
        let at = middle + DVec3::X * side * half * 0.58;
        let pipe = turned_forward(cylinder(0.012, [back - at.z, 0.0], 6)).moved(at.x, at.y, at.z);
        builder.add(slot, pipe);
        let end = middle + DVec3::X * side * (half - 0.001);
        if is_traditional {
            builder.cuboid(Slot::Ceramic, Bay::around(end + DVec3::X * side * 0.012, 0.012, 0.07, 0.012));
            builder.cuboid(Slot::Ceramic, Bay::around(end + DVec3::X * side * 0.012, 0.0118, 0.0122, 0.07));
            let stub = [end - DVec3::X * side * 0.002, end + DVec3::X * side * 0.02];
            builder.add(slot, sweep(&stub, 0.008, 6));
        } else {
            let grip = lathe(&[(0.021, 0.0), (0.026, 0.006), (0.024, 0.045)], SIDES)
                .turned_z(-FRAC_PI_2 * side)
                .moved(end.x, end.y, end.z);
            builder.add(if set == GeometrySet::Industrial { Slot::MetalDark } else { slot }, grip);
        }
    }
}
