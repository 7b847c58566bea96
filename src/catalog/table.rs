//! The definitions of all folders, and which of them extend which.

use std::collections::BTreeMap;

use super::report::{Report, Spot};

/// Definitions that one may extend in a row. Those of the catalogue extend three; each one more is walked through for every key.
const MOST_EXTENDED: usize = 64;

/// One definition as it was written.
#[derive(Debug)]
pub(crate) struct Definition<T> {
    /// Its id.
    pub(crate) id: String,
    /// The folder it comes from: 0 is built in, later ones count on.
    pub(crate) layer: usize,
    /// Where it is written.
    pub(crate) spot: Spot,
    /// The entry as written.
    pub(crate) entry: T,
}

/// The interface of all kinds of definitions.
pub(crate) trait Extends {
    /// The name of the kind in messages.
    const KIND: &'static str;
    /// The key of a file under which they stand.
    const TABLE: &'static str;

    /// The definition whose keys are taken where this one has none.
    fn base(&self) -> Option<&str>;
}

/// All definitions of one kind.
#[derive(Debug)]
pub(crate) struct Table<T> {
    definitions: Vec<Definition<T>>,
    newest: BTreeMap<String, usize>,
    /// The definition of the same id in an earlier folder, by definition.
    earlier: Vec<Option<usize>>,
}

impl<T> Default for Table<T> {
    fn default() -> Self {
        Self { definitions: Vec::new(), newest: BTreeMap::new(), earlier: Vec::new() }
    }
}

/// A definition and all that it extends, itself first.
pub(crate) struct Chain<'a, T>(pub(crate) Vec<&'a Definition<T>>);

impl<T> Clone for Chain<'_, T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

/// A value with the definition that it is written in.
pub(crate) struct FoundValue<'a, T, V: ?Sized> {
    /// The value.
    pub(crate) value: &'a V,
    /// Where it is written.
    pub(crate) spot: Spot,
    /// The definition that writes it, which may be one that the asking one extends.
    pub(crate) definition: &'a Definition<T>,
}

impl<'a, T> Chain<'a, T> {
    /// The definition itself.
    pub(crate) fn own(&self) -> &'a Definition<T> {
        self.0[0]
    }

    /// The value of a key in the nearest definition that has one.
    pub(crate) fn find<V: ?Sized>(
        &self,
        key: &str,
        get: impl Fn(&'a T) -> Option<&'a V>,
    ) -> Option<FoundValue<'a, T, V>> {
        self.0.iter().find_map(|&definition| {
            get(&definition.entry).map(|value| FoundValue {
                value,
                spot: definition.spot.key(key),
                definition,
            })
        })
    }
}

impl<T: Extends> Table<T> {
    /// Adds a definition; folders come in their order, so that later ones win.
    pub(crate) fn add(&mut self, definition: Definition<T>, report: &mut Report<'_>) {
        let newest = self.newest.get(&definition.id).map(|&index| &self.definitions[index]);
        if let Some(first) = newest.filter(|first| first.layer == definition.layer) {
            let message = format!("{} \"{}\" is defined twice", T::KIND, definition.id);
            let hint = format!("the other definition is in {}", report.file(&first.spot));
            report.error_at_key(&definition.spot, message, &hint);
            return;
        }
        self.earlier.push(self.newest.insert(definition.id.clone(), self.definitions.len()));
        self.definitions.push(definition);
    }

    /// The ids, sorted.
    pub(crate) fn ids(&self) -> impl Iterator<Item = &str> + Clone {
        self.newest.keys().map(String::as_str)
    }

    /// The definition of an id in the last folder that has one.
    pub(crate) fn get(&self, id: &str) -> Option<&Definition<T>> {
        self.newest.get(id).map(|&index| &self.definitions[index])
    }

    /// The last definition of every id with all that it extends, sorted by id. Definitions whose bases
    /// are unknown, run in a circle or are too many are reported and left out.
    pub(crate) fn chains(&self, report: &mut Report<'_>) -> Vec<Chain<'_, T>> {
        self.newest.values().filter_map(|&index| self.chain(index, report)).collect()
    }

    fn chain(&self, start: usize, report: &mut Report<'_>) -> Option<Chain<'_, T>> {
        let mut indices = vec![start];
        let mut current = start;
        while let Some(base) = self.definitions[current].entry.base() {
            current = self.base_index(current, base, report)?;
            if let Some(first) = indices.iter().position(|&index| index == current) {
                // Every member and everything that leads into the circle ends here; one member reports it.
                if first == 0 && indices.iter().min() == Some(&start) {
                    self.report_circle(&indices, report);
                }
                return None;
            }
            indices.push(current);
            if indices.len() > MOST_EXTENDED + 1 {
                self.report_length(start, report);
                return None;
            }
        }
        Some(Chain(indices.iter().map(|&index| &self.definitions[index]).collect()))
    }

    /// The definition that another extends: the last definition of that id, or, where it names itself, the one of
    /// an earlier folder.
    fn base_index(&self, index: usize, base: &str, report: &mut Report<'_>) -> Option<usize> {
        let definition = &self.definitions[index];
        let spot = definition.spot.key("extends");
        if base == definition.id {
            let earlier = self.earlier[index];
            if earlier.is_none() {
                let message = format!("{} \"{base}\" extends itself", T::KIND);
                report.error_with_hint(&spot, message, "no earlier folder defines it");
            }
            return earlier;
        }
        let found = self.newest.get(base).copied();
        if found.is_none() {
            report.unknown(&spot, T::KIND, base, self.ids());
        }
        found
    }

    fn report_length(&self, start: usize, report: &mut Report<'_>) {
        let definition = &self.definitions[start];
        let message =
            format!("{} \"{}\" extends more than {MOST_EXTENDED} others in a row", T::KIND, definition.id);
        report.error_with_hint(&definition.spot.key("extends"), message, "let it extend one of the first");
    }

    fn report_circle(&self, indices: &[usize], report: &mut Report<'_>) {
        let ids: Vec<&str> =
            indices.iter().chain(indices.first()).map(|&index| self.definitions[index].id.as_str()).collect();
        let spot = self.definitions[indices[0]].spot.key("extends");
        report.error_with_hint(&spot, ids.join(" extends "), "take one `extends` of this circle away");
    }
}
