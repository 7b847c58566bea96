//! Small rooms and a small catalogue for the audit's tests.

use crate::catalog::{
    Access, Along, Catalog, Class, Clearance, Count, Extent, Finish, Orientation, PaletteRef, ParentName,
    ParentRule, PrismRule, Request, RoomType, Shape, Side, Size, Style, StyleRef, Turn, Untidiness,
};
use crate::geometry::{Point, Polygon, Region};
use crate::layout::{Furnished, Parent, Placement, Removal, RemovalReason};
use crate::plan::{Level, Opening, OpeningKind, OpeningSide, Room, RoomOpening};
use crate::recipes::{GeometrySet, Slot, find};
use crate::solve::judge_room;

use super::fault::{Element, Fault, Named};
use super::{Code, Finding, Severity, Verdict};

/// A finding of a kind that the test has no room for.
pub(crate) fn found(code: Code, ids: &[&str]) -> Finding {
    let named = |id: &&str| Named { id: (*id).to_owned(), element: Element::Object(0) };
    Finding::new(code, Fault::new(code.quantities()[0], ids.iter().map(named).collect(), 0.5, 0.9))
}

/// The same finding where the plan leaves no other choice.
pub(crate) fn given(finding: &Finding) -> Finding {
    Finding { severity: Severity::Given, ..finding.clone() }
}

/// A room 2.5 m high, of type `office` and style `default`, with objects of the test catalogue that are placed by hand. Wall 0 of
/// a rectangle is the south wall, wall 1 the east wall; at angle 0 the front of an object faces south.
///
/// Classes, width × depth × height: chest 1 × 1 × 0.8, stool 0.4 × 0.4 × 0.45, lamp 0.2 × 0.2 × 0.3 (hangs from ceilings),
/// picture 0.6 × 0.05 × 0.5 (hangs on walls), table 1.5 × 0.75 × 0.75 with four legs, desk the same as a box with a clearance of 0.75 before it.
///
/// [`Self::add`] puts an object at floor height, whatever its parent. To hang one, set the height of its underside: a lamp at
/// the ceiling has `room.placements[lamp].elevation = 2.5 - 0.3`.
pub(crate) struct TestRoom {
    pub(crate) level: Level,
    pub(crate) catalog: Catalog,
    pub(crate) placements: Vec<Placement>,
    pub(crate) removals: Vec<Removal>,
    pub(crate) requested: Option<u32>,
}

pub(crate) fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

impl TestRoom {
    pub(crate) fn rectangle(width: f64, depth: f64) -> Self {
        Self::outline(&[(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)])
    }

    pub(crate) fn outline(corners: &[(f64, f64)]) -> Self {
        let corners: Vec<Point> = corners.iter().map(|&(x, y)| at(x, y)).collect();
        let region = Region::simple(Polygon::new(&corners).unwrap());
        let level = Level::bare("ground", 3.0, vec![room(region)]);
        Self { level, catalog: catalog(), placements: Vec::new(), removals: Vec::new(), requested: None }
    }

    pub(crate) fn set_holes(&mut self, holes: Vec<Polygon>) {
        let outline = self.level.rooms[0].region.outline.clone();
        self.level.rooms[0] = room(Region { outline, holes });
    }

    /// Puts an opening `(from, to)` metres along a wall, `(bottom, top)` metres high.
    pub(crate) fn open(&mut self, wall: usize, kind: OpeningKind, along: (f64, f64), heights: (f64, f64)) {
        let number = self.level.openings.len();
        let face = self.level.rooms[0].walls[wall].clone();
        let (from, to) = along;
        self.level.openings.push(Opening {
            id: number.to_string(),
            kind,
            center: face.start + face.direction() * (from + to) / 2.0,
            along: face.direction(),
            width: to - from,
            bottom: heights.0,
            top: heights.1,
            leaves: Vec::new(),
            sides: vec![OpeningSide { room: 0, wall, from, to }],
        });
        self.level.rooms[0].openings.push(RoomOpening { opening: number, wall, from, to });
    }

    /// Stands an object on the floor; the answer is its index.
    pub(crate) fn stand(&mut self, class: &str, position: Point) -> usize {
        self.add(class, position, Parent::Floor)
    }

    /// Adds an object at floor height; the answer is its index.
    pub(crate) fn add(&mut self, class: &str, position: Point, parent: Parent) -> usize {
        let class = self.catalog.class_index(class).unwrap();
        let earlier = self.placements.iter().filter(|placement| placement.class == class).count();
        self.placements.push(Placement {
            class,
            number: u32::try_from(earlier).unwrap() + 1,
            parent,
            side: if matches!(parent, Parent::Ceiling) { Side::Below } else { Side::Above },
            position,
            elevation: 0.0,
            angle: 0.0,
            variant: 0,
            size: self.catalog.classes[class].sizes[0],
        });
        self.placements.len() - 1
    }

    /// Adds a class to a group.
    pub(crate) fn group(&mut self, class: &str, group: &str) {
        let class = self.catalog.class_index(class).unwrap();
        let groups = &mut self.catalog.classes[class].groups;
        groups.push(group.into());
        groups.sort();
    }

    /// Sets the least share of the floor that the room's type asks to cover.
    pub(crate) fn set_density(&mut self, least: f64) {
        self.catalog.room_types.get_mut("office").unwrap().density.0 = least;
    }

