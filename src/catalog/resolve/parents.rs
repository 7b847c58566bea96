//! Resolves the parents of a class.

use super::names::{NamedClasses, Names, room_part, union};
use super::number::{ANGLE, DISTANCE, Quantity, SIGNED_DISTANCE};
use crate::catalog::file::{ClassEntry, ParentEntry};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Chain;
use crate::catalog::{Along, Orientation, ParentName, ParentRule, Side, Turn};

/// A parent rule and the words that it was made of.
#[derive(Clone, Debug)]
pub(crate) struct ResolvedParent {
    /// The rule.
    pub(crate) rule: ParentRule,
    /// The classes and groups that it names; empty for room parts.
    pub(crate) named: Vec<NamedClasses>,
}

/// The parent rules of a class, best first.
pub(super) fn resolve_parents(
    chain: &Chain<'_, ClassEntry>,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Vec<ResolvedParent> {
    let Some(found) = chain.find("parents", |entry| entry.parents.as_ref()) else { return Vec::new() };
    let entries = found.value.items();
    entries
        .filter_map(|(place, entry)| resolve_parent(entry, &found.spot.item(place), names, report))
        .collect()
}

fn resolve_parent(
    entry: &ParentEntry,
    spot: &Spot,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Option<ResolvedParent> {
    let (parent, named) = resolve_name(entry, &spot.key("on"), names, report);
    let jitter = Quantity::degrees("jitter", ANGLE);
    let jitter = entry.jitter.map_or(0.0, |degrees| jitter.check(degrees, &spot.key("jitter"), report));
    let gap = Quantity::metres("gap", SIGNED_DISTANCE);
    let gap = entry.gap.map_or((0.0, 0.0), |pair| gap.check_pair(pair.both(), &spot.key("gap"), report));
    let elevation = Quantity::metres("elevation", DISTANCE);
    let elevation = entry
        .elevation
        .map_or((0.0, 0.0), |pair| elevation.check_pair(pair.both(), &spot.key("elevation"), report));
    let above_head = Quantity::metres("above_head", DISTANCE);
    let above_head = entry.above_head.map(|metres| above_head.check(metres, &spot.key("above_head"), report));
    let parent = parent?;
    let sides = resolve_sides(entry, &parent, spot, report)?;
    let default_turn = if parent == ParentName::Floor { Turn::Quarter } else { Turn::Parallel };
    let rule = ParentRule {
        sides,
        tag: entry.tag.clone(),
        orientation: Orientation { turn: entry.turn.unwrap_or(default_turn), jitter: jitter.to_radians() },
        along: entry.along.unwrap_or(Along::Random),
        gap,
        elevation,
        above_head,
        parent,
    };
    Some(ResolvedParent { rule, named })
}

/// A room part that stands alone, or the classes of all words.
fn resolve_name(
    entry: &ParentEntry,
    spot: &Spot,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> (Option<ParentName>, Vec<NamedClasses>) {
    let mut words = entry.on.items().map(|(_, word)| word);
    if let (Some(word), None) = (words.next(), words.next())
        && let Some(part) = room_part(word)
    {
        return (Some(part), Vec::new());
    }
    let named = names.all_classes(&entry.on, spot, report);
    let parent = (!named.is_empty()).then(|| ParentName::Classes(union(&named)));
    (parent, named)
}

/// The sides of room parts that one can stand at.
fn sides_of_part(parent: &ParentName) -> Option<&'static [Side]> {
    match parent {
        ParentName::Floor => Some(&[Side::Above]),
        ParentName::Ceiling => Some(&[Side::Below]),
        ParentName::Wall | ParentName::Door | ParentName::Window => Some(&[Side::Front]),
        ParentName::Column => Some(&[Side::Front, Side::Back, Side::Left, Side::Right]),
        ParentName::Classes(_) => None,
    }
}

fn resolve_sides(
    entry: &ParentEntry,
    parent: &ParentName,
    spot: &Spot,
    report: &mut Report<'_>,
) -> Option<Vec<Side>> {
    let possible = sides_of_part(parent);
    let Some(written) = &entry.side else {
        if possible.is_none() {
            let hint = "write `side:` with front, back, left, right, above or below";
            report.error_with_hint(spot, "it is not said at which side of the parent", hint);
        }
        return possible.map(<[Side]>::to_vec);
    };
    let spot = spot.key("side");
    let mut sides = Vec::new();
    for (place, &side) in written.items() {
        if possible.is_some_and(|possible| !possible.contains(&side)) {
            let possible: Vec<&str> = possible.into_iter().flatten().map(|side| side.name()).collect();
            let message = format!("this room part has no side \"{}\" to stand at", side.name());
            report.error_with_hint(
                &spot.item(place),
                message,
                &format!("possible here: {}", possible.join(", ")),
            );
        } else if !sides.contains(&side) {
            sides.push(side);
        }
    }
    if written.items().next().is_none() {
        report.error_with_hint(&spot, "the list of sides is empty", "name at least one side of the parent");
    }
    (!sides.is_empty()).then_some(sides)
}
