//! Writes a checked building as a native plan, for `import`.

mod file;

use std::collections::BTreeMap;

use self::file::{Number, OutColumn, OutLevel, OutOpening, OutPlan, OutRoom, OutWall, OutWalls, point, ring};
use super::read::native::number_of_id;
use super::{Building, Leaf, Level, Opening, OpeningKind, Room, Wall, WallKind};
use crate::geometry::Point;
use serde_saphyr::{FlowMap, FlowSeq};

/// Tags that assembling gives by what a wall is; they are not written, for they come back by themselves.
const GIVEN_TAGS: [&str; 11] = [
    "blind",
    "door",
    "end",
    "exterior",
    "interior",
    "longest",
    "open",
    "opposite_door",
    "pipes",
    "railing",
    "window",
];
/// Thickness of outer walls where a building has none.
const USUAL_EXTERIOR_THICKNESS: f64 = 0.3;

/// Writes a building as YAML in the native format, one line per outline and opening.
///
/// Lengths are rounded to 0.01 mm. Reading the text back gives the same rooms, numbers, walls, columns and openings;
/// outer walls get one thickness for the whole building, the one that most metres of wall have.
#[must_use]
pub fn write_native(building: &Building, id: &str) -> String {
    let plan = OutPlan {
        version: super::read::native::VERSION,
        id: id.to_owned(),
        name: building.name.clone(),
        attribution: building.attribution.clone(),
        walls: FlowMap(OutWalls { exterior: Number(exterior_thickness(building)) }),
        levels: building.levels.iter().map(level).collect(),
    };
    let options = serde_saphyr::ser_options! { prefer_block_scalars: false, compact_list_indent: true };
    // Texts and numbers alone cannot fail to be written.
    serde_saphyr::to_string_with_options(&plan, options).expect("a plan is texts and numbers")
}

fn level(level: &Level) -> OutLevel {
    let mut columns = Vec::new();
    for room in &level.rooms {
        columns.extend(room.obstacles.iter().map(|obstacle| {
            let is_full = obstacle.height >= room.height;
            let height = (!is_full).then_some(Number(obstacle.height));
            FlowMap(OutColumn { outline: ring(&obstacle.outline), height })
        }));
    }
    OutLevel {
        id: level.id.clone(),
        name: Some(level.name.clone()).filter(|name| *name != level.id),
        elevation: Number(level.elevation),
        height: Number(level.height),
        rooms: level.rooms.iter().map(room).collect(),
        openings: level.openings.iter().map(|entry| FlowMap(opening(level, entry))).collect(),
        columns,
    }
}

fn room(room: &Room) -> OutRoom {
    let edge_count = room.region.outline.corners().len();
    let edges = room.walls.iter().take(edge_count).enumerate();
    let walls = edges.filter_map(|(edge, wall)| special_wall(edge, wall)).map(FlowMap).collect();
    OutRoom {
        id: room.id.clone(),
        name: room.name.clone(),
        room_type: room.room_type.clone(),
        style: room.style.clone(),
        dwelling: room.dwelling.clone(),
        household: room.household.clone(),
        number: (room.number != number_of_id(&room.id)).then_some(room.number),
        height: Number(room.height),
        outline: ring(&room.region.outline),
        holes: room.region.holes.iter().map(ring).collect(),
        walls,
    }
}

fn special_wall(edge: usize, wall: &Wall) -> Option<OutWall> {
    let own = wall.tags.iter().filter(|tag| !GIVEN_TAGS.contains(&tag.as_str()));
    let tags: Vec<String> = own.cloned().collect();
    let railing = matches!(wall.kind, WallKind::Railing(_));
    (railing || !tags.is_empty()).then_some(OutWall { edge, tags, railing })
}

