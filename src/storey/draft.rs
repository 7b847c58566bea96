//! Writes storeys as the drafts that the readers of plans make: rooms on the middles of walls, openings by place.

use crate::plan::{LeafDraft, LevelDraft, OpeningDraft, OpeningKind, OpeningPlace, OutlineKind, RoomDraft};

use super::balconies::{BALCONY, railing};
use super::brief::Brief;
use super::building::Storey;
use super::dwelling::Cell;
use super::links::Link;
use super::typology::PlanKind;
use super::windows::Window;

/// Metres of floor between storeys.
const SLAB: f64 = 0.3;
/// Metres of the heads of doors.
pub(super) const DOOR_HEAD: f64 = 2.05;

/// A storey by its number from the ground up.
pub(super) fn level_draft(storey: &Storey, number: usize, brief: &Brief<'_>) -> LevelDraft {
    let is_house = brief.typology.plan == PlanKind::House;
    let ids = room_ids(&storey.cells, is_house);
    let rooms = storey.cells.iter().zip(&ids).map(|(cell, id)| RoomDraft {
        id: id.clone(),
        room_type: cell.room_type.clone(),
        outline: cell.ring.clone(),
        // A house without a name for its dwelling is one on all levels.
        dwelling: cell.unit.filter(|_| !is_house).map(|unit| format!("flat-{}", unit + 1)),
        ..RoomDraft::default()
    });
    let height = brief.typology.storey_height;
    let doors = storey
        .links
        .links
        .iter()
        .enumerate()
        .map(|(index, link)| door_draft(link, index, &ids, height - SLAB));
    let panes = storey.windows.iter().enumerate().map(|(index, window)| window_draft(window, index, &ids));
    let balconies = storey.cells.iter().filter(|cell| cell.room_type == BALCONY);
    LevelDraft {
        id: if number == 0 { "ground".to_owned() } else { format!("level-{number}") },
        name: String::new(),
        elevation: height * number as f64,
        height,
        exterior_thickness: storey.wall,
        interior_thickness: brief.typology.interior,
        outlines: OutlineKind::Center,
        rooms: rooms.collect(),
        openings: doors.chain(panes).collect(),
        railings: balconies.map(|cell| railing(&cell.ring)).collect(),
        ..LevelDraft::default()
    }
}

/// Ids of rooms: type and number, after the flat.
fn room_ids(cells: &[Cell], is_house: bool) -> Vec<String> {
    let mut counts = std::collections::BTreeMap::new();
    let id = |cell: &Cell| {
        let prefix = match cell.unit.filter(|_| !is_house) {
            Some(unit) => format!("flat-{}-{}", unit + 1, cell.room_type),
            None => cell.room_type.clone(),
        };
        let prefix = prefix.replace('_', "-");
        let count = counts.entry(prefix.clone()).and_modify(|count| *count += 1).or_insert(1);
        format!("{prefix}-{count}")
    };
    cells.iter().map(id).collect()
}

fn door_draft(link: &Link, index: usize, ids: &[String], ceiling: f64) -> OpeningDraft {
    let leaf = match (link.kind, link.leaves) {
        (OpeningKind::Door, 2) => LeafDraft::Swing {
            hinge_left: true,
            into: (!link.opens_out).then(|| ids[link.rooms.0].clone()),
            count: 2,
            angle: std::f64::consts::FRAC_PI_2,
        },
        (OpeningKind::Door, _) => LeafDraft::Automatic,
        _ => LeafDraft::None,
    };
    OpeningDraft {
        id: format!("door-{}", index + 1),
        kind: link.kind,
        place: OpeningPlace::Points { center: link.center, along: Some(link.along) },
        rooms: std::iter::once(link.rooms.0).chain(link.rooms.1).map(|room| ids[room].clone()).collect(),
        width: link.width,
        bottom: 0.0,
        top: if link.kind == OpeningKind::OpenBoundary { ceiling } else { DOOR_HEAD },
        leaf,
    }
}

fn window_draft(window: &Window, index: usize, ids: &[String]) -> OpeningDraft {
    OpeningDraft {
        id: format!("window-{}", index + 1),
        kind: OpeningKind::Window,
        place: OpeningPlace::Points { center: window.center, along: Some(window.along) },
        rooms: vec![ids[window.room].clone()],
        width: window.width,
        bottom: window.bottom,
        top: window.top,
        leaf: LeafDraft::None,
    }
}
