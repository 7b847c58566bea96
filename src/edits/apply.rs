//! Applies edits to a furnished room.

use super::book::{ObjectEdit, RoomEdits};
use super::file::ObjectEntry;
use super::misfit::Misfit;
use super::tree::{Object, Tree, usual_place, usual_side};
use crate::catalog::{Catalog, ClassIndex};
use crate::contract::{ElementId, ObjectId};
use crate::layout::{Furnished, Parent};
use crate::plan::Level;
use crate::read_back::room_part;

/// The room after its edits.
#[derive(Clone, Debug)]
pub(super) struct Edited {
    pub(super) furnished: Furnished,
    /// Rejected edits, in the order of the ids.
    pub(super) misfits: Vec<Misfit>,
    /// Ids of the objects that were edited, with their edits' ids.
    pub(super) touched: Vec<(String, String)>,
}

/// Makes the edits: classes first, for other edits may name what comes of them; then new objects, then places, and last
/// what goes, so that objects with an edit of their own are not removed with it.
pub(super) fn apply(level: &Level, furnished: &Furnished, edits: &RoomEdits, catalog: &Catalog) -> Edited {
    let tree = Tree::new(furnished);
    let mut editor =
        Editor { level, room: furnished.room, catalog, tree, misfits: Vec::new(), touched: Vec::new() };
    let each =
        |chosen: fn(&ObjectEntry) -> bool| edits.objects.iter().filter(move |(_, edit)| chosen(&edit.entry));
    for (id, edit) in each(|entry| entry.class.is_some() || (entry.variant.is_some() && !entry.add)) {
        editor.swap(id, edit);
    }
    let added = each(|entry| entry.add).filter_map(|(id, edit)| Some((editor.add(id, edit)?, edit)));
    let added: Vec<_> = added.collect();
    // Only now that all are there: one may stand on another, whatever their order.
    for (object, edit) in added {
        editor.place(object, edit);
    }
    for (id, edit) in each(|entry| !entry.remove) {
        editor.put(id, edit);
    }
    for (id, edit) in each(|entry| entry.remove) {
        editor.remove(id, edit);
    }
    editor.finish(furnished)
}

struct Editor<'a> {
    level: &'a Level,
    room: usize,
    catalog: &'a Catalog,
    tree: Tree,
    misfits: Vec<Misfit>,
    /// Objects that were edited, with the ids of the edits.
    touched: Vec<(usize, String)>,
}

const GONE_HINT: &str = "the room is arranged otherwise now; take the edit out, or name another object";

