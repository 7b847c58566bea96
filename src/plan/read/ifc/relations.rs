//! Reads the relations of instances: parts and wholes, openings and their doors, types, classes, and the spaces of doors.

use std::collections::{BTreeMap, BTreeSet};

use super::model::{Entity, Model, Read};

/// Wholes of wholes; a building has five.
const DEEPEST: usize = 64;

/// The relations of a file that a plan needs.
#[derive(Debug, Default)]
pub(super) struct Relations {
    /// Part or contained product → what it is in.
    whole_of: BTreeMap<u64, u64>,
    /// Whole → its parts, in the file's order.
    parts_of: BTreeMap<u64, Vec<u64>>,
    /// Hole in a wall → the wall.
    pub(super) host_of: BTreeMap<u64, u64>,
    /// Door or window → the hole that it fills.
    pub(super) hole_of: BTreeMap<u64, u64>,
    /// Hole → how many fill it.
    pub(super) fillers: BTreeMap<u64, usize>,
    /// Product → its type.
    pub(super) type_of: BTreeMap<u64, u64>,
    /// Product → the spaces that it bounds.
    pub(super) spaces_of: BTreeMap<u64, BTreeSet<u64>>,
    /// Space → the relations that bound it, ascending by kind.
    boundaries_of: BTreeMap<u64, Vec<u64>>,
    /// Product → the classifications that it has, as references to OmniClass or other tables.
    classes_of: BTreeMap<u64, Vec<u64>>,
}

impl Relations {
    /// Goes through the relations of a file once.
    pub(super) fn of(model: &Model) -> Self {
        let mut relations = Self::default();
        let mut each = |kinds: &[&str], (one, many): (usize, usize), enter: fn(&mut Self, u64, u64)| {
            for relation in model.all(kinds) {
                if let Some((whole, parts)) = model.sound(ends(&relation, one, many)) {
                    parts.into_iter().for_each(|part| enter(&mut relations, whole, part));
                }
            }
        };
        each(&["IFCRELAGGREGATES"], (4, 5), |all, whole, part| {
            all.whole_of.insert(part, whole);
            all.parts_of.entry(whole).or_default().push(part);
        });
        // A part of a whole may be contained in the storey as well; the whole says more.
        each(&["IFCRELCONTAINEDINSPATIALSTRUCTURE"], (5, 4), |all, whole, part| {
            all.whole_of.entry(part).or_insert(whole);
        });
        each(&["IFCRELVOIDSELEMENT"], (4, 5), |all, wall, hole| {
            all.host_of.insert(hole, wall);
        });
        each(&["IFCRELFILLSELEMENT"], (4, 5), |all, hole, filler| {
            all.hole_of.insert(filler, hole);
            *all.fillers.entry(hole).or_default() += 1;
        });
        each(&["IFCRELDEFINESBYTYPE"], (5, 4), |all, kind, product| {
            all.type_of.insert(product, kind);
        });
        each(&["IFCRELASSOCIATESCLASSIFICATION"], (5, 4), |all, class, product| {
            all.classes_of.entry(product).or_default().push(class);
        });
        relations.read_boundaries(model);
        relations
    }

    fn read_boundaries(&mut self, model: &Model) {
        const KINDS: [&str; 3] =
            ["IFCRELSPACEBOUNDARY", "IFCRELSPACEBOUNDARY1STLEVEL", "IFCRELSPACEBOUNDARY2NDLEVEL"];
        for boundary in model.all(&KINDS) {
            let Some(space) = boundary.value(4).reference() else { continue };
            self.boundaries_of.entry(space).or_default().push(boundary.id);
            // Boundaries between rooms without a wall name no product.
            if let Some(product) = boundary.value(5).reference() {
                self.spaces_of.entry(product).or_default().insert(space);
            }
        }
    }

    /// The parts of a whole, in the file's order.
    pub(super) fn parts(&self, whole: u64) -> &[u64] {
        self.parts_of.get(&whole).map_or(&[], Vec::as_slice)
    }

    /// The boundaries of a space, ascending by kind.
    pub(super) fn boundaries(&self, space: u64) -> &[u64] {
        self.boundaries_of.get(&space).map_or(&[], Vec::as_slice)
    }

    /// The classifications of a product, in the file's order.
    pub(super) fn classes(&self, product: u64) -> &[u64] {
        self.classes_of.get(&product).map_or(&[], Vec::as_slice)
    }

    /// The wholes that a part belongs to, from the nearest to the farthest.
    pub(super) fn wholes(&self, part: u64) -> impl Iterator<Item = u64> {
        std::iter::successors(self.whole_of.get(&part), |whole| self.whole_of.get(whole))
            .copied()
            .take(DEEPEST)
    }

    /// The nearest whole, also by the wall that an opening is in, that is one of some.
    pub(super) fn within(&self, part: u64, is_wanted: impl Fn(u64) -> bool) -> Option<u64> {
        let host = self.hole_of.get(&part).unwrap_or(&part);
        let host = self.host_of.get(host).copied();
        let by_host = || host.and_then(|host| self.wholes(host).find(|whole| is_wanted(*whole)));
        self.wholes(part).find(|whole| is_wanted(*whole)).or_else(by_host)
    }
}

fn ends(relation: &Entity, one: usize, many: usize) -> Read<(u64, Vec<u64>)> {
    Ok((relation.reference(one)?, relation.references(many)?))
}
