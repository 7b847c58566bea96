//! The objects of a room in the frames of their carriers, so that children follow their parents.

use super::file::ObjectEntry;
use crate::catalog::{Catalog, ClassIndex, Side, Size};
use crate::contract::ObjectId;
use crate::geometry::{Point, direction};
use crate::layout::{Furnished, Parent, Placement};
use crate::plan::Room;

/// Metres from the top of an object within which something stands on it.
const ON_TOP: f64 = 1e-3;

/// The room's objects; indices stay while it is edited.
pub(super) struct Tree {
    pub(super) objects: Vec<Object>,
}

/// One object.
#[derive(Clone, Debug)]
pub(super) struct Object {
    pub(super) class: ClassIndex,
    pub(super) number: u32,
    /// The id that the arrangement gave it, if that is another one.
    pub(super) former_id: Option<String>,
    pub(super) on: Parent,
    pub(super) side: Side,
    /// In the frame of the object that it stands on, else in that of the level.
    pub(super) place: ObjectPlace,
    /// Where it was arranged, in the level, unless it was moved.
    pub(super) arranged: Option<ObjectPlace>,
    pub(super) variant: u32,
    pub(super) size: Size,
    pub(super) is_gone: bool,
}

/// Where an object is, in some frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ObjectPlace {
    /// Metres.
    pub(super) position: Point,
    /// Metres above the frame's origin.
    pub(super) elevation: f64,
    /// Radians counter-clockwise.
    pub(super) angle: f64,
}

impl ObjectPlace {
    /// As seen from a frame.
    pub(super) fn seen_from(&self, frame: &Self) -> Self {
        let (across, offset) = (direction(frame.angle), self.position - frame.position);
        Self {
            position: Point::new(offset.dot(across), offset.dot(across.perp())),
            elevation: self.elevation - frame.elevation,
            angle: self.angle - frame.angle,
        }
    }

    /// The place that this one is in a frame.
    pub(super) fn put_into(&self, frame: &Self) -> Self {
        let across = direction(frame.angle);
        Self {
            position: frame.position + across * self.position.x + across.perp() * self.position.y,
            elevation: frame.elevation + self.elevation,
            angle: frame.angle + self.angle,
        }
    }

    /// The place of a placement in the level.
    pub(super) fn of(placement: &Placement) -> Self {
        let Placement { position, elevation, angle, .. } = *placement;
        Self { position, elevation, angle }
    }

    /// The place that an edit asks for, as far as it says so.
    pub(super) fn edited(&self, entry: &ObjectEntry) -> Self {
        let at = entry.at.as_deref().unwrap_or_default();
        Self {
            position: at.first().zip(at.get(1)).map_or(self.position, |(&x, &y)| Point::new(x, y)),
            elevation: at.get(2).copied().unwrap_or(self.elevation),
            angle: entry.turn.map_or(self.angle, f64::to_radians),
        }
    }
}

impl Tree {
    pub(super) fn new(furnished: &Furnished) -> Self {
        let placements = &furnished.placements;
        let object = |placement: &Placement| {
            let arranged = ObjectPlace::of(placement);
            let place = match placement.parent {
                Parent::Object(parent) => arranged.seen_from(&ObjectPlace::of(&placements[parent])),
                _ => arranged,
            };
            Object {
                class: placement.class,
                number: placement.number,
                former_id: None,
                on: placement.parent,
                side: placement.side,
                place,
                arranged: Some(arranged),
                variant: placement.variant,
                size: placement.size,
                is_gone: false,
            }
        };
        Self { objects: placements.iter().map(object).collect() }
    }

    /// The object of an id: of one that an edit gave it, or of the one that it was arranged with.
    pub(super) fn find(&self, id: &str, catalog: &Catalog) -> Option<usize> {
        let ObjectId { class, number } = id.parse().ok()?;
        let class = catalog.class_index(&class)?;
        let is_it = |object: &Object| object.class == class && object.number == number;
        let is_former = |object: &Object| object.former_id.as_deref() == Some(id);
        let present = || self.objects.iter().enumerate().filter(|(_, object)| !object.is_gone);
        let own = present().find(|(_, object)| is_it(object));
        own.or_else(|| present().find(|(_, object)| is_former(object))).map(|(index, _)| index)
    }

    /// The lowest number that no object of a class has had.
    pub(super) fn free_number(&self, class: ClassIndex) -> u32 {
        let numbers = self.objects.iter().filter(|object| object.class == class).map(|object| object.number);
        numbers.max().unwrap_or(0) + 1
    }

