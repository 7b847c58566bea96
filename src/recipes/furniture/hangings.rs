//! Pictures and mirrors on walls.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::parts::turned_forward;
use crate::recipes::kit::{
    Axis, Bay, Builder, Outline, SINK, Sampler, Slice, Solid, cylinder, extrude, loft, loft_ring,
};
use crate::recipes::{Draft, GeometrySet, Recipe, Slot};

/// Metres between layers of paint, so that none shares a plane with another.
const LAYER: f64 = 0.000_4;

/// A frame in the plane of the wall, of an outline: through (share of the depth, metres inwards) pairs.
pub(super) fn framed(outline: &Outline, bay: Bay, profile: &[(f64, f64)]) -> Solid {
    let half = bay.extent() / 2.0;
    let slices: Vec<Slice> = profile.iter().map(|&(depth, back)| slice(bay, half, depth, back)).collect();
    turned_forward(loft_ring(outline, &slices)).moved(0.0, bay.center().y, 0.0)
}

/// A plate in the plane of the wall.
pub(super) fn plate(outline: &Outline, bay: Bay, profile: &[(f64, f64)]) -> Solid {
    let half = bay.extent() / 2.0;
    let slices: Vec<Slice> = profile.iter().map(|&(depth, back)| slice(bay, half, depth, back)).collect();
    turned_forward(loft(outline, &slices)).moved(0.0, bay.center().y, 0.0)
}

fn slice(bay: Bay, half: DVec3, depth: f64, back: f64) -> Slice {
    let round = (half.x.min(half.y) * 0.3 - back).max(0.002);
    Slice::new(bay.low.z + depth * bay.depth(), (half.x - back).max(0.002), (half.y - back).max(0.002))
        .softened(round)
}

/// The profile of a frame: flat, moulded, or a thin edge.
fn profile(set: GeometrySet, border: f64) -> Vec<(f64, f64)> {
    match set {
        GeometrySet::Traditional => vec![
            (0.0, 0.0),
            (0.5, 0.0),
            (1.0, border * 0.22),
            (0.75, border * 0.42),
            (0.85, border * 0.72),
            (0.6, border),
            (0.0, border),
        ],
        GeometrySet::Industrial => vec![
            (0.0, 0.0),
            (1.0, 0.0),
            (1.0, border * 0.4),
            (0.7, border * 0.4),
            (0.7, border),
            (0.0, border),
        ],
        _ => vec![(0.0, 0.0), (0.9, 0.0), (1.0, border * 0.15), (1.0, border), (0.0, border)],
    }
}

/// A painting or print: in a slim frame with a passe-partout, a moulded one, a steel one, on canvas, or a poster.
pub(super) static PICTURE: Recipe = Recipe::accessory("picture", [0.7, 0.03, 0.5]).every_set(picture);

fn picture(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let mut sampler = draft.sampler();
    let look = draft.form();
    let set = draft.set();
    let short = bay.width().min(bay.height());
    let is_canvas = set == GeometrySet::Plain && look == 3;
    let is_poster = set == GeometrySet::Budget && look.is_multiple_of(2);
    let sheet = if is_canvas {
        builder.block(
            Slot::Linen,
            bay.inset(0.0, 0.0, 0.0).with_z([bay.low.z, bay.high.z - LAYER * 6.0]),
            0.004,
        );
        bay.inset(0.002, 0.002, 0.0).with_z([bay.high.z - LAYER * 7.0, bay.high.z - LAYER * 5.0])
    } else if is_poster {
        poster(builder, bay)
    } else {
        let border = match set {
            GeometrySet::Traditional => (short * 0.13).min(0.075),
            GeometrySet::Industrial => (short * 0.06).min(0.035),
            _ => (short * 0.045).min(0.022),
        };
        let slot = match set {
            GeometrySet::Traditional => [Slot::Brass, Slot::WoodDark, Slot::Brass, Slot::Wood],
            GeometrySet::Industrial => [Slot::MetalDark, Slot::Metal, Slot::MetalDark, Slot::WoodDark],
            GeometrySet::Budget => [Slot::PlasticDark, Slot::PlasticDark, Slot::Plastic, Slot::WoodLight],
            GeometrySet::Plain => [Slot::Wood, Slot::MetalDark, Slot::Painted, Slot::WoodLight],
        }[look];
        builder.add(slot, framed(&Outline::Square, bay, &profile(set, border)));
        let z = |share: f64| bay.low.z + share * bay.depth();
        builder.cuboid(Slot::Paper, bay.inset(border - SINK, border - SINK, 0.0).with_z([z(0.1), z(0.5)]));
        let margin = if set == GeometrySet::Plain {
            short * [0.16, 0.1, 0.2, 0.1][look]
        } else if look % 2 == 1 {
            short * 0.07
        } else {
            0.004
        };
        let inner = bay.inset(border + margin, border + margin, 0.0);
        if margin > 0.01 {
            // The bevel that is cut into the card.
            builder.cuboid(Slot::Linen, inner.inset(-0.004, -0.004, 0.0).with_z([z(0.45), z(0.5) + LAYER]));
        }
        inner.with_z([z(0.45), z(0.5) + LAYER * 2.0])
    };
    compose(builder, &mut sampler, sheet, (look + set as usize) % 4);
}

