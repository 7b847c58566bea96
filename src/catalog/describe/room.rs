//! Describes a room type.

use serde_json::{Value, json};

use super::lines::{Lines, range};
use super::programme::{show_request, value_of_programme};
use crate::catalog::{Catalog, Finish, RoomType};

/// The label, and how much it holds.
pub(super) fn summary(catalog: &Catalog, id: &str) -> (String, String) {
    let Some(room_type) = catalog.room_types.get(id) else { return Default::default() };
    let fact = if room_type.is_furnished {
        format!("{} lines", room_type.programme.len())
    } else {
        "not furnished".to_owned()
    };
    (room_type.label.clone(), fact)
}

/// Everything about a room type.
pub(super) fn describe_room_type(catalog: &Catalog, room_type: &RoomType) -> (Lines, Value) {
    let finish = &room_type.finish;
    let styles: Vec<&str> = catalog
        .styles
        .values()
        .filter(|style| style.room_types.is_empty() || style.room_types.contains(&room_type.id))
        .map(|style| style.id.as_str())
        .collect();
    let mut lines = Lines::default();
    lines.add("label", &room_type.label);
    lines.add("furnished", if room_type.is_furnished { "yes" } else { "no" });
    lines.add("usually", &format!("{} m²", range(room_type.area)));
    lines.add("density", &range(room_type.density));
    lines.add("excludes", &room_type.excludes.join(", "));
    let dado = finish.dado.as_ref().map(|dado| format!(", dado {} up to {} m", dado.slot, dado.height));
    let dado = dado.unwrap_or_default();
    lines.add(
        "finish",
        &format!("floor {}, wall {}{dado}, ceiling {}", finish.floor, finish.wall, finish.ceiling),
    );
    lines.add("alike in a", room_type.share.word());
    lines.add("fitted", &show_fittings(finish));
    lines.add_all("holds", room_type.programme.iter().map(|request| show_request(catalog, request)));
    lines.add("styles", &styles.join(", "));
    let value = json!({
        "label": room_type.label,
        "furnish": room_type.is_furnished,
        "joins_levels": room_type.joins_levels,
        "area": [room_type.area.0, room_type.area.1],
        "density": [room_type.density.0, room_type.density.1],
        "excludes": room_type.excludes,
        "finish": {
            "floor": finish.floor.name(),
            "wall": finish.wall.name(),
            "ceiling": finish.ceiling.name(),
            "dado": finish.dado.as_ref().map(|dado| json!({"slot": dado.slot.name(), "height": dado.height})),
            "sockets": finish.sockets.unwrap_or(0.0),
            "switches": finish.has_switches,
        },
        "share": room_type.share.word(),
        "programme": value_of_programme(catalog, &room_type.programme),
        "styles": styles,
    });
    (lines, value)
}

/// The fittings of the walls.
fn show_fittings(finish: &Finish) -> String {
    let sockets = finish.sockets.map(|interval| format!("a socket for {interval} m of wall"));
    let switches = finish.has_switches.then(|| "switches at doors".to_owned());
    let words: Vec<String> = sockets.into_iter().chain(switches).collect();
    if words.is_empty() { "nothing".to_owned() } else { words.join(", ") }
}
