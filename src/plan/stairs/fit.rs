//! Finds the stairs that fit into rooms above each other: past their doors, with room to stand before the first step and after the
//! last.

use std::cell::OnceCell;

use super::form::{DESIGNS, Design, Form, Kind};
use super::landing::Floor;
use crate::geometry::{Convex, Point, Segment};
use crate::plan::{Level, OpeningKind, Room, RoomOpening};

/// Metres of floor before the first step and after the last.
const STAND: f64 = 0.8;
/// Metres of floor before doors that stay free, at least; a leaf that opens into the room takes its own width.
const DOOR: f64 = 0.8;
/// Metres by which bodies may lie in each other: rounding.
const TOLERANCE: f64 = 0.01;
/// Walls that stairs may be built against, in each of two directions.
const MOST_WALLS: usize = 8;
/// Metres of the shortest of these.
const SHORTEST_WALL: f64 = 0.5;
/// The sine of the angle below which walls run the same way.
const PARALLEL: f64 = 0.01;
/// The same for walls that stairs are built against: they touch a wall that is a little askew at one of its ends.
const NEARLY_PARALLEL: f64 = 0.07;
/// Metres behind stairs that a way along the far wall takes.
const WAY: f64 = 1.1;
/// Borders of a room and places tried in it, at most: a rectangle has some six thousand.
const MOST_BORDERS: usize = 200;
/// See [`MOST_BORDERS`].
const MOST_PLACES: usize = 20_000;
/// Metres before the first step to the wall, where nothing else says where stairs begin.
const LANDING: f64 = 1.5;
/// Metres within which an edge of stairs lies in a doorway.
const AT_DOOR: f64 = 0.15;
/// Metres that the two share at least.
const LEAST_WAY: f64 = 0.62;

/// A room that stairs go through, on one level.
pub(super) struct Storey<'l> {
    pub(super) room: &'l Room,
    /// Whether they go on up from here.
    pub(super) goes_up: bool,
    /// Whether they come up to here.
    pub(super) comes_up: bool,
    doors: Vec<Door>,
    /// Made when the first place is worth it.
    floor: OnceCell<Floor>,
}

/// Where people come in.
struct Door {
    stretch: Segment,
    /// The floor before it.
    zone: Convex,
    /// Where one stands before it.
    stand: Point,
    /// Whether a leaf opens into the room.
    opens_in: bool,
    /// Whether no wall at all is there.
    is_open: bool,
}

/// Where stairs stand in a level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    origin: Point,
    across: Point,
    width: f64,
    is_mirrored: bool,
}

/// Stairs at their place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fitted {
    pub(super) form: Form,
    pub(super) frame: Frame,
}

impl Frame {
    pub(super) fn point(&self, local: Point) -> Point {
        let x = if self.is_mirrored { self.width - local.x } else { local.x };
        self.origin + self.across * x + self.across.perp() * local.y
    }

    /// With the same side on its left.
    pub(super) fn segment(&self, local: Segment) -> Segment {
        let (start, end) = (self.point(local.start), self.point(local.end));
        if self.is_mirrored { Segment::new(end, start) } else { Segment::new(start, end) }
    }

    /// A counter-clockwise ring; its first edge stays the first.
    pub(super) fn ring(&self, local: &[Point]) -> Vec<Point> {
        let mut ring: Vec<Point> = local.iter().map(|&corner| self.point(corner)).collect();
        if self.is_mirrored {
            ring.reverse();
            ring.rotate_right(2);
        }
        ring
    }
}

impl<'l> Storey<'l> {
    pub(super) fn of(level: &'l Level, room: usize, comes_up: bool, goes_up: bool) -> Self {
        let room = &level.rooms[room];
        let walkable = room.openings.iter().filter(|at| level.openings[at.opening].kind.is_walkable());
        let door = |at: &RoomOpening| {
            let (wall, opening) = (&room.walls[at.wall], &level.openings[at.opening]);
            let stretch = wall.stretch(at.from, at.to);
            let leaf = opening.leaves_into(wall).map(|leaf| leaf.hinge.distance(leaf.open_tip));
            let leaf = leaf.fold(0.0, f64::max);
            let is_open = opening.kind == OpeningKind::OpenBoundary;
            let depth = if is_open { DOOR / 2.0 } else { DOOR.max(leaf) };
            let normal = wall.normal();
            let half = Point::new(stretch.length() / 2.0, depth / 2.0);
            let zone = Convex::rectangle(stretch.middle() + normal * half.y, half, wall.direction());
            Door {
                stretch,
                zone,
                stand: stretch.middle() + normal * (DOOR / 2.0),
                opens_in: leaf > 0.0,
                is_open,
            }
        };
        Self { room, goes_up, comes_up, doors: walkable.map(door).collect(), floor: OnceCell::new() }
    }

    /// Whether there is room for stairs, and before their ends.
    fn has_room_for(&self, fitted: &Fitted) -> bool {
        let bodies = fitted.boxes();
        self.is_clear_of_doors(fitted, &bodies)
            && bodies.iter().all(|body| self.is_clear(body))
            && fitted.ends(self).into_iter().all(|end| self.is_clear_before(fitted, end, &bodies))
    }

