//! Spaces that a building holds itself, without a storey, as small programs write them: each height of floors is a storey.

use glam::DAffine3;

use super::level::LOWEST_STOREY;
use super::model::Entity;
use super::placement::Geometry;
use super::solid::IfcBody;

/// The spaces of each height of floors, the lowest first; those of one height in their order.
pub(super) fn by_floors(geometry: &Geometry<'_>, frame: &DAffine3, spaces: Vec<Entity>) -> Vec<Vec<Entity>> {
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
    storeys.into_iter().map(|(_, storey)| storey).collect()
}

/// Metres of the lowest point of a space, of one without a body of its place; faults are reported where its room is read.
fn floor_of(geometry: &Geometry<'_>, frame: &DAffine3, space: &Entity) -> f64 {
    let bodies = geometry.bodies(space, frame).unwrap_or_default();
    let lowest = bodies.iter().flat_map(IfcBody::corners).map(|corner| corner.z).reduce(f64::min);
    let place = || geometry.place(space).map(|place| (*frame * place).translation.z).ok();
    lowest.or_else(place).filter(|floor| floor.is_finite()).unwrap_or_default()
}
