//! The world that a page looks at, and the answers to what it asks.

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use serde_json::{Value, json};

use super::questions::{Answers, Controls, Edit, Listener, Look, LookAnswer, Mode, Refusal, ShownRoom};
use super::site::{Abilities, level, site};
use crate::audit::Verdict;
use crate::contract::RoomId;
use crate::document::{Fault, Faults};
use crate::edits::{EditsFile, set_object, set_seed};
use crate::geometry::Point;
use crate::gltf::SharedLibrary;
use crate::layout::Furnished;
use crate::output::LevelOptions;
use crate::plan::{PlacedBuilding, RoomRef};
use crate::project::{Project, RoomView, RoomWriter, WrittenRoom};
use crate::scene::SceneMaterial;
use crate::world::{Budget, DEFAULT_REACH, Eye, Need, World};

/// Rooms that the world holds for a page: those of a large level, and of the levels beside it.
const BUDGET: Budget = Budget { rooms: 2048, bytes: 64 << 20 };
/// Rooms that a page is told to draw at most.
const MOST_ROOMS: usize = 600;
/// Rooms that are furnished for one look where nothing happens in the background.
const ROOMS_A_LOOK: usize = 3;

/// Changes the edits file of somebody.
pub(crate) type EditsChange<'a> = dyn Fn(Option<EditsFile>) -> Result<EditsFile, Faults> + 'a;

/// Where a session has its project from; the command line knows.
pub(crate) trait ViewSources: Send + Sync {
    /// Reads everything anew, and says with which options it is furnished.
    ///
    /// # Errors
    /// If nothing can be read.
    fn read(&self, controls: &Controls) -> Result<(Project, LevelOptions), Faults>;

    /// What `explain` says about a room of an occupied building; none where nobody can say it.
    fn explain(
        &self,
        project: &Project,
        options: &LevelOptions,
        building: &PlacedBuilding,
        at: RoomRef<'_>,
    ) -> Option<Value>;

    /// Changes the edits file of a building, and says which file that is.
    ///
    /// # Errors
    /// If it cannot be read or written.
    fn change_edits(
        &self,
        project: &Project,
        building: &str,
        change: &EditsChange<'_>,
    ) -> Result<PathBuf, Faults>;

    /// Whether edits can be kept at all.
    fn is_editable(&self) -> bool;

    /// Keeps textures between runs.
    fn writer(&self, project: &Project, options: &LevelOptions) -> RoomWriter;
}

/// What the rooms are made from, and how they are written.
struct Scenery {
    project: Arc<Project>,
    options: LevelOptions,
    writer: Arc<RoomWriter>,
    /// The project with whose models rooms are written: an earlier one, where the catalogue is still the same.
    models: Arc<Project>,
}

impl Scenery {
    fn new(project: Arc<Project>, options: LevelOptions, sources: &dyn ViewSources) -> Self {
        let writer = Arc::new(sources.writer(&project, &options));
        Self { models: Arc::clone(&project), project, options, writer }
    }

    /// The scenery after a change. Models and textures that are made already are kept where they would be the same.
    fn changed(&self, project: Arc<Project>, options: LevelOptions, sources: &dyn ViewSources) -> Self {
        if self.options == options && self.project.catalog.digest == project.catalog.digest {
            let (writer, models) = (Arc::clone(&self.writer), Arc::clone(&self.models));
            return Self { project, options, writer, models };
        }
        Self::new(project, options, sources)
    }
}

