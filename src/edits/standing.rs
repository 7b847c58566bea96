//! The parents and places of the objects of a surveyed level, in the terms of edits.

use glam::DVec3;

use super::file::ObjectEntry;
use super::tree::ObjectPlace;
use crate::contract::{ElementId, ObjectId};
use crate::geometry::Point;
use crate::read_back::{Survey, SurveyedObject, SurveyedPlace};

/// Room and id.
pub(super) type Key = (String, ObjectId);

/// Metres up to which an object counts as not moved: the way through an editor's single precision is shorter.
const SAME_PLACE: f64 = 1e-4;
/// Degrees up to which an object counts as not turned.
const SAME_TURN: f64 = 0.01;

/// One of the two files of a level.
pub(super) struct Floor<'a> {
    pub(super) objects: &'a [SurveyedObject],
    /// Room and id of each object; `None` for those that are in no room.
    pub(super) keys: Vec<Option<Key>>,
    /// Where each object is in the level; `None` for those that do not stand upright.
    frames: Vec<Option<ObjectPlace>>,
}

impl<'a> Floor<'a> {
    pub(super) fn new(survey: &'a Survey, keys: Vec<Option<Key>>) -> Self {
        let frames = survey.objects.iter().map(|object| object.place.map(|place| level_place(&place)));
        Self { objects: &survey.objects, keys, frames: frames.collect() }
    }

    /// Puts each object where a bake with the captured edits will: edits are rounded, and what stands on an object is then
    /// captured as seen from there, so that roundings do not add up from one to the next. `former`, by object, is the one of
    /// `old` that it was, in the same room.
    pub(super) fn settle(&mut self, old: &Floor<'_>, former: &[Option<usize>]) {
        let carriers = |&index: &usize| {
            std::iter::successors(Some(index), |&index| self.objects[index].above).take(former.len())
        };
        let mut order: Vec<usize> = (0..former.len()).collect();
        order.sort_by_key(|index| carriers(index).count());
        for index in order {
            let Some(is) = self.standing(index) else { continue };
            let was = former[index].and_then(|former| old.standing(former));
            let rests = is.rests(was.filter(|was| was.parent == is.parent).as_ref());
            self.frames[index] = Some(self.carrier(index).map_or(rests, |frame| rests.put_into(&frame)));
        }
    }

    /// The parent of an object, and the place in the parent's frame; `None` if the object does not stand upright.
    pub(super) fn standing(&self, index: usize) -> Option<Standing> {
        let object = &self.objects[index];
        let place = object.place.map(|place| level_place(&place))?;
        let Some(above) = self.above(index) else {
            // An object that it is not above any more says nothing about where it stands now.
            let is_object = matches!(object.parent, ElementId::Object(_));
            let on = if is_object { &ElementId::Floor } else { &object.parent };
            return Some(Standing { parent: on.to_string(), place });
        };
        let frame = self.frames[above]?;
        let on = self.keys[above].as_ref().map(|(_, id)| id.to_string())?;
        Some(Standing { parent: on, place: place.seen_from(&frame) })
    }

    /// The object of the same room that an object stands on.
    fn above(&self, index: usize) -> Option<usize> {
        self.objects[index].above.filter(|&above| self.room(above) == self.room(index))
    }

    /// The frame of what an object stands on, if that is an object.
    fn carrier(&self, index: usize) -> Option<ObjectPlace> {
        self.above(index).and_then(|above| self.frames[above])
    }

    pub(super) fn room(&self, index: usize) -> Option<&String> {
        self.keys[index].as_ref().map(|(room, _)| room)
    }
}

/// The parent of an object, and its place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Standing {
    pub(super) parent: String,
    pub(super) place: ObjectPlace,
}

impl Standing {
    /// The place in the frame of its parent that a bake gives it which reads its edits: the old one, as far as it did not move.
    fn rests(&self, was: Option<&Self>) -> ObjectPlace {
        let edit = ObjectEntry {
            at: moved(was, &self.place),
            turn: turned(was, &self.place),
            ..ObjectEntry::default()
        };
        was.map_or(self.place, |was| was.place).edited(&edit)
    }
}

/// Room and id of each object of a level as it was baked.
pub(super) fn own_keys(survey: &Survey) -> Vec<Option<Key>> {
    survey.objects.iter().map(|object| Some((object.room.clone()?, object.id.clone()))).collect()
}

fn level_place(place: &SurveyedPlace) -> ObjectPlace {
    let DVec3 { x, y, z } = place.position;
    ObjectPlace { position: Point::new(x, y), elevation: z, angle: place.angle }
}

/// Where it stands now, if that is elsewhere.
pub(super) fn moved(was: Option<&Standing>, is: &ObjectPlace) -> Option<Vec<f64>> {
    let place = |elevation: bool| {
        let height = elevation.then_some(is.elevation);
        [is.position.x, is.position.y].into_iter().chain(height).map(round).collect()
    };
    let Some(Standing { place: was, .. }) = was else { return Some(place(true)) };
    let has_risen = (was.elevation - is.elevation).abs() > SAME_PLACE;
    (has_risen || was.position.distance(is.position) > SAME_PLACE).then(|| place(has_risen))
}

/// How it is turned now, if that is another way; degrees.
pub(super) fn turned(was: Option<&Standing>, is: &ObjectPlace) -> Option<f64> {
    let degrees = wrapped(is.angle.to_degrees());
    let by = was.map_or(f64::INFINITY, |was| wrapped(was.place.angle.to_degrees() - degrees).abs());
    (by > SAME_TURN).then(|| round(degrees))
}

/// Between −180 (excluded) and 180.
fn wrapped(degrees: f64) -> f64 {
    let rest = degrees.rem_euclid(360.0);
    if rest > 180.0 { rest - 360.0 } else { rest }
}

/// To a tenth of a millimetre or of a thousandth of a degree, without a negative zero.
pub(super) fn round(value: f64) -> f64 {
    (value * 1e4).round() / 1e4 + 0.0
}
