//! Whether models agree with the collision shapes that the catalogue declares for their classes.

use std::fmt::Write as _;

use glam::DVec3;

use super::{Model, ModelLibrary, ModelMaterial, Primitive, geometry_sets};
use crate::catalog::{Catalog, Class, Extent, PrismRule, Shape, Size, load_catalog};

/// Metres by which a part may stand out of the declared shape: room enough for cushions, seams and taps.
const TOLERANCE: f64 = 0.04;

/// Materials of loose pillows, which may lie on what carries them.
const LOOSE: [&str; 3] = ["linen", "fabric_accent", "fabric_light"];
/// Classes with arm rests that go under table tops: no part of the shape, so that the seats may, too.
const ARM_RESTS: [&str; 1] = ["office_chair"];

/// Metres by which a point of a model stands out of a part of a shape.
fn distance_outside(point: DVec3, rule: &PrismRule, size: Size) -> f64 {
    let at = |extent: Extent, length: f64| extent.share * length + extent.offset;
    // In the class's frame, from the low corner: width to the right, depth to the back, height upwards.
    let local = DVec3::new(point.x + size.width / 2.0, size.depth / 2.0 - point.z, point.y);
    let extent = DVec3::new(size.width, size.depth, size.height);
    let low = DVec3::from_array([0, 1, 2].map(|axis| at(rule.low[axis], extent[axis])));
    let high = DVec3::from_array([0, 1, 2].map(|axis| at(rule.high[axis], extent[axis])));
    if rule.is_disc {
        let half = (high - low) / 2.0;
        let off = (local - (low + high) / 2.0) / half;
        let beyond = (off.truncate().length() - 1.0).max(0.0) * half.truncate().min_element();
        return beyond.max(low.z - local.z).max(local.z - high.z);
    }
    (low - local).max(local - high).max(DVec3::ZERO).max_element()
}

fn rules(shape: &Shape) -> Vec<PrismRule> {
    let whole = |is_disc| PrismRule {
        is_disc,
        low: [Extent { share: 0.0, offset: 0.0 }; 3],
        high: [Extent { share: 1.0, offset: 0.0 }; 3],
    };
    match shape {
        Shape::Box => vec![whole(false)],
        Shape::Disc => vec![whole(true)],
        Shape::Prisms(rules) => rules.clone(),
    }
}

/// How far the farthest corner of a model stands out of its class's shape, and where.
fn farthest_outside(class: &Class, model: &Model, size: Size) -> (f64, DVec3) {
    let rules = rules(&class.shape);
    let is_firm = |part: &&Primitive| !LOOSE.iter().any(|slot| part.material == ModelMaterial::Slot(slot));
    let points = model
        .primitives
        .iter()
        .filter(is_firm)
        .flat_map(|part| &part.positions)
        .map(|p| DVec3::from_array(p.map(f64::from)));
    let outside =
        |point: DVec3| rules.iter().map(|rule| distance_outside(point, rule, size)).fold(f64::MAX, f64::min);
    points
        .map(|point| (outside(point), point))
        .fold((0.0, DVec3::ZERO), |worst, here| if here.0 > worst.0 { here } else { worst })
}

fn catalog() -> Catalog {
    load_catalog(&[]).expect("the built-in configuration is sound").value
}

#[test]
fn built_in_models_stay_in_the_shapes_of_their_classes() {
    let catalog = catalog();
    let library = ModelLibrary::load(&catalog).unwrap();
    let mut report = String::new();
    for (index, class) in catalog.classes.iter().enumerate() {
        let variants = 0..class.variant_count();
        for (variant, &set) in
            variants.flat_map(|variant| geometry_sets().iter().map(move |set| (variant, set)))
        {
            let model = library.model(index, variant, set);
            let (outside, at) = farthest_outside(class, &model, class.size(variant));
            if outside > TOLERANCE && !ARM_RESTS.contains(&class.id.as_str()) {
                writeln!(report, "{} {variant} {set}: {outside:.3} m at {at:.3}", class.id).unwrap();
            }
        }
    }
    assert!(report.is_empty(), "\n{report}");
}
