//! Checks the hierarchy of classes: which class can stand on which, and how deep.

use std::collections::VecDeque;

use crate::catalog::report::Report;
use crate::catalog::resolve::ResolvedClass;
use crate::catalog::{ClassIndex, ParentName, ParentRule, Side};

/// Sets the expected depth of all classes: 0 for those that can stand on a room part, else one more than
/// their nearest possible parent (Germer and Schwarz 2009, section 3.2). Reports classes that lead to no
/// room part, and rules whose parents take no children.
///
/// `classes` holds every class at its index.
pub(crate) fn find_depths(classes: &mut [ResolvedClass], report: &mut Report<'_>) {
    report_barren_rules(classes, report);
    let depths = search(classes);
    for (class, depth) in classes.iter_mut().zip(depths) {
        match depth {
            Some(depth) => class.class.depth = depth,
            None => report_lost(class, report),
        }
    }
}

/// Breadth first from the room parts, so that the first depth found is the smallest.
fn search(classes: &[ResolvedClass]) -> Vec<Option<u32>> {
    let stands_on_part = |class: &ResolvedClass| class.class.parents.iter().any(|rule| !is_of_classes(rule));
    let mut depths: Vec<Option<u32>> =
        classes.iter().map(|class| stands_on_part(class).then_some(0)).collect();
    let children = list_children(classes);
    let mut queue: VecDeque<ClassIndex> =
        (0..classes.len()).filter(|&class| depths[class].is_some()).collect();
    while let Some(parent) = queue.pop_front() {
        for &child in &children[parent] {
            if depths[child].is_none() {
                depths[child] = depths[parent].map(|depth| depth + 1);
                queue.push_back(child);
            }
        }
    }
    depths
}

fn is_of_classes(rule: &ParentRule) -> bool {
    matches!(rule.parent, ParentName::Classes(_))
}

/// For each class, the classes that can stand at one of its sides.
fn list_children(classes: &[ResolvedClass]) -> Vec<Vec<ClassIndex>> {
    let mut children = vec![Vec::new(); classes.len()];
    for (child, class) in classes.iter().enumerate() {
        for rule in &class.class.parents {
            let ParentName::Classes(parents) = &rule.parent else { continue };
            for &parent in parents.iter().filter(|&&parent| takes_children(&classes[parent], &rule.sides)) {
                children[parent].push(child);
            }
        }
    }
    children
}

fn takes_children(parent: &ResolvedClass, sides: &[Side]) -> bool {
    sides.iter().any(|&side| parent.class.offer(side).places > 0)
}

/// A word in a rule that names no class with a place at the rule's sides.
fn report_barren_rules(classes: &[ResolvedClass], report: &mut Report<'_>) {
    for parent in classes.iter().flat_map(|class| &class.parents) {
        let sides = &parent.rule.sides;
        for named in &parent.named {
            if named.classes.iter().any(|&class| takes_children(&classes[class], sides)) {
                continue;
            }
            let sides: Vec<&str> = sides.iter().map(|side| side.name()).collect();
            let message = format!("\"{}\" offers no places at its side {}", named.word, sides.join(", "));
            report.warning(&named.spot, message, "give that side places, or take the parent away");
        }
    }
}

fn report_lost(class: &ResolvedClass, report: &mut Report<'_>) {
    let hint = if class.class.parents.is_empty() {
        "it has no `parents`: say on what it stands"
    } else {
        "its parents lead to no floor, ceiling, wall, door, window or column"
    };
    report.error_at_key(&class.spot, format!("class \"{}\" can never stand anywhere", class.class.id), hint);
}
