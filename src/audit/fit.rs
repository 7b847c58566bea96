//! Whether an empty room could hold a piece: what separates a fault of the layout from a room too small.

use core::f64::consts::FRAC_PI_2;

use crate::catalog::{Class, ClassIndex, Clearance, ParentName, Side, Size};
use crate::geometry::{Point, Solid, bounds_overlap, direction, edges};
use crate::plan::{FRAME_DEPTH, FRAME_WIDTH, RoomOpening, Wall};

use super::convex::{clip_segment, middle, penetration};
use super::doors;
use super::subject::{Body, Subject};
use super::thresholds::{FIT_STEP, ROUNDING, SAME_DIRECTION};

/// Whether some size of a class, with its smallest clearances, fits somewhere on the empty floor: clear of
/// walls, columns and door zones, and with its back to a solid stretch of wall if it can stand in no other
/// way. Positions are tried every [`FIT_STEP`]; "no" may miss a fit without slack, "yes" never errs.
pub(crate) fn can_hold(subject: &Subject<'_>, class: ClassIndex) -> bool {
    let class = &subject.catalog.classes[class];
    let empty = Space::empty(subject);
    class.sizes.iter().any(|&size| empty.holds(class, size, |clearance| clearance.minimum))
}

/// The same for one body with its good clearances.
pub(crate) fn can_hold_comfortably(subject: &Subject<'_>, body: &Body<'_>) -> bool {
    Space::empty(subject).holds(body.class, body.placement.size, |clearance| clearance.good)
}

/// A rectangle on the floor.
#[derive(Clone, Copy)]
pub(super) struct Footprint {
    /// Counter-clockwise.
    pub(super) corners: [Point; 4],
    /// The box around them.
    pub(super) bounds: (Point, Point),
}

/// Where a piece may be tried.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    /// The middle of the piece.
    pub(super) position: Point,
    /// Its angle, as a placement's.
    pub(super) angle: f64,
    /// The wall that it has its back to, by index into the room's walls.
    pub(super) wall: Option<usize>,
}

/// A piece where it could stand.
pub(super) struct Stand {
    /// Where.
    pub(super) spot: Spot,
    /// Its footprint, then those of its clearances.
    pub(super) parts: Vec<Footprint>,
    /// The box around them.
    pub(super) bounds: (Point, Point),
}

impl Footprint {
    fn moved(&self, by: Point) -> Self {
        let (low, high) = self.bounds;
        Self { corners: self.corners.map(|corner| corner + by), bounds: (low + by, high + by) }
    }
}

/// What the frames of doors and passages take of the floor.
fn frames(subject: &Subject<'_>) -> impl Iterator<Item = Vec<Point>> {
    let kind = |place: &RoomOpening| subject.level.openings[place.opening].kind;
    subject.room.openings.iter().filter(move |place| kind(place).has_frame()).map(|place| {
        let wall = &subject.room.walls[place.wall];
        let at = |along: f64| wall.start + wall.direction() * along;
        let (start, end) = (at(place.from - FRAME_WIDTH), at(place.to + FRAME_WIDTH));
        let outward = wall.normal() * FRAME_DEPTH;
        vec![start, end, end + outward, start + outward]
    })
}

/// The box around corners.
fn bounds_of<'p>(corners: impl Iterator<Item = &'p Point>) -> (Point, Point) {
    corners.fold((Point::INFINITY, Point::NEG_INFINITY), |(low, high), &at| (low.min(at), high.max(at)))
}

/// Whether a body could stand, with its smallest clearances, among the others on one side of a line: to the
/// left of a direction from a point.
pub(crate) fn has_room_beside(subject: &Subject<'_>, body: &Body<'_>, line: (Point, Point)) -> bool {
    let among =
        subject.bodies.iter().filter(|other| other.low() < body.high() && !other.placement.is_covering());
    let bodies = among.flat_map(|other| &other.solids).collect();
    let space = Space { bodies, line: Some(line), ..Space::empty(subject) };
    space.holds(body.class, body.placement.size, |clearance| clearance.minimum)
}

/// Metres above the floor of the underside of a piece hung as low as its class allows.
fn lowest_underside(class: &Class) -> f64 {
    let on_parts = class.parents.iter().filter(|rule| !matches!(rule.parent, ParentName::Classes(_)));
    let lowest = on_parts.map(|rule| rule.elevation.0).fold(f64::INFINITY, f64::min);
    if lowest.is_finite() { lowest } else { 0.0 }
}

/// A box of a piece or its clearance in the class's frame: lowest and highest corner.
type LocalBox = (Point, Point);

