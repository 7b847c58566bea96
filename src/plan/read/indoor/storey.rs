//! Drafts of levels as indoor maps draw them. None of these formats says how thick walls are or how high doors.

use crate::geometry::Point;
use crate::plan::{LeafDraft, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, OutlineKind, RoomDraft};

/// Metres from floor to floor where a map does not say: public buildings are higher than flats.
pub(in crate::plan::read) const STOREY_HEIGHT: f64 = 3.6;
/// Metres of walls between rooms, half taken from each.
const INTERIOR_THICKNESS: f64 = 0.1;
/// Metres of walls to the open air.
const EXTERIOR_THICKNESS: f64 = 0.4;
/// Metres of a door's head.
const DOOR_HEAD: f64 = 2.1;
/// Metres of the widest door; wider openings have no leaf.
const WIDEST_DOOR: f64 = 2.4;

/// A level of an indoor map.
#[derive(Debug, Default)]
pub(in crate::plan::read) struct Storey {
    pub(in crate::plan::read) id: String,
    /// A title for people; may be empty.
    pub(in crate::plan::read) name: String,
    /// Metres above the building's zero.
    pub(in crate::plan::read) elevation: f64,
    /// Metres from floor to floor.
    pub(in crate::plan::read) height: f64,
    pub(in crate::plan::read) rooms: Vec<RoomDraft>,
    pub(in crate::plan::read) openings: Vec<OpeningDraft>,
}

impl From<Storey> for LevelDraft {
    fn from(storey: Storey) -> Self {
        let Storey { id, name, elevation, height, rooms, openings } = storey;
        Self {
            id,
            name,
            elevation,
            height,
            exterior_thickness: EXTERIOR_THICKNESS,
            interior_thickness: INTERIOR_THICKNESS,
            outlines: OutlineKind::Center,
            rooms,
            openings,
            ..Self::default()
        }
    }
}

/// An opening in the wall that a line runs along, from end to end; wide ones have no leaf. `None` of a line without two ends.
pub(in crate::plan::read) fn opening_along(
    id: &str,
    kind: OpeningKind,
    line: &[Point],
) -> Option<OpeningDraft> {
    let (first, last) = (*line.first()?, *line.last()?);
    let width = first.distance(last);
    let place = OpeningPlace::Points { center: first.midpoint(last), along: Some(last - first) };
    Some(opening(id, kind, place, width))
}

/// An opening of a width; wide ones have no leaf.
pub(super) fn opening(id: &str, kind: OpeningKind, place: OpeningPlace, width: f64) -> OpeningDraft {
    OpeningDraft {
        id: id.to_owned(),
        kind: if width > WIDEST_DOOR { OpeningKind::Passage } else { kind },
        place,
        rooms: Vec::new(),
        width,
        bottom: 0.0,
        top: DOOR_HEAD,
        leaf: LeafDraft::Automatic,
    }
}
