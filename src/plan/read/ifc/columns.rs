//! Reads walls and columns as outlines, on each storey that they stand on.

use std::collections::BTreeMap;

use glam::DAffine3;

use super::footprint::{Footprint, footprints};
use super::level::Storey;
use super::model::{Entity, Read};
use super::placement::Geometry;
use super::relations::Relations;
use crate::geometry::{Bounds, Point, Polygon};
use crate::plan::assemble::BoxIndex;
use crate::plan::clean::to_simple;
use crate::plan::{ObstacleDraft, RoomDraft};

/// Elements that divide rooms. Curtain walls and walls of parts have the bodies of their parts.
pub(super) const WALLS: [&str; 4] =
    ["IFCWALL", "IFCWALLSTANDARDCASE", "IFCWALLELEMENTEDCASE", "IFCCURTAINWALL"];
const COLUMNS: [&str; 2] = ["IFCCOLUMN", "IFCCOLUMNSTANDARDCASE"];
/// Metres above the floor between which something stands in the way of walkers.
const WALKED: (f64, f64) = (0.1, 1.0);
/// Metres below the ceiling up to which a column reaches it.
const AT_CEILING: f64 = 0.1;
/// Share of a column's width by which it must reach into a room.
const WITHIN: f64 = 0.9;

/// A building's products.
pub(super) struct Products<'a> {
    pub(super) geometry: &'a Geometry<'a>,
    pub(super) relations: &'a Relations,
    /// From the world to the building's axes.
    pub(super) frame: DAffine3,
    /// Its products by kind, ascending.
    pub(super) own: &'a Own,
}

/// The products of a building by kind.
pub(super) type Own = BTreeMap<&'static str, Vec<u64>>;

/// The kinds of products that are read, but for furniture.
pub(super) fn kinds() -> impl Iterator<Item = &'static str> {
    [&WALLS[..], &COLUMNS].concat().into_iter()
}

impl Products<'_> {
    /// The building's sound products of some kinds, ascending by kind; the others are noted.
    pub(super) fn all<'b>(&'b self, kinds: &'b [&'b str]) -> impl Iterator<Item = Entity> + 'b {
        let model = self.geometry.model;
        let ids = kinds.iter().filter_map(|kind| self.own.get(kind)).flatten();
        ids.filter_map(|id| model.sound(model.get(*id)))
    }

    /// Enters walls and columns into the storeys of a building.
    pub(super) fn stand(&self, storeys: &mut [Storey]) {
        let model = self.geometry.model;
        for product in self.all(&WALLS) {
            match self.outlines(&product) {
                Ok(outlines) => {
                    for outline in outlines {
                        let here = storeys.iter_mut().filter(|storey| storey.is_in_the_way(&outline));
                        here.for_each(|storey| storey.draft.wall_outlines.extend(outline.pieces()));
                    }
                }
                Err(trouble) => self.forget_walls(storeys, &product, &trouble.message),
            }
        }
        for storey in storeys.iter_mut().filter(|storey| storey.has_unread_walls) {
            storey.draft.wall_outlines.clear();
        }
        let places: Vec<BoxIndex<usize>> = storeys.iter().map(Storey::rooms_by_place).collect();
        for product in self.all(&COLUMNS) {
            match self.outlines(&product) {
                Ok(outlines) => outlines.iter().for_each(|outline| columns(storeys, &places, outline)),
                Err(trouble) => {
                    model.warn(trouble.id, format!("a column: {}", trouble.message), "it was left out")
                }
            }
        }
    }

    /// The outlines of a product or its parts, each body by itself.
    pub(super) fn outlines(&self, product: &Entity) -> Read<Vec<Footprint>> {
        let of = |product: &Entity| -> Read<Vec<Footprint>> {
            let bodies = self.geometry.bodies(product, &self.frame)?;
            Ok(bodies.iter().flat_map(|body| footprints(std::slice::from_ref(body))).collect())
        };
        let parts = self.relations.parts(product.id);
        match of(product) {
            Err(_) if !parts.is_empty() => {
                let parts = parts.iter().map(|part| of(&self.geometry.model.get(*part)?));
                Ok(parts.collect::<Read<Vec<_>>>()?.concat())
            }
            own => own,
        }
    }

    /// Where a wall is unknown, its absence cannot be known either.
    fn forget_walls(&self, storeys: &mut [Storey], wall: &Entity, reason: &str) {
        let home = self.relations.within(wall.id, |whole| storeys.iter().any(|storey| storey.id == whole));
        let on = storeys.iter_mut().filter(|storey| home.is_none_or(|home| storey.id == home));
        on.for_each(|storey| storey.has_unread_walls = true);
        let hint = "where rooms of its storey meet without a wall is not told: a wall is taken to be there";
        self.geometry.model.warn(wall.id, format!("a wall is not read: {reason}"), hint);
    }
}

impl Storey {
    pub(super) fn rooms_by_place(&self) -> BoxIndex<usize> {
        BoxIndex::of(self.draft.rooms.iter().map(|room| bounds(&room.outline)).zip(0..))
    }

    /// Whether something stands where people walk on this storey.
    pub(super) fn is_in_the_way(&self, footprint: &Footprint) -> bool {
        // A bare outline stands on its storey, as high as that is.
        let high = if footprint.high > footprint.low { footprint.high } else { footprint.low + WALKED.1 };
        footprint.low < self.floor + WALKED.1 && high > self.floor + WALKED.0
    }
}

/// Enters a column into the storeys on which it stands in a room; most are part of a wall.
fn columns(storeys: &mut [Storey], places: &[BoxIndex<usize>], column: &Footprint) {
    let here = storeys.iter_mut().zip(places).filter(|(storey, _)| storey.is_in_the_way(column));
    let bounds = bounds(&column.outer);
    for (storey, places) in here {
        storey.draft.wall_outlines.extend(Some(column.outer.clone()).filter(|_| !storey.has_unread_walls));
        let mut rooms = places.near(bounds).into_iter().map(|room| &storey.draft.rooms[room]);
        let Some(room) = rooms.find(|room| reaches_into(room, &column.outer)) else {
            continue;
        };
        let ceiling = room.height.map_or(f64::INFINITY, |height| storey.floor + height);
        let height = Some(column.high - storey.floor).filter(|_| column.high < ceiling - AT_CEILING);
        storey.draft.obstacles.push(ObstacleDraft { outline: column.outer.clone(), height });
    }
}

fn bounds(ring: &[Point]) -> Bounds {
    Bounds::around(ring.iter().copied())
}

fn reaches_into(room: &RoomDraft, column: &[Point]) -> bool {
    let middle = column.iter().sum::<Point>() / column.len().max(1) as f64;
    let Some(outline) = to_simple(&room.outline) else { return false };
    let holes: Vec<Polygon> = room.holes.iter().filter_map(|hole| to_simple(hole)).collect();
    let places = column.iter().map(|corner| middle.lerp(*corner, WITHIN)).chain([middle]);
    places
        .filter(|place| outline.contains(*place))
        .any(|place| !holes.iter().any(|hole| hole.contains(place)))
}