    /// Whether an object stands on another one, or on what stands on it.
    pub(super) fn stands_on(&self, object: usize, other: usize) -> bool {
        let mut next = Some(object);
        while let Some(index) = next {
            if index == other {
                return true;
            }
            next = match self.objects[index].on {
                Parent::Object(parent) => Some(parent),
                _ => None,
            };
        }
        false
    }

    /// Gives an object another size: its back stays at the wall, its top at the ceiling, and what stands on it is lifted
    /// or lowered.
    pub(super) fn resize(&mut self, object: usize, size: Size) {
        let Object { on, place, size: before, .. } = &mut self.objects[object];
        let (by_depth, by_height) = (size.depth - before.depth, size.height - before.height);
        match on {
            Parent::Wall(_) | Parent::Opening(_) | Parent::Column(_) => {
                place.position -= direction(place.angle).perp() * (by_depth / 2.0);
            }
            Parent::Ceiling => place.elevation -= by_height,
            Parent::Floor | Parent::Object(_) => {}
        }
        let (top, has_moved) = (before.height, by_depth != 0.0 || by_height != 0.0);
        *before = size;
        if !has_moved {
            return;
        }
        self.objects[object].arranged = None;
        for child in &mut self.objects {
            if child.on == Parent::Object(object) && (child.place.elevation - top).abs() < ON_TOP {
                child.place.elevation += by_height;
            }
        }
    }

    /// Takes an object away, with all that stands on it.
    pub(super) fn remove(&mut self, object: usize) {
        for index in 0..self.objects.len() {
            if self.stands_on(index, object) {
                self.objects[index].is_gone = true;
            }
        }
    }

    /// The place of an object in the level: exactly where it was arranged, unless it was moved.
    pub(super) fn place_in_level(&self, object: usize) -> ObjectPlace {
        let Object { on, place, arranged, .. } = &self.objects[object];
        match *on {
            Parent::Object(parent) => match arranged.filter(|_| self.stays(parent)) {
                Some(arranged) => arranged,
                None => place.put_into(&self.place_in_level(parent)),
            },
            _ => *place,
        }
    }

    /// Whether neither an object nor what it stands on was moved.
    fn stays(&self, object: usize) -> bool {
        let Object { on, arranged, .. } = &self.objects[object];
        let parent_stays = match *on {
            Parent::Object(parent) => self.stays(parent),
            _ => true,
        };
        arranged.is_some() && parent_stays
    }

    /// The placements, parents before children, otherwise in the order of the objects.
    pub(super) fn placements(&self) -> Vec<Placement> {
        let mut order: Vec<usize> = Vec::new();
        let mut index_of = vec![None; self.objects.len()];
        for object in 0..self.objects.len() {
            self.append(object, &mut order, &mut index_of);
        }
        let placement = |&object: &usize| {
            let Object { class, number, on, side, variant, size, .. } = self.objects[object].clone();
            let ObjectPlace { position, elevation, angle } = self.place_in_level(object);
            let parent = match on {
                Parent::Object(parent) => Parent::Object(index_of[parent].expect("parents come first")),
                part => part,
            };
            Placement { class, number, parent, side, position, elevation, angle, variant, size }
        };
        order.iter().map(placement).collect()
    }

    fn append(&self, object: usize, order: &mut Vec<usize>, index_of: &mut [Option<usize>]) {
        if self.objects[object].is_gone || index_of[object].is_some() {
            return;
        }
        if let Parent::Object(parent) = self.objects[object].on {
            self.append(parent, order, index_of);
        }
        index_of[object] = Some(order.len());
        order.push(object);
    }
}

/// The height and turn of an object on a room part, for edits that name neither.
pub(super) fn usual_place(on: Parent, size: Size, room: &Room) -> ObjectPlace {
    let floor = ObjectPlace { position: Point::ZERO, elevation: 0.0, angle: 0.0 };
    match on {
        Parent::Ceiling => ObjectPlace { elevation: room.height - size.height, ..floor },
        Parent::Wall(wall) => {
            // With the back to it.
            let normal = room.walls[wall].normal();
            ObjectPlace { angle: libm::atan2(normal.x + 0.0, -normal.y), ..floor }
        }
        Parent::Floor | Parent::Opening(_) | Parent::Column(_) | Parent::Object(_) => floor,
    }
}

/// The side of a parent that something usually touches.
pub(super) fn usual_side(on: Parent) -> Side {
    match on {
        Parent::Floor | Parent::Object(_) => Side::Above,
        Parent::Ceiling => Side::Below,
        Parent::Wall(_) | Parent::Opening(_) | Parent::Column(_) => Side::Front,
    }
}