    /// Whether a body is in the room and in no obstacle.
    fn is_clear(&self, body: &Convex) -> bool {
        let is_inside = |&corner: &Point| {
            let inward = corner + (body.center() - corner).normalize_or_zero() * (2.0 * TOLERANCE);
            self.room.region.contains(inward)
        };
        body.corners().iter().all(is_inside)
            && !self.room.region.borders().any(|border| body.is_entered_by(border, TOLERANCE))
            && !self.room.obstacles.iter().any(|obstacle| {
                obstacle.outline.edges().any(|edge| body.is_entered_by(edge, TOLERANCE))
                    || obstacle.outline.contains(body.center())
            })
    }

    /// Whether one can stand before an end of the stairs, or in the doorway that it lies in.
    fn is_clear_before(&self, fitted: &Fitted, end: Segment, bodies: &[Convex]) -> bool {
        if self.is_in_doorway(fitted, end) {
            return true;
        }
        let zone = before(end);
        self.is_clear(&zone) && !bodies.iter().any(|body| body.overlaps(&zone, TOLERANCE))
    }

    fn is_in_doorway(&self, fitted: &Fitted, end: Segment) -> bool {
        self.doors.iter().any(|door| fitted.begins_at(door, end))
    }

    fn is_clear_of_doors(&self, fitted: &Fitted, bodies: &[Convex]) -> bool {
        let ends = fitted.ends(self);
        let all = fitted.form.approaches().map(|edge| fitted.frame.segment(edge));
        // One steps from a door onto the flight that begins or ends there, not between two of them.
        let is_between = |door: &Door, end: &Segment| {
            all.iter()
                .any(|other| other != end && door.shared(*other) > TOLERANCE && door.shared(*end) > TOLERANCE)
        };
        let is_way = |door: &Door| {
            ends.iter().any(|end| fitted.begins_at(door, *end) && (door.is_open || !is_between(door, end)))
        };
        let is_free = |door: &Door| !bodies.iter().any(|body| body.overlaps(&door.zone, TOLERANCE));
        self.doors.iter().all(|door| is_way(door) || is_free(door))
    }

    /// Whether one gets from each door to both ends of the stairs.
    fn is_joined(&self, fitted: &Fitted) -> bool {
        let ends = fitted.ends(self);
        let inner = ends.iter().filter(|end| !self.is_in_doorway(fitted, **end));
        let stands = inner.map(|end| end.middle() - end.normal() * (STAND / 2.0));
        let doors = self.doors.iter().filter(|door| !ends.iter().any(|end| fitted.begins_at(door, *end)));
        let places: Vec<Point> = stands.chain(doors.map(|door| door.stand)).collect();
        let bodies: Vec<Vec<Point>> = fitted.boxes().iter().map(|body| body.corners().to_vec()).collect();
        self.floor.get_or_init(|| Floor::of(self.room)).joins(&places, &bodies)
    }
}

impl Door {
    /// Whether an end of stairs lies in it: one steps from the doorway onto the first step.
    fn is_at(&self, end: Segment) -> bool {
        !self.opens_in && self.shared(end) >= LEAST_WAY
    }

    /// Metres of an end of stairs that lie in it.
    fn shared(&self, end: Segment) -> f64 {
        let along = self.stretch.direction();
        let is_beside = (end.middle() - self.stretch.start).perp_dot(along).abs() > AT_DOOR
            || end.direction().perp_dot(along).abs() > PARALLEL;
        if is_beside {
            return 0.0;
        }
        let [from, to] = [end.start, end.end].map(|at| (at - self.stretch.start).dot(along));
        from.max(to).min(self.stretch.length()) - from.min(to).max(0.0)
    }
}

/// The floor that one stands on before an edge that has the stairs on its left.
fn before(end: Segment) -> Convex {
    let half = Point::new(end.length() / 2.0, STAND / 2.0);
    Convex::rectangle(end.middle() - end.normal() * half.y, half, end.direction())
}

impl Fitted {
    fn boxes(&self) -> Vec<Convex> {
        let body = |[low, high]: [Point; 2]| {
            Convex::rectangle(self.frame.point((low + high) / 2.0), (high - low) / 2.0, self.frame.across)
        };
        self.form.boxes().into_iter().map(body).collect()
    }

    /// Whether one steps from a door onto the first step; spirals have a landing to stand on instead.
    fn begins_at(&self, door: &Door, end: Segment) -> bool {
        self.form.design.kind != Kind::Spiral && door.is_at(end)
    }

    /// The edges that one steps over on a storey.
    fn ends(&self, storey: &Storey<'_>) -> Vec<Segment> {
        let [foot, head] = self.form.approaches().map(|edge| self.frame.segment(edge));
        let wanted = [(storey.goes_up, foot), (storey.comes_up, head)];
        wanted.into_iter().filter(|(is_used, _)| *is_used).map(|(_, edge)| edge).collect()
    }
}

