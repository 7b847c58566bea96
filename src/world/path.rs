//! Paths through buildings: recorded in files, or drawn at random.

use std::path::Path;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::graph::{BuildingGraph, Place};
use super::near::STAIRS;
use super::route::{CLEARANCE, route};
use crate::catalog::Catalog;
use crate::document::{Fault, FaultSeverity, Faults, Source, did_you_mean};
use crate::geometry::{Point, Segment};
use crate::plan::{Plan, middle};

/// The version that this program reads.
const VERSION: u32 = 1;
/// Metres from the origin of a building to the farthest place of a path.
const FARTHEST: f64 = 1e6;
/// Metres after which a random walk goes on elsewhere: on another level, in another building.
const METRES_A_PIECE: f64 = 500.0;
/// Rooms that a piece of a random walk goes through at most: rooms may be as short as one likes.
const ROOMS_A_PIECE: usize = 2000;
/// How much rather one goes to stairs than into another room.
const STAIRS_WEIGHT: usize = 6;

/// A path for `roomwright walk`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Roomwright path")]
pub struct PathFile {
    /// Version of the format: 1.
    pub version: u32,
    /// The places that one walks to, in a straight line each.
    #[schemars(length(min = 2))]
    pub stops: Vec<StopEntry>,
}

/// A place of a path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StopEntry {
    /// Id of the building; that of the stop before where absent, else the only one of the plan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub building: Option<String>,
    /// Id of the level; that of the stop before where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub level: Option<String>,
    /// Metres east and north in the frame of the building.
    pub at: [f64; 2],
}

/// A place of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stop {
    /// Index into the buildings of the plan.
    pub(crate) building: usize,
    /// Index into the levels of the building.
    pub(crate) level: usize,
    /// Metres east and north.
    pub(crate) at: Point,
}

impl Stop {
    /// Metres to the next stop; the height of stairs counts too.
    pub(crate) fn distance(self, next: Self) -> f64 {
        let stairs = if self.level == next.level { 0.0 } else { STAIRS };
        self.at.distance(next.at) + stairs
    }
}

/// Metres of a path.
pub(crate) fn metres(stops: &[Stop]) -> f64 {
    stops.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

/// Paths that one walks one after the other; at the beginning of each one arrives from elsewhere.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WalkPath {
    pub(crate) pieces: Vec<Vec<Stop>>,
}

impl WalkPath {
    /// Metres to walk.
    #[must_use]
    pub fn metres(&self) -> f64 {
        self.pieces.iter().map(|piece| metres(piece)).sum()
    }

    /// Reads a path for a plan.
    ///
    /// # Errors
    /// All faults of its form, and all places that the plan does not have.
    pub fn read(path: &Path, plan: &Plan) -> Result<Self, Faults> {
        let source = Source::read(path)?;
        let file: PathFile = source.parse()?;
        let mut faults = Faults::default();
        if file.version != VERSION {
            let message = format!("version {} is not known", file.version);
            let hint = format!("this program reads version {VERSION}");
            faults.push(source.fault(&["version".into()], message, Some(hint), FaultSeverity::Error));
        }
        let mut stops: Vec<Stop> = Vec::new();
        for (index, entry) in file.stops.iter().enumerate() {
            match stop(entry, stops.last(), plan) {
                Ok(stop) => stops.push(stop),
                Err((key, message, hint)) => {
                    let at = ["stops".into(), index.into(), key.into()];
                    faults.push(source.fault(&at, message, hint, FaultSeverity::Error));
                }
            }
        }
        if file.stops.len() < 2 {
            let message = "a path has two stops or more".to_owned();
            faults.push(source.fault(&["stops".into()], message, None, FaultSeverity::Error));
        }
        if faults.has_errors() { Err(faults) } else { Ok(Self { pieces: vec![stops] }) }
    }

    /// A walk of so many metres through doors, along corridors and on stairs, drawn from a seed. Every five hundred metres it goes
    /// on in another place of the plan.
    ///
    /// # Errors
    /// If no room of the plan has a door to another.
    pub fn random(plan: &Plan, catalog: &Catalog, seed: u64, metres: f64) -> Result<Self, Faults> {
        let mut stroll = Stroll { plan, catalog, draw: ChaCha8Rng::seed_from_u64(seed) };
        let mut path = Self::default();
        let mut walked = 0.0;
        let mut misses = 0;
        while walked < metres {
            let piece = stroll.piece((metres - walked).min(METRES_A_PIECE));
            let length = self::metres(&piece);
            if length > 0.0 {
                walked += length;
                path.pieces.push(piece);
                continue;
            }
            misses += 1;
            // Of rooms without doors to others, as many as one looks at before giving up.
            if misses > 1000 {
                let fault = Fault::of_file(Path::new("--random"), "no way from room to room was found");
                return Err(fault.with_hint("a walk needs rooms that doors join").into());
            }
        }
        Ok(path)
    }
}

