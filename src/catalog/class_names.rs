//! Sets of classes in words.

use std::collections::{BTreeMap, BTreeSet};

use super::{Catalog, ClassIndex};

impl Catalog {
    /// The name of a set of classes (sorted indices) for people: the groups that lie wholly in it, those first that name most of
    /// it, and the ids of the classes that are in none of these. Exact: nothing else is meant.
    #[must_use]
    pub fn class_names(&self, classes: &[ClassIndex]) -> String {
        let groups = self.groups_within(classes);
        let mut unnamed: BTreeSet<ClassIndex> = classes.iter().copied().collect();
        let mut names = Vec::new();
        loop {
            let named = |members: &[ClassIndex]| members.iter().filter(|it| unnamed.contains(it)).count();
            let gains = groups.iter().map(|(&group, members)| (named(members), group, members));
            // Of equals the first by name.
            let best = gains.reduce(|best, next| if next.0 > best.0 { next } else { best });
            // A group in place of one class would be no shorter.
            let Some((_, group, members)) = best.filter(|&(gain, ..)| gain > 1) else { break };
            members.iter().for_each(|member| _ = unnamed.remove(member));
            names.push(group);
        }
        names.extend(unnamed.iter().map(|&class| self.classes[class].id.as_str()));
        names.join(", ")
    }

    /// The groups that have no class outside of a set (sorted indices), with their classes.
    fn groups_within(&self, classes: &[ClassIndex]) -> BTreeMap<&str, Vec<ClassIndex>> {
        let mut groups: BTreeMap<&str, Vec<ClassIndex>> = BTreeMap::new();
        for (index, class) in self.classes.iter().enumerate() {
            for group in &class.groups {
                groups.entry(group).or_default().push(index);
            }
        }
        groups.retain(|_, members| members.iter().all(|member| classes.binary_search(member).is_ok()));
        groups
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Catalog, Class};
    use crate::recipes::find;

    fn catalog(classes: &[(&str, &[&str])]) -> Catalog {
        let class = |&(id, groups): &(&str, &[&str])| Class {
            groups: groups.iter().map(|&group| group.to_owned()).collect(),
            ..Class::plain(id, Vec::new(), find("desk").expect("a recipe"))
        };
        Catalog { classes: classes.iter().map(class).collect(), ..Catalog::default() }
    }

    #[test]
    fn a_set_of_classes_is_named_by_the_largest_groups_that_lie_in_it() {
        let catalog = catalog(&[
            ("armchair", &["seat", "soft_seat"]),
            ("bookcase", &["storage"]),
            ("chest", &["storage", "surface"]),
            ("desk", &["surface", "table"]),
            ("lamp", &[]),
            ("sofa", &["seat", "soft_seat"]),
        ]);
        assert_eq!(catalog.class_names(&[0, 5]), "seat");
        assert_eq!(catalog.class_names(&[0, 1, 2, 4, 5]), "seat, storage, lamp");
        assert_eq!(catalog.class_names(&[1, 3]), "bookcase, desk", "no group lies in it");
        assert_eq!(catalog.class_names(&[1, 2, 3]), "storage, desk", "one more is named by its id");
        assert_eq!(catalog.class_names(&[]), "");
    }
}
