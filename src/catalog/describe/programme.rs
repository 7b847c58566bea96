//! Describes the lines of programmes.

use serde_json::{Value, json};

use super::lines::{class_names, range, rounded};
use crate::catalog::{Catalog, Count, ForWhom, Request};

/// Square metres from which on an upper bound is none.
const UNBOUNDED_AREA: f64 = 1e6;

/// `2 armchair, chair (chance 0.5, from 9 m²)`.
pub(super) fn show_request(catalog: &Catalog, request: &Request) -> String {
    let mut terms = Vec::new();
    let (low, high) = request.area;
    if high < UNBOUNDED_AREA {
        terms.push(format!("{} m²", range(request.area)));
    } else if low > 0.0 {
        terms.push(format!("from {} m²", rounded(low)));
    }
    if request.is_required {
        terms.push("required".to_owned());
    }
    if !request.substitutes.is_empty() {
        terms.push(format!("or else {}", class_names(catalog, &request.substitutes).join(", ")));
    }
    if request.chance < 1.0 {
        terms.push(format!("chance {}", rounded(request.chance)));
    }
    if request.needs_window {
        terms.push("with a window".to_owned());
    }
    terms.extend(show_for_whom(&request.for_whom));
    let terms = if terms.is_empty() { String::new() } else { format!(" ({})", terms.join(", ")) };
    format!(
        "{} {}{terms}",
        show_count(catalog, request.count),
        class_names(catalog, &request.classes).join(" or ")
    )
}

/// Who gets the line, if not everybody.
fn show_for_whom(for_whom: &ForWhom) -> Vec<String> {
    let everybody = ForWhom::default();
    let households =
        (!for_whom.households.is_empty()).then(|| format!("for {}", for_whom.households.join(", ")));
    let persons = match (for_whom.persons, everybody.persons.1) {
        (persons, _) if persons == everybody.persons => None,
        ((least, most), unbounded) if most < unbounded => Some(format!("{least} to {most} people")),
        ((least, _), _) => Some(format!("from {least} people")),
    };
    let guests = for_whom.guests.map(|guests| format!("at most people and {guests} guests"));
    [households, persons, guests].into_iter().flatten().collect()
}

fn show_count(catalog: &Catalog, count: Count) -> String {
    match count {
        Count::Fixed(count) => count.to_string(),
        Count::Range(least, most) => format!("{least} to {most}"),
        Count::PerArea(pieces, least, most) => format!("{} per m², {least} to {most},", rounded(pieces)),
        Count::PerPiece(class, each) => format!("{} per {}:", rounded(each), catalog.classes[class].id),
        Count::PerWindow(each) => format!("{} per window:", rounded(each)),
        Count::Fill(most) => format!("up to {most}"),
        Count::FillPerArea(pieces, most) => format!("up to {} per m², up to {most},", rounded(pieces)),
    }
}

/// As in a configuration file.
pub(super) fn value_of_request(catalog: &Catalog, request: &Request) -> Value {
    let count = match request.count {
        Count::Fixed(count) => json!(count),
        Count::Range(least, most) => json!([least, most]),
        Count::PerArea(pieces, least, most) => json!({"per_area": pieces, "least": least, "most": most}),
        Count::PerPiece(class, each) => json!({"per": catalog.classes[class].id, "each": each}),
        Count::PerWindow(each) => json!({"per": "window", "each": each}),
        Count::Fill(most) => json!({"fill": most}),
        Count::FillPerArea(pieces, most) => json!({"fill": most, "per_area": pieces}),
    };
    json!({
        "class": class_names(catalog, &request.classes),
        "or": class_names(catalog, &request.substitutes),
        "count": count,
        "area": [request.area.0, request.area.1],
        "required": request.is_required,
        "chance": request.chance,
        "window": request.needs_window,
        "household": request.for_whom.households,
        "persons": [request.for_whom.persons.0, request.for_whom.persons.1],
        "guests": request.for_whom.guests,
    })
}

/// All lines as in a configuration file.
pub(super) fn value_of_programme(catalog: &Catalog, programme: &[Request]) -> Value {
    programme.iter().map(|request| value_of_request(catalog, request)).collect()
}
