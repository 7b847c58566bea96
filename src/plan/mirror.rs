//! Mirrors drafts of levels.

use super::{BuildingDraft, Leaf, LeafDraft, LevelDraft, OpeningPlace};
use crate::geometry::Point;

/// The building with east and west exchanged: x becomes −x, left hinges become right ones. Edges keep their
/// numbers, for corners keep their order; assembling turns the outlines round again.
pub(crate) fn mirror_building(draft: &BuildingDraft) -> BuildingDraft {
    BuildingDraft {
        name: draft.name.clone(),
        attribution: draft.attribution.clone(),
        usual_family: draft.usual_family,
        levels: draft.levels.iter().map(mirror_level).collect(),
    }
}

fn mirror_level(level: &LevelDraft) -> LevelDraft {
    let mut level = level.clone();
    for room in &mut level.rooms {
        mirror_points(&mut room.outline);
        room.holes.iter_mut().for_each(|hole| mirror_points(hole));
    }
    for obstacle in &mut level.obstacles {
        mirror_points(&mut obstacle.outline);
    }
    for outline in level.railings.iter_mut().chain(&mut level.wall_outlines) {
        mirror_points(outline);
    }
    for opening in &mut level.openings {
        if let OpeningPlace::Points { center, along } = &mut opening.place {
            *center = mirror(*center);
            *along = along.map(mirror);
        }
        mirror_leaf(&mut opening.leaf);
    }
    level
}

fn mirror_leaf(leaf: &mut LeafDraft) {
    match leaf {
        LeafDraft::Automatic | LeafDraft::None => {}
        LeafDraft::Swing { hinge_left, .. } => *hinge_left = !*hinge_left,
        LeafDraft::Points(leaves) => {
            for Leaf { hinge, closed_tip, open_tip } in leaves {
                [hinge, closed_tip, open_tip].into_iter().for_each(|point| *point = mirror(*point));
            }
        }
    }
}

fn mirror(point: Point) -> Point {
    // Subtracted, not negated: there is no negative zero to tell equal plans apart.
    Point::new(0.0 - point.x, point.y)
}

fn mirror_points(points: &mut [Point]) {
    points.iter_mut().for_each(|point| *point = mirror(*point));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::{OpeningDraft, OpeningKind, RoomDraft};

    #[test]
    fn twice_mirrored_is_as_before() {
        let door = OpeningDraft {
            id: "d".to_owned(),
            kind: OpeningKind::Door,
            place: OpeningPlace::Points { center: Point::new(1.0, 0.0), along: Some(Point::X) },
            rooms: Vec::new(),
            width: 0.9,
            bottom: 0.0,
            top: 2.0,
            leaf: LeafDraft::Swing { hinge_left: true, into: None, count: 1, angle: 1.5 },
        };
        let room = RoomDraft { outline: vec![Point::ZERO, Point::X, Point::ONE], ..RoomDraft::default() };
        let level = LevelDraft { rooms: vec![room], openings: vec![door], ..LevelDraft::default() };
        let draft = BuildingDraft { levels: vec![level], ..BuildingDraft::default() };
        let once = mirror_building(&draft);
        assert_eq!(once.levels[0].rooms[0].outline[1], Point::NEG_X);
        assert!(matches!(once.levels[0].openings[0].leaf, LeafDraft::Swing { hinge_left: false, .. }));
        let twice = mirror_building(&once);
        assert_eq!(format!("{twice:?}"), format!("{draft:?}"));
    }
}
