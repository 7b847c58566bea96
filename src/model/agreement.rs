//! Whether models agree with the collision shapes that the catalogue declares for their classes.

use std::fmt::Write as _;

use glam::DVec3;

use super::stand_in::{distance_outside, rules};
use super::{Model, ModelLibrary, ModelMaterial, Primitive, geometry_sets};
use crate::catalog::{Catalog, Class, Size, load_catalog};

/// Metres by which a part may stand out of the declared shape: room enough for cushions, seams and taps.
const TOLERANCE: f64 = 0.04;

/// Materials of loose pillows, which may lie on what carries them.
const LOOSE: [&str; 3] = ["linen", "fabric_accent", "fabric_light"];
/// Classes with arm rests that go under table tops: no part of the shape, so that the seats may, too.
const ARM_RESTS: [&str; 1] = ["office_chair"];

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
