//! Reads points and directions, and follows the chain of placements from a product up to its building.

use std::cell::RefCell;
use std::collections::HashMap;

use glam::{DAffine3, DMat3, DVec3};

use super::model::{Entity, Model, Read};
use super::units::Units;
use super::value::Value;

/// Placements in placements; buildings have five or six.
const LONGEST_CHAIN: usize = 256;
/// Vectors shorter than this have no direction.
const SHORTEST: f64 = 1e-9;

/// Reads shapes and their places, in metres.
pub(super) struct Geometry<'a> {
    pub(super) model: &'a Model,
    pub(super) units: Units,
    /// Local placement → place in the world. Asked, never listed, so that its order shows nowhere.
    placed: RefCell<HashMap<u64, DAffine3>>,
}

impl<'a> Geometry<'a> {
    pub(super) fn new(model: &'a Model) -> Self {
        Self { model, units: Units::of(model), placed: RefCell::default() }
    }

    /// The coordinates of a point in two or three dimensions.
    pub(super) fn point(&self, id: u64) -> Read<DVec3> {
        let point = self.model.get(id)?;
        self.coordinates(&point, point.value(0))
    }

    /// Numbers of a list as metres.
    pub(super) fn coordinates(&self, of: &Entity, list: &Value) -> Read<DVec3> {
        let numbers: Option<Vec<f64>> = list.items().iter().map(Value::number).collect();
        match numbers.as_deref() {
            Some([x, y]) => Ok(DVec3::new(*x, *y, 0.0) * self.units.length),
            Some([x, y, z]) => Ok(DVec3::new(*x, *y, *z) * self.units.length),
            _ => Err(of.trouble("a point has two or three coordinates")),
        }
    }

    /// A unit vector; `None` where nothing is named.
    pub(super) fn direction(&self, named: &Value) -> Read<Option<DVec3>> {
        let Some(id) = named.reference() else { return Ok(None) };
        let direction = self.model.get(id)?;
        let numbers: Option<Vec<f64>> = direction.value(0).items().iter().map(Value::number).collect();
        let vector = match numbers.as_deref() {
            Some([x, y]) => DVec3::new(*x, *y, 0.0),
            Some([x, y, z]) => DVec3::new(*x, *y, *z),
            _ => return Err(direction.trouble("a direction has two or three numbers")),
        };
        let unit = vector.try_normalize().filter(|_| vector.length() > SHORTEST);
        unit.map(Some).ok_or_else(|| direction.trouble("a direction without length"))
    }

    /// A placement with its own axes, in two or three dimensions; the identity where none is named.
    pub(super) fn axes(&self, named: &Value) -> Read<DAffine3> {
        let Some(id) = named.reference() else { return Ok(DAffine3::IDENTITY) };
        let placement = self.model.get(id)?;
        let origin = self.point(placement.reference(0)?)?;
        let (z, x) = match placement.kind.as_str() {
            "IFCAXIS2PLACEMENT2D" => (None, self.direction(placement.value(1))?),
            "IFCAXIS2PLACEMENT3D" => {
                (self.direction(placement.value(1))?, self.direction(placement.value(2))?)
            }
            _ => return Err(placement.trouble("no placement that is known here")),
        };
        let z = z.unwrap_or(DVec3::Z);
        let x = across(x.unwrap_or(DVec3::X), z);
        Ok(DAffine3::from_mat3_translation(DMat3::from_cols(x, z.cross(x), z), origin))
    }

    /// The place of an `IfcLocalPlacement` in the world; the identity where none is named.
    pub(super) fn placement(&self, named: &Value) -> Read<DAffine3> {
        let mut chain: Vec<(u64, DAffine3)> = Vec::new();
        let mut next = named.reference();
        let mut world = DAffine3::IDENTITY;
        while let Some(id) = next {
            if let Some(known) = self.placed.borrow().get(&id) {
                world = *known;
                break;
            }
            let placement = self.model.get(id)?;
            if placement.kind != "IFCLOCALPLACEMENT" {
                return Err(placement.trouble("only local placements are read"));
            }
            if chain.len() >= LONGEST_CHAIN {
                return Err(placement.trouble("placements refer to each other without end"));
            }
            chain.push((id, self.axes(placement.value(1))?));
            next = placement.value(0).reference();
        }
        for (id, own) in chain.into_iter().rev() {
            world *= own;
            self.placed.borrow_mut().insert(id, world);
        }
        Ok(world)
    }

    /// A Cartesian transformation operator: turns, scales and mirrors.
    pub(super) fn operator(&self, id: u64) -> Read<DAffine3> {
        let operator = self.model.get(id)?;
        if !operator.kind.starts_with("IFCCARTESIANTRANSFORMATIONOPERATOR") {
            return Err(operator.trouble("no transformation that is known here"));
        }
        let z = self.direction(operator.value(4))?.unwrap_or(DVec3::Z);
        let y = self.direction(operator.value(1))?;
        let x = match (self.direction(operator.value(0))?, y) {
            (Some(x), _) => across(x, z),
            (None, Some(y)) => across(y.cross(z), z),
            (None, None) => across(DVec3::X, z),
        };
        let left = z.cross(x);
        let y = if y.is_some_and(|y| y.dot(left) < 0.0) { -left } else { left };
        let origin = self.point(operator.reference(2)?)?;
        let scale = operator.value(3).number().unwrap_or(1.0);
        let other = |place: usize| operator.value(place).number().unwrap_or(scale);
        let is_uneven = operator.kind.ends_with("NONUNIFORM");
        let is_flat = operator.kind.contains("2D");
        let (second, third) = match (is_uneven, is_flat) {
            (true, true) => (other(4), scale),
            (true, false) => (other(5), other(6)),
            _ => (scale, scale),
        };
        let axes = DMat3::from_cols(x * scale, y * second, z * third);
        if axes.determinant().abs() < SHORTEST {
            return Err(operator.trouble("a transformation onto nothing"));
        }
        Ok(DAffine3::from_mat3_translation(axes, origin))
    }
}

/// The part of a direction that is at right angles to an axis; any, if they are parallel.
fn across(direction: DVec3, axis: DVec3) -> DVec3 {
    let rest = direction - axis * direction.dot(axis);
    if rest.length() > SHORTEST { rest.normalize() } else { axis.any_orthonormal_vector() }
}
