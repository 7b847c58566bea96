//! An explanation for programs.

use serde_json::{Value, json};

use crate::layout::{Parent, Placement};

use super::Subject;

/// Everything: where the room is, how it was furnished, each object and each missing piece. Metres, angles in
/// degrees.
pub(super) fn report(subject: &Subject<'_>) -> Value {
    let (found, explanation) = (subject.found, &subject.explanation);
    let room = found.room();
    let objects: Vec<Value> = explanation
        .objects
        .iter()
        .zip(&subject.furnished.placements)
        .map(|(story, placement)| {
            let mut object = json!(story);
            object["class"] = json!(subject.sources.catalog.classes[placement.class].id);
            object["parent"] = json!(parent(subject, placement));
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
    })
}

fn parent(subject: &Subject<'_>, placement: &Placement) -> String {
    match placement.parent {
        Parent::Floor => "floor".to_owned(),
        Parent::Ceiling => "ceiling".to_owned(),
        Parent::Wall(wall) => format!("wall.{wall}"),
        Parent::Opening(index) => {
            let opening = &subject.found.level.openings[index];
            let kind = if opening.kind.is_walkable() { "door" } else { "window" };
            format!("{kind}:{}", opening.id)
        }
        Parent::Column(column) => format!("column.{column}"),
        Parent::Object(index) => subject.explanation.objects[index].id.clone(),
    }
}
