//! Resolves the relations of a class.

use super::names::{Names, room_part, union};
use super::number::{ANGLE, FACTOR, FAR, Quantity, RANGE};
use crate::catalog::file::{ClassEntry, OneOrMany, RelationEntry};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Chain;
use crate::catalog::{ParentName, Relation, RelationKind};

/// Degrees off the axis that are good where the file says nothing.
const DEFAULT_ANGLE: f64 = 30.0;
/// Share in the score where the file says nothing.
const DEFAULT_WEIGHT: f64 = 1.0;

/// Metres that are good where the file says nothing.
fn default_distance(kind: RelationKind) -> (f64, f64) {
    match kind {
        // Across a room and no further: a television, a whiteboard.
        RelationKind::Faces | RelationKind::Sees | RelationKind::Opposite => (0.0, 8.0),
        RelationKind::Near => (0.0, 1.5),
        RelationKind::AwayFrom => (1.0, FAR),
        // As deep as the light of a window should stay free.
        RelationKind::NotBefore => (0.0, 1.0),
        RelationKind::Beside => (0.0, 0.3),
        RelationKind::AlignedWith => (0.0, FAR),
        // Who comes in carries something past it.
        RelationKind::ClearOf => (0.75, FAR),
    }
}

/// The relations of a class.
pub(super) fn resolve_relations(
    chain: &Chain<'_, ClassEntry>,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Vec<Relation> {
    let Some(found) = chain.find("relations", |entry| entry.relations.as_ref()) else { return Vec::new() };
    let entries = found.value.items();
    entries
        .filter_map(|(place, entry)| resolve_relation(entry, &found.spot.item(place), names, report))
        .collect()
}

fn resolve_relation(
    entry: &RelationEntry,
    spot: &Spot,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Option<Relation> {
    let weight = Quantity::plain("weight", FACTOR);
    let weight = weight.check(entry.weight.unwrap_or(DEFAULT_WEIGHT), &spot.key("weight"), report);
    let angle = Quantity::degrees("angle", ANGLE);
    let angle = angle.check(entry.angle.unwrap_or(DEFAULT_ANGLE), &spot.key("angle"), report);
    let (key, kind, target) = only_kind(entry, spot, report)?;
    let distance = entry.distance.map_or_else(
        || default_distance(kind),
        |pair| {
            let away = matches!(kind, RelationKind::AwayFrom | RelationKind::ClearOf);
            let both = if away { pair.with_highest(FAR) } else { pair.with_lowest(0.0) };
            Quantity::metres("distance", RANGE).check_pair(both, &spot.key("distance"), report)
        },
    );
    let target = resolve_target(target, &spot.key(key), names, report)?;
    Some(Relation { kind, target, distance, angle: angle.to_radians(), weight, is_needed: entry.needed })
}

/// The kind that is written, if it is exactly one.
fn only_kind<'e>(
    entry: &'e RelationEntry,
    spot: &Spot,
    report: &mut Report<'_>,
) -> Option<(&'static str, RelationKind, &'e OneOrMany<String>)> {
    let kinds = [
        ("faces", RelationKind::Faces, &entry.faces),
        ("sees", RelationKind::Sees, &entry.sees),
        ("opposite", RelationKind::Opposite, &entry.opposite),
        ("near", RelationKind::Near, &entry.near),
        ("away_from", RelationKind::AwayFrom, &entry.away_from),
        ("not_before", RelationKind::NotBefore, &entry.not_before),
        ("beside", RelationKind::Beside, &entry.beside),
        ("aligned_with", RelationKind::AlignedWith, &entry.aligned_with),
        ("clear_of", RelationKind::ClearOf, &entry.clear_of),
    ];
    let all = kinds.map(|(key, ..)| key).join(", ");
    let mut written = kinds.into_iter().filter_map(|(key, kind, target)| Some((key, kind, target.as_ref()?)));
    let first = written.next();
    if first.is_none() {
        report.error_with_hint(spot, "the relation does not say its kind", &format!("write one of {all}"));
    }
    if let (Some((first, ..)), Some((second, ..))) = (&first, written.next()) {
        let message = format!("the relation is both `{first}` and `{second}`");
        report.error_with_hint(&spot.key(second), message, "write one line for each");
    }
    first
}

/// A room part that stands alone, or classes.
fn resolve_target(
    words: &OneOrMany<String>,
    spot: &Spot,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Option<ParentName> {
    let mut each = words.items().map(|(_, word)| word);
    if let (Some(word), None) = (each.next(), each.next())
        && let Some(part) = room_part(word)
    {
        return Some(part);
    }
    let named = names.all_classes(words, spot, report);
    (!named.is_empty()).then(|| ParentName::Classes(union(&named)))
}
