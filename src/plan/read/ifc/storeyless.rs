//! Spaces that a building holds itself, without a storey, as small programs write them: they are on the storey on which their floors
//! lie, else each height of floors is one.

use glam::DAffine3;

use super::level::{LOWEST_STOREY, elevation};
use super::model::Entity;
use super::placement::Geometry;
use super::solid::IfcBody;

/// The number of the storey whose floor lies at a height, if there is one.
pub(super) fn storey_at(
    geometry: &Geometry<'_>,
    frame: &DAffine3,
    storeys: &[Entity],
    floor: f64,
) -> Option<usize> {
    let distance = |number: &usize| (elevation(geometry, frame, &storeys[*number], floor) - floor).abs();
    let nearest = (0..storeys.len()).min_by(|one, other| distance(one).total_cmp(&distance(other)));
    nearest.filter(|number| distance(number) < LOWEST_STOREY / 2.0)
}

/// The heights of floors in metres with their spaces, the lowest first; those of one height in their order.
pub(super) fn by_floors(
    geometry: &Geometry<'_>,
    frame: &DAffine3,
    spaces: Vec<Entity>,
) -> Vec<(f64, Vec<Entity>)> {
    let mut spaces: Vec<(f64, Entity)> =
        spaces.into_iter().map(|space| (floor_of(geometry, frame, &space), space)).collect();
    spaces.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut storeys: Vec<(f64, Vec<Entity>)> = Vec::new();
    for (floor, space) in spaces {
        match storeys.last_mut() {
            Some((lowest, storey)) if floor - *lowest < LOWEST_STOREY => storey.push(space),
            _ => storeys.push((floor, vec![space])),
        }
    }
    storeys
}

/// Metres of the lowest point of a space, of one without a body of its place; faults are reported where its room is read.
fn floor_of(geometry: &Geometry<'_>, frame: &DAffine3, space: &Entity) -> f64 {
    let bodies = geometry.bodies(space, frame).unwrap_or_default();
    let lowest = bodies.iter().flat_map(IfcBody::corners).map(|corner| corner.z).reduce(f64::min);
    let place = || geometry.place(space).map(|place| (*frame * place).translation.z).ok();
    lowest.or_else(place).filter(|floor| floor.is_finite()).unwrap_or_default()
}