/// A sheet of paper between two rails; gives what is painted on.
fn poster(builder: &mut Builder, bay: Bay) -> Bay {
    let rail = (bay.height() * 0.035).min(0.02);
    let middle = bay.center().z;
    for y in [[bay.low.y, bay.low.y + rail], [bay.high.y - rail, bay.high.y]] {
        builder.block(Slot::WoodLight, bay.with_y(y), 0.002);
    }
    let paper = bay.inset(0.004, rail - SINK, 0.0).with_z([middle - 0.001, middle + 0.001]);
    builder.cuboid(Slot::Paper, paper);
    paper.inset(bay.width() * 0.05, bay.height() * 0.04, 0.0).with_z([middle, middle + 0.001 + LAYER])
}

const FIELDS: [Slot; 6] =
    [Slot::PaintedAccent, Slot::FabricAccent, Slot::Leaf, Slot::Terracotta, Slot::FabricLight, Slot::Book];

/// A sheet to be painted, and the colour that a picture begins with.
struct Canvas {
    sheet: Bay,
    first: usize,
}

impl Canvas {
    /// From the back of the sheet to a layer over it.
    fn front(&self, layer: f64) -> [f64; 2] {
        [self.sheet.low.z, self.sheet.high.z + LAYER * layer]
    }
}

/// Paints a sheet: a landscape, fields of colour, mountains, or circles.
fn compose(builder: &mut Builder, sampler: &mut Sampler, sheet: Bay, kind: usize) {
    let canvas = Canvas { sheet, first: sampler.count(0, 2) as usize };
    match kind {
        0 => landscape(builder, sampler, &canvas),
        1 => fields(builder, sampler, &canvas),
        2 => mountains(builder, &canvas),
        _ => circles(builder, &canvas),
    }
}

/// Two fields that meet at a horizon, and a disc over it.
fn landscape(builder: &mut Builder, sampler: &mut Sampler, canvas: &Canvas) {
    let horizon = sampler.between(0.3, 0.5) * canvas.sheet.height();
    builder.cuboid(
        FIELDS[canvas.first + 1],
        canvas.sheet.with_y([canvas.sheet.low.y, canvas.sheet.low.y + horizon]),
    );
    builder
        .cuboid(FIELDS[4], canvas.sheet.with_y([canvas.sheet.low.y + horizon + 0.001, canvas.sheet.high.y]));
    let radius = canvas.sheet.width().min(canvas.sheet.height()) * sampler.between(0.1, 0.18);
    let x = sampler.between(-0.25, 0.25) * canvas.sheet.width();
    disc(
        builder,
        FIELDS[(canvas.first + 3) % 6],
        DVec2::new(x, canvas.sheet.low.y + horizon + radius * 0.6),
        radius,
        canvas.front(2.0),
    );
}

/// Four fields around a cut that is off the middle.
fn fields(builder: &mut Builder, sampler: &mut Sampler, canvas: &Canvas) {
    let (x, y) = (
        sampler.between(0.3, 0.6) * canvas.sheet.width(),
        sampler.between(0.35, 0.65) * canvas.sheet.height(),
    );
    let cut = [canvas.sheet.low.x + x, canvas.sheet.low.y + y];
    let gap = canvas.sheet.width() * 0.02;
    for (index, (x, y)) in [
        ([canvas.sheet.low.x, cut[0]], [canvas.sheet.low.y, cut[1]]),
        ([cut[0] + gap, canvas.sheet.high.x], [canvas.sheet.low.y, cut[1] - gap * 3.0]),
        ([canvas.sheet.low.x, cut[0]], [cut[1] + gap, canvas.sheet.high.y]),
        ([cut[0] + gap, canvas.sheet.high.x], [cut[1] - gap * 2.0, canvas.sheet.high.y]),
    ]
    .into_iter()
    .enumerate()
    {
        builder.cuboid(FIELDS[(canvas.first + index * 2 + index / 2) % 6], canvas.sheet.with_x(x).with_y(y));
    }
}

/// Three triangles behind each other.
fn mountains(builder: &mut Builder, canvas: &Canvas) {
    builder.cuboid(FIELDS[4], canvas.sheet);
    for (index, (left, peak, right, rise)) in
        [(0.0, 0.32, 0.72, 0.75), (0.3, 0.7, 1.0, 0.6), (0.0, 0.12, 0.5, 0.36)].into_iter().enumerate()
    {
        let at = |share: f64, rise: f64| {
            DVec2::new(
                canvas.sheet.low.x + share * canvas.sheet.width(),
                canvas.sheet.low.y + rise * canvas.sheet.height(),
            )
        };
        let mountain = [at(left, 0.0), at(right, 0.0), at(peak, rise)];
        builder.add(
            FIELDS[(canvas.first + index) % 4],
            extrude(&mountain, Axis::Z, canvas.front(2.0 + index as f64 * 2.0)),
        );
    }
}

