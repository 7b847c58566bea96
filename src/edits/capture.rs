//! Derives edits from a level before and after somebody changed it.
//!
//! Objects are known by their ids, which editors keep in the extras. If several objects have one id, the original is the
//! one that kept its name, else the nearest; the others are copies.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::file::{ObjectEntry, RoomEntry};
use super::standing::{Floor, Key, moved, own_keys, round, turned};
use crate::catalog::{Catalog, Side, Size};
use crate::contract::{ObjectId, VariantId};
use crate::document::{Fault, Faults};
use crate::read_back::{Survey, SurveyedObject, SurveyedPlace};

/// The result of a comparison.
#[derive(Clone, Debug, Default)]
pub struct Captured {
    /// The edits, by room.
    pub entries: Vec<RoomEntry>,
    /// Changes that no edit can express, as warnings.
    pub notes: Faults,
}

/// Metres by which a scaled object may differ from the variant that stands in for it.
const SAME_SIZE: f64 = 5e-3;

/// Metres by which the box around a mesh may change on its way through an editor.
const SAME_MESH: f64 = 2e-3;

/// Compares a level as it was baked with its edited file; `file` names the edited one in messages.
///
/// # Errors
/// If they are not of one level.
pub fn capture(old: &Survey, new: &Survey, catalog: &Catalog, file: &Path) -> Result<Captured, Fault> {
    if (&old.building, &old.level) != (&new.building, &new.level) {
        let names = |survey: &Survey| format!("{}/{}", survey.building, survey.level);
        let message = format!("is {}, but the level before is {}", names(new), names(old));
        return Err(Fault::of_file(file, message).with_hint("name the file that was opened in the editor"));
    }
    let mut capturing = Capturing {
        catalog,
        file,
        old: Floor::new(old, own_keys(old)),
        new: Floor::new(new, Vec::new()),
        twins: Vec::new(),
        by_id: by_id(new),
        models: &old.models,
        broken: &new.broken,
        entries: BTreeMap::new(),
        notes: Faults::default(),
    };
    capturing.pair();
    capturing.compare_all();
    for node in &new.broken {
        capturing.note(
            node,
            "has extras that cannot be read: what became of it is not captured",
            BROKEN_HINT,
        );
    }
    for node in &new.strangers {
        capturing.note(node, "is no furniture that the catalogue knows", STRANGER_HINT);
    }
    let entries = capturing.entries.into_iter().map(|(room, objects)| RoomEntry {
        building: Some(new.building.clone()),
        level: new.level.clone(),
        room,
        seed: None,
        objects,
    });
    Ok(Captured { entries: entries.collect(), notes: capturing.notes })
}

const BROKEN_HINT: &str = "keep its custom properties";
const STRANGER_HINT: &str = "give it a class: docs/guide.md, \"A model of your own\"";

struct Capturing<'a> {
    catalog: &'a Catalog,
    file: &'a Path,
    old: Floor<'a>,
    new: Floor<'a>,
    /// By old object: the new one.
    twins: Vec<Option<usize>>,
    /// The new objects by the ids that they say they have.
    by_id: BTreeMap<&'a ObjectId, Vec<usize>>,
    /// The looks of the old models.
    models: &'a BTreeMap<VariantId, String>,
    /// Names of new nodes whose extras cannot be read.
    broken: &'a [String],
    entries: BTreeMap<String, BTreeMap<String, ObjectEntry>>,
    notes: Faults,
}