/// The piece itself and its clearances.
fn needed_boxes(class: &Class, size: Size, depth_of: impl Fn(&Clearance) -> f64) -> Vec<LocalBox> {
    let half = Point::new(size.width, size.depth) / 2.0;
    let mut boxes = vec![(-half, half)];
    for clearance in &class.clearances {
        let (mut low, mut high, depth) = (-half, half, depth_of(clearance));
        match clearance.side {
            Side::Front => (low.y, high.y) = (-half.y - depth, -half.y),
            Side::Back => (low.y, high.y) = (half.y, half.y + depth),
            Side::Left => (low.x, high.x) = (-half.x - depth, -half.x),
            Side::Right => (low.x, high.x) = (half.x, half.x + depth),
            Side::Above | Side::Below => continue,
        }
        match clearance.side {
            Side::Front | Side::Back => {
                (low.x, high.x) = (low.x - clearance.margin, high.x + clearance.margin)
            }
            _ => (low.y, high.y) = (low.y - clearance.margin, high.y + clearance.margin),
        }
        boxes.push((low, high));
    }
    boxes.retain(|(low, high)| low.cmplt(*high).all());
    boxes
}

/// Where a piece may stand.
pub(super) struct Space<'s, 'a> {
    subject: &'s Subject<'a>,
    borders: Vec<(Point, Point)>,
    /// Corners of what no piece may stand in: the ways through the doors, and their frames.
    door_zones: Vec<Vec<Point>>,
    /// Bodies whose footprints the piece and its clearances keep clear of.
    bodies: Vec<&'s Solid>,
    /// The piece stays to the left of this line: a point and a direction.
    line: Option<(Point, Point)>,
}

impl<'s, 'a> Space<'s, 'a> {
    /// The room without furniture.
    pub(super) fn empty(subject: &'s Subject<'a>) -> Self {
        let columns = subject.room.obstacles.iter().flat_map(|column| column.outline.edges());
        let borders = subject.room.region.borders().chain(columns).collect();
        let passages = doors::zones(subject).into_iter().map(|zone| zone.base);
        let door_zones = passages.chain(frames(subject)).collect();
        Self { subject, borders, door_zones, bodies: Vec::new(), line: None }
    }

    fn holds(&self, class: &Class, size: Size, depth_of: impl Fn(&Clearance) -> f64) -> bool {
        let boxes = needed_boxes(class, size, depth_of);
        let mut stands = self.stands(class, size);
        let mut turned = Turned::new(&boxes);
        lowest_underside(class) + size.height <= self.subject.room.height
            && stands.any(|spot| self.is_free(turned.to(spot.angle), spot.position))
    }

