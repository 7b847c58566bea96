//! A requested opening, checked and in the frame of the level.

use super::{Face, LEAST_PARTNER_SHARE, LEAST_SHARE, LEAST_WINDOW_PARTNER, NARROWEST_OPENING};
use crate::geometry::{Point, Segment};
use crate::plan::assemble::{Assembly, WallIndex};
use crate::plan::limits::{OPENING_WIDTH, ROOM_SIDE, is_place};
use crate::plan::{OpeningDraft, OpeningKind, OpeningPlace};

/// Without a direction of its own an opening takes that of a wall within this many metres.
const NEAREST_WALL: f64 = 1.0;
/// Problems up to which a similar name is looked for, because each is compared with all names.
const HINTED: usize = 200;
/// Metres of an open boundary that both rooms must share.
const SHORTEST_BOUNDARY: f64 = 0.3;

/// An opening before it is attached.
#[derive(Clone, Debug)]
pub(in crate::plan) struct Request {
    /// Id in the level.
    pub(in crate::plan) id: String,
    /// The kind of closure.
    pub(in crate::plan) kind: OpeningKind,
    /// Middle, in the level's frame.
    pub(in crate::plan) center: Point,
    /// Unit vector along the wall.
    pub(in crate::plan) along: Point,
    /// Metres along the wall.
    pub(in crate::plan) width: f64,
    /// Metres above the floor.
    pub(in crate::plan) bottom: f64,
    /// Metres above the floor.
    pub(in crate::plan) top: f64,
    /// Rooms that it must join, as indices into the assembled rooms.
    pub(in crate::plan) rooms: Vec<usize>,
}

impl Request {
    /// Metres of the opening between two places on its axis.
    pub(super) fn overlap(&self, low: f64, high: f64) -> f64 {
        let half = self.width / 2.0;
        (high.min(half) - low.max(-half)).max(0.0)
    }

    /// Metres of the opening that lie within both of two faces.
    pub(super) fn common(&self, left: Face, right: Face) -> f64 {
        self.overlap(left.low.max(right.low), left.high.min(right.high))
    }

    /// The same opening from one place on its axis to another.
    pub(super) fn stretch(&self, from: f64, to: f64) -> Self {
        let center = self.center + self.along * ((from + to) / 2.0);
        Self { center, width: to - from, ..self.clone() }
    }

    /// Metres that two walls should hold together.
    pub(super) fn least_common(&self) -> f64 {
        match self.kind {
            OpeningKind::Window => self.width * LEAST_WINDOW_PARTNER,
            _ => self.least_overlap(),
        }
    }

    /// Metres that the wall behind must hold where one wall holds the opening. Two named rooms are taken at their
    /// word: both hold it.
    pub(super) fn least_partner(&self) -> f64 {
        match self.kind {
            OpeningKind::Door | OpeningKind::SlidingDoor | OpeningKind::Passage if self.rooms.len() < 2 => {
                self.width * LEAST_PARTNER_SHARE
            }
            _ => self.least_common(),
        }
    }

    /// Metres that must lie within a wall.
    pub(super) fn least_overlap(&self) -> f64 {
        match self.kind {
            OpeningKind::OpenBoundary => SHORTEST_BOUNDARY.min(self.width * LEAST_SHARE),
            _ => self.width * LEAST_SHARE,
        }
    }
}

/// Checks numbers and names of an opening and finds its place.
///
/// # Errors
/// The fact and a hint.
pub(in crate::plan) fn request(
    opening: &OpeningDraft,
    assembly: &Assembly<'_>,
    index: &WallIndex,
) -> Result<Request, (String, Option<String>)> {
    check_numbers(opening)?;
    let rooms = named_rooms(opening, assembly)?;
    let (center, along) = match &opening.place {
        OpeningPlace::Points { center, along } => (*center, *along),
        OpeningPlace::Edge { edge, at } => on_edge(opening, assembly, *edge, *at)?,
    };
    if !is_place(center) {
        return Err((format!("opening \"{}\" has no finite place", opening.id), None));
    }
    let along = along.filter(|along| along.is_finite()).map(|along| along.normalize_or_zero());
    let along = match along {
        Some(along) if along != Point::ZERO => along,
        _ => nearest_direction(center, &rooms, assembly, index).ok_or_else(|| {
            let fact = format!("no wall within {NEAREST_WALL} m of opening \"{}\"", opening.id);
            (fact, Some("move it onto a wall, or name its room and edge".to_owned()))
        })?,
    };
    let bottom = if opening.kind == OpeningKind::Window { opening.bottom } else { opening.bottom.max(0.0) };
    Ok(Request {
        id: opening.id.clone(),
        kind: opening.kind,
        center,
        along,
        width: opening.width,
        bottom,
        top: opening.top,
        rooms,
    })
}

