//! Turns storeys into drafted levels.

use std::collections::{BTreeMap, BTreeSet};

use glam::DAffine3;

use super::model::Entity;
use super::placement::Geometry;
use super::relations::Relations;
use super::rooms::{Naming, Outlined, Space, space};
use crate::plan::read::foreign::UniqueIds;
use crate::plan::{LevelDraft, OutlineKind};

/// Metres of slab between the highest ceiling and what is above, where no storey says more.
const SLAB_THICKNESS: f64 = 0.3;
/// Metres of outer walls behind which nothing is known.
const EXTERIOR_THICKNESS: f64 = 0.35;
/// Metres of walls between rooms whose outlines touch; gaps between spaces say more.
const INTERIOR_THICKNESS: f64 = 0.12;
/// Metres between the floors of two storeys of which the upper stands on the lower.
pub(super) const LOWEST_STOREY: f64 = 1.8;

/// A storey while it is read.
pub(super) struct Storey {
    /// Its instance.
    pub(super) id: u64,
    /// Metres of the floor of its rooms, and of what is above them, in the building's axes.
    pub(super) floor: f64,
    pub(super) top: f64,
    pub(super) draft: LevelDraft,
    /// Space → its rooms in the draft.
    pub(super) rooms_of: BTreeMap<u64, Vec<usize>>,
    /// Whether a wall could not be read, so that the absence of walls cannot be known.
    pub(super) has_unread_walls: bool,
    /// Spaces without a body and without boundaries that have a shape.
    pub(super) bodiless: Vec<Entity>,
    opening_ids: BTreeSet<String>,
}

/// The spaces of a storey, and what is known of them.
pub(super) struct Spaces<'a, 'b> {
    pub(super) own: &'a [Entity],
    pub(super) relations: &'a Relations,
    pub(super) naming: &'a mut Naming<'b>,
}

impl Storey {
    /// Reads the rooms of a storey; what cannot be read is noted.
    pub(super) fn read(
        geometry: &Geometry<'_>,
        frame: &DAffine3,
        storey: &Entity,
        spaces: Spaces<'_, '_>,
    ) -> Self {
        let model = geometry.model;
        let Spaces { own, relations, naming } = spaces;
        naming.taken = UniqueIds::default();
        let mut read: Vec<Space> = Vec::new();
        let mut bodiless: Vec<Entity> = Vec::new();
        for entity in own {
            match space(geometry, frame, entity, relations.boundaries(entity.id), naming) {
                Ok(Outlined::Space(space)) => read.push(space),
                Ok(Outlined::Bodiless) => bodiless.push(entity.clone()),
                Err(trouble) => {
                    let name = entity.text(2).or(entity.text(7)).unwrap_or_default();
                    let hint = "the room is left out; export the space as a swept profile or a body of faces";
                    model.error(&trouble, &format!("space \"{name}\": "), hint);
                }
            }
        }
        let floor = read.iter().map(|space| space.low).fold(f64::INFINITY, f64::min);
        let elevation = elevation(geometry, frame, storey, floor);
        let draft = LevelDraft {
            name: storey.text(2).or(storey.text(7)).unwrap_or_default().to_owned(),
            elevation,
            exterior_thickness: EXTERIOR_THICKNESS,
            interior_thickness: INTERIOR_THICKNESS,
            outlines: OutlineKind::Inner,
            ..LevelDraft::default()
        };
        let (floor, top) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut storey = Self {
            id: storey.id,
            floor,
            top,
            draft,
            rooms_of: BTreeMap::new(),
            has_unread_walls: false,
            bodiless,
            opening_ids: BTreeSet::new(),
        };
        read.into_iter().for_each(|space| storey.add(space));
        storey
    }

    /// The storey of the spaces that a building holds itself: it lies where their floor does, and has no name.
    pub(super) fn without_storey(mut self) -> Self {
        self.draft.name.clear();
        if self.floor.is_finite() {
            self.draft.elevation = self.floor;
        }
        self
    }

    /// Adds the rooms of a space.
    pub(super) fn add(&mut self, space: Space) {
        self.floor = self.floor.min(space.low);
        self.top = self.top.max(space.high + SLAB_THICKNESS);
        let first = self.draft.rooms.len();
        self.draft.rooms.extend(space.rooms);
        self.rooms_of.insert(space.id, (first..self.draft.rooms.len()).collect());
    }

    /// The global id, by which people find the product in their own program; its number where that is taken.
    pub(super) fn free_opening_id(&mut self, product: &Entity) -> String {
        let ids = [product.text(0).unwrap_or_default().to_owned(), format!("opening_{}", product.id)];
        let free = ids.into_iter().find(|id| !id.is_empty() && self.opening_ids.insert(id.clone()));
        free.unwrap_or_default()
    }
}

/// Metres of a storey in the building's axes. Files disagree whether the placement or the attribute says it: the one
/// nearer to the floor of the rooms does.
pub(super) fn elevation(geometry: &Geometry<'_>, frame: &DAffine3, storey: &Entity, floor: f64) -> f64 {
    let placed = geometry.model.sound(geometry.place(storey)).map(|place| (*frame * place).translation.z);
    let said = storey.value(9).number().map(|number| number * geometry.units.length);
    let off = |height: &f64| if floor.is_finite() { (height - floor).abs() } else { 0.0 };
    // The first of equals.
    let nearest =
        placed.into_iter().chain(said).reduce(|best, next| if off(&next) < off(&best) { next } else { best });
    nearest.unwrap_or(if floor.is_finite() { floor } else { 0.0 })
}

/// Ids and heights: a storey ends where the next with rooms begins, the last above its highest room.
pub(super) fn stack(storeys: &mut Vec<Storey>) {
    storeys.retain(|storey| !storey.draft.rooms.is_empty());
    storeys.sort_by(|a, b| a.draft.elevation.total_cmp(&b.draft.elevation).then(a.id.cmp(&b.id)));
    let mut ids = UniqueIds::default();
    for index in 0..storeys.len() {
        let own = storeys[index].draft.elevation;
        let above = storeys[index + 1..].iter().map(|storey| storey.draft.elevation - own);
        let above = above.into_iter().find(|height| *height >= LOWEST_STOREY);
        let storey = &mut storeys[index];
        storey.draft.height = above.unwrap_or(storey.top - own);
        storey.top = storey.top.max(own + storey.draft.height);
        storey.draft.id = ids.of_name(&storey.draft.name, &format!("storey_{index}"));
    }
}