impl Capturing<'_> {
    /// Finds the new object of each old one, then ids for the others, and where all of them will be.
    fn pair(&mut self) {
        let mut is_twin = vec![false; self.new.objects.len()];
        for index in 0..self.old.objects.len() {
            let twin = self.old.keys[index].as_ref().and_then(|key| self.twin(index, key));
            twin.into_iter().for_each(|twin| is_twin[twin] = true);
            self.twins.push(twin);
        }
        let mut taken: BTreeSet<Key> = self.old.keys.iter().flatten().cloned().collect();
        let mut keys: Vec<Option<Key>> = Vec::with_capacity(is_twin.len());
        for (object, is_twin) in self.new.objects.iter().zip(is_twin) {
            let Some(room) = object.room.clone() else {
                keys.push(None);
                continue;
            };
            let own = (room.clone(), object.id.clone());
            let is_own = is_twin && object.named_room.as_ref().is_none_or(|named| *named == room);
            let key = if is_own || !taken.contains(&own) { own } else { free_key(&room, &object.id, &taken) };
            taken.insert(key.clone());
            keys.push(Some(key));
        }
        self.new.keys = keys;
        let mut former = vec![None; self.new.objects.len()];
        for (index, twin) in self.twins.iter().enumerate() {
            let stays = twin.filter(|&twin| self.new.room(twin) == self.old.room(index));
            stays.into_iter().for_each(|twin| former[twin] = Some(index));
        }
        self.new.settle(&self.old, &former);
    }

    /// The new object that an old one is.
    fn twin(&self, index: usize, (room, id): &Key) -> Option<usize> {
        let place = self.old.objects[index].place;
        let is_here =
            |object: &SurveyedObject| object.named_room.as_ref().or(object.room.as_ref()) == Some(room);
        let same_id = self.by_id.get(id).into_iter().flatten();
        let candidates = same_id.map(|&index| (index, &self.new.objects[index]));
        let candidates = candidates.filter(|(_, object)| is_here(object));
        let rank = |(_, object): &(usize, &SurveyedObject)| {
            let has_name = object.node == self.old.objects[index].node;
            (!has_name, square_millimetres(place, object.place))
        };
        candidates.min_by_key(rank).map(|(twin, _)| twin)
    }

    fn compare_all(&mut self) {
        let mut is_known = vec![false; self.new.objects.len()];
        for index in 0..self.old.objects.len() {
            let Some((room, id)) = self.old.keys[index].clone() else { continue };
            let twin = self.twins[index].filter(|&twin| self.new.room(twin) == Some(&room));
            match twin {
                Some(twin) => {
                    is_known[twin] = true;
                    if let Some(entry) = self.compare(index, twin) {
                        self.entries.entry(room).or_default().insert(id.to_string(), entry);
                    }
                }
                None if self.goes_with_another(index) || self.is_broken(index) => {}
                None => {
                    let gone = ObjectEntry { remove: true, ..ObjectEntry::default() };
                    self.entries.entry(room).or_default().insert(id.to_string(), gone);
                }
            }
        }
        for index in (0..is_known.len()).filter(|&index| !is_known[index]) {
            self.add(index);
        }
    }

    /// Whether what an old object stands on is gone too.
    fn goes_with_another(&self, index: usize) -> bool {
        let stays =
            |above: usize| self.twins[above].is_some_and(|twin| self.new.room(twin) == self.old.room(above));
        self.old.objects[index].above.is_some_and(|above| !stays(above))
    }

    /// Whether an old object is there, but says nothing readable of itself any more: it stays as it was.
    fn is_broken(&self, index: usize) -> bool {
        self.broken.contains(&self.old.objects[index].node)
    }

    /// The changes of an object that is still in its room.
    fn compare(&mut self, old: usize, new: usize) -> Option<ObjectEntry> {
        let (before, after) = (&self.old.objects[old], &self.new.objects[new]);
        let mut entry = ObjectEntry::default();
        let model = self.look(before, after);
        let is_new = model != said_variant(before);
        if model.class != before.class {
            entry.class = Some(model.class);
        }
        if is_new {
            entry.variant = Some(model.number);
        }
        let Some(is) = self.new.standing(new) else {
            self.note(
                &after.node,
                "does not stand upright, or is mirrored: where it stands is not captured",
                UPRIGHT_HINT,
            );
            return (entry != ObjectEntry::default()).then_some(entry);
        };
        if !is_new && has_other_mesh(before, after) {
            self.note(
                &after.node,
                "has another mesh than it had: where it stands is not captured",
                MESH_HINT,
            );
            return (entry != ObjectEntry::default()).then_some(entry);
        }
        let was = self.old.standing(old);
        let is_elsewhere = was.as_ref().is_none_or(|was| was.parent != is.parent);
        if is_elsewhere {
            entry.parent = Some(is.parent.clone());
        }
        let was = was.filter(|_| !is_elsewhere);
        entry.at = moved(was.as_ref(), &is.place);
        entry.turn = turned(was.as_ref(), &is.place);
        self.note_size(before, after, &mut entry);
        (entry != ObjectEntry::default()).then_some(entry)
    }

    /// Class and variant of an object after the edit: what its extras say, else, where only its mesh is another one, what
    /// that tells. Of meshes that are alike an editor may keep one for all.
    fn look(&self, before: &SurveyedObject, after: &SurveyedObject) -> VariantId {
        let said = said_variant(after);
        let is_said_anew = said != said_variant(before);
        let (Some(was), Some(is), false) = (&before.model, &after.model, is_said_anew) else { return said };
        let is_alike = was == is || self.models.get(was) == self.models.get(is);
        if is_alike { said } else { is.clone() }
    }

    /// A scaled object is of another variant, or nothing that an edit can say.
    fn note_size(&mut self, before: &SurveyedObject, after: &SurveyedObject, entry: &mut ObjectEntry) {
        let (Some(was), Some(is)) = (before.place, after.place) else { return };
        let is_scaled = was.scale.iter().zip(&is.scale).any(|(a, b)| (a - b).abs() > 1e-3);
        if !is_scaled || entry.variant.is_some() {
            return;
        }
        let size: [f64; 3] = std::array::from_fn(|axis| after.size[axis] * is.scale[axis]);
        match self.variant_of_size(&after.class, after.variant, size) {
            Some(variant) => entry.variant = Some(variant),
            None => {
                let [width, depth, height] = size.map(round);
                let message =
                    format!("is scaled to {width} × {depth} × {height} m, which no variant of its class has");
                self.note(&after.node, &message, "`roomwright catalog classes CLASS` shows the sizes");
            }
        }
    }

    /// The variant of a size in the look of another one.
    fn variant_of_size(&self, class: &str, like: u32, size: [f64; 3]) -> Option<u32> {
        let class = &self.catalog.classes[self.catalog.class_index(class)?];
        let is_near = |Size { width, depth, height }: Size| {
            [width, depth, height].iter().zip(size).all(|(a, b)| (a - b).abs() <= SAME_SIZE)
        };
        let has_look = |variant: &u32| variant % class.looks == like % class.looks;
        (0..class.variant_count()).filter(has_look).find(|&variant| is_near(class.size(variant)))
    }

    fn add(&mut self, index: usize) {
        let object = &self.new.objects[index];
        let Some((room, id)) = self.new.keys[index].clone() else {
            return self.note(
                &object.node,
                "hangs below no room: it is not captured",
                "hang it below a room",
            );
        };
        let Some(is) = self.new.standing(index) else {
            return self.note(
                &object.node,
                "does not stand upright, or is mirrored: it is not captured",
                UPRIGHT_HINT,
            );
        };
        let entry = ObjectEntry {
            add: true,
            variant: Some(object.model.as_ref().map_or(object.variant, |model| model.number)),
            side: Side::ALL.into_iter().find(|side| side.name() == object.side),
            at: moved(None, &is.place),
            turn: turned(None, &is.place),
            parent: Some(is.parent),
            ..ObjectEntry::default()
        };
        self.entries.entry(room).or_default().insert(id.to_string(), entry);
    }

    fn note(&mut self, node: &str, message: &str, hint: &str) {
        let fault = Fault::of_file(self.file, format!("node \"{node}\" {message}"));
        self.notes.push(fault.with_hint(hint).as_warning());
    }
}

