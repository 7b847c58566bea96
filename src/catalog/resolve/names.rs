//! Resolves the words of parents, relations, programmes and `excludes`.

use std::collections::{BTreeMap, BTreeSet};

use crate::catalog::file::{ClassEntry, OneOrMany};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::{Chain, Table};
use crate::catalog::{ClassIndex, ParentName};

/// The room parts by name.
pub(super) const ROOM_PARTS: [(&str, ParentName); 6] = [
    ("ceiling", ParentName::Ceiling),
    ("column", ParentName::Column),
    ("door", ParentName::Door),
    ("floor", ParentName::Floor),
    ("wall", ParentName::Wall),
    ("window", ParentName::Window),
];

/// The room part of a name.
pub(super) fn room_part(name: &str) -> Option<ParentName> {
    ROOM_PARTS.iter().find(|(part, _)| *part == name).map(|(_, parent)| parent.clone())
}

/// All classes by index, and who is meant by each word.
pub(crate) struct Names<'a> {
    ids: Vec<&'a str>,
    groups: Vec<Vec<String>>,
    words: BTreeMap<&'a str, Vec<ClassIndex>>,
    abstract_ids: BTreeSet<&'a str>,
    /// The households that lines of programmes may be for.
    pub(crate) households: BTreeSet<&'a str>,
}

/// A word and the classes that it means, sorted.
#[derive(Clone, Debug)]
pub(crate) struct NamedClasses {
    /// The word.
    pub(crate) word: String,
    /// Where it is written.
    pub(crate) spot: Spot,
    /// At least one.
    pub(crate) classes: Vec<ClassIndex>,
}

impl<'a> Names<'a> {
    /// Numbers the classes by id and collects their groups.
    pub(crate) fn new(
        table: &'a Table<ClassEntry>,
        chains: &[Chain<'a, ClassEntry>],
        report: &mut Report<'_>,
    ) -> Self {
        let mut names = Self {
            ids: Vec::new(),
            groups: Vec::new(),
            words: BTreeMap::new(),
            abstract_ids: BTreeSet::new(),
            households: BTreeSet::new(),
        };
        for id in table.ids() {
            let definition = table.get(id).expect("the id comes from the table");
            if room_part(id).is_some() {
                let message = format!("class \"{id}\" is named like a room part");
                report.error_at_key(&definition.spot, message, "take another id");
            }
            if definition.entry.is_abstract {
                names.abstract_ids.insert(id);
            } else {
                names.words.entry(id).or_default().push(names.ids.len());
                names.ids.push(id);
                names.groups.push(Vec::new());
            }
        }
        for chain in chains {
            names.add_groups(chain, report);
        }
        for members in names.words.values_mut() {
            members.sort_unstable();
            members.dedup();
        }
        names
    }

    fn add_groups(&mut self, chain: &Chain<'a, ClassEntry>, report: &mut Report<'_>) {
        let Some(found) = chain.find("groups", |entry| entry.groups.as_ref()) else { return };
        let class = self.index(&chain.own().id);
        for (place, group) in found.value.items() {
            let spot = found.spot.item(place);
            if room_part(group).is_some() || group.is_empty() {
                report.error_with_hint(
                    &spot,
                    format!("\"{group}\" is no name for a group"),
                    "take another word",
                );
            }
            let Some(class) = class else { continue };
            self.words.entry(group).or_default().push(class);
            self.groups[class].push(group.clone());
        }
        if let Some(class) = class {
            self.groups[class].sort();
            self.groups[class].dedup();
        }
    }

    /// Number of classes that are not abstract.
    pub(crate) fn class_count(&self) -> usize {
        self.ids.len()
    }

    /// The id of a class.
    pub(crate) fn id(&self, class: ClassIndex) -> &'a str {
        self.ids[class]
    }

    /// The groups of a class, sorted.
    pub(crate) fn groups(&self, class: ClassIndex) -> &[String] {
        &self.groups[class]
    }

    /// The index of a class that is not abstract.
    pub(crate) fn index(&self, id: &str) -> Option<ClassIndex> {
        self.ids.binary_search(&id).ok()
    }

    /// The other classes of a group that is named like a class.
    pub(super) fn stand_ins(&self, class: ClassIndex) -> Vec<ClassIndex> {
        let meant = self.words.get(self.id(class)).into_iter().flatten();
        meant.copied().filter(|&other| other != class).collect()
    }

    /// The classes of a word: the class of that id and all classes of that group.
    pub(super) fn classes(&self, word: &str, spot: &Spot, report: &mut Report<'_>) -> Option<NamedClasses> {
        if let Some(classes) = self.words.get(word) {
            return Some(NamedClasses {
                word: word.to_owned(),
                spot: spot.clone(),
                classes: classes.clone(),
            });
        }
        if self.abstract_ids.contains(word) {
            let hint = "name one of its groups, or classes that extend it";
            report.error_with_hint(
                spot,
                format!("class \"{word}\" is abstract and never stands in a room"),
                hint,
            );
        } else if room_part(word).is_some() {
            let hint = "name a class or a group; a room part as a parent needs a line of its own";
            report.error_with_hint(spot, format!("\"{word}\" is a room part and cannot stand here"), hint);
        } else {
            report.unknown(spot, "class or group", word, self.words.keys().copied());
        }
        None
    }

    /// The classes of each of several words that has a meaning.
    pub(super) fn all_classes(
        &self,
        words: &OneOrMany<String>,
        spot: &Spot,
        report: &mut Report<'_>,
    ) -> Vec<NamedClasses> {
        let named =
            words.items().filter_map(|(place, word)| self.classes(word, &spot.item(place), report)).collect();
        if words.items().next().is_none() {
            report.error_with_hint(spot, "the list is empty", "name at least one class or group");
        }
        named
    }
}

/// The classes of several words, sorted, each once.
pub(super) fn union(named: &[NamedClasses]) -> Vec<ClassIndex> {
    let mut classes: Vec<ClassIndex> = named.iter().flat_map(|one| one.classes.iter().copied()).collect();
    classes.sort_unstable();
    classes.dedup();
    classes
}