/// The state behind a page.
pub(crate) struct Session {
    sources: Box<dyn ViewSources>,
    controls: Mutex<Controls>,
    world: Mutex<World>,
    scenery: Mutex<Arc<Scenery>>,
    /// Models and images that rooms refer to, by path.
    shared: Mutex<BTreeMap<String, Arc<Vec<u8>>>>,
    /// Held while the inputs are read.
    reading: Mutex<()>,
    /// What was wrong when the inputs were read last.
    faults: Mutex<Vec<String>>,
    revision: AtomicU64,
    listeners: Mutex<Vec<Listener>>,
    /// Whether rooms are furnished in the background.
    has_threads: bool,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Session {
    /// Opens what was read, and furnishes in the background with so many threads; without any, a few rooms at each look.
    ///
    /// # Errors
    /// If the system has no more threads.
    pub(crate) fn open(
        sources: Box<dyn ViewSources>,
        controls: Controls,
        (project, options): (Project, LevelOptions),
        threads: Option<NonZeroUsize>,
    ) -> std::io::Result<Self> {
        let project = Arc::new(project);
        let mut world = World::open(Arc::clone(&project), options.clone());
        if let Some(threads) = threads {
            world.start(threads)?;
        }
        let scenery = Scenery::new(project, options, &*sources);
        Ok(Self {
            sources,
            controls: Mutex::new(controls),
            world: Mutex::new(world),
            scenery: Mutex::new(Arc::new(scenery)),
            shared: Mutex::default(),
            reading: Mutex::default(),
            faults: Mutex::default(),
            revision: AtomicU64::new(1),
            listeners: Mutex::default(),
            has_threads: threads.is_some(),
        })
    }

    fn scenery(&self) -> Arc<Scenery> {
        Arc::clone(&lock(&self.scenery))
    }

    fn revision(&self) -> u64 {
        self.revision.load(Ordering::SeqCst)
    }

    fn tell(&self, event: &Value) {
        let event = event.to_string();
        lock(&self.listeners).retain(|listener| listener(&event));
    }

    /// Reads everything anew; rooms of which nothing has changed stay. What cannot be read is told, and all stays as it was.
    pub(crate) fn reload(&self) {
        // One after the other, so that what was read last is what counts.
        let _turn = lock(&self.reading);
        let controls = lock(&self.controls).clone();
        match self.sources.read(&controls) {
            Ok((project, options)) => self.replace(project, options),
            Err(faults) => {
                let faults: Vec<String> = faults.0.iter().map(Fault::report).collect();
                lock(&self.faults).clone_from(&faults);
                self.tell(&json!({"kind": "faults", "faults": faults}));
            }
        }
    }

    fn replace(&self, project: Project, options: LevelOptions) {
        let errors = project.faults.0.iter().filter(|fault| fault.is_error());
        let faults: Vec<String> = errors.map(Fault::report).collect();
        let before = self.scenery();
        let is_equal = before.options == options && before.project.is_equal(&project);
        let had_faults = std::mem::replace(&mut *lock(&self.faults), faults.clone()) != faults;
        if !is_equal {
            let project = Arc::new(project);
            let changed = before.changed(Arc::clone(&project), options.clone(), &*self.sources);
            *lock(&self.scenery) = Arc::new(changed);
            lock(&self.world).replace(project, options);
            self.revision.fetch_add(1, Ordering::SeqCst);
        }
        if !is_equal || had_faults {
            self.tell(&json!({"kind": "changed", "revision": self.revision(), "rooms": null}));
        }
        if !faults.is_empty() {
            self.tell(&json!({"kind": "faults", "faults": faults}));
        }
    }

    /// All rooms of a level as one binary glTF file, the one of a bake.
    ///
    /// # Errors
    /// If there is no such level, in words.
    pub(super) fn level_glb(&self, building: &str, id: &str) -> Result<Vec<u8>, String> {
        let Scenery { project, options, .. } = &*self.scenery();
        let unknown = || format!("there is no level {building}/{id}");
        let mut world = lock(&self.world);
        let (placed, _) = world.building(building).ok_or_else(unknown)?;
        let level = placed.building.levels.iter().find(|level| level.id == id).ok_or_else(unknown)?;
        let rooms = level.rooms.iter().map(|room| world.furnish(&RoomId::new(building, id, &room.id)));
        let rooms = rooms.collect::<Result<Vec<_>, _>>().map_err(|error| error.to_string())?;
        drop(world);
        let (furnished, verdicts): (Vec<Furnished>, Vec<Verdict>) =
            rooms.iter().map(|room| (room.furnished.clone(), room.verdict.clone())).unzip();
        let view = RoomView { building: &placed, level, furnished: &furnished, verdicts: &verdicts };
        let defaults = project.level_options();
        let alone = LevelOptions { seed: options.seed, style: options.style.clone(), ..defaults };
        RoomWriter::alone(&project.catalog, &alone)
            .glb(project, &alone, &view)
            .map_err(|error| error.to_string())
    }

    fn share(&self, models: SharedLibrary, materials: &[SceneMaterial]) {
        let mut shared = lock(&self.shared);
        for model in models.into_values() {
            shared.entry(model.path().to_owned()).or_insert_with(|| Arc::new(model.bytes()));
        }
        for (_, texture) in materials.iter().flat_map(SceneMaterial::textures) {
            if let Some(uri) = &texture.image.uri {
                shared.entry(uri.clone()).or_insert_with(|| Arc::new(texture.image.bytes.clone()));
            }
        }
    }

    fn change_edits(&self, id: &RoomId, change: &EditsChange<'_>) -> Result<String, Refusal> {
        let project = self.scenery().project.clone();
        if !self.sources.is_editable() {
            return Err(Refusal::Bad("there is no plan beside which edits could be kept".to_owned()));
        }
        if !project.has_room(id) {
            return Err(Refusal::NotFound(format!("there is no room {id}")));
        }
        let path = self.sources.change_edits(&project, &id.building, change).map_err(|faults| {
            Refusal::Bad(faults.0.first().map(|fault| fault.report()).unwrap_or_default())
        })?;
        // At once, so that the answer is about what is there; the watcher finds nothing new afterwards.
        self.reload();
        Ok(path.display().to_string())
    }
}

impl Answers for Session {
    fn listen(&self, listener: Listener) {
        lock(&self.listeners).push(listener);
    }

    fn site(&self) -> Value {
        let Scenery { project, options, .. } = &*self.scenery();
        let abilities =
            Abilities { revision: self.revision(), kind: "plan", is_editable: self.sources.is_editable() };
        json!(site(&project.plan, &project.catalog, options, abilities))
    }

