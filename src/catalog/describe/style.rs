//! Describes a style.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use super::lines::{Lines, degrees, rounded};
use super::programme::{show_request, value_of_programme};
use crate::catalog::{Catalog, Era, Request, Style};

/// The label, and what it is for.
pub(super) fn summary(catalog: &Catalog, id: &str) -> (String, String) {
    catalog.styles.get(id).map(|style| (style.label.clone(), show_room_types(style))).unwrap_or_default()
}

type Programmes = BTreeMap<String, Vec<Request>>;

/// A fact about a style, as people read it.
type Show = fn(&Catalog, &Style) -> String;

/// Programmes of a style.
type Select = fn(&Style) -> &Programmes;

/// The facts of a style besides programmes.
const FACTS: [(&str, Show); 8] = [
    ("made for", |_, style| show_room_types(style)),
    ("geometry", |_, style| style.geometry.name().to_owned()),
    ("palette", |catalog, style| catalog.palettes[style.palette].id.clone()),
    ("untidiness", |_, style| {
        format!("{}°, {} m", degrees(style.untidiness.turn), rounded(style.untidiness.distance))
    }),
    ("density", |_, style| rounded(style.density).to_string()),
    ("access", |_, style| style.access.word().to_owned()),
    ("era", |_, style| style.era.map_or("any", Era::word).to_owned()),
    ("wealth", |_, style| style.wealth.map_or_else(|| "any".to_owned(), |wealth| wealth.to_string())),
];

/// A fact, with that of the style that is extended where it is another.
fn compared(catalog: &Catalog, style: &Style, base: Option<&Style>, show: Show) -> String {
    let own = show(catalog, style);
    match base.map(|base| (show(catalog, base), &base.id)) {
        Some((other, id)) if other != own => format!("{own} (in {id}: {other})"),
        _ => own,
    }
}

/// The differences of a style from the one that it extends, or all facts if it extends none, in words:
/// names of facts and what they are here.
pub(super) fn differences(
    catalog: &Catalog,
    style: &Style,
    base: Option<&Style>,
) -> Vec<(&'static str, String)> {
    let differs = |show: Show| base.is_none_or(|base| show(catalog, base) != show(catalog, style));
    let facts = FACTS.into_iter().filter(|&(_, show)| differs(show));
    let facts = facts.map(|(name, show)| (name, show(catalog, style)));
    let kinds: [(&str, Select); 2] =
        [("programmes", |style| &style.programmes), ("additions", |style| &style.additions)];
    let changed = |(name, of): (&'static str, Select)| {
        let is_own = |room_type: &&String| {
            base.is_none_or(|base| of(base).get(*room_type) != of(style).get(*room_type))
        };
        let room_types: Vec<&str> = of(style).keys().filter(is_own).map(String::as_str).collect();
        (!room_types.is_empty()).then(|| (name, room_types.join(", ")))
    };
    facts.chain(kinds.into_iter().filter_map(changed)).collect()
}

fn show_room_types(style: &Style) -> String {
    if style.room_types.is_empty() { "all rooms".to_owned() } else { style.room_types.join(", ") }
}

/// Everything about a style, and what it changes of the one that it extends.
pub(super) fn describe_style(catalog: &Catalog, style: &Style, base: Option<&Style>) -> (Lines, Value) {
    let untidiness = style.untidiness;
    let mut lines = Lines::default();
    lines.add("label", &style.label);
    for (name, show) in FACTS {
        lines.add(name, &compared(catalog, style, base, show));
    }
    let inherited = |room_type: &str, of: Select| {
        base.filter(|base| of(base).get(room_type) == of(style).get(room_type)).map(|base| &base.id)
    };
    let kinds: [(&str, Select); 2] = [("", |style| &style.programmes), (", also", |style| &style.additions)];
    for (suffix, of) in kinds {
        for (room_type, programme) in of(style) {
            let name = format!("{room_type}{suffix}");
            match inherited(room_type, of) {
                Some(base) => lines.add(&name, &format!("as in {base}")),
                None => lines.add_all(&name, programme.iter().map(|request| show_request(catalog, request))),
            }
        }
    }
    let value = json!({
        "label": style.label,
        "room_types": style.room_types,
        "geometry": style.geometry.name(),
        "palette": catalog.palettes[style.palette].id,
        "untidiness": {"turn": degrees(untidiness.turn), "distance": untidiness.distance},
        "density": style.density,
        "access": style.access.word(),
        "era": style.era.map(Era::word),
        "wealth": style.wealth,
        "programmes": value_of_programmes(catalog, &style.programmes),
        "additions": value_of_programmes(catalog, &style.additions),
    });
    (lines, value)
}

fn value_of_programmes(catalog: &Catalog, programmes: &BTreeMap<String, Vec<Request>>) -> Value {
    let programmes = programmes
        .iter()
        .map(|(room_type, programme)| (room_type.clone(), value_of_programme(catalog, programme)));
    Value::Object(programmes.collect::<Map<_, _>>())
}