    /// Where a piece may be tried: along the walls, and all over the floor unless it needs a wall.
    fn stands(&self, class: &Class, size: Size) -> impl Iterator<Item = Spot> + '_ {
        let hangs = |wanted: &ParentName| class.parents.iter().any(|rule| rule.parent == *wanted);
        let needs_wall = hangs(&ParentName::Wall) && !hangs(&ParentName::Floor);
        let walls = self.subject.room.walls.iter().enumerate().filter(|(_, wall)| wall.length() > ROUNDING);
        let directions = if needs_wall { Vec::new() } else { self.directions() };
        walls
            .flat_map(move |wall| self.stands_at_wall(size, wall))
            .chain(directions.into_iter().flat_map(|angle| self.stands_inside(angle)))
    }

    /// All free places for a size of a class with its smallest clearances, those along the walls first.
    pub(super) fn free_stands(&self, class: &Class, size: Size) -> Vec<Stand> {
        let boxes = needed_boxes(class, size, |clearance| clearance.minimum);
        let mut turned = Turned::new(&boxes);
        let stand = |spot: Spot| {
            let parts = turned.to(spot.angle);
            self.is_free(parts, spot.position).then(|| {
                let parts: Vec<Footprint> = parts.iter().map(|part| part.moved(spot.position)).collect();
                Stand { spot, bounds: bounds_of(parts.iter().flat_map(|part| &part.corners)), parts }
            })
        };
        self.stands(class, size).filter_map(stand).collect()
    }

    /// The directions of the walls that are no quarter turns of each other, nearly parallel ones once.
    fn directions(&self) -> Vec<f64> {
        let mut directions: Vec<Point> = Vec::new();
        for wall in self.subject.room.walls.iter().filter(|wall| wall.length() > ROUNDING) {
            let along = wall.direction();
            let is_known =
                |known: &Point| known.perp_dot(along).abs().min(known.dot(along).abs()) < SAME_DIRECTION;
            if !directions.iter().any(is_known) {
                directions.push(along);
            }
        }
        directions.into_iter().map(|along| libm::atan2(along.y, along.x)).collect()
    }

    /// Along a wall, the back of the piece to it, before solid wall.
    fn stands_at_wall(
        &self,
        size: Size,
        (number, wall): (usize, &'a Wall),
    ) -> impl Iterator<Item = Spot> + '_ {
        let angle = libm::atan2(wall.direction().y, wall.direction().x) + core::f64::consts::PI;
        let off_wall = wall.normal() * (size.depth / 2.0 + ROUNDING);
        let is_solid = move |&along: &f64| {
            let mut here = self.subject.room.openings.iter().filter(|place| place.wall == number);
            let (from, to) = (along - size.width / 2.0, along + size.width / 2.0);
            !here.any(|place| {
                let is_framed = self.subject.level.openings[place.opening].kind.has_frame();
                let frame = if is_framed { FRAME_WIDTH } else { 0.0 };
                place.from - frame < to && from < place.to + frame
            })
        };
        steps(size.width / 2.0 + ROUNDING, wall.length() - size.width / 2.0)
            .filter(is_solid)
            .map(move |along| wall.start + wall.direction() * along + off_wall)
            .map(move |position| Spot { position, angle, wall: Some(number) })
    }

    /// Anywhere, at an angle and its quarter turns.
    fn stands_inside(&self, first: f64) -> impl Iterator<Item = Spot> + '_ {
        let (low, high) = self.subject.room.region.outline.bounds();
        let turns = (0..4).map(move |quarter| first + FRAC_PI_2 * f64::from(quarter));
        turns.flat_map(move |angle| {
            steps(low.x, high.x)
                .flat_map(move |x| steps(low.y, high.y).map(move |y| Point::new(x, y)))
                .map(move |position| Spot { position, angle, wall: None })
        })
    }

    fn is_free(&self, parts: &[Footprint], position: Point) -> bool {
        // The middle decides most positions; the rest is asked only where it is inside.
        !self.crosses_line(&[position])
            && self.subject.room.region.contains(position)
            && parts.iter().enumerate().all(|(number, part)| {
                let footprint = part.moved(position);
                let is_body = number == 0;
                self.is_clear(&footprint)
                    && self.is_inside(&footprint)
                    && !(is_body && (self.blocks_a_door(&footprint) || self.crosses_line(&footprint.corners)))
            })
    }

    fn is_inside(&self, footprint: &Footprint) -> bool {
        let in_column =
            |point: Point| self.subject.room.obstacles.iter().any(|column| column.outline.contains(point));
        // A corner may lie on a border, where it is neither in nor out.
        let middle = middle(&footprint.corners);
        self.subject.room.region.contains(middle) && !in_column(middle) && !self.is_crossed(footprint)
    }

    /// Whether a border runs through a footprint. Nearly all borders are far away, which their boxes tell.
    fn is_crossed(&self, footprint: &Footprint) -> bool {
        let is_near =
            |(a, b): (Point, Point)| bounds_overlap((a.min(b), a.max(b)), footprint.bounds, -ROUNDING);
        let crosses = |border| clip_segment(&footprint.corners, border, ROUNDING / 2.0).is_some();
        self.borders.iter().any(|&border| is_near(border) && crosses(border))
    }

    fn is_clear(&self, footprint: &Footprint) -> bool {
        let meets = |body: &&Solid| {
            bounds_overlap(body.bounds, footprint.bounds, 0.0)
                && penetration(body.footprint(), &footprint.corners) > 0.0
        };
        !self.bodies.iter().any(meets)
    }

    fn crosses_line(&self, corners: &[Point]) -> bool {
        let is_right =
            |(from, along): (Point, Point)| corners.iter().any(|&corner| along.perp_dot(corner - from) < 0.0);
        self.line.is_some_and(is_right)
    }

    fn blocks_a_door(&self, footprint: &Footprint) -> bool {
        self.door_zones.iter().any(|zone| penetration(zone, &footprint.corners) > 0.0)
    }
}

/// The boxes of a piece turned to an angle, around its middle. Places come in long runs of one angle.
struct Turned<'b> {
    boxes: &'b [LocalBox],
    angle: f64,
    parts: Vec<Footprint>,
}

impl<'b> Turned<'b> {
    fn new(boxes: &'b [LocalBox]) -> Self {
        Self { boxes, angle: f64::NAN, parts: Vec::new() }
    }

    fn to(&mut self, angle: f64) -> &[Footprint] {
        if self.angle.to_bits() != angle.to_bits() {
            self.angle = angle;
            self.parts = self.boxes.iter().map(|&local| turned(local, direction(angle))).collect();
        }
        &self.parts
    }
}

