//! An explanation for programs.

use serde_json::{Value, json};

use crate::layout::parent_id;

use super::Subject;

/// Everything: where the room is, how it was furnished, each object and each missing piece. Metres, angles in
/// degrees.
pub(super) fn report(subject: &Subject<'_>) -> Value {
    let (found, explanation) = (subject.found, &subject.explanation);
    let room = found.room();
    let (catalog, placements) = (&subject.sources.catalog, &subject.furnished.placements);
    let parent = |parent| parent_id(parent, found.level, catalog, placements);
    let objects: Vec<Value> = explanation
        .objects
        .iter()
        .zip(placements)
        .map(|(story, placement)| {
            let mut object = json!(story);
            object["class"] = json!(catalog.classes[placement.class].id);
            object["parent"] = json!(parent(placement.parent));
            object["side"] = json!(placement.side);
            object["position"] = json!([placement.position.x, placement.position.y, placement.elevation]);
            object["turn"] = json!(placement.angle.to_degrees());
            object
        })
        .collect();
    json!({
        "building": found.placed.id,
        "level": found.level.id,
        "room": room.id,
        "type": room.room_type,
        "area": room.region.area(),
        "seed": subject.seed,
        "style": subject.furnished.style,
        "requested": subject.furnished.requested,
        "placed": subject.furnished.placements.len(),
        "arrangement": subject.alternative + 1,
        "attempt": explanation.kept,
        "attempts": explanation.attempts,
        "objects": objects,
        "missing": explanation.missing,
        "findings": subject.findings,
        "edited_afterwards": subject.edited,
    })
}
