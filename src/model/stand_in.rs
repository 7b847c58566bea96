//! The boxes and cylinders of a class's shape as a model.

use glam::{DVec3, Vec3};

use super::{Model, ModelMaterial, Primitive};
use crate::catalog::{Extent, PrismRule, Shape, Size};
use crate::recipes::kit::{Bay, Builder, Solid, cuboid, cylinder};

/// Corners of a disc: enough to tell it from a box, and some on both axes, so that it fills its own.
const DISC_CORNERS: usize = 12;
/// Metres by which a part of the model may stand out of its prism and still count as its look.
const REACH: f64 = 0.03;

/// A stand-in for a model: one solid for each prism of the class's shape, in the material that covers most of what the
/// model has there.
pub(crate) fn stand_in(model: &Model, shape: &Shape, size: Size) -> Model {
    let rules = prisms_of(shape);
    let mut primitives: Vec<Primitive> = Vec::new();
    for rule in &rules {
        let material = prevailing(model, |point| distance_outside(point, rule, size) <= REACH)
            .or_else(|| prevailing(model, |_| true))
            .unwrap_or_default();
        // Each prism is built alone, for a builder fits what it is given to the whole box.
        for part in Builder::unfitted(solid(rule, size)).parts {
            let mut primitive = Primitive::from(part);
            match primitives.iter_mut().find(|known| known.material == material) {
                Some(known) => append(known, &primitive),
                None => {
                    primitive.material = material.clone();
                    primitives.push(primitive);
                }
            }
        }
    }
    primitives.iter_mut().for_each(repeat_coordinates);
    Model { primitives }
}

/// Boxes have one set of texture coordinates: whatever is laid on by another is laid on by that.
fn repeat_coordinates(primitive: &mut Primitive) {
    let ModelMaterial::Own(own) = &primitive.material else { return };
    let further = own.coordinate_set_count().saturating_sub(1);
    primitive.further_coordinates = vec![primitive.texture_coordinates.clone(); further];
}

/// The parts of a shape, whatever it is.
pub fn prisms_of(shape: &Shape) -> Vec<PrismRule> {
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

/// Low and high corner of a prism in the class's frame, from the box's low corner: width to the right, depth to the back,
/// height upwards.
fn corners(rule: &PrismRule, size: Size) -> [DVec3; 2] {
    let extent = [size.width, size.depth, size.height];
    [rule.low, rule.high].map(|corner| {
        DVec3::from_array([0, 1, 2].map(|axis| corner[axis].share * extent[axis] + corner[axis].offset))
    })
}

/// Metres by which a point of a model stands out of a part of a shape.
pub fn distance_outside(point: DVec3, rule: &PrismRule, size: Size) -> f64 {
    let local = DVec3::new(point.x + size.width / 2.0, size.depth / 2.0 - point.z, point.y);
    let [low, high] = corners(rule, size);
    if rule.is_disc {
        let half = (high - low) / 2.0;
        let off = (local - (low + high) / 2.0) / half;
        let beyond = (off.truncate().length() - 1.0).max(0.0) * half.truncate().min_element();
        return beyond.max(low.z - local.z).max(local.z - high.z);
    }
    (low - local).max(local - high).max(DVec3::ZERO).max_element()
}

/// A prism as a solid in the model's frame, cut to the class's box.
fn solid(rule: &PrismRule, size: Size) -> Solid {
    let extent = DVec3::new(size.width, size.depth, size.height);
    let [low, high] = corners(rule, size).map(|corner| corner.clamp(DVec3::ZERO, extent));
    let (width, depth) = (size.width / 2.0, size.depth / 2.0);
    let bay = Bay::new([low.x - width, high.x - width], [low.z, high.z], [depth - high.y, depth - low.y]);
    if !rule.is_disc {
        return cuboid(bay);
    }
    let middle = (bay.low + bay.high) / 2.0;
    let half = bay.extent() / 2.0;
    let unit = cylinder(1.0, [0.0, 1.0], DISC_CORNERS);
    // Its corners lie on the circle and its sides within.
    unit.stretched(DVec3::new(half.x, bay.extent().y, half.z)).moved(middle.x, bay.low.y, middle.z)
}

/// The material with the most area among triangles whose middle fulfils a condition; of equal ones the first.
fn prevailing(model: &Model, is_counted: impl Fn(DVec3) -> bool) -> Option<ModelMaterial> {
    let area = |primitive: &Primitive| -> f64 {
        let triangles = primitive.indices.as_chunks::<3>().0.iter();
        let corners = triangles.map(|triangle| {
            triangle.map(|index| Vec3::from_array(primitive.positions[index as usize]).as_dvec3())
        });
        let counted = corners.filter(|[a, b, c]| is_counted((a + b + c) / 3.0));
        counted.map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum()
    };
    let mut best: Option<(f64, &Primitive)> = None;
    for primitive in &model.primitives {
        let area = area(primitive);
        if area > best.map_or(0.0, |(most, _)| most) {
            best = Some((area, primitive));
        }
    }
    best.map(|(_, primitive)| primitive.material.clone())
}

fn append(to: &mut Primitive, from: &Primitive) {
    let first = to.positions.len() as u32;
    to.positions.extend_from_slice(&from.positions);
    to.normals.extend_from_slice(&from.normals);
    to.texture_coordinates.extend_from_slice(&from.texture_coordinates);
    to.indices.extend(from.indices.iter().map(|index| first + index));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipes::{GeometrySet, RecipeInput, find};

    fn desk() -> (Model, Size) {
        let recipe = find("desk").unwrap();
        let size = recipe.usual_size();
        let input = RecipeInput { size, look: 0, geometry: GeometrySet::Plain, parameters: &[] };
        (recipe.build(&input).into(), size)
    }

    fn rule(is_disc: bool, low: [f64; 3], high: [f64; 3]) -> PrismRule {
        let extents = |shares: [f64; 3]| shares.map(|share| Extent { share, offset: 0.0 });
        PrismRule { is_disc, low: extents(low), high: extents(high) }
    }

    #[test]
    fn a_box_is_twelve_triangles_that_fill_it() {
        let (desk, size) = desk();
        let model = stand_in(&desk, &Shape::Box, size);
        assert_eq!(model.primitives.len(), 1);
        assert_eq!(model.primitives[0].indices.len(), 36);
        let high = model.primitives[0].positions.iter().map(|point| point[1]).fold(0.0, f32::max);
        assert!((f64::from(high) - size.height).abs() < 1e-6);
    }

    #[test]
    fn parts_stand_where_the_shape_says_and_look_like_what_is_there() {
        let (desk, size) = desk();
        let top = rule(false, [0.0, 0.0, 0.95], [1.0; 3]);
        let leg = rule(true, [0.0, 0.0, 0.0], [0.1, 0.1, 0.95]);
        let model = stand_in(&desk, &Shape::Prisms(vec![top, leg]), size);
        let triangles: usize = model.primitives.iter().map(|part| part.indices.len() / 3).sum();
        assert_eq!(triangles, 12 + 4 * DISC_CORNERS - 4);
        let is_known = |part: &Primitive| desk.primitives.iter().any(|known| known.material == part.material);
        assert!(model.primitives.iter().all(is_known));
        // The leg at the left front: at −X and +Z in the model's frame.
        let points = || model.primitives.iter().flat_map(|part| &part.positions);
        let feet = points().filter(|point| point[1] < 0.01);
        assert!(feet.clone().count() > 0 && feet.clone().all(|point| point[0] < 0.0 && point[2] > 0.0));
    }
}