fn turned((low, high): LocalBox, turn: Point) -> Footprint {
    let corners =
        [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)].map(|corner| turn.rotate(corner));
    debug_assert!(edges(&corners).count() == 4, "empty boxes were dropped");
    Footprint { corners, bounds: bounds_of(corners.iter()) }
}

/// `from`, then on by [`FIT_STEP`] up to `to`.
fn steps(from: f64, to: f64) -> impl Iterator<Item = f64> {
    let mut number = 0_u32;
    core::iter::from_fn(move || {
        let value = from + f64::from(number) * FIT_STEP;
        number += 1;
        (value <= to).then_some(value)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::testing::{TestRoom, at};
    use crate::geometry::Polygon;
    use crate::plan::{Obstacle, OpeningKind};

    fn holds(room: &TestRoom, class: &str) -> bool {
        let furnished = room.furnished();
        let subject = Subject::new(&room.level, 0, &furnished, &room.catalog);
        can_hold(&subject, room.catalog.class_index(class).unwrap())
    }

    #[test]
    fn a_chest_needs_its_own_size() {
        assert!(holds(&TestRoom::rectangle(1.01, 1.01), "chest"));
        assert!(!holds(&TestRoom::rectangle(0.99, 3.0), "chest"));
    }

    #[test]
    fn a_desk_needs_its_clearance_too() {
        assert!(holds(&TestRoom::rectangle(1.52, 1.52), "desk"));
        assert!(!holds(&TestRoom::rectangle(1.45, 1.45), "desk"));
    }

    #[test]
    fn a_clearance_wholly_behind_a_wall_is_not_in_the_room() {
        let mut room = TestRoom::rectangle(1.6, 2.0);
        let chest = room.catalog.class_index("chest").unwrap();
        let desk = room.catalog.class_index("desk").unwrap();
        let beside = room.catalog.classes[desk].clearances[0];
        for side in [Side::Left, Side::Right, Side::Front, Side::Back] {
            room.catalog.classes[chest].clearances.push(Clearance { side, minimum: 0.31, ..beside });
        }
        assert!(!holds(&room, "chest"));
        let mut wide = TestRoom::rectangle(1.7, 2.0);
        wide.catalog = room.catalog;
        assert!(holds(&wide, "chest"));
    }

    #[test]
    fn a_door_or_a_column_takes_the_room() {
        let mut room = TestRoom::rectangle(1.6, 1.1);
        assert!(holds(&room, "chest"));
        room.open(0, OpeningKind::Passage, (0.4, 1.2), (0.0, 2.0));
        assert!(!holds(&room, "chest"));
        let mut room = TestRoom::rectangle(1.6, 1.1);
        let outline = Polygon::rectangle(at(0.7, 0.4), at(0.2, 0.2));
        room.level.rooms[0].obstacles.push(Obstacle { outline, height: 2.5 });
        assert!(!holds(&room, "chest"));
    }

    #[test]
    fn the_frame_of_a_door_takes_a_little_of_the_walls_beside_it() {
        let beside_door = |depth: f64| {
            let mut room = TestRoom::rectangle(1.01, depth);
            room.open(1, OpeningKind::Passage, (0.1, 0.9), (0.0, 2.0));
            room
        };
        assert!(holds(&beside_door(0.9 + FRAME_WIDTH + 1.01), "chest"));
        assert!(!holds(&beside_door(0.9 + 1.01), "chest"));
    }

    #[test]
    fn a_picture_needs_a_wall_beside_the_window() {
        let mut room = TestRoom::rectangle(3.0, 3.0);
        assert!(holds(&room, "picture"));
        let picture = room.catalog.class_index("picture").unwrap();
        room.catalog.classes[picture].parents[0].elevation = (2.1, 2.2);
        assert!(!holds(&room, "picture"), "half a metre under the ceiling at 2.5 m is too little");
        room.catalog.classes[picture].parents[0].elevation = (1.2, 2.2);
        assert!(holds(&room, "picture"));
        for wall in 0..4 {
            room.open(wall, OpeningKind::Window, (0.2, 2.8), (0.9, 2.2));
        }
        assert!(!holds(&room, "picture"));
    }

    #[test]
    fn a_slanted_room_is_tried_along_its_own_walls() {
        let turn = direction(0.5);
        let corners = [(0.0, 0.0), (1.02, 0.0), (1.02, 1.02), (0.0, 1.02)]
            .map(|(x, y)| turn.rotate(Point::new(x, y)))
            .map(|corner| (corner.x, corner.y));
        assert!(holds(&TestRoom::outline(&corners), "chest"));
    }
}
