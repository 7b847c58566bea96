//! Finds edits files beside their plans, and checks them against plan and catalogue.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::book::{EditBook, ObjectEdit};
use super::file::{EditsFile, ObjectEntry, RoomEntry, VERSION};
use crate::catalog::Catalog;
use crate::contract::ObjectId;
use crate::disk::unpacked_name;
use crate::document::{
    Fault, FaultSeverity, Faults, PathStep, Source, bounded, did_you_mean, first_of_each_kind,
};
use crate::plan::{Level, PlacedBuilding, Plan};

/// The ending of the names of edits files, after the name of the plan without its extension.
pub const EDITS_ENDING: &str = ".edits.yaml";

/// The edits file of a plan or project: `house.edits.yaml` beside `house.yaml` or the folder `house`.
#[must_use]
pub fn edits_path(plan: &Path) -> PathBuf {
    let stem = if plan.is_dir() { plan.file_name() } else { unpacked_name(plan).file_stem() };
    let mut name = stem.unwrap_or_default().to_owned();
    name.push(EDITS_ENDING);
    plan.with_file_name(name)
}

/// Reads the edits beside the plans, beside the projects, and the files named; later ones win, and edits for one
/// building over those for every building of a plan.
///
/// An entry with a fault is left out; the others are used. An entry for a room that is not there is a warning.
#[must_use]
pub fn read_edits(plan: &Plan, named: &[PathBuf], catalog: &Catalog) -> (EditBook, Faults) {
    let (mut book, mut faults) = (EditBook::default(), Faults::default());
    let scopes = [scopes(plan, |placed| Some(&placed.source.plan)), scopes(plan, project)];
    let beside = scopes.into_iter().flatten().map(|(file, scope)| (edits_path(&file), scope));
    let beside = beside.filter(|(path, _)| path.exists());
    let everything: Vec<&PlacedBuilding> = plan.buildings.iter().collect();
    let named = named.iter().map(|path| (path.clone(), everything.clone()));
    for (path, scope) in beside.chain(named) {
        match Source::read(&path).and_then(|source| source.parse().map(|file| (source, file))) {
            Ok((source, file)) => {
                let mut reading = Reading { source: &source, catalog, scope: &scope, faults: &mut faults };
                reading.add(&file, &mut book);
            }
            Err(found) => faults.merge(found),
        }
    }
    faults.sort();
    (book, first_of_each_kind(faults))
}

/// Reads one edits file by itself, to be added to.
///
/// # Errors
/// All faults of its form.
pub fn read_edits_file(path: &Path) -> Result<EditsFile, Faults> {
    let source = Source::read(path)?;
    let file: EditsFile = source.parse()?;
    version_fault(&source, &file).map_or(Ok(file), |fault| Err(fault.into()))
}

fn version_fault(source: &Source, file: &EditsFile) -> Option<Fault> {
    let message = format!("version {} is not known", file.version);
    let hint = format!("this program reads version {VERSION}");
    let fault = || source.fault(&["version".into()], message, Some(hint), FaultSeverity::Error);
    (file.version != VERSION).then(fault)
}

fn project(placed: &PlacedBuilding) -> Option<&PathBuf> {
    placed.source.project.as_ref()
}

/// The files that buildings come from, each with its buildings.
fn scopes<'a>(
    plan: &'a Plan,
    file_of: impl Fn(&'a PlacedBuilding) -> Option<&'a PathBuf>,
) -> BTreeMap<PathBuf, Vec<&'a PlacedBuilding>> {
    let mut scopes: BTreeMap<&PathBuf, Vec<&PlacedBuilding>> = BTreeMap::new();
    for placed in &plan.buildings {
        if let Some(file) = file_of(placed) {
            scopes.entry(file).or_default().push(placed);
        }
    }
    scopes.into_iter().map(|(file, scope)| (file.clone(), scope)).collect()
}

/// One file on its way into the book.
struct Reading<'a> {
    source: &'a Source,
    catalog: &'a Catalog,
    /// The buildings that the file speaks of.
    scope: &'a [&'a PlacedBuilding],
    faults: &'a mut Faults,
}

