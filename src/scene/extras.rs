//! The `extras` of levels, openings, rooms and furniture.

use super::input::SceneInput;
use crate::audit::{Finding, Verdict};
use crate::catalog::{Catalog, Side};
use crate::contract::{
    Closure, Corner, Extras, FurnitureExtras, HouseholdExtras, LeafExtras, LevelExtras, OpeningExtras,
    OpeningWord, RemovedExtras, RoomExtras, SideExtras, SiteExtras, Word,
};
use crate::geometry::{Point, Polygon};
use crate::layout::{Furnished, Placement, object_id, parent_id};
use crate::plan::{Home, Leaf, Level, Opening, OpeningKind, OpeningSide, Room, SitePlacement};

/// Parts of a metre (or radian) that extras keep: what is smaller is rounding errors of the reader.
const PER_UNIT: f64 = 1e6;

/// Program and version, as in every file.
pub(crate) const GENERATOR: &str = concat!("roomwright ", env!("CARGO_PKG_VERSION"));

pub(crate) fn level_extras(input: &SceneInput<'_>) -> Extras {
    let site = (input.site != SitePlacement::default())
        .then(|| SiteExtras { position: pair(input.site.position), turn: rounded(input.site.turn) });
    Extras::Level(LevelExtras {
        building: input.building.to_owned(),
        level: input.level.id.clone(),
        elevation: rounded(input.level.elevation),
        height: rounded(input.level.height),
        seed: Some(input.seed),
        generator: Word::Borrowed(GENERATOR),
        site,
    })
}

pub(crate) fn opening_extras(level: &Level, opening: &Opening) -> Extras {
    let leaf = |leaf: &Leaf| LeafExtras {
        hinge: pair(leaf.hinge),
        closed: pair(leaf.closed_tip),
        open: pair(leaf.open_tip),
    };
    let side = |side: &OpeningSide| SideExtras {
        room: level.rooms[side.room].id.clone(),
        wall: side.wall,
        from: rounded(side.from),
        to: rounded(side.to),
    };
    Extras::Opening(OpeningExtras {
        opening: if opening.kind.is_walkable() { OpeningWord::Door } else { OpeningWord::Window },
        closure: closure(opening.kind),
        id: opening.id.clone(),
        rooms: opening.sides.iter().map(|side| level.rooms[side.room].id.clone()).collect(),
        sides: opening.sides.iter().map(side).collect(),
        width: rounded(opening.width),
        height: rounded(opening.top - opening.bottom),
        sill: rounded(opening.bottom),
        leaves: opening.leaves.iter().map(leaf).collect(),
    })
}

/// How an opening of a kind is closed, in the words of the contract.
pub(crate) fn closure(kind: OpeningKind) -> Closure {
    match kind {
        OpeningKind::Door => Closure::Door,
        OpeningKind::SlidingDoor => Closure::Sliding,
        OpeningKind::Passage => Closure::Passage,
        OpeningKind::OpenBoundary => Closure::Open,
        OpeningKind::Window => Closure::Window,
    }
}

pub(crate) fn room_extras(room: &Room, furnished: &Furnished, verdict: Verdict, catalog: &Catalog) -> Extras {
    let removed = furnished.removals.iter().map(|removal| RemovedExtras {
        class: catalog.classes[removal.class].id.clone(),
        reason: removal.reason.name().into(),
        required: removal.is_required,
    });
    Extras::Room(RoomExtras {
        room: room.id.clone(),
        room_type: room.room_type.clone(),
        planned_type: room.home.as_ref().and_then(|home| home.planned_type.clone()),
        household: room.home.as_ref().map(household_extras),
        style: catalog.styles[furnished.style].id.clone(),
        seed: furnished.seed,
        outline: corners(&room.region.outline),
        holes: room.region.holes.iter().map(corners).collect(),
        height: rounded(room.height),
        requested: furnished.requested,
        placed: u32::try_from(furnished.placements.len()).unwrap_or(u32::MAX),
        removed: removed.collect(),
        grade: verdict.grade().name().into(),
        score: verdict.score.map(|score| score.value),
        findings: verdict.findings.iter().map(Finding::extras).collect(),
    })
}

fn household_extras(home: &Home) -> HouseholdExtras {
    HouseholdExtras { id: home.household.clone(), persons: home.persons, bedrooms: home.bedrooms }
}

pub(crate) fn furniture_extras(
    input: &SceneInput<'_>,
    furnished: &Furnished,
    placement: &Placement,
) -> FurnitureExtras {
    let size = placement.size;
    FurnitureExtras {
        class: input.catalog.classes[placement.class].id.clone(),
        id: object_id(input.catalog, placement),
        parent: parent_id(placement.parent, input.level, input.catalog, &furnished.placements),
        side: Side::name(placement.side).into(),
        size: [size.width, size.depth, size.height].map(rounded),
        variant: placement.variant,
    }
}

/// The corners of a polygon.
pub(crate) fn corners(polygon: &Polygon) -> Vec<Corner> {
    polygon.corners().iter().map(|&corner| pair(corner)).collect()
}

fn pair(point: Point) -> Corner {
    [rounded(point.x), rounded(point.y)]
}

/// Without digits that are rounding errors, and without a negative zero.
pub(crate) fn rounded(value: f64) -> f64 {
    (value * PER_UNIT).round() / PER_UNIT + 0.0
}
