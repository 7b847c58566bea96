//! Finds the bodies that represent a product, in the axes of the building.

use glam::DAffine3;

use super::model::{Entity, Read, Trouble};
use super::placement::Geometry;
use super::solid::IfcBody;

/// Where an `IfcProduct` names its placement and its shape.
pub(super) const PLACEMENT: usize = 5;
const SHAPE: usize = 6;

/// The rank of a representation, lowest preferred; `None` for those without a body.
fn rank(identifier: &str) -> Option<u8> {
    match identifier.to_ascii_uppercase().as_str() {
        "BODY" => Some(0),
        "FOOTPRINT" => Some(2),
        "BOX" => Some(3),
        "AXIS" | "PLAN" | "ANNOTATION" | "PROFILE" | "COG" | "CLEARANCE" | "LIGHTING" | "REFERENCE" => None,
        _ => Some(1),
    }
}

impl Geometry<'_> {
    /// The place of a product in the world.
    pub(super) fn place(&self, product: &Entity) -> Read<DAffine3> {
        self.placement(product.value(PLACEMENT))
    }

    /// Whether a product claims a body or a footprint, whatever that is worth.
    pub(super) fn has_body(&self, product: &Entity) -> bool {
        let is_shaped = product.value(SHAPE).reference().is_some();
        is_shaped && !self.representations(product).is_ok_and(|all| all.is_empty())
    }

    /// The items of a product by representation, the best first.
    pub(super) fn representations(&self, product: &Entity) -> Read<Vec<Vec<u64>>> {
        let none = || product.trouble("it has no shape");
        let shape = self.model.get(product.value(SHAPE).reference().ok_or_else(none)?)?;
        let mut ranked = Vec::new();
        for id in shape.references(2)? {
            let representation = self.model.get(id)?;
            if let Some(rank) = rank(representation.text(1).unwrap_or_default()) {
                ranked.push((rank, representation.references(3)?));
            }
        }
        ranked.sort_by_key(|(rank, _)| *rank);
        Ok(ranked.into_iter().map(|(_, items)| items).collect())
    }

    /// The bodies of a product's first representation that can be read, moved from the world by a frame.
    pub(super) fn bodies(&self, product: &Entity, frame: &DAffine3) -> Read<Vec<IfcBody>> {
        let by = *frame * self.place(product)?;
        let mut first: Option<Trouble> = None;
        for items in self.representations(product)? {
            let bodies: Read<Vec<Vec<IfcBody>>> = items.into_iter().map(|item| self.item(item, 0)).collect();
            match bodies {
                Ok(bodies) => return Ok(bodies.iter().flatten().map(|body| body.moved(&by)).collect()),
                Err(trouble) => first = first.or(Some(trouble)),
            }
        }
        Err(first.unwrap_or_else(|| product.trouble("it has no body and no footprint")))
    }
}