impl Reading<'_> {
    fn add(&mut self, file: &EditsFile, book: &mut EditBook) {
        if let Some(fault) = version_fault(self.source, file) {
            return self.faults.push(fault);
        }
        let mut known = BTreeSet::new();
        let mut entries: Vec<(usize, &RoomEntry)> = Vec::new();
        for (index, entry) in file.edits.iter().enumerate() {
            if known.insert((&entry.building, &entry.level, &entry.room)) {
                entries.push((index, entry));
            } else {
                let message = format!("edits of room \"{}\" on level \"{}\"", entry.room, entry.level);
                self.error(&step(index, &["room"]), format!("has a second list of {message}"), None);
            }
        }
        // Edits for every building come first, so that those for one building win.
        entries.sort_by_key(|(_, entry)| entry.building.is_some());
        for (index, entry) in entries {
            self.add_room(index, entry, book);
        }
    }

    fn add_room(&mut self, index: usize, entry: &RoomEntry, book: &mut EditBook) {
        if entry.objects.len() > MOST_OBJECTS {
            let message = format!("has edits of {} objects", entry.objects.len());
            let hint = format!("{MOST_OBJECTS} of them are applied, more than any room holds");
            self.error(&step(index, &["objects"]), message, Some(hint));
        }
        let objects: BTreeMap<String, ObjectEdit> = entry
            .objects
            .iter()
            .take(MOST_OBJECTS)
            .filter_map(|(id, object)| Some((id.clone(), self.object(index, id, object)?)))
            .collect();
        let mut has_room = false;
        for placed in self.buildings(index, entry) {
            if find_room(placed, entry).is_none() {
                continue;
            }
            has_room = true;
            let levels = book.buildings.entry(placed.id.clone()).or_default();
            let level = Arc::make_mut(levels.entry(entry.level.clone()).or_default());
            let room = level.rooms.entry(entry.room.clone()).or_default();
            room.seed = entry.seed.or(room.seed);
            room.objects.extend(objects.clone());
        }
        if !has_room {
            self.no_room(index, entry);
        }
    }

    /// The buildings that an entry speaks of.
    fn buildings(&mut self, index: usize, entry: &RoomEntry) -> Vec<&'_ PlacedBuilding> {
        let Some(id) = &entry.building else {
            let mirrored = self.scope.iter().filter(|placed| placed.source.is_mirrored).count();
            if mirrored > 0 {
                let message = format!("does not hold for {mirrored} mirrored buildings");
                let hint = "name the `building`: its places are those of the mirrored rooms".to_owned();
                self.warn(&step(index, &["room"]), message, Some(hint));
            }
            return self.scope.iter().filter(|placed| !placed.source.is_mirrored).copied().collect();
        };
        self.scope.iter().filter(|placed| placed.id == *id).copied().collect()
    }

    fn no_room(&mut self, index: usize, entry: &RoomEntry) {
        let RoomEntry { building, level, room, .. } = entry;
        let scope = || self.scope.iter().filter(|placed| building.as_ref().is_none_or(|id| *id == placed.id));
        let levels = || scope().flat_map(|placed| &placed.building.levels);
        let (key, message, hint) = if scope().next().is_none() {
            let id = building.as_deref().unwrap_or_default();
            let hint = did_you_mean(id, self.scope.iter().map(|placed| placed.id.as_str()));
            ("building", format!("there is no building \"{id}\" here"), hint)
        } else if !levels().any(|known| known.id == *level) {
            let hint = did_you_mean(level, levels().map(|known| known.id.as_str()));
            ("level", format!("there is no level \"{level}\""), hint)
        } else {
            let rooms = levels().filter(|known| known.id == *level).flat_map(|known| &known.rooms);
            let hint = did_you_mean(room, rooms.map(|known| known.id.as_str()));
            ("room", format!("there is no room \"{room}\" on level \"{level}\""), hint)
        };
        let message = format!("{message}: its edits wait");
        self.warn(&step(index, &[key]), message, hint);
    }

    /// An edit that makes sense, whatever room it is for.
    fn object(&mut self, index: usize, id: &str, entry: &ObjectEntry) -> Option<ObjectEdit> {
        let path = step(index, &["objects", id]);
        let problem = self.form_problem(id, entry).or_else(|| self.class_problem(id, entry));
        if let Some((key, message, hint)) = problem {
            let mut path = path;
            path.extend(key.map(PathStep::from));
            self.error(&path, message, hint);
            return None;
        }
        let mark = self.source.fault(&path, "", None, FaultSeverity::Error);
        Some(ObjectEdit { entry: entry.clone(), mark })
    }

    fn form_problem(&self, id: &str, entry: &ObjectEntry) -> Option<Problem> {
        let plain = |key, message: &str, hint: &str| Some((key, message.to_owned(), Some(hint.to_owned())));
        if id.parse::<ObjectId>().is_err() {
            return plain(None, &format!("\"{id}\" is no id of an object"), "ids are like desk.1");
        }
        let ObjectEntry { add, remove, lock, class, variant, parent, side, at, turn } = entry;
        let has_place = parent.is_some() || side.is_some() || at.is_some() || turn.is_some();
        if *remove && (*add || *lock || class.is_some() || variant.is_some() || has_place) {
            return plain(Some("remove"), "is removed and changed at once", "keep one of both");
        }
        if (*add || *lock) && at.is_none() {
            let key = if *add { "add" } else { "lock" };
            return plain(Some(key), "does not say where it stands", "add `at: [x, y]`");
        }
        if *add && class.is_some() {
            return plain(Some("class"), "a new object has a second class", "its id names the class");
        }
        if *lock && class.is_some() {
            let hint = "lock an object of the new class, which its id names";
            return plain(Some("class"), "is locked and of another class at once", hint);
        }
        if let Some(at) = at
            && !(matches!(at.len(), 2 | 3) && at.iter().all(|metres| metres.abs() < FARTHEST))
        {
            let message = format!("{} is no place", bounded(&format!("{at:?}")));
            let hint = format!("write [x, y] or [x, y, z], in metres within {FARTHEST} m of the origin");
            return plain(Some("at"), &message, &hint);
        }
        if turn.is_some_and(|degrees| !degrees.is_finite()) {
            return plain(Some("turn"), "is no angle", "write degrees");
        }
        let says_nothing = !(*add || *remove || *lock || has_place || class.is_some() || variant.is_some());
        if says_nothing {
            return plain(None, "says nothing of it", "see configs/schema/edits.schema.json");
        }
        None
    }

    fn class_problem(&self, id: &str, entry: &ObjectEntry) -> Option<Problem> {
        let ObjectId { class: of_id, .. } = id.parse().ok()?;
        let key = entry.class.as_ref().map(|_| "class");
        let class = entry.class.as_deref().unwrap_or(&of_id);
        let Some(index) = self.catalog.class_index(class) else {
            let known = self.catalog.classes.iter().map(|class| class.id.as_str());
            return Some((key, format!("unknown class \"{class}\""), did_you_mean(class, known)));
        };
        let count = self.catalog.classes[index].variant_count();
        let variant = entry.variant.filter(|&variant| variant >= count)?;
        let hint = format!("`roomwright catalog classes {class}` shows them");
        Some((
            Some("variant"),
            format!("{class} has no variant {variant}, but 0 to {}", count - 1),
            Some(hint),
        ))
    }

    fn error(&mut self, path: &[PathStep], message: String, hint: Option<String>) {
        self.faults.push(self.source.fault(path, message, hint, FaultSeverity::Error));
    }

    fn warn(&mut self, path: &[PathStep], message: String, hint: Option<String>) {
        self.faults.push(self.source.fault(path, message, hint, FaultSeverity::Warning));
    }
}

/// Key, fact and hint.
type Problem = (Option<&'static str>, String, Option<String>);

/// Metres: farther off is no building.
const FARTHEST: f64 = 1e6;

/// Edits of one room. The audit compares all objects that stand in one place, which takes a minute for so many.
const MOST_OBJECTS: usize = 2_000;

fn find_room<'a>(placed: &'a PlacedBuilding, entry: &RoomEntry) -> Option<&'a Level> {
    let level = placed.building.levels.iter().find(|level| level.id == entry.level)?;
    level.rooms.iter().any(|room| room.id == entry.room).then_some(level)
}

/// `edits[index].key…`.
fn step(index: usize, keys: &[&str]) -> Vec<PathStep> {
    let start = [PathStep::from("edits"), PathStep::from(index)];
    start.into_iter().chain(keys.iter().map(|&key| PathStep::from(key))).collect()
}