/// Three discs, the smaller over the larger.
fn circles(builder: &mut Builder, canvas: &Canvas) {
    builder.cuboid(FIELDS[4], canvas.sheet);
    let short = canvas.sheet.width().min(canvas.sheet.height());
    for (index, (x, y, size)) in
        [(-0.12, 0.42, 0.3), (0.2, 0.62, 0.2), (0.08, 0.26, 0.13)].into_iter().enumerate()
    {
        let at = DVec2::new(x * short, canvas.sheet.low.y + y * canvas.sheet.height());
        disc(
            builder,
            FIELDS[(canvas.first + index) % 4],
            at,
            size * short * 0.9,
            canvas.front(2.0 + index as f64 * 2.0),
        );
    }
}

fn disc(builder: &mut Builder, slot: Slot, at: DVec2, radius: f64, z: [f64; 2]) {
    builder.add(slot, turned_forward(cylinder(radius, z, 14)).moved(at.x, at.y, 0.0));
}

/// An outline with a round top.
fn arch() -> Outline {
    let steps = 10;
    let top = (0..=steps).map(|step| {
        let (sine, cosine) = libm::sincos(PI * f64::from(step) / f64::from(steps));
        DVec2::new(cosine, -0.4 - 0.6 * sine)
    });
    Outline::Points([DVec2::new(-1.0, 1.0), DVec2::new(1.0, 1.0)].into_iter().chain(top).collect())
}

/// A mirror: in a slim frame, an oval one, an arch, a moulded or a steel frame, or held by clips.
pub(super) static MIRROR: Recipe = Recipe::accessory("mirror", [0.6, 0.03, 0.8]).every_set(mirror);

fn mirror(draft: &Draft, builder: &mut Builder) {
    let bay = builder.bay();
    let look = draft.form();
    let set = draft.set();
    let outline = match (set, look) {
        (GeometrySet::Plain, 1) => Outline::Round(20),
        (GeometrySet::Traditional, 1) => Outline::Round(16),
        (GeometrySet::Plain, 2) | (GeometrySet::Traditional, 3) => arch(),
        (GeometrySet::Plain, 3) | (GeometrySet::Industrial, 1 | 3) => Outline::Soft(3),
        _ => Outline::Square,
    };
    let slot = match set {
        GeometrySet::Traditional => [Slot::Brass, Slot::Brass, Slot::WoodDark, Slot::Wood],
        GeometrySet::Industrial => [Slot::MetalDark, Slot::MetalDark, Slot::Metal, Slot::Brass],
        GeometrySet::Budget => [Slot::Plastic, Slot::Metal, Slot::PlasticDark, Slot::WoodLight],
        GeometrySet::Plain => [Slot::MetalDark, Slot::Wood, Slot::Brass, Slot::Metal],
    }[look];
    let short = bay.width().min(bay.height());
    let border = match set {
        GeometrySet::Traditional => (short * 0.14).min(0.07),
        GeometrySet::Industrial => (short * 0.06).min(0.03),
        _ => (short * 0.04).min(0.018),
    };
    if set == GeometrySet::Budget && look % 2 == 1 {
        builder.add(Slot::Mirror, plate(&outline, bay, &[(0.1, 0.006), (0.5, 0.004), (0.6, 0.008)]));
        for x in [-0.3, 0.3] {
            for (y, turn) in [(bay.low.y, 1.0), (bay.high.y, -1.0)] {
                let clip = Bay::around(
                    DVec3::new(x * bay.width(), y + turn * 0.009, bay.center().z),
                    0.03,
                    0.018,
                    bay.depth(),
                );
                builder.cuboid(slot, clip);
            }
        }
        return;
    }
    builder.add(slot, framed(&outline, bay, &profile(set, border)));
    builder.add(Slot::Mirror, plate(&outline, bay, &[(0.15, border - SINK), (0.5, border - SINK)]));
    if set == GeometrySet::Traditional && look.is_multiple_of(2) {
        crest(builder, slot, bay, border);
    }
}

/// Carved scrolls in the middle of a frame's upper and lower bar.
fn crest(builder: &mut Builder, slot: Slot, bay: Bay, border: f64) {
    for (y, size) in [(bay.high.y - border * 0.5, 0.96), (bay.low.y + border * 0.5, 0.8)] {
        for (x, radius) in [(0.0, 0.5), (-0.92, 0.34), (0.92, 0.34)] {
            let shell = [
                Slice::round(bay.low.z + bay.depth() * 0.42, border * radius * size),
                Slice::round(bay.high.z - 0.002, border * radius * size * 0.8),
                Slice::round(bay.high.z - 0.0006, border * radius * size * 0.3),
            ];
            builder.add(slot, turned_forward(loft(&Outline::Round(6), &shell)).moved(x * border, y, 0.0));
        }
    }
}
