//! Whether models agree with the collision shapes that the catalogue declares for their classes.

use std::fmt::Write as _;

use glam::DVec3;

use roomwright::internals::catalog::{Class, ModelSource, Side, Size, VariantRef};
use roomwright::internals::model::{
    Model, ModelLibrary, ModelMaterial, Primitive, distance_outside, prisms_of,
};
use roomwright::internals::recipes::{GeometrySet, Slot};

use crate::CATALOG;

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

/// How far the farthest of some points lies outside of the prisms of a class, and where; zero where none does. Models have millions of
/// corners: who is inside one prism is not compared with the others.
fn farthest_outside(class: &Class, size: Size, points: impl Iterator<Item = DVec3>) -> (f64, DVec3) {
    let prisms = prisms_of(&class.shape);
    let mut worst = (0.0, DVec3::ZERO);
    for point in points {
        let mut outside = f64::MAX;
        for prism in &prisms {
            outside = outside.min(distance_outside(point, prism, size));
            if outside <= worst.0 {
                break;
            }
        }
        if outside > worst.0 {
            worst = (outside, point);
        }
    }
    worst
}

/// Calls `check` with every model of the classes that are wanted, and lists what it finds.
fn faults_of(is_wanted: impl Fn(&Class) -> bool, check: impl Fn(&Class, &Model, Size) -> Option<String>) {
    let catalog = &*CATALOG;
    let library = ModelLibrary::load(catalog).unwrap();
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
        let (farthest, _) = farthest_outside(class, size, points.into_iter());
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
        let (farthest, _) = farthest_outside(class, size, corners(model).filter(is_carried));
        (farthest > CLOSE).then(|| format!("{farthest:.3} m"))
    });
}

/// The corners of a model but for those of loose pillows.
fn firm_corners(model: &Model) -> impl Iterator<Item = DVec3> {
    let is_firm = |part: &&Primitive| !LOOSE.iter().any(|&slot| part.material == ModelMaterial::Slot(slot));
    let parts = model.primitives.iter().filter(is_firm);
    parts.flat_map(|part| &part.positions).map(|place| DVec3::from_array(place.map(f64::from)))
}

#[test]
fn built_in_models_stay_in_the_shapes_of_their_classes() {
    let has_no_arm_rests = |class: &Class| !ARM_RESTS.contains(&class.id.as_str());
    faults_of(has_no_arm_rests, |class, model, size| {
        let (outside, at) = farthest_outside(class, size, firm_corners(model));
        (outside > TOLERANCE).then(|| format!("{outside:.3} m at {at:.3}"))
    });
}
