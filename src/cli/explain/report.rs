//! An explanation as JSON.

use super::Subject;
use crate::audit::Finding;
use crate::cli::answer::{ExplainAnswer, ExplainedObject};
use crate::layout::parent_id;

/// Everything: where the room is, how it was furnished, each object and each missing piece. Metres, angles in
/// degrees.
pub(super) fn report<'a>(subject: &'a Subject<'_>) -> ExplainAnswer<'a> {
    let (found, explanation) = (&subject.found, &subject.explanation);
    let room = found.at.room;
    let (catalog, placements) = (&subject.sources.catalog, &subject.furnished.placements);
    let pairs = explanation.objects.iter().zip(placements);
    let objects = pairs.map(|(story, placement)| ExplainedObject {
        story,
        class: &catalog.classes[placement.class].id,
        parent: parent_id(placement.parent, found.at.level, catalog, placements),
        side: placement.side,
        position: [placement.position.x, placement.position.y, placement.elevation],
        turn: placement.angle.to_degrees(),
    });
    ExplainAnswer {
        building: &found.placed.id,
        level: &found.at.level.id,
        room: &room.id,
        room_type: &room.room_type,
        planned_type: room.home.as_ref().and_then(|home| home.planned_type.as_deref()),
        household: room.home.as_ref().map(|home| home.household.as_str()),
        area: room.region.area(),
        seed: subject.seed,
        style: &subject.sources.catalog.styles[subject.furnished.style].id,
        requested: subject.furnished.requested,
        placed: placements.len(),
        arrangement: subject.alternative + 1,
        attempt: explanation.kept,
        attempts: explanation.attempts,
        objects: objects.collect(),
        missing: &explanation.missing,
        findings: subject.findings.iter().map(Finding::extras).collect(),
        edited_afterwards: &subject.edited,
    }
}