    pub(crate) fn remove(&mut self, class: &str, is_required: bool) {
        let class = self.catalog.class_index(class).unwrap();
        self.removals.push(Removal { class, reason: RemovalReason::Collision, is_required });
    }

    /// Adds a line to the programme of the room's type.
    pub(crate) fn ask(&mut self, line: impl Fn(&Catalog) -> Request) {
        let line = line(&self.catalog);
        self.catalog.room_types.get_mut("office").unwrap().programme.push(line);
    }

    pub(crate) fn furnished(&self) -> Furnished {
        Furnished {
            room: 0,
            seed: 1,
            style: StyleRef::default(),
            requested: self.requested.unwrap_or(0),
            placements: self.placements.clone(),
            removals: self.removals.clone(),
        }
    }

    pub(crate) fn audit(&self) -> Vec<Finding> {
        self.judge().findings
    }

    pub(crate) fn judge(&self) -> Verdict {
        judge_room(self.level.room(0), &self.furnished(), &self.catalog)
    }

    pub(crate) fn count(&self, code: Code) -> usize {
        self.audit().iter().filter(|finding| finding.code == code).count()
    }
}

fn room(region: Region) -> Room {
    Room::bare("101", "office", region, 2.5, 0.1)
}

/// A required line for one piece of a class.
pub(crate) fn required(class: &'static str) -> impl Fn(&Catalog) -> Request {
    move |catalog| line(catalog, class, Count::Fixed(1))
}

/// A required line for pieces of a class by pieces of another.
pub(crate) fn per_piece(class: &'static str, of: &'static str, each: f64) -> impl Fn(&Catalog) -> Request {
    move |catalog| line(catalog, class, Count::PerPiece(catalog.class_index(of).unwrap(), each))
}

fn line(catalog: &Catalog, class: &str, count: Count) -> Request {
    let classes = vec![catalog.class_index(class).unwrap()];
    Request {
        classes,
        substitutes: Vec::new(),
        count,
        area: (0.0, 1000.0),
        is_required: true,
        chance: 1.0,
        needs_window: false,
        for_whom: crate::catalog::ForWhom::default(),
    }
}

fn catalog() -> Catalog {
    let mut desk = class("desk", 1.5, 0.75, 0.75, ParentName::Floor);
    desk.clearances.push(Clearance::SEAT);
    let mut table = class("table", 1.5, 0.75, 0.75, ParentName::Floor);
    table.shape = table_shape();
    let room_type = RoomType {
        id: "office".into(),
        label: "Office".into(),
        is_furnished: true,
        joins_levels: false,
        programme: Vec::new(),
        excludes: Vec::new(),
        area: (0.0, 1e6),
        plausible: crate::catalog::Plausible::default(),
        share: crate::catalog::Share::default(),
        density: (0.0, 1.0),
        finish: Finish {
            floor: Slot::Parquet,
            wall: Slot::Plaster,
            ceiling: Slot::Ceiling,
            dado: None,
            sockets: None,
            has_switches: false,
        },
    };
    let style = Style {
        id: "default".into(),
        label: "Plain".into(),
        room_types: Vec::new(),
        programmes: std::collections::BTreeMap::new(),
        additions: std::collections::BTreeMap::new(),
        geometry: GeometrySet::Plain,
        palette: PaletteRef::default(),
        untidiness: Untidiness::default(),
        density: 1.0,
        access: Access::default(),
        era: None,
        wealth: None,
    };
    Catalog {
        classes: vec![
            class("chest", 1.0, 1.0, 0.8, ParentName::Floor),
            desk,
            class("lamp", 0.2, 0.2, 0.3, ParentName::Ceiling),
            class("picture", 0.6, 0.05, 0.5, ParentName::Wall),
            class("stool", 0.4, 0.4, 0.45, ParentName::Floor),
            table,
        ],
        room_types: [("office".to_owned(), room_type)].into(),
        styles: [style].into_iter().collect(),
        ..Catalog::default()
    }
}

fn class(id: &str, width: f64, depth: f64, height: f64, parent: ParentName) -> Class {
    let rule = ParentRule {
        parent,
        sides: vec![Side::Above],
        tag: None,
        orientation: Orientation { turn: Turn::Parallel, jitter: 0.0 },
        along: Along::Random,
        gap: (0.0, 0.0),
        elevation: (0.0, 0.0),
        above_head: None,
    };
    Class {
        parents: vec![rule],
        ..Class::plain(id, vec![Size { width, depth, height }], find("cabinet").unwrap())
    }
}

/// A top of 4 cm on four legs of 5 cm at the corners.
fn table_shape() -> Shape {
    const LEG: f64 = 0.05;
    let low = |offset: f64| Extent { share: 0.0, offset };
    let high = |offset: f64| Extent { share: 1.0, offset };
    let leg_ends = |at_far_end: bool| if at_far_end { (high(-LEG), high(0.0)) } else { (low(0.0), low(LEG)) };
    let mut parts = vec![PrismRule {
        is_disc: false,
        low: [low(0.0), low(0.0), high(-0.04)],
        high: [high(0.0), high(0.0), high(0.0)],
    }];
    for (right, back) in [(false, false), (true, false), (false, true), (true, true)] {
        let ((x0, x1), (y0, y1)) = (leg_ends(right), leg_ends(back));
        parts.push(PrismRule { is_disc: false, low: [x0, y0, low(0.0)], high: [x1, y1, high(-0.04)] });
    }
    Shape::Prisms(parts)
}
