//! Resolves the lines of a programme.

use super::names::{NamedClasses, Names};
use super::number::{AREA, COUNT, FACTOR, Quantity, SHARE, check_count};
use crate::catalog::file::{CountEntry, CountFields, RequestEntry};
use crate::catalog::report::{Report, Spot};
use crate::catalog::{ClassIndex, Count, ForWhom, Request};

/// Pieces for each piece of another class where the file says nothing.
const DEFAULT_EACH: f64 = 1.0;
/// The word of `per` for counting by the room's windows.
const WINDOW_WORD: &str = "window";
/// Most pieces of a line whose count goes with the area, where the file says nothing.
const DEFAULT_MOST: i64 = 1000;

/// A programme and the words that it was made of.
#[derive(Clone, Debug, Default)]
pub(crate) struct ResolvedProgramme {
    /// The lines.
    pub(crate) requests: Vec<Request>,
    /// The classes and groups of all lines.
    pub(crate) named: Vec<NamedClasses>,
    /// The classes that other lines count by, each with the place of its name.
    pub(crate) counted: Vec<(ClassIndex, Spot)>,
}

/// The lines of a programme that are not broken.
pub(super) fn resolve_programme(
    entries: &[RequestEntry],
    spot: &Spot,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> ResolvedProgramme {
    let mut programme = ResolvedProgramme::default();
    for (index, entry) in entries.iter().enumerate() {
        let spot = spot.index(index);
        let named = names.all_classes(&entry.class, &spot.key("class"), report);
        let or = entry.or.as_ref();
        let named_substitutes =
            or.map_or_else(Vec::new, |words| names.all_classes(words, &spot.key("or"), report));
        let count = resolve_count(entry.count.as_ref(), &spot.key("count"), names, report);
        if let Some(Count::PerPiece(class, _)) = count {
            programme.counted.push((class, spot.key("count").key("per")));
        }
        let area = entry.area.map_or((*AREA.start(), *AREA.end()), |pair| pair.with_highest(*AREA.end()));
        let area =
            Quantity { name: "area", unit: " m²", range: AREA }.check_pair(area, &spot.key("area"), report);
        let chance = Quantity::plain("chance", SHARE);
        let chance =
            entry.chance.map_or(1.0, |chance_of| chance.check(chance_of, &spot.key("chance"), report));
        let request = count.map(|count| Request {
            classes: in_written_order(&named, names),
            substitutes: in_written_order(&named_substitutes, names),
            count,
            area,
            is_required: entry.required,
            chance,
            needs_window: entry.window,
            for_whom: resolve_for_whom(entry, &spot, names, report),
        });
        programme.requests.extend(request.filter(|request| !request.classes.is_empty()));
        programme.named.extend(named.into_iter().chain(named_substitutes));
    }
    programme
}

fn resolve_for_whom(
    entry: &RequestEntry,
    spot: &Spot,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> ForWhom {
    let most = *COUNT.end() as f64;
    let persons = entry.persons.map_or((0.0, f64::from(u32::MAX)), |pair| {
        let quantity = Quantity::plain("persons", 0.0..=most);
        quantity.check_pair(pair.with_highest(most), &spot.key("persons"), report)
    });
    let words = || entry.household.iter().flat_map(|words| words.items());
    for (place, unknown) in words().filter(|(_, word)| !names.households.contains(word.as_str())) {
        let candidates = names.households.iter().copied();
        report.unknown(&spot.key("household").item(place), "household", unknown, candidates);
    }
    let households = words().map(|(_, word)| word.clone());
    let guests = match &entry.count {
        Some(CountEntry::Fields(CountFields { guests: Some(guests), .. })) => {
            Some(check_count("guests", *guests, &spot.key("count").key("guests"), report))
        }
        _ => None,
    };
    ForWhom { households: households.collect(), persons: (persons.0 as u32, persons.1 as u32), guests }
}

/// Each class once; of a word first the class of that id, then those of its group by id.
fn in_written_order(named: &[NamedClasses], names: &Names<'_>) -> Vec<ClassIndex> {
    let mut classes = Vec::new();
    for one in named {
        for class in names.index(&one.word).into_iter().chain(one.classes.iter().copied()) {
            if !classes.contains(&class) {
                classes.push(class);
            }
        }
    }
    classes
}

fn resolve_count(
    entry: Option<&CountEntry>,
    spot: &Spot,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Option<Count> {
    match entry {
        None => Some(Count::Fixed(1)),
        Some(CountEntry::Fixed(count)) => Some(Count::Fixed(check_count("count", *count, spot, report))),
        Some(CountEntry::Range([least, most])) => {
            check_order(*least, *most, spot, report);
            let least = check_count("count", *least, &spot.index(0), report);
            Some(Count::Range(least, check_count("count", *most, &spot.index(1), report)))
        }
        Some(CountEntry::Fields(fields)) => resolve_fields(fields, spot, names, report),
    }
}

fn check_order(least: i64, most: i64, spot: &Spot, report: &mut Report<'_>) {
    if least > most {
        let message = format!("count goes from {least} down to {most}");
        report.error_with_hint(spot, message, "write the lower number first");
    }
}

fn resolve_fields(
    fields: &CountFields,
    spot: &Spot,
    names: &Names<'_>,
    report: &mut Report<'_>,
) -> Option<Count> {
    check_companions(fields, spot, report);
    match (&fields.per, fields.per_area, fields.fill) {
        (Some(word), None, None) => {
            let each = Quantity::plain("each", FACTOR);
            let each = each.check(fields.each.unwrap_or(DEFAULT_EACH), &spot.key("each"), report);
            if word == WINDOW_WORD {
                return Some(Count::PerWindow(each));
            }
            Some(Count::PerPiece(only_class(word, &spot.key("per"), names, report)?, each))
        }
        (None, Some(per_area), None) => {
            let per_area = Quantity::plain("per_area", FACTOR).check(per_area, &spot.key("per_area"), report);
            let (least, most) = (fields.least.unwrap_or(0), fields.most.unwrap_or(DEFAULT_MOST));
            check_order(least, most, &spot.key("least"), report);
            let least = check_count("least", least, &spot.key("least"), report);
            Some(Count::PerArea(per_area, least, check_count("most", most, &spot.key("most"), report)))
        }
        (None, per_area, Some(fill)) => {
            let fill = check_count("fill", fill, &spot.key("fill"), report);
            let per_area_spot = spot.key("per_area");
            let per_area =
                per_area.map(|n| Quantity::plain("per_area", FACTOR).check(n, &per_area_spot, report));
            Some(per_area.map_or(Count::Fill(fill), |per_area| Count::FillPerArea(per_area, fill)))
        }
        _ => {
            let hint = "write a number, [least, most], {per: class or window, each: n}, {per_area: n}, {fill: n} or \
                        {fill: n, per_area: n}";
            report.error_with_hint(spot, "the count needs exactly one of `per`, `per_area` and `fill`", hint);
            None
        }
    }
}

/// `each` goes with `per`, `least` and `most` go with `per_area` without `fill`.
fn check_companions(fields: &CountFields, spot: &Spot, report: &mut Report<'_>) {
    let goes_with_area = fields.per_area.is_some() && fields.fill.is_none();
    let companions = [
        ("each", fields.each.is_some(), "per", fields.per.is_some()),
        ("guests", fields.guests.is_some(), "per", fields.per.is_some()),
        ("least", fields.least.is_some(), "per_area", goes_with_area),
        ("most", fields.most.is_some(), "per_area", goes_with_area),
    ];
    for (key, is_written, other, is_other_written) in companions {
        if is_written && !is_other_written {
            report.error(&spot.key(key), format!("`{key}` says nothing without `{other}`"));
        }
    }
}

/// The one class of a word that a count goes by.
fn only_class(word: &str, spot: &Spot, names: &Names<'_>, report: &mut Report<'_>) -> Option<ClassIndex> {
    let named = names.classes(word, spot, report)?;
    if let Some(class) = names.index(word) {
        return Some(class);
    }
    if named.classes.len() > 1 {
        let message = format!("\"{word}\" names {} classes, a count goes by one", named.classes.len());
        let ids: Vec<&str> = named.classes.iter().map(|&class| names.id(class)).collect();
        report.error_with_hint(spot, message, &format!("possible here: {}", ids.join(", ")));
        return None;
    }
    named.classes.first().copied()
}
