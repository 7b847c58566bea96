//! How many of the wishes of the classes about others are met; a term of the score, no finding.
//!
//! The audit's own statement of what `relations` in `configs/classes/` mean. Distances are between the middles,
//! less half of the smaller side of each. Of a class with many objects the nearest ([`super::near`]) are asked.

use std::collections::BTreeSet;

use super::checks::{is_before, swings};
use super::mean::weighted_mean;
use super::subject::{Body, Subject};
use super::zone::{NearPair, Purpose};
use crate::catalog::{ParentName, Relation, RelationKind};
use crate::geometry::{Point, distance_of_convex};
use crate::plan::{OpeningKind, RoomRef};

/// Metres outside the good distances, or radians off the good angle, over which a wish fades to unmet.
const FADE: f64 = 1.0;

/// The share that is met, by weight; `None` where nobody wishes for anything that is there.
pub(crate) fn met(subject: &Subject<'_>, hits: &[NearPair<'_>]) -> Option<f64> {
    let wishing = |(_, body): &(usize, &Body<'_>)| !body.class.relations.is_empty();
    let mut wishing = subject.bodies.iter().enumerate().filter(wishing).peekable();
    wishing.peek()?;
    let known = Known::new(subject, hits);
    weighted_mean(wishing.flat_map(|(index, body)| {
        let known = &known;
        let relations = body.class.relations.iter();
        relations.filter_map(move |relation| Some((known.met(index, relation)?, relation.weight)))
    }))
}

/// The target of a wish: a point, the direction it faces, and half of its smaller side.
#[derive(Clone, Copy)]
struct Target {
    position: Point,
    front: Point,
    radius: f64,
}

impl Target {
    fn of_body(body: &Body<'_>) -> Self {
        let size = body.placement.size;
        Self {
            position: body.placement.position,
            front: body.front(),
            radius: size.width.min(size.depth) / 2.0,
        }
    }
}

/// The room as wishes see it.
struct Known<'s, 'a> {
    subject: &'s Subject<'a>,
    /// Indices of the bodies that take the light of a window.
    before_windows: BTreeSet<usize>,
    /// Where the leaves of the room's doors swing.
    swings: Vec<Vec<Point>>,
}

impl<'s, 'a> Known<'s, 'a> {
    fn new(subject: &'s Subject<'a>, hits: &[NearPair<'_>]) -> Self {
        let lit = hits.iter().filter(|(zone, _)| matches!(zone.purpose, Purpose::Light(_)));
        let before = lit.filter(|(zone, body)| is_before(subject, zone, &subject.bodies[*body]));
        let swings = swings(subject.at, subject.rules().doors).collect();
        Self { subject, before_windows: before.map(|&(_, body)| body).collect(), swings }
    }

    /// How far a body keeps away from where leaves swing, from 0 to 1; `None` where none swings into the room.
    fn clear_of_swings(&self, index: usize, least: f64) -> Option<f64> {
        let solids = self.subject.bodies[index].solids.iter();
        let distances = solids
            .flat_map(|solid| self.swings.iter().map(|swing| distance_of_convex(solid.footprint(), swing)));
        distances.reduce(f64::min).map(|distance| (1.0 - (least - distance) / least).clamp(0.0, 1.0))
    }

    /// How far a wish of a body is met, from 0 to 1; `None` where what it is about is not there.
    fn met(&self, index: usize, relation: &Relation) -> Option<f64> {
        if relation.kind == RelationKind::ClearOf {
            return self.clear_of_swings(index, relation.distance.0);
        }
        let own = Target::of_body(&self.subject.bodies[index]);
        let (mut least, mut most) = (None, None);
        self.each_target(index, &relation.target, own.position, |thing| {
            let value = value(relation, own, thing);
            least = Some(least.map_or(value, |least: f64| least.min(value)));
            most = Some(most.map_or(value, |most: f64| most.max(value)));
        });
        match relation.kind {
            RelationKind::NotBefore => {
                most.map(|_| f64::from(u8::from(!self.before_windows.contains(&index))))
            }
            // Away from all of them: the nearest decides. Of the others the one that suits best does.
            RelationKind::AwayFrom => least,
            _ => most,
        }
    }

    /// Calls `visit` with all that a name means, but for the body itself.
    fn each_target(&self, own: usize, name: &ParentName, position: Point, mut visit: impl FnMut(Target)) {
        let Subject { at: RoomRef { level, room, .. }, bodies, .. } = self.subject;
        let fixed = |position, front| Target { position, front, radius: 0.0 };
        match name {
            ParentName::Classes(classes) => {
                for &class in classes {
                    let others = self.subject.nearest_of(class, position);
                    let others = others.iter().filter(|&&index| index != own);
                    others.for_each(|&index| visit(Target::of_body(&bodies[index])));
                }
            }
            ParentName::Window | ParentName::Door => {
                for place in &room.openings {
                    let is_window = level.openings[place.opening].kind == OpeningKind::Window;
                    if is_window == (*name == ParentName::Window) {
                        let wall = &room.walls[place.wall];
                        let middle = wall.after(f64::midpoint(place.from, place.to));
                        visit(fixed(middle, wall.normal()));
                    }
                }
            }
            ParentName::Wall => {
                let faces = room.walls.iter();
                faces.for_each(|wall| {
                    visit(fixed(wall.segment().nearest(position), wall.normal()));
                });
            }
            ParentName::Column => {
                let middles = room.obstacles.iter().map(|column| column.outline.bounds().center());
                middles.for_each(|middle| visit(fixed(middle, Point::NEG_Y)));
            }
            ParentName::Floor | ParentName::Ceiling => {}
        }
    }
}

/// How far a wish about one thing is met.
fn value(relation: &Relation, own: Target, other: Target) -> f64 {
    let between = other.position - own.position;
    let distance = (between.length() - own.radius - other.radius).max(0.0);
    // What stands at the same place (a lamp on its table) counts as straight ahead.
    let towards = between.normalize_or(own.front);
    let (least, most) = relation.distance;
    let fade = |off: f64| (1.0 - off.max(0.0) / FADE).max(0.0);
    // Linear from met at the ends of the range to unmet FADE beyond them.
    let within = |distance: f64| fade((least - distance).max(distance - most));
    let faces = |front: Point, direction: Point| fade(front.angle_to(direction).abs() - relation.angle);
    match relation.kind {
        RelationKind::Near | RelationKind::Beside => within(distance),
        // Nothing is too far away from what one wants to be away from: the upper end does not count.
        RelationKind::AwayFrom => fade(least - distance),
        RelationKind::Faces | RelationKind::Sees => faces(own.front, towards) * within(distance),
        RelationKind::Opposite => faces(own.front, towards) * faces(other.front, -towards) * within(distance),
        RelationKind::AlignedWith => {
            within(between.dot(own.front).abs().min(between.perp_dot(own.front).abs()))
        }
        // Asked of the room as a whole.
        RelationKind::NotBefore | RelationKind::ClearOf => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::audit::testing::{TestRoom, at};
    use crate::catalog::{ParentName, Relation, RelationKind};
    use crate::geometry::Point;
    use crate::plan::{Leaf, OpeningKind};

    /// A room whose stool (radius 0.2) wishes something of desks (radius 0.375), in metres.
    fn room(kind: RelationKind, distance: (f64, f64)) -> TestRoom {
        let mut room = TestRoom::rectangle(8.0, 6.0);
        let desk = ParentName::Classes(vec![room.catalog.class_index("desk").unwrap()]);
        wish(&mut room, kind, desk, distance);
        room.stand("stool", at(4.0, 1.0));
        room.requested = Some(2);
        room
    }

    fn wish(room: &mut TestRoom, kind: RelationKind, target: ParentName, distance: (f64, f64)) {
        let stool = room.catalog.class_index("stool").unwrap();
        let relation = Relation { kind, target, distance, angle: 0.5, weight: 1.0, is_needed: false };
        room.catalog.classes[stool].relations.push(relation);
    }

    fn met(room: &TestRoom) -> Option<f64> {
        room.judge().score.unwrap().relations
    }

    /// With a desk whose edge is `gap` metres north of the stool.
    fn with_desk(mut room: TestRoom, gap: f64) -> TestRoom {
        room.stand("desk", at(4.0, 1.575 + gap));
        room
    }

    fn is_near(value: Option<f64>, expected: f64) -> bool {
        value.is_some_and(|value| (value - expected).abs() < 1e-9)
    }

    #[test]
    fn a_wish_about_nothing_that_is_there_is_left_out() {
        let room = room(RelationKind::Near, (0.0, 1.0));
        assert_eq!(met(&room), None);
        assert!(is_near(met(&with_desk(room, 0.5)), 1.0));
    }

    #[test]
    fn near_and_away_from_fade_over_a_metre() {
        let near = |gap| met(&with_desk(room(RelationKind::Near, (0.0, 1.0)), gap));
        assert!(is_near(near(0.9), 1.0) && is_near(near(1.3), 0.7) && is_near(near(3.0), 0.0));
        let away = |gap| met(&with_desk(room(RelationKind::AwayFrom, (2.0, 100.0)), gap));
        assert!(is_near(away(2.1), 1.0) && is_near(away(1.3), 0.3) && is_near(away(0.5), 0.0));
    }

    #[test]
    fn who_is_to_be_clear_of_doors_is_measured_from_where_the_leaf_swings() {
        let clear = |x: f64| {
            let mut room = TestRoom::rectangle(8.0, 6.0);
            room.open(0, OpeningKind::Door, (2.0, 2.9), (0.0, 2.0));
            let hinge = Point::new(2.0, 0.0);
            let leaf = Leaf { hinge, closed_tip: hinge + 0.9 * Point::X, open_tip: hinge + 0.9 * Point::Y };
            room.level.openings[0].leaves = vec![leaf];
            wish(&mut room, RelationKind::ClearOf, ParentName::Door, (1.0, 100.0));
            room.stand("stool", at(x, 0.3));
            room.requested = Some(1);
            met(&room)
        };
        assert!(is_near(clear(5.0), 1.0));
        let beside = clear(3.5).unwrap();
        assert!(beside > 0.3 && beside < 0.7, "0.4 m to the arc: {beside}");
    }

    #[test]
    fn the_nearest_desk_is_enough_and_every_desk_is_to_be_kept_away_from() {
        let two = |kind, distance| {
            let mut room = with_desk(room(kind, distance), 0.5);
            room.stand("desk", at(4.0, 5.5));
            met(&room)
        };
        assert!(is_near(two(RelationKind::Near, (0.0, 1.0)), 1.0));
        assert!(is_near(two(RelationKind::AwayFrom, (1.0, 100.0)), 0.5));
    }

    #[test]
    fn to_face_asks_for_the_own_front_and_to_stand_opposite_for_both() {
        let turned = |kind, stool: f64, desk: f64| {
            let mut room = with_desk(room(kind, (0.0, 3.0)), 1.0);
            room.placements[0].angle = stool;
            room.placements[1].angle = desk;
            met(&room)
        };
        assert!(is_near(turned(RelationKind::Faces, PI, PI), 1.0));
        assert!(is_near(turned(RelationKind::Faces, PI - 0.75, PI), 0.75), "a quarter radian too far");
        assert!(is_near(turned(RelationKind::Faces, 0.0, 0.0), 0.0));
        assert!(is_near(turned(RelationKind::Opposite, PI, 0.0), 1.0));
        assert!(is_near(turned(RelationKind::Opposite, PI, PI), 0.0));
    }

    #[test]
    fn what_takes_a_windows_light_stands_before_it() {
        let tall_stool_at = |y: f64| {
            let mut room = TestRoom::rectangle(4.0, 4.0);
            room.open(0, OpeningKind::Window, (1.0, 3.0), (0.8, 2.0));
            wish(&mut room, RelationKind::NotBefore, ParentName::Window, (0.0, 1.0));
            room.stand("stool", at(2.0, y));
            room.placements[0].size.height = 1.8;
            room.requested = Some(1);
            met(&room)
        };
        assert!(is_near(tall_stool_at(0.3), 0.0));
        assert!(is_near(tall_stool_at(0.8), 1.0));
    }

    #[test]
    fn on_one_line_with_a_desk() {
        let beside = |offset: f64| {
            let mut room = room(RelationKind::AlignedWith, (0.0, 0.1));
            room.stand("desk", at(6.5, 1.0 + offset));
            met(&room)
        };
        assert!(is_near(beside(0.1), 1.0));
        assert!(is_near(beside(0.6), 0.5));
    }
}