impl Editor<'_> {
    /// The object of an edit; if there is none, the edit is rejected.
    fn find(&mut self, id: &str, edit: &ObjectEdit) -> Option<usize> {
        let found = self.tree.find(id, self.catalog);
        if found.is_none() {
            let room = &self.level.rooms[self.room].id;
            let message = format!("there is no {id} in room \"{room}\"");
            let misfit = Misfit::unmade(&edit.mark, message, GONE_HINT);
            // Asked for once for each change of the edit.
            if !self.misfits.contains(&misfit) {
                self.misfits.push(misfit);
            }
        }
        found
    }

    fn swap(&mut self, id: &str, edit: &ObjectEdit) {
        let Some(object) = self.find(id, edit) else { return };
        let named = edit.entry.class.as_deref().and_then(|class| self.catalog.class_index(class));
        let before = self.tree.objects[object].class;
        let class = named.unwrap_or(before);
        let number = self.tree.free_number(class);
        let changed = &mut self.tree.objects[object];
        if class != before {
            (changed.class, changed.number, changed.former_id) = (class, number, Some(id.to_owned()));
        }
        changed.variant = edit.entry.variant.unwrap_or(0);
        let size = self.catalog.classes[class].size(changed.variant);
        self.tree.resize(object, size);
        self.touched.push((object, id.to_owned()));
    }

    /// A new object, not yet where its edit says; none where the class is unknown or it is locked and there already.
    fn add(&mut self, id: &str, edit: &ObjectEdit) -> Option<usize> {
        let (class, wanted) = self.class_of(id)?;
        let is_taken = self.tree.find(id, self.catalog).is_some();
        if is_taken && edit.entry.lock {
            // It was there before the others.
            return None;
        }
        let number = if is_taken { self.tree.free_number(class) } else { wanted };
        let variant = edit.entry.variant.unwrap_or(0);
        self.tree.objects.push(Object {
            class,
            number,
            former_id: None,
            on: Parent::Floor,
            side: usual_side(Parent::Floor),
            place: usual_place(Parent::Floor, self.catalog.classes[class].size(variant), self.room()),
            arranged: None,
            variant,
            size: self.catalog.classes[class].size(variant),
            is_gone: false,
        });
        let object = self.tree.objects.len() - 1;
        if is_taken {
            let new_id = self.id(object);
            let message = format!("{id} is in the room already: the new one is {new_id}");
            self.misfits.push(Misfit::made(&edit.mark, message, "give it another number"));
        }
        self.touched.push((object, id.to_owned()));
        Some(object)
    }

    /// Moves, turns, hangs elsewhere.
    fn put(&mut self, id: &str, edit: &ObjectEdit) {
        let ObjectEntry { add, lock, parent, side, at, turn, .. } = &edit.entry;
        let says_where = parent.is_some() || side.is_some() || at.is_some() || turn.is_some();
        if (*add && !*lock) || !says_where {
            return;
        }
        let Some(object) = self.find(id, edit) else { return };
        self.place(object, edit);
        self.touched.push((object, id.to_owned()));
    }

    /// Puts an object where its edit says.
    fn place(&mut self, object: usize, edit: &ObjectEdit) {
        let entry = &edit.entry;
        if let Some(on) = &entry.parent {
            match self.parent(object, on) {
                Ok(parent) if parent == self.tree.objects[object].on && !entry.add => {}
                Ok(parent) => self.hang(object, parent),
                Err(message) => {
                    self.misfits.push(Misfit::unmade(&edit.mark, message, GONE_HINT));
                    if !entry.add {
                        return;
                    }
                }
            }
        }
        let changed = &mut self.tree.objects[object];
        let place = changed.place.edited(entry);
        changed.side = entry.side.unwrap_or(changed.side);
        if place != changed.place {
            (changed.place, changed.arranged) = (place, None);
        }
    }

    /// Gives an object another parent: where nothing else is said it stands as one usually does there.
    fn hang(&mut self, object: usize, on: Parent) {
        let size = self.tree.objects[object].size;
        let mut place = usual_place(on, size, self.room());
        if let Parent::Object(parent) = on {
            place.elevation = self.tree.objects[parent].size.height;
        }
        let changed = &mut self.tree.objects[object];
        (changed.on, changed.side, changed.place, changed.arranged) = (on, usual_side(on), place, None);
    }

    fn remove(&mut self, id: &str, edit: &ObjectEdit) {
        if let Some(object) = self.find(id, edit) {
            self.tree.remove(object);
        }
    }

    /// The parent that an edit names.
    fn parent(&self, object: usize, on: &str) -> Result<Parent, String> {
        let element = on.parse::<ElementId>().ok();
        if let Some(part) = element.and_then(|element| room_part(&element, self.level.room(self.room))) {
            return Ok(part);
        }
        let room = &self.room().id;
        let missing = || format!("there is no {on} in room \"{room}\" to stand on");
        let parent = self.tree.find(on, self.catalog).ok_or_else(missing)?;
        match self.tree.stands_on(parent, object) {
            true => Err(format!("{on} stands on {} itself", self.id(object))),
            false => Ok(Parent::Object(parent)),
        }
    }

    fn class_of(&self, id: &str) -> Option<(ClassIndex, u32)> {
        let ObjectId { class, number } = id.parse().ok()?;
        Some((self.catalog.class_index(&class)?, number))
    }

    fn room(&self) -> &crate::plan::Room {
        &self.level.rooms[self.room]
    }

    fn id(&self, object: usize) -> String {
        let Object { class, number, .. } = &self.tree.objects[object];
        ObjectId::new(self.catalog.classes[*class].id.as_str(), *number).to_string()
    }

    fn finish(self, furnished: &Furnished) -> Edited {
        let placements = self.tree.placements();
        let count = placements.len() + furnished.removals.len();
        let present = self.touched.iter().filter(|(object, _)| !self.tree.objects[*object].is_gone);
        let touched = present.map(|(object, id)| (self.id(*object), id.clone())).collect();
        let requested = u32::try_from(count).expect("a room holds fewer than 2^32 pieces");
        Edited {
            furnished: Furnished { placements, requested, ..furnished.clone() },
            misfits: self.misfits,
            touched,
        }
    }
}