    fn level(&self, building: &str, id: &str) -> Result<Value, Refusal> {
        let unknown = || Refusal::NotFound(format!("there is no level {building}/{id}"));
        let (placed, graph) = lock(&self.world).building(building).ok_or_else(unknown)?;
        let at = placed.building.levels.iter().position(|level| level.id == id).ok_or_else(unknown)?;
        Ok(json!(level((building, &placed.building), at, &graph, self.revision())))
    }

    fn look(&self, look: &Look) -> Result<LookAnswer, Refusal> {
        let numbers = look.position.iter().chain(&look.direction).chain(&look.velocity);
        if !numbers.chain([&look.fov]).all(|number| number.is_finite()) {
            return Err(Refusal::Bad("a look has finite numbers".to_owned()));
        }
        let eye = Eye {
            velocity: Point::from(look.velocity),
            field_of_view: look.fov.to_radians(),
            reach: DEFAULT_REACH,
            ..Eye::new(&look.building, &look.level, Point::from(look.position), Point::from(look.direction))
        };
        let mut world = lock(&self.world);
        let change = match look.mode {
            Mode::Walk => world.update(&eye, BUDGET),
            Mode::Orbit => world.survey(&eye, BUDGET),
        };
        let mut change = change.map_err(|error| Refusal::NotFound(error.to_string()))?;
        if !self.has_threads {
            change.waiting -= (0..ROOMS_A_LOOK.min(change.waiting)).take_while(|_| world.step()).count();
        }
        let rooms = world.wanted().into_iter().filter_map(|wanted| {
            let version = format!("{:x}", wanted.room?.number);
            let RoomId { building, level, room } = wanted.id;
            Some(ShownRoom { building, level, room, version, is_visible: wanted.need == Need::Visible })
        });
        let rooms = rooms.take(MOST_ROOMS).collect();
        Ok(LookAnswer { revision: self.revision(), rooms, waiting: change.waiting })
    }

    fn room(&self, id: &RoomId) -> Result<Vec<u8>, Refusal> {
        // Written without the lock: a page that looks around does not wait for a room.
        let room = lock(&self.world).shown(id);
        let scenery = self.scenery();
        // One of another catalogue is as good as gone.
        let room = room.filter(|room| room.catalog == scenery.project.catalog.digest);
        let room = room
            .ok_or_else(|| Refusal::NotFound(format!("room {id} is not furnished now: look at it first")))?;
        let Scenery { models, options, writer, .. } = &*scenery;
        let written = writer.write(models, options, &room.view());
        let WrittenRoom { glb, scene, models } = written.map_err(|error| Refusal::Bad(error.to_string()))?;
        self.share(models, &scene.materials);
        Ok(glb)
    }

    fn shared(&self, path: &str) -> Result<Arc<Vec<u8>>, Refusal> {
        let found = lock(&self.shared).get(path).map(Arc::clone);
        found.ok_or_else(|| Refusal::NotFound(format!("no room refers to {path}")))
    }

    fn explain(&self, id: &RoomId) -> Result<Value, Refusal> {
        let unknown = || Refusal::NotFound(format!("there is no room {id}"));
        let Scenery { project, options, .. } = &*self.scenery();
        let (placed, _) = lock(&self.world).building(&id.building).ok_or_else(unknown)?;
        let level = placed.building.levels.iter().find(|level| level.id == id.level).ok_or_else(unknown)?;
        let room = level.rooms.iter().position(|room| room.id == id.room).ok_or_else(unknown)?;
        let answer = self.sources.explain(project, options, &placed, level.room(room));
        answer.ok_or_else(|| Refusal::NotFound("reasons need the program on a machine".to_owned()))
    }

    fn edit(&self, edit: &Edit) -> Result<Value, Refusal> {
        let Edit { building, level, room, object, entry } = edit;
        let id = RoomId::new(building, level, room);
        let change = |file| {
            let set = set_object(file, &id, object, entry.as_ref());
            set.map_err(|message| Fault::of_file(Path::new("edit"), message).into())
        };
        let file = self.change_edits(&id, &change)?;
        Ok(json!({"revision": self.revision(), "file": file}))
    }

    fn edits(&self, building: &str) -> Value {
        json!({"rooms": self.scenery().project.edits.entries(building)})
    }

    fn reroll(&self, id: &RoomId) -> Result<Value, Refusal> {
        let scenery = self.scenery();
        let edits = scenery.project.edits.level(&id.building, &id.level);
        let own = edits.and_then(|edits| edits.room(&id.room)?.seed);
        let seed = own.unwrap_or(scenery.options.seed).wrapping_add(1);
        let file = self.change_edits(id, &|file| Ok(set_seed(file, id, Some(seed))))?;
        Ok(json!({"revision": self.revision(), "seed": seed, "file": file}))
    }

    fn set_controls(&self, controls: Controls) -> Result<Value, Refusal> {
        let known = self.scenery();
        if let Some(style) = controls.style.as_ref().filter(|style| !known.project.catalog.has_style(style)) {
            return Err(Refusal::Bad(format!("there is no style \"{style}\"")));
        }
        *lock(&self.controls) = controls;
        self.reload();
        Ok(json!({"revision": self.revision()}))
    }
}