fn opening(level: &Level, opening: &Opening) -> OutOpening {
    let ids = opening.sides.iter().map(|side| level.rooms[side.room].id.clone());
    let mut out = OutOpening {
        id: opening.id.clone(),
        kind: kind(opening.kind),
        at: point(opening.center),
        along: point(opening.along),
        rooms: FlowSeq(ids.collect()),
        width: Number(opening.width),
        sill: Number(opening.bottom),
        head: Number(opening.top),
        hinge: None,
        opens_into: None,
        leaves: None,
        swing: None,
    };
    if opening.kind == OpeningKind::Door {
        describe_leaves(level, opening, &mut out);
    }
    out
}

fn describe_leaves(level: &Level, opening: &Opening, out: &mut OutOpening) {
    let Some(leaf) = opening.leaves.first() else {
        out.leaves = Some(0);
        return;
    };
    let into = opening.sides.iter().find(|side| {
        let wall = &level.rooms[side.room].walls[side.wall];
        (leaf.open_tip - leaf.hinge).dot(wall.normal()) > 0.0
    });
    // Seen from inside, a wall runs from right to left, for its room is on its left; from outside the other way.
    let (room, right_to_left) = match (into, opening.sides.first()) {
        (Some(side), _) => (Some(side.room), level.rooms[side.room].walls[side.wall].direction()),
        (None, Some(side)) => (None, -level.rooms[side.room].walls[side.wall].direction()),
        (None, None) => return,
    };
    let is_left = (leaf.closed_tip - leaf.hinge).dot(right_to_left) < 0.0;
    out.opens_into = Some(room.map_or("outside", |room| &level.rooms[room].id).to_owned());
    out.leaves = (opening.leaves.len() != 1).then_some(opening.leaves.len());
    out.hinge = (opening.leaves.len() == 1).then_some(if is_left { "left" } else { "right" });
    let swing = Number(swing_degrees(leaf));
    out.swing = (swing.rounded() != RIGHT_ANGLE).then_some(swing);
}

/// Degrees that a leaf opens where nothing is said.
const RIGHT_ANGLE: f64 = 90.0;

fn swing_degrees(leaf: &Leaf) -> f64 {
    let (closed, open): (Point, Point) = (leaf.closed_tip - leaf.hinge, leaf.open_tip - leaf.hinge);
    libm::atan2(closed.perp_dot(open).abs(), closed.dot(open)).to_degrees()
}

fn kind(kind: OpeningKind) -> &'static str {
    match kind {
        OpeningKind::Door => "door",
        OpeningKind::SlidingDoor => "sliding_door",
        OpeningKind::Passage => "passage",
        OpeningKind::OpenBoundary => "open_boundary",
        OpeningKind::Window => "window",
    }
}

/// The thickness that most metres of outer wall have.
fn exterior_thickness(building: &Building) -> f64 {
    let mut metres: BTreeMap<u64, f64> = BTreeMap::new();
    let rooms = building.levels.iter().flat_map(|level| &level.rooms);
    // A railing is no measure for walls.
    let is_outer = |wall: &&Wall| wall.is_exterior && !matches!(wall.kind, WallKind::Railing(_));
    for wall in rooms.flat_map(|room| &room.walls).filter(is_outer) {
        // Keyed by whole hundredths of a millimetre: floats have no order to sort by.
        *metres.entry((wall.thickness.max(0.0) * file::ROUNDING) as u64).or_default() += wall.length();
    }
    let most = metres.iter().max_by(|a, b| a.1.total_cmp(b.1).then(b.0.cmp(a.0)));
    most.map_or(USUAL_EXTERIOR_THICKNESS, |(thickness, _)| *thickness as f64 / file::ROUNDING)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_building_is_written() {
        let text = write_native(&Building { name: None, attribution: None, levels: Vec::new() }, "none");
        assert_eq!(text, "version: 1\nid: none\nwalls: {exterior: 0.3}\nlevels: []\n");
    }

    #[test]
    fn the_angle_of_a_leaf_is_measured() {
        let leaf = Leaf { hinge: Point::ZERO, closed_tip: Point::X, open_tip: Point::NEG_Y };
        assert!((swing_degrees(&leaf) - 90.0).abs() < 1e-12);
    }
}