fn check_numbers(opening: &OpeningDraft) -> Result<(), (String, Option<String>)> {
    let id = &opening.id;
    let (narrowest, mut widest) = OPENING_WIDTH;
    if opening.kind == OpeningKind::OpenBoundary {
        // As long as its rooms' common edge; what is too long is cut.
        widest = ROOM_SIDE.1;
    }
    if !(narrowest..=widest).contains(&opening.width) {
        let fact = format!("opening \"{id}\" is {} m wide", opening.width);
        return Err((fact, Some(format!("widths from {narrowest} to {widest} m are used"))));
    }
    let is_upright = opening.bottom.is_finite() && opening.bottom >= 0.0 && opening.top.is_finite();
    if !is_upright || opening.top - opening.bottom < NARROWEST_OPENING {
        let fact = format!("opening \"{id}\" reaches from {} m to {} m height", opening.bottom, opening.top);
        return Err((
            fact,
            Some("the top must lie above the bottom, the bottom not below the floor".to_owned()),
        ));
    }
    Ok(())
}

fn named_rooms(
    opening: &OpeningDraft,
    assembly: &Assembly<'_>,
) -> Result<Vec<usize>, (String, Option<String>)> {
    if opening.rooms.len() > 2 {
        let fact = format!("opening \"{}\" names {} rooms", opening.id, opening.rooms.len());
        return Err((fact, Some("an opening joins one room or two".to_owned())));
    }
    opening
        .rooms
        .iter()
        .map(|name| {
            let found = assembly.places.get(name.as_str()).copied();
            found.ok_or_else(|| {
                let fact = format!("opening \"{}\" names the unknown room \"{name}\"", opening.id);
                let compared = if assembly.problems.len() < HINTED { assembly.rooms.len() } else { 0 };
                let candidates = assembly.rooms[..compared].iter().map(|room| room.id.as_str());
                let near = candidates.max_by(|a, b| {
                    strsim::jaro(a, name).total_cmp(&strsim::jaro(b, name)).then_with(|| b.cmp(a))
                });
                (fact, near.map(|near| format!("did you mean \"{near}\"?")))
            })
        })
        .collect()
}

type PlaceOnWall = (Point, Option<Point>);

fn on_edge(
    opening: &OpeningDraft,
    assembly: &Assembly<'_>,
    edge: usize,
    at: f64,
) -> Result<PlaceOnWall, (String, Option<String>)> {
    let id = &opening.id;
    let room = opening.rooms.first().ok_or_else(|| {
        (format!("opening \"{id}\" names an edge but no room"), Some("name the room of the edge".to_owned()))
    })?;
    let place = assembly.places.get(room.as_str());
    let draft = place.map(|place| &assembly.draft.rooms[assembly.sources[*place]]);
    let outline = draft.map(|draft| draft.outline.as_slice()).unwrap_or_default();
    let Some(&start) = outline.get(edge) else {
        let fact = format!("opening \"{id}\" names edge {edge} of room \"{room}\"");
        return Err((fact, Some(format!("the outline has {} edges, counted from 0", outline.len()))));
    };
    let end = outline[(edge + 1) % outline.len()];
    let length = start.distance(end);
    if !(0.0..=length).contains(&at) {
        let fact = format!("opening \"{id}\" is {at} m along edge {edge} of room \"{room}\"");
        return Err((fact, Some(format!("the edge is {length:.3} m long"))));
    }
    let along = (end - start).normalize_or_zero();
    Ok((start + along * at, Some(along)))
}

fn nearest_direction(
    center: Point,
    rooms: &[usize],
    assembly: &Assembly<'_>,
    index: &WallIndex,
) -> Option<Point> {
    let near = index.near_segment(Segment::new(center, center), NEAREST_WALL);
    let walls = near
        .into_iter()
        .filter(|place| rooms.is_empty() || rooms.contains(&place.room))
        .map(|place| &assembly.rooms[place.room].walls[place.wall]);
    walls
        .map(|wall| {
            let place = (center - wall.start).dot(wall.direction()).clamp(0.0, wall.length());
            (center.distance(wall.after(place)), wall.direction())
        })
        .filter(|(distance, _)| *distance <= NEAREST_WALL)
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, direction)| direction)
}
