//! Describes a building style.

use serde_json::{Map, Value, json};

use super::lines::{Lines, rounded};
use crate::catalog::{BuildingStyle, Catalog, DEFAULT_STYLE, StyleRef, WeightedStyle};

/// The label, and what it draws from.
pub(super) fn summary(catalog: &Catalog, id: &str) -> (String, String) {
    let fact = |style: &BuildingStyle| match (show_choice(catalog, &style.styles), style.rooms.len()) {
        (choice, 0) => choice,
        (choice, 1) => format!("{choice}; 1 room type apart"),
        (choice, count) => format!("{choice}; {count} room types apart"),
    };
    catalog.building_styles.get(id).map(|style| (style.label.clone(), fact(style))).unwrap_or_default()
}

/// Everything about a building style.
pub(super) fn describe_building_style(catalog: &Catalog, style: &BuildingStyle) -> (Lines, Value) {
    let mut lines = Lines::default();
    lines.add("label", &style.label);
    lines.add("drawn per", style.share.word());
    lines.add("styles", &show_choice(catalog, &style.styles));
    for (room_type, choice) in &style.rooms {
        lines.add(room_type, &show_choice(catalog, choice));
    }
    lines.add_all(
        "instead",
        style.instead.iter().map(|(drawn, choice)| show_instead(catalog, *drawn, choice)),
    );
    let instead = style
        .instead
        .iter()
        .map(|(drawn, choice)| (id_of(catalog, *drawn), value_of_choice(catalog, choice)));
    let instead = Value::Object(instead.collect::<Map<_, _>>());
    let rooms =
        style.rooms.iter().map(|(room_type, choice)| (room_type.clone(), value_of_choice(catalog, choice)));
    let value = json!({
        "label": style.label,
        "share": style.share.word(),
        "styles": value_of_choice(catalog, &style.styles),
        "rooms": Value::Object(rooms.collect::<Map<_, _>>()),
        "instead": instead,
    });
    (lines, value)
}

fn id_of(catalog: &Catalog, style: StyleRef) -> String {
    catalog.styles[style].id.clone()
}

fn show_instead(catalog: &Catalog, drawn: StyleRef, choice: &[WeightedStyle]) -> String {
    let share = |one: &WeightedStyle| {
        format!("{} in {} of 100", id_of(catalog, one.style), rounded(one.weight * 100.0))
    };
    format!("{}: {}", id_of(catalog, drawn), choice.iter().map(share).collect::<Vec<_>>().join(", "))
}

fn show_choice(catalog: &Catalog, choice: &[WeightedStyle]) -> String {
    let is_even = choice.windows(2).all(|pair| pair[0].weight == pair[1].weight);
    let show = |one: &WeightedStyle| {
        let id = id_of(catalog, one.style);
        if is_even { id } else { format!("{} {id}", rounded(one.weight)) }
    };
    let shown: Vec<String> = choice.iter().map(show).collect();
    if shown.is_empty() { DEFAULT_STYLE.to_owned() } else { shown.join(", ") }
}

fn value_of_choice(catalog: &Catalog, choice: &[WeightedStyle]) -> Value {
    let weights = choice.iter().map(|one| (id_of(catalog, one.style), json!(one.weight)));
    Value::Object(weights.collect::<Map<_, _>>())
}
