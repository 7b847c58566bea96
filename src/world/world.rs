//! Keeps the rooms around an eye furnished, in the background.

use std::collections::BTreeMap;
use std::fmt;
use std::num::NonZeroUsize;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;

use super::graph::{BuildingGraph, Key, Place};
use super::inputs::Inputs;
use super::room::WorldRoom;
use super::site::{in_building, on_site, turned};
use super::store::{Budget, Store};
use super::wish::{Gaze, Need, Wanted, wishes};
use crate::batch::catch_bug;
use crate::contract::RoomId;
use crate::geometry::Point;
use crate::output::LevelOptions;
use crate::plan::PlacedBuilding;
use crate::project::{Project, UnknownRoom};

/// Metres of the way to rooms that are furnished though nobody sees them: the threshold of the paper's section 4.
pub const DEFAULT_REACH: f64 = 10.0;
/// Graphs of buildings that are remembered. Buildings that share a plan share one.
const GRAPHS: usize = 64;

/// Where somebody is and looks, in the frame of a building: metres, x east, y north.
#[derive(Clone, Debug, PartialEq)]
pub struct Eye {
    /// Id of the building.
    pub building: String,
    /// Id of the level.
    pub level: String,
    /// Where the eye is.
    pub position: Point,
    /// Where it looks; of any length.
    pub direction: Point,
    /// How it moves, in metres a second; zero for somebody who stands.
    pub velocity: Point,
    /// Radians that it sees from side to side.
    pub field_of_view: f64,
    /// Metres of the way to the rooms that are wanted though one does not see them; [`DEFAULT_REACH`] is usual.
    pub reach: f64,
}

impl Eye {
    /// Somebody who stands and sees a right angle.
    #[must_use]
    pub fn new(building: &str, level: &str, position: Point, direction: Point) -> Self {
        Self {
            building: building.to_owned(),
            level: level.to_owned(),
            position,
            direction,
            velocity: Point::ZERO,
            field_of_view: core::f64::consts::FRAC_PI_2,
            reach: DEFAULT_REACH,
        }
    }
}

/// A level that the plan does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownLevel {
    /// Id of the building.
    pub building: String,
    /// Id of the level.
    pub level: String,
}

impl fmt::Display for UnknownLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the plan has no level {}/{}", self.building, self.level)
    }
}

impl std::error::Error for UnknownLevel {}

/// What has changed since the last look.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Change {
    /// Rooms that are there now.
    pub came: Vec<RoomId>,
    /// Rooms that are forgotten.
    pub went: Vec<RoomId>,
    /// Rooms that are wanted and not there yet.
    pub waiting: usize,
}

/// A room that the last look wanted.
#[derive(Clone, Debug)]
pub struct WantedRoom {
    /// Its ids.
    pub id: RoomId,
    /// Why it is wanted.
    pub need: Need,
    /// Metres to it.
    pub distance: f64,
    /// The room, if it is there; after a change of the inputs, the room before that until it is made again.
    pub room: Option<Arc<WorldRoom>>,
}

/// What threads share.
struct Shared {
    inputs: Mutex<Arc<Inputs>>,
    store: Mutex<Store>,
    /// Rings when there is something to make, and when something was made.
    bell: Condvar,
}

