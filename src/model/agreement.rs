//! Whether models agree with the collision shapes that the catalogue declares for their classes.

use std::fmt::Write as _;

use glam::DVec3;

use super::stand_in::{distance_outside, rules};
use super::{Model, ModelLibrary, ModelMaterial, Primitive};
use crate::catalog::{Catalog, Class, ModelSource, Side, Size, VariantRef, load_catalog};
use crate::recipes::{GeometrySet, Slot};

/// Metres by which a part may stand out of the declared shape: room enough for cushions, seams and taps.
const TOLERANCE: f64 = 0.04;
/// The same where other pieces come close: legs of tables beside seats, taps beside soap.
const CLOSE: f64 = 0.004;
/// Share of a table's height at which seats are.
const SEAT: f64 = 0.6;

/// Materials of loose pillows, which may lie on what carries them.
const LOOSE: [Slot; 3] = [Slot::Linen, Slot::FabricAccent, Slot::FabricLight];
/// Classes with arm rests that go under table tops: no part of the shape, so that the seats may, too.
const ARM_RESTS: [&str; 1] = ["office_chair"];

/// How far a point lies outside of the prisms of a class.
fn outside(class: &Class, size: Size, point: DVec3) -> f64 {
    rules(&class.shape).iter().map(|rule| distance_outside(point, rule, size)).fold(f64::MAX, f64::min)
}

/// Calls `check` with every model of the classes that are wanted, and lists what it finds.
fn faults_of(is_wanted: impl Fn(&Class) -> bool, check: impl Fn(&Class, &Model, Size) -> Option<String>) {
    let catalog = catalog();
    let library = ModelLibrary::load(&catalog).unwrap();
    let mut report = String::new();
    for (index, class) in catalog.classes.iter().enumerate().filter(|(_, class)| is_wanted(class)) {
        for (variant, set) in
            (0..class.variant_count()).flat_map(|variant| GeometrySet::ALL.map(|set| (variant, set)))
        {
            let model = library.model(VariantRef::new(index, variant), set);
            if let Some(fault) = check(class, &model, class.size(variant)) {
                writeln!(report, "{} {variant} {set}: {fault}", class.id).unwrap();
            }
        }
    }
    assert!(report.is_empty(), "\n{report}");
}

fn corners(model: &Model) -> impl Iterator<Item = DVec3> {
    let place = |p: &[f32; 3]| DVec3::from_array(p.map(f64::from));
    model.primitives.iter().flat_map(move |part| part.positions.iter().map(place))
}

/// Where edges of a model cross a height.
fn crossings(model: &Model, height: f64) -> Vec<DVec3> {
    let mut points = Vec::new();
    for part in &model.primitives {
        let place = |index: u32| DVec3::from_array(part.positions[index as usize].map(f64::from));
        for &[a, b, c] in part.indices.as_chunks::<3>().0 {
            for (from, to) in [(a, b), (b, c), (c, a)].map(|(from, to)| (place(from), place(to))) {
                let share = (height - from.y) / (to.y - from.y);
                if share > 0.0 && share < 1.0 {
                    points.push(from.lerp(to, share));
                }
            }
        }
    }
    points
}

#[test]
fn legs_of_tables_end_with_their_shapes_where_seats_are() {
    let is_table = |class: &Class| matches!(&class.model, ModelSource::Recipe { recipe, .. } if recipe.name() == "table");
    faults_of(is_table, |class, model, size| {
        let points = crossings(model, size.height * SEAT);
        assert!(!points.is_empty(), "{} has no legs", class.id);
        let farthest = points.into_iter().map(|point| outside(class, size, point)).fold(0.0, f64::max);
        (farthest > CLOSE).then(|| format!("{farthest:.3} m"))
    });
}

#[test]
fn nothing_stands_up_where_basins_carry_soap() {
    let carries = |class: &Class| class.groups.iter().any(|group| group == "basin_edge");
    faults_of(carries, |class, model, size| {
        let offer = class.offer(Side::Above);
        let [_, front, _, back] = offer.margin;
        let surface = offer.surface.expect("basins name the height of their rims");
        let is_carried = |point: &DVec3| {
            point.y > surface + CLOSE
                && point.z > back - size.depth / 2.0
                && point.z < size.depth / 2.0 - front
        };
        let standing = corners(model).filter(is_carried);
        let farthest = standing.map(|point| outside(class, size, point)).fold(0.0, f64::max);
        (farthest > CLOSE).then(|| format!("{farthest:.3} m"))
    });
}

/// How far the farthest corner of a model stands out of its class's shape, and where.
fn farthest_outside(class: &Class, model: &Model, size: Size) -> (f64, DVec3) {
    let is_firm = |part: &&Primitive| !LOOSE.iter().any(|&slot| part.material == ModelMaterial::Slot(slot));
    let points = model
        .primitives
        .iter()
        .filter(is_firm)
        .flat_map(|part| &part.positions)
        .map(|p| DVec3::from_array(p.map(f64::from)));
    points
        .map(|point| (outside(class, size, point), point))
        .fold((0.0, DVec3::ZERO), |worst, here| if here.0 > worst.0 { here } else { worst })
}

fn catalog() -> Catalog {
    load_catalog(&[]).expect("the built-in configuration is sound").value
}

#[test]
fn built_in_models_stay_in_the_shapes_of_their_classes() {
    let has_no_arm_rests = |class: &Class| !ARM_RESTS.contains(&class.id.as_str());
    faults_of(has_no_arm_rests, |class, model, size| {
        let (outside, at) = farthest_outside(class, model, size);
        (outside > TOLERANCE).then(|| format!("{outside:.3} m at {at:.3}"))
    });
}