const UPRIGHT_HINT: &str = "furniture is moved, and turned about the vertical";

const MESH_HINT: &str = "move objects, not their vertices, and do not apply transforms (Ctrl+A)";

/// The class, number and variant in the extras of an object.
fn said_variant(object: &SurveyedObject) -> VariantId {
    VariantId { class: object.class.clone(), number: object.variant }
}

/// Whether vertices were moved: the box around them is another one.
fn has_other_mesh(before: &SurveyedObject, after: &SurveyedObject) -> bool {
    let Some((was, is)) = before.bounds.zip(after.bounds) else { return false };
    was.iter().flatten().zip(is.iter().flatten()).any(|(a, b)| (a - b).abs() > SAME_MESH)
}

fn by_id(survey: &Survey) -> BTreeMap<&ObjectId, Vec<usize>> {
    let mut by_id: BTreeMap<&ObjectId, Vec<usize>> = BTreeMap::new();
    for (index, object) in survey.objects.iter().enumerate() {
        by_id.entry(&object.id).or_default().push(index);
    }
    by_id
}

/// The next number of a class that is free in a room.
fn free_key(room: &str, id: &ObjectId, taken: &BTreeSet<Key>) -> Key {
    let mut keys = (1..).map(|number| (room.to_owned(), ObjectId::new(id.class.as_str(), number)));
    keys.find(|key| !taken.contains(key)).expect("there are more numbers than objects")
}

fn square_millimetres(a: Option<SurveyedPlace>, b: Option<SurveyedPlace>) -> u64 {
    let distance = |(a, b): (SurveyedPlace, SurveyedPlace)| a.position.distance_squared(b.position) * 1e6;
    a.zip(b).map_or(u64::MAX, |pair| distance(pair) as u64)
}