impl Shared {
    fn store(&self) -> MutexGuard<'_, Store> {
        // A room that cannot be made is caught before it could poison the lock.
        self.store.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn inputs(&self) -> Arc<Inputs> {
        Arc::clone(&self.inputs.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// The furnished rooms around an eye.
///
/// The rooms that it makes are those that a bake with the same options writes, whatever one saw before; see [`super`].
pub struct World {
    shared: Arc<Shared>,
    workers: Vec<JoinHandle<()>>,
    graphs: BTreeMap<usize, Arc<BuildingGraph>>,
    /// The rooms that were told of, with their ids for the day they are forgotten.
    told: BTreeMap<Key, RoomId>,
}

impl World {
    /// The rooms of a project with options, and nothing furnished yet. Nothing happens in the background until
    /// [`World::start`].
    #[must_use]
    pub fn open(project: impl Into<Arc<Project>>, options: LevelOptions) -> Self {
        let shared = Shared {
            inputs: Mutex::new(Arc::new(Inputs::new(project.into(), options))),
            store: Mutex::default(),
            bell: Condvar::new(),
        };
        Self { shared: Arc::new(shared), workers: Vec::new(), graphs: BTreeMap::new(), told: BTreeMap::new() }
    }

    /// Furnishes in the background from now on, with so many threads in all. They end with the world.
    ///
    /// # Errors
    /// If the system has no more threads.
    pub fn start(&mut self, threads: NonZeroUsize) -> std::io::Result<()> {
        while self.workers.len() < threads.get() {
            let shared = Arc::clone(&self.shared);
            let name = "roomwright-world".to_owned();
            self.workers.push(std::thread::Builder::new().name(name).spawn(move || work(&shared))?);
        }
        Ok(())
    }

    /// Looks around: from now on, the rooms that this eye sees or comes to are made first, and others are forgotten when the
    /// budget is full.
    ///
    /// # Errors
    /// If the plan has no such level; then nothing changes.
    pub fn update(&mut self, eye: &Eye, budget: Budget) -> Result<Change, UnknownLevel> {
        let (inputs, building, level) = self.find(eye)?;
        let gaze = Gaze {
            level,
            position: eye.position,
            direction: eye.direction,
            velocity: eye.velocity,
            field_of_view: eye.field_of_view,
            reach: eye.reach,
        };
        let graph = self.graph(&inputs, building);
        let plan = &inputs.project.plan.buildings;
        let mut wanted: Vec<Wanted> = wishes(&graph, (building, &plan[building].building), &gaze).collect();
        if graph.is_outside(&plan[building].building, level, eye.position) {
            for (other, gaze) in gazes_beside(&inputs, building, &gaze) {
                let graph = self.graph(&inputs, other);
                wanted.extend(wishes(&graph, (other, &plan[other].building), &gaze));
            }
        }
        Ok(self.want(&inputs, wanted, budget))
    }

    /// The indices of the building and level of an eye.
    fn find(&self, eye: &Eye) -> Result<(Arc<Inputs>, usize, usize), UnknownLevel> {
        let inputs = self.shared.inputs();
        let Eye { building, level, .. } = eye;
        let found = inputs.level(building, level);
        let unknown = || UnknownLevel { building: building.clone(), level: level.clone() };
        found.map(|(building, level)| (inputs, building, level)).ok_or_else(unknown)
    }

    /// The eye of somebody at a place of the site: in the building there, or before the nearest one, on the highest level whose
    /// floor is below the eye. Metres east and north of the site's origin, and above the buildings' zero; none in a plan without
    /// levels.
    #[must_use]
    pub fn eye_on_site(&self, position: Point, height: f64, direction: Point) -> Option<Eye> {
        let inputs = self.shared.inputs();
        let plan = &inputs.project.plan;
        let placed = &plan.buildings[inputs.site.nearest(plan, position)?];
        let levels = &placed.building.levels;
        let below = levels.iter().filter(|level| level.elevation <= height);
        let highest = below.max_by(|one, other| one.elevation.total_cmp(&other.elevation));
        let lowest = levels.iter().min_by(|one, other| one.elevation.total_cmp(&other.elevation));
        let level = highest.or(lowest)?;
        let position = in_building(placed.site, position);
        Some(Eye::new(&placed.id, &level.id, position, turned(direction, -placed.site.turn)))
    }

    /// Wants all rooms of a level, the nearest to a place first: what one sees from above.
    ///
    /// # Errors
    /// If the plan has no such level; then nothing changes.
    pub fn survey(&mut self, eye: &Eye, budget: Budget) -> Result<Change, UnknownLevel> {
        let (inputs, building, level) = self.find(eye)?;
        let graph = self.graph(&inputs, building);
        let rooms = graph.levels[level].cells.iter().enumerate();
        let wanted = rooms.map(|(room, cell)| Wanted {
            key: Key { building, place: Place { level, room } },
            need: Need::Visible,
            distance: cell.bounds.center().distance(eye.position),
            is_near: false,
        });
        let wanted = wanted.collect();
        Ok(self.want(&inputs, wanted, budget))
    }

    fn want(&mut self, inputs: &Inputs, mut wanted: Vec<Wanted>, budget: Budget) -> Change {
        // Stable, so that of equals the first in the plan comes first.
        wanted.sort_by(Wanted::order);
        let mut store = self.shared.store();
        store.want(wanted, budget);
        let new: Vec<Key> = store.keys().filter(|key| !self.told.contains_key(key)).collect();
        let gone: Vec<Key> = self.told.keys().copied().filter(|key| !store.holds(*key)).collect();
        let waiting = store.waiting();
        drop(store);
        self.shared.bell.notify_all();
        let came: Vec<RoomId> = new.iter().map(|key| inputs.id(*key)).collect();
        self.told.extend(new.into_iter().zip(came.iter().cloned()));
        let went = gone.iter().filter_map(|key| self.told.remove(key)).collect();
        Change { came, went, waiting }
    }

    /// The rooms that the last look wanted, the most urgent first.
    #[must_use]
    pub fn wanted(&self) -> Vec<WantedRoom> {
        let inputs = self.shared.inputs();
        let store = self.shared.store();
        let wanted = store.wanted().iter().map(|wanted| WantedRoom {
            id: inputs.id(wanted.key),
            need: wanted.need,
            distance: wanted.distance,
            room: store.shown(wanted.key).map(Arc::clone),
        });
        wanted.collect()
    }

    /// A room, if it is there.
    #[must_use]
    pub fn room(&self, id: &RoomId) -> Option<Arc<WorldRoom>> {
        let key = self.shared.inputs().key(id)?;
        self.shared.store().ready(key).map(Arc::clone)
    }

    /// A room as it is, or as it was before the last change of the inputs.
    pub(crate) fn shown(&self, id: &RoomId) -> Option<Arc<WorldRoom>> {
        let key = self.shared.inputs().key(id)?;
        self.shared.store().shown(key).map(Arc::clone)
    }

    /// A room now: waits for it if it is being made, else makes it on this thread.
    ///
    /// # Errors
    /// If the plan has no such room.
    ///
    /// # Panics
    /// If the room cannot be made, which is a fault of the program.
    pub fn furnish(&self, id: &RoomId) -> Result<Arc<WorldRoom>, UnknownRoom> {
        let inputs = self.shared.inputs();
        let key = inputs.key(id).ok_or_else(|| UnknownRoom::in_plan(id, &inputs.project.plan))?;
        let mut store = self.shared.store();
        loop {
            if let Some(room) = store.ready(key) {
                return Ok(Arc::clone(room));
            }
            if let Some(fault) = store.fault(key) {
                panic!("{id}: {fault}");
            }
            if !store.is_being_made(key) {
                break;
            }
            store = self.shared.bell.wait(store).unwrap_or_else(PoisonError::into_inner);
        }
        store.begin(key);
        let job = Job { key, generation: store.generation, inputs };
        drop(store);
        // Over the budget, or after a change: what was asked for is the answer all the same.
        self.shared.keep(job.make()).map_or_else(|| self.furnish(id), Ok)
    }

    /// Makes the most urgent room on this thread, for programs with a schedule of their own; `false` if none is wanted.
    pub fn step(&self) -> bool {
        self.take().map(|job| self.keep(job.make())).is_some()
    }

    /// The most urgent room, for callers that measure how long it takes.
    pub(crate) fn take(&self) -> Option<Job> {
        self.shared.take()
    }

    pub(crate) fn keep(&self, made: MadeRoom) {
        self.shared.keep(made);
    }

    /// Goes through what the last look wanted, the most urgent first, with the rooms that are there.
    pub(crate) fn each_wanted(&self, mut visit: impl FnMut(&Wanted, Option<&WorldRoom>)) {
        let store = self.shared.store();
        for wanted in store.wanted() {
            visit(wanted, store.ready(wanted.key).map(|room| &**room));
        }
    }

    /// A building with people in it, and its graph; none if there is no such building.
    pub(crate) fn building(&mut self, id: &str) -> Option<(Arc<PlacedBuilding>, Arc<BuildingGraph>)> {
        let inputs = self.shared.inputs();
        let index = inputs.building(id)?;
        Some((inputs.occupied(index), self.graph(&inputs, index)))
    }

    /// Goes on with other inputs: a plan, edits or options that have changed. Rooms of which all inputs are equal stay.
    pub fn replace(&mut self, project: impl Into<Arc<Project>>, options: LevelOptions) {
        let inputs = Arc::new(Inputs::new(project.into(), options));
        let before = self.shared.inputs();
        {
            let mut held = self.shared.inputs.lock().unwrap_or_else(PoisonError::into_inner);
            *held = Arc::clone(&inputs);
        }
        self.shared.store().change(|room| {
            let key = inputs.key(&room.id)?;
            Some((key, inputs.makes_equal(key, room, &before)))
        });
        self.graphs.clear();
        // Keys are indices into the plan before.
        self.told = self.shared.store().keys().map(|key| (key, inputs.id(key))).collect();
    }

    /// The project of the rooms.
    #[must_use]
    pub fn project(&self) -> Arc<Project> {
        Arc::clone(&self.shared.inputs().project)
    }

    /// Bytes of the rooms that are held ([`WorldRoom::bytes`]).
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.shared.store().bytes()
    }

    /// Rooms that are held.
    #[must_use]
    pub fn len(&self) -> usize {
        self.shared.store().keys().count()
    }

    /// Whether no room is held.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Rooms that were made so far, those that were forgotten and made again more than once.
    #[must_use]
    pub fn made(&self) -> u64 {
        self.shared.store().made()
    }

    fn graph(&mut self, inputs: &Inputs, building: usize) -> Arc<BuildingGraph> {
        let plan = &inputs.project.plan.buildings[building].building;
        // The project holds the building, so that no other can come to its place.
        let address = Arc::as_ptr(plan).addr();
        if let Some(found) = self.graphs.get(&address) {
            return Arc::clone(found);
        }
        if self.graphs.len() >= GRAPHS {
            self.graphs.clear();
        }
        let made = Arc::new(BuildingGraph::new(plan, &inputs.project.catalog));
        self.graphs.insert(address, Arc::clone(&made));
        made
    }
}

impl Drop for World {
    fn drop(&mut self) {
        self.shared.store().is_closing = true;
        self.shared.bell.notify_all();
        for worker in self.workers.drain(..) {
            // It ends after the room that it makes; its own faults are caught.
            let _ = worker.join();
        }
    }
}

impl fmt::Debug for World {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("World").field("rooms", &self.len()).field("threads", &self.workers.len()).finish()
    }
}

/// What somebody in the open air sees of the other buildings around: each with the eye in its own frame, on the level that is as
/// high as that where the eye is.
fn gazes_beside(inputs: &Inputs, building: usize, gaze: &Gaze) -> Vec<(usize, Gaze)> {
    let plan = &inputs.project.plan;
    let placed = &plan.buildings[building];
    let level = &placed.building.levels[gaze.level];
    let beside = inputs.site.beside(plan, building, gaze.position).into_iter().filter_map(|other| {
        let there = &plan.buildings[other];
        let levels = there.building.levels.iter().enumerate();
        let off = |elevation: f64| (elevation - level.elevation).abs();
        let nearest =
            levels.min_by(|(_, one), (_, other)| off(one.elevation).total_cmp(&off(other.elevation)));
        let turn = placed.site.turn - there.site.turn;
        let position = in_building(there.site, on_site(placed.site, gaze.position));
        let (direction, velocity) = (turned(gaze.direction, turn), turned(gaze.velocity, turn));
        Some((other, Gaze { level: nearest?.0, position, direction, velocity, ..*gaze }))
    });
    beside.collect()
}

/// A room to be made.
pub(crate) struct Job {
    key: Key,
    generation: u64,
    inputs: Arc<Inputs>,
}

/// A room that was made and is not held yet.
pub(crate) struct MadeRoom {
    key: Key,
    generation: u64,
    room: Result<WorldRoom, String>,
}

impl Job {
    pub(crate) fn make(self) -> MadeRoom {
        let Self { key, generation, inputs } = self;
        MadeRoom { key, generation, room: catch_bug(|| inputs.make(key)) }
    }
}

impl MadeRoom {
    pub(crate) fn key(&self) -> Key {
        self.key
    }
}

impl Shared {
    /// The most urgent room.
    fn take(&self) -> Option<Job> {
        let (key, generation) = {
            let mut store = self.store();
            (store.take()?, store.generation)
        };
        // Of a later generation, where the inputs change right now: then the room is not held.
        Some(Job { key, generation, inputs: self.inputs() })
    }

    fn keep(&self, made: MadeRoom) -> Option<Arc<WorldRoom>> {
        let kept = self.store().keep(made.key, made.generation, made.room);
        self.bell.notify_all();
        kept
    }
}

/// The life of a thread in the background.
fn work(shared: &Shared) {
    loop {
        if let Some(job) = shared.take() {
            shared.keep(job.make());
            continue;
        }
        let store = shared.store();
        if store.is_closing {
            return;
        }
        if store.is_idle() {
            drop(shared.bell.wait(store).unwrap_or_else(PoisonError::into_inner));
        }
    }
}