/// The first stairs that fit through all of some storeys, which rise by so many metres at most.
pub(super) fn fit(storeys: &[Storey<'_>], rise: f64) -> Option<Fitted> {
    if storeys.iter().any(|storey| storey.room.walls.len() > MOST_BORDERS) {
        return None;
    }
    let walls = Walls::of(storeys.first()?.room);
    let headings: Vec<Heading> = walls.headings();
    let places =
        DESIGNS.iter().flat_map(|design| headings.iter().flat_map(|heading| heading.places(design, rise)));
    // Ways take longest to find: they are looked for where there is room on all storeys.
    places.take(MOST_PLACES).find(|fitted| {
        storeys.iter().all(|storey| storey.has_room_for(fitted))
            && storeys.iter().all(|storey| storey.is_joined(fitted))
    })
}

/// The longer walls of a room, the longest first.
struct Walls<'r> {
    room: &'r Room,
    walls: Vec<Segment>,
}

/// A way that stairs may run, and the walls along and across it: metres along `across` and along its perpendicular.
struct Heading {
    across: Point,
    sides: Vec<f64>,
    ends: Vec<f64>,
    /// The room's extent along both axes.
    extent: [(f64, f64); 2],
}

impl<'r> Walls<'r> {
    fn of(room: &'r Room) -> Self {
        let mut walls: Vec<Segment> =
            room.region.borders().filter(|wall| wall.length() >= SHORTEST_WALL).collect();
        walls.sort_by(|one, other| other.length().total_cmp(&one.length()));
        Self { room, walls }
    }

    /// The four ways along the two longest walls that are not parallel; of skew rooms, eight.
    fn headings(&self) -> Vec<Heading> {
        let mut found: Vec<Point> = Vec::new();
        for direction in self.walls.iter().map(|wall| wall.direction()) {
            let is_new = |other: &Point| {
                direction.perp_dot(*other).abs() > PARALLEL && direction.dot(*other).abs() > PARALLEL
            };
            if found.len() < 2 && found.iter().all(is_new) {
                found.push(direction);
            }
        }
        let turned = |direction: Point| [direction, direction.perp(), -direction, -direction.perp()];
        found.into_iter().flat_map(turned).map(|across| self.heading(across)).collect()
    }

    fn heading(&self, across: Point) -> Heading {
        let places = |axis: Point| {
            let mut places: Vec<f64> = Vec::new();
            let along = |wall: &&Segment| wall.direction().dot(axis).abs() <= NEARLY_PARALLEL;
            for at in self.walls.iter().filter(along).flat_map(|wall| [wall.start, wall.end]) {
                let at = at.dot(axis);
                if places.iter().all(|other| (other - at).abs() > TOLERANCE) && places.len() < MOST_WALLS {
                    places.push(at);
                }
            }
            places
        };
        let extent = [across, across.perp()].map(|axis| {
            let along = self.room.region.outline.corners().iter().map(|corner| corner.dot(axis));
            along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
        });
        Heading { across, sides: places(across), ends: places(across.perp()), extent }
    }
}

impl Heading {
    /// The places of a design: between two walls or at one, with the back at a wall, or a way between.
    fn places(&self, design: &Design, rise: f64) -> impl Iterator<Item = Fitted> {
        let across = self.across;
        // The same seen in a mirror is the same.
        let hands: &[bool] = if design.kind == Kind::Straight { &[false] } else { &[false, true] };
        let lines = self.forms(design, rise).into_iter().flat_map(move |(form, left)| {
            self.starts(form.length).into_iter().map(move |from| (form, across * left + across.perp() * from))
        });
        lines.flat_map(move |(form, origin)| {
            let frame = move |&is_mirrored| Frame { origin, across, width: form.width, is_mirrored };
            hands.iter().map(move |hand| Fitted { form, frame: frame(hand) })
        })
    }

    /// The forms of a design, each with the metres along `across` where it begins.
    fn forms(&self, design: &Design, rise: f64) -> Vec<(Form, f64)> {
        let sides = || self.sides.iter().copied();
        let between = sides().flat_map(|left| {
            sides().filter_map(move |right| Some((design.across(right - left, rise)?, left)))
        });
        let usual = design.lanes.iter().filter_map(|&lane| design.form(lane, rise));
        let at_walls = usual.flat_map(|form| {
            sides().flat_map(move |side| [side, side - form.width].map(|left| (form, left)))
        });
        between.chain(at_walls).filter(|(form, left)| self.holds(0, *left, form.width)).collect()
    }

    /// Metres along the way up where stairs of a length may begin.
    fn starts(&self, length: f64) -> Vec<f64> {
        let starts = |&end: &f64| [end - length, end - WAY - length, end, end + WAY, end + LANDING];
        self.ends.iter().flat_map(starts).filter(|from| self.holds(1, *from, length)).collect()
    }

    fn holds(&self, axis: usize, from: f64, length: f64) -> bool {
        let (low, high) = self.extent[axis];
        from >= low - TOLERANCE && from + length <= high + TOLERANCE
    }
}
