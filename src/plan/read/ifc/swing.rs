//! How doors open: `OperationType` and the axes of the door.
//!
//! ```text
//!        y  the way that a leaf opens
//!        ^
//!   |====+====|      A leaf "to the left" hangs at the end of small x, seen along y.
//!   0    x →  width
//! ```

use glam::{DAffine3, DVec3};

use super::model::{Entity, Read};
use super::placement::Geometry;
use super::relations::Relations;
use crate::geometry::Point;
use crate::plan::{Leaf, LeafDraft, OpeningKind};

/// Cosine of the largest angle between a door's own axis and its wall.
const ALONG: f64 = 0.9;

/// The file's word for the operation of a door.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Operation {
    /// Leaves that hang at the left, at the right, or both.
    Swing {
        left: bool,
        right: bool,
    },
    /// Everything that needs no room to open.
    Slide,
    Unknown,
}

impl Operation {
    fn of(word: &str) -> Self {
        let has = |part: &str| word.contains(part);
        match word {
            _ if ["SLIDING", "FOLDING", "ROLLINGUP", "REVOLVING", "LIFTING"].into_iter().any(has) => {
                Self::Slide
            }
            _ if has("DOUBLE_DOOR") || has("DOUBLE_PANEL") => Self::Swing { left: true, right: true },
            "SINGLE_SWING_LEFT" | "DOUBLE_SWING_LEFT" | "SWING_FIXED_LEFT" => {
                Self::Swing { left: true, right: false }
            }
            "SINGLE_SWING_RIGHT" | "DOUBLE_SWING_RIGHT" | "SWING_FIXED_RIGHT" => {
                Self::Swing { left: false, right: true }
            }
            _ => Self::Unknown,
        }
    }
}

/// A door in its wall.
pub(super) struct Doorway {
    pub(super) center: Point,
    /// Unit vector.
    pub(super) along: Point,
    pub(super) width: f64,
}

/// The closure of a door, and its leaves.
pub(super) fn closure(
    geometry: &Geometry<'_>,
    relations: &Relations,
    frame: &DAffine3,
    door: &Entity,
    doorway: &Doorway,
) -> Read<(OpeningKind, LeafDraft)> {
    let word = operation_word(geometry, relations, door)?;
    match Operation::of(word.as_deref().unwrap_or_default()) {
        Operation::Slide => Ok((OpeningKind::SlidingDoor, LeafDraft::Automatic)),
        Operation::Unknown => Ok((OpeningKind::Door, LeafDraft::Automatic)),
        Operation::Swing { left, right } => {
            let axes = *frame * geometry.place(door)? * turned(geometry, door)?;
            Ok((OpeningKind::Door, leaves(&axes, doorway, left, right)))
        }
    }
}

/// The door's own operation (IFC4), or that of its type or style.
fn operation_word(geometry: &Geometry<'_>, relations: &Relations, door: &Entity) -> Read<Option<String>> {
    if let Some(word) = door.value(11).word() {
        return Ok(Some(word.to_owned()));
    }
    let Some(kind) = relations.type_of.get(&door.id) else { return Ok(None) };
    let kind = geometry.model.get(*kind)?;
    let place = match kind.kind.as_str() {
        "IFCDOORSTYLE" => 8,
        "IFCDOORTYPE" => 10,
        _ => return Ok(None),
    };
    Ok(kind.value(place).word().map(str::to_owned))
}

/// How the shape of the type, which the operation speaks of, is turned or mirrored for this door.
fn turned(geometry: &Geometry<'_>, door: &Entity) -> Read<DAffine3> {
    let first = geometry.representations(door).ok().and_then(|all| all.first()?.first().copied());
    let Some(item) = first.filter(|item| geometry.model.is(*item, &["IFCMAPPEDITEM"])) else {
        return Ok(DAffine3::IDENTITY);
    };
    let item = geometry.model.get(item)?;
    geometry.operator(item.reference(1)?)
}

fn leaves(axes: &DAffine3, doorway: &Doorway, left: bool, right: bool) -> LeafDraft {
    let flat = |axis: DVec3| axes.transform_vector3(axis).truncate().normalize_or_zero();
    let (x, y) = (flat(DVec3::X), flat(DVec3::Y));
    let is_along = x.dot(doorway.along).abs() > ALONG && y.dot(doorway.along).abs() < 1.0 - ALONG;
    if !is_along {
        return LeafDraft::Automatic;
    }
    let leaf = |to_hinge: Point| {
        let hinge = doorway.center + to_hinge * (doorway.width / 2.0);
        let length = if left && right { doorway.width / 2.0 } else { doorway.width };
        Leaf { hinge, closed_tip: hinge - to_hinge * length, open_tip: hinge + y * length }
    };
    let hung = [(left, -x), (right, x)].into_iter().filter(|(is_there, _)| *is_there);
    LeafDraft::Points(hung.map(|(_, to_hinge)| leaf(to_hinge)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOORWAY: Doorway = Doorway { center: Point::new(3.0, 2.0), along: Point::X, width: 0.9 };

    fn hung(axes: &DAffine3, [left, right]: [bool; 2]) -> Vec<Leaf> {
        match leaves(axes, &DOORWAY, left, right) {
            LeafDraft::Points(leaves) => leaves,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_left_leaf_hangs_at_small_x_and_opens_along_y() {
        let [leaf] = hung(&DAffine3::IDENTITY, [true, false])[..] else { panic!() };
        assert!(leaf.hinge.distance(Point::new(2.55, 2.0)) < 1e-9);
        assert!(leaf.open_tip.distance(Point::new(2.55, 2.9)) < 1e-9);
        let half_turn = DAffine3::from_rotation_z(std::f64::consts::PI);
        let [leaf] = hung(&half_turn, [true, false])[..] else { panic!() };
        assert!(leaf.hinge.distance(Point::new(3.45, 2.0)) < 1e-9);
        assert!(leaf.open_tip.distance(Point::new(3.45, 1.1)) < 1e-9);
    }

    #[test]
    fn a_mirrored_leaf_hangs_at_the_other_end() {
        let mirror = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
        let [leaf] = hung(&mirror, [true, false])[..] else { panic!() };
        assert!(leaf.hinge.distance(Point::new(3.45, 2.0)) < 1e-9);
        assert!(leaf.open_tip.distance(Point::new(3.45, 2.9)) < 1e-9);
        assert_eq!(hung(&mirror, [true, true]).len(), 2);
    }

    #[test]
    fn words_of_all_schemas_are_known() {
        let both = Operation::Swing { left: true, right: true };
        for (word, operation) in [
            ("SINGLE_SWING_LEFT", Operation::Swing { left: true, right: false }),
            ("DOUBLE_SWING_RIGHT", Operation::Swing { left: false, right: true }),
            ("DOUBLE_DOOR_SINGLE_SWING", both),
            ("DOUBLE_PANEL_DOUBLE_SWING", both),
            ("DOUBLE_DOOR_SLIDING", Operation::Slide),
            ("FOLDING_TO_LEFT", Operation::Slide),
            ("NOTDEFINED", Operation::Unknown),
        ] {
            assert_eq!(Operation::of(word), operation, "{word}");
        }
    }
}
