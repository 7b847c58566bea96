//! What carries other pieces carries them on its model: catalogue classes with places above, whose surface the model must have.

use roomwright::internals::catalog::{Class, Extent, Shape, Side, Size, VariantRef};
use roomwright::internals::geometry::{Bounds, Point};
use roomwright::internals::model::{Model, ModelLibrary};
use roomwright::internals::recipes::GeometrySet;

use crate::CATALOG;

/// Metres between the surface of the class and the model's top there: a piece on it neither floats nor sinks in visibly.
const LEVEL: f64 = 0.012;
/// Points of a raster over what carries, along each side.
const RASTER: u32 = 9;
/// Metres that a piece bridges: half of a gap between slats, or of one between the rollers that suitcases lie on.
const BRIDGED: f64 = 0.06;
/// Share of these points that may lie off the surface: rounded corners.
const MOST_OFF: f64 = 0.1;

/// The part of the top that carries, in the frame of the class: its front is at the lesser y.
fn carrying(class: &Class, size: Size) -> Bounds {
    let [left, front, right, back] = class.offer(Side::Above).margin;
    let half = Point::new(size.width / 2.0, size.depth / 2.0);
    Bounds { low: Point::new(left - half.x, front - half.y), high: Point::new(half.x - right, half.y - back) }
}

/// A triangle seen from above: its corners in the frame of the class, and their heights.
struct Facet {
    corners: [Point; 3],
    heights: [f64; 3],
    bounds: Bounds,
}

/// The triangles of a model that are seen from above.
fn facets(model: &Model) -> Vec<Facet> {
    let mut facets = Vec::new();
    for part in &model.primitives {
        // In glTF the front looks along z.
        let at = |index: u32| part.positions[index as usize].map(f64::from);
        for &triangle in part.indices.as_chunks::<3>().0 {
            let corners = triangle.map(at);
            let [a, b, c] = corners.map(|[x, _, z]| Point::new(x, -z));
            if (b - a).perp_dot(c - a).abs() > 1e-9 {
                let bounds = Bounds { low: a.min(b).min(c), high: a.max(b).max(c) };
                facets.push(Facet { corners: [a, b, c], heights: corners.map(|[_, y, _]| y), bounds });
            }
        }
    }
    facets
}

/// The height of the highest triangle over a point, if there is one.
fn top_at(facets: &[Facet], point: Point) -> Option<f64> {
    let mut top: Option<f64> = None;
    for Facet { corners: [a, b, c], heights, bounds } in facets {
        if point.cmplt(bounds.low).any() || point.cmpgt(bounds.high).any() {
            continue;
        }
        let area = (*b - *a).perp_dot(*c - *a);
        let weight = |from: &Point, to: &Point| (*to - *from).perp_dot(point - *from) / area;
        let weights = [weight(b, c), weight(c, a), weight(a, b)];
        if weights.iter().all(|&weight| weight >= -1e-9) {
            let height = weights.iter().zip(heights).map(|(weight, height)| weight * height).sum();
            top = Some(top.map_or(height, |top| top.max(height)));
        }
    }
    top
}

/// Whether a part of the class stands on its surface at a point, so that nothing else does.
fn is_taken(class: &Class, size: Size, surface: f64, point: Point) -> bool {
    let Shape::Prisms(parts) = &class.shape else { return false };
    let at = |extent: &Extent, length: f64| extent.share * length + extent.offset;
    parts.iter().any(|part| {
        let [low, high] = [&part.low, &part.high].map(|corner| {
            Point::new(
                at(&corner[0], size.width) - size.width / 2.0,
                at(&corner[1], size.depth) - size.depth / 2.0,
            )
        });
        at(&part.high[2], size.height) > surface + LEVEL && point.cmpge(low).all() && point.cmple(high).all()
    })
}

/// The share of a raster over what carries at which the model has no top, and the metres from it at the worst point.
fn share_off(model: &Model, class: &Class, size: Size) -> (f64, f64) {
    let surface = class.offer(Side::Above).surface.unwrap_or(size.height);
    let carries = carrying(class, size);
    let facets = facets(model);
    let off = |point: Point| top_at(&facets, point).map_or(surface, |top| (top - surface).abs());
    let share = |step: u32| (f64::from(step) + 0.5) / f64::from(RASTER);
    let raster = (0..RASTER * RASTER).map(|index| {
        carries.low + Point::new(share(index % RASTER), share(index / RASTER)) * (carries.high - carries.low)
    });
    let (mut count, mut bad, mut worst) = (0, 0, 0.0_f64);
    for point in raster.filter(|&point| !is_taken(class, size, surface, point)) {
        let around = [Point::ZERO, Point::X, Point::Y, Point::NEG_X, Point::NEG_Y];
        let metres = around.map(|way| off(point + way * BRIDGED)).into_iter().fold(f64::INFINITY, f64::min);
        count += 1;
        if metres > LEVEL {
            bad += 1;
            worst = worst.max(metres);
        }
    }
    (f64::from(bad) / f64::from(count.max(1)), worst)
}

#[test]
fn what_carries_others_has_a_top_there() {
    let library = ModelLibrary::load(&CATALOG).unwrap();
    let mut faults = Vec::new();
    for (index, class) in CATALOG.classes.iter().enumerate() {
        if class.offer(Side::Above).places == 0 {
            continue;
        }
        for variant in 0..class.variant_count() {
            for set in GeometrySet::ALL {
                let model = library.model(VariantRef::new(index, variant), set);
                let (share, worst) = share_off(&model, class, class.size(variant));
                if share > MOST_OFF {
                    faults.push(format!("{} {variant} ({set}): {share:.2} off, {worst:.3} m", class.id));
                }
            }
        }
    }
    assert_eq!(faults, Vec::<String>::new());
}
