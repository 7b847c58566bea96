//! One style.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use super::lines::{Lines, degrees, rounded};
use super::programme::{show_request, value_of_programme};
use crate::catalog::{Catalog, Request, Style};

/// The label, and what it is for.
pub(super) fn summary(catalog: &Catalog, id: &str) -> (String, String) {
    catalog.styles.get(id).map(|style| (style.label.clone(), show_room_types(style))).unwrap_or_default()
}

fn show_room_types(style: &Style) -> String {
    if style.room_types.is_empty() { "all rooms".to_owned() } else { style.room_types.join(", ") }
}

/// Everything about a style.
pub(super) fn describe_style(catalog: &Catalog, style: &Style) -> (Lines, Value) {
    let untidiness = style.untidiness;
    let mut lines = Lines::default();
    lines.add("label", &style.label);
    lines.add("made for", &show_room_types(style));
    lines.add("geometry", &style.geometry);
    lines.add("palette", &style.palette);
    lines.add("untidiness", &format!("{}°, {} m", degrees(untidiness.turn), rounded(untidiness.distance)));
    lines.add("density", &rounded(style.density).to_string());
    for (room_type, programme) in &style.programmes {
        lines.add_all(room_type, programme.iter().map(|request| show_request(catalog, request)));
    }
    for (room_type, programme) in &style.additions {
        let lines_of = programme.iter().map(|request| show_request(catalog, request));
        lines.add_all(&format!("{room_type}, also"), lines_of);
    }
    let value = json!({
        "label": style.label,
        "room_types": style.room_types,
        "geometry": style.geometry,
        "palette": style.palette,
        "untidiness": {"turn": degrees(untidiness.turn), "distance": untidiness.distance},
        "density": style.density,
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
