//! Finds the carrier of a piece: the object that it stands or hangs on, and moves with.
//!
//! The layout's parent is the object that a piece was arranged by: a sofa belongs to the television that it faces, but
//! stands on the floor. Only pieces that rest on another object are its children in the tree.

use crate::catalog::{Catalog, ParentName, Side};
use crate::layout::{Parent, Placement};

/// The placement that carries each placement; `None` for what stands on the floor or hangs on a wall, a door, a window or
/// the ceiling. Carriers come before what they carry, as parents do.
pub(crate) fn carriers(catalog: &Catalog, placements: &[Placement]) -> Vec<Option<usize>> {
    let mut carriers: Vec<Option<usize>> = Vec::with_capacity(placements.len());
    for placement in placements {
        let carrier = match placement.parent {
            Parent::Object(parent) => object_carrier(catalog, placement, parent, placements, &carriers),
            _ => None,
        };
        carriers.push(carrier);
    }
    carriers
}

fn object_carrier(
    catalog: &Catalog,
    placement: &Placement,
    parent: usize,
    placements: &[Placement],
    earlier: &[Option<usize>],
) -> Option<usize> {
    let contact = catalog.audit.bodies.support_gap;
    let beside = &placements[parent];
    if placement.elevation <= contact {
        return None;
    }
    match placement.side {
        // A hood belongs to its cooker, but hangs on the wall.
        Side::Above => {
            (placement.elevation <= beside.elevation + beside.size.height + contact).then_some(parent)
        }
        Side::Below => Some(parent),
        // Books in a row stand on one shelf, wall units hang on one wall.
        _ if (placement.elevation - beside.elevation).abs() <= contact => earlier[parent],
        _ if hangs_on_walls(catalog, placement) => None,
        _ => Some(parent),
    }
}

fn hangs_on_walls(catalog: &Catalog, placement: &Placement) -> bool {
    catalog.classes[placement.class].parents.iter().any(|rule| rule.parent == ParentName::Wall)
}