/// A stop of a file; the key at fault, the fact and a hint where the plan has no such place.
fn stop(
    entry: &StopEntry,
    before: Option<&Stop>,
    plan: &Plan,
) -> Result<Stop, (&'static str, String, Option<String>)> {
    let ids = || plan.buildings.iter().map(|placed| placed.id.as_str());
    let building = match (&entry.building, before) {
        (Some(id), _) => plan.buildings.iter().position(|placed| placed.id == *id).ok_or_else(|| {
            ("building", format!("the plan has no building \"{id}\""), did_you_mean(id, ids()))
        })?,
        (None, Some(before)) => before.building,
        (None, None) if plan.buildings.len() == 1 => 0,
        (None, None) => {
            let hint = "the plan has more than one: name it with `building`".to_owned();
            return Err(("at", "the first stop names no building".to_owned(), Some(hint)));
        }
    };
    let levels = &plan.buildings[building].building.levels;
    let level = match (&entry.level, before.filter(|before| before.building == building)) {
        (Some(id), _) => levels.iter().position(|level| level.id == *id).ok_or_else(|| {
            let hint = did_you_mean(id, levels.iter().map(|level| level.id.as_str()));
            ("level", format!("building \"{}\" has no level \"{id}\"", plan.buildings[building].id), hint)
        })?,
        (None, Some(before)) => before.level,
        (None, None) => 0,
    };
    let at = Point::from(entry.at);
    if !at.is_finite() || at.abs().max_element() > FARTHEST {
        return Err(("at", "a place is two numbers of at most a million metres".to_owned(), None));
    }
    Ok(Stop { building, level, at })
}

/// Draws random walks.
struct Stroll<'a> {
    plan: &'a Plan,
    catalog: &'a Catalog,
    draw: ChaCha8Rng,
}

impl Stroll<'_> {
    fn index(&mut self, count: usize) -> usize {
        // The remainder favours low numbers by less than one in 10^16.
        (self.draw.next_u64() % count.max(1) as u64) as usize
    }

    /// A walk from a random room on; empty where that room has no door to another.
    fn piece(&mut self, metres: f64) -> Vec<Stop> {
        let building = self.index(self.plan.buildings.len());
        let plan = &self.plan.buildings[building].building;
        let level = self.index(plan.levels.len());
        let Some(rooms) = plan.levels.get(level).map(|level| level.rooms.len()).filter(|count| *count > 0)
        else {
            return Vec::new();
        };
        let graph = BuildingGraph::new(plan, self.catalog);
        let mut place = Place { level, room: self.index(rooms) };
        let mut came_from = None;
        let room = |place: Place| &plan.levels[place.level].rooms[place.room];
        let mut stops = vec![Stop { building, level, at: middle(room(place)) }];
        for _ in 0..ROOMS_A_PIECE {
            let Some(next) = self.next(&graph, place, came_from) else { break };
            let (before, beyond) = match next {
                // Not along the wall: from before the door straight through it.
                Next::Through { out, into, .. } => (
                    [out.middle() + out.normal() * CLEARANCE, out.middle()],
                    [into.middle(), into.middle() + into.normal() * CLEARANCE],
                ),
                Next::Stairs(to) => ([middle(room(place)); 2], [middle(room(to)); 2]),
            };
            let from = stops.last().map_or(before[0], |stop| stop.at);
            let way = route(&room(place).region, from, before[0]);
            let way = way.into_iter().skip(1).chain([before[1]]);
            stops.extend(way.map(|at| Stop { building, level: place.level, at }));
            (came_from, place) = (Some(place), next.place());
            stops.extend(beyond.map(|at| Stop { building, level: place.level, at }));
            if self::metres(&stops) >= metres {
                break;
            }
        }
        shortened(stops, metres)
    }

    /// A door or stairs, rather not the way back, and rather stairs.
    fn next(&mut self, graph: &BuildingGraph, place: Place, came_from: Option<Place>) -> Option<Next> {
        let cell = graph.cell(place);
        let doors = cell.portals.iter().filter(|portal| portal.is_walkable).filter_map(|portal| {
            let behind = portal.behind?;
            let to = Place { room: behind.room, ..place };
            Some(Next::Through { out: portal.face, into: behind.face, to })
        });
        let all: Vec<Next> = doors.chain(cell.joined.iter().map(|&to| Next::Stairs(to))).collect();
        let onward: Vec<Next> = all.iter().copied().filter(|next| Some(next.place()) != came_from).collect();
        let choice = if onward.is_empty() { all } else { onward };
        let weight = |next: &Next| {
            let is_up = !graph.cell(next.place()).joined.is_empty();
            if is_up { STAIRS_WEIGHT } else { 1 }
        };
        let total: usize = choice.iter().map(weight).sum();
        let mut drawn = self.index(total);
        for next in choice {
            match drawn.checked_sub(weight(&next)) {
                Some(rest) => drawn = rest,
                None => return Some(next),
            }
        }
        None
    }
}

/// The next step of a random walk.
#[derive(Clone, Copy, Debug)]
enum Next {
    /// The hole in the wall of the room that one leaves, and in that of the room that one enters, each with its room on the left.
    Through {
        out: Segment,
        into: Segment,
        to: Place,
    },
    Stairs(Place),
}

impl Next {
    fn place(self) -> Place {
        match self {
            Self::Through { to, .. } | Self::Stairs(to) => to,
        }
    }
}

/// The beginning of a walk.
fn shortened(stops: Vec<Stop>, metres: f64) -> Vec<Stop> {
    let mut left = metres;
    let mut kept: Vec<Stop> = Vec::new();
    for stop in stops {
        let Some(last) = kept.last() else {
            kept.push(stop);
            continue;
        };
        let length = last.distance(stop);
        if length >= left {
            if left > 0.0 && length > 0.0 {
                kept.push(Stop { at: last.at.lerp(stop.at, left / length), ..stop });
            }
            return kept;
        }
        left -= length;
        kept.push(stop);
    }
    kept
}
