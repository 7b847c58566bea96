//! Wishes about objects that are not the parent (beyond the paper, its section 6.1).

use std::f64::consts::FRAC_PI_2;

use crate::catalog::{ParentName, Relation, RelationKind, Side, WallWishes};
use crate::geometry::Point;
use crate::layout::body::{Pose, box_solid};
use crate::layout::constants::{
    BUILT_IN_REWARD, CONTACT_TOLERANCE, LIGHT_GROUPS, LONG_PIECE, RUN_LENGTH, SEAT_IN_WAY_PENALTY,
    SEAT_PENALTY, TIGHT_PENALTY, WINDOW_PENALTY,
};
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, ParentPart, Place};
use crate::plan::OpeningKind;

use super::corner::corner_points;
use super::sight::is_in_sight;
use super::swing::clearness;

/// Radians beyond the good angle over which a wish about direction fades to nothing.
const ANGLE_FADE: f64 = 1.0;
/// Metres beyond the good distance over which a wish about distance fades to half.
const DISTANCE_FADE: f64 = 1.0;
/// Metres of a wall from which on a longer one is liked no more.
const LONG_WALL: f64 = 4.0;

/// How well a place suits an agent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Score {
    /// More is better, zero is indifferent.
    pub(crate) value: f64,
    /// Whether it darkens a window, is at a door's swing, has seats in ways or takes the place of one: the agent looks further.
    pub(crate) is_spoilt: bool,
    /// Whether somebody has less room than is good because of it.
    pub(crate) is_tight: bool,
}

impl Score {
    /// Whether the agent looks for a better place.
    pub(crate) fn is_poor(self) -> bool {
        self.is_spoilt || self.is_tight
    }
}

/// How well a place suits an agent.
pub(crate) fn score(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> Score {
    let mut value = 0.0;
    let (is_spoilt, is_tight) = weigh(environment, agent, place, |_, points| value += points);
    Score { value, is_spoilt, is_tight }
}

/// A reason for or against a place.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Factor<'a> {
    /// A wish of the class.
    Wish(&'a Relation),
    /// It darkens a window.
    BeforeWindow,
    /// It likes its wall, or would rather not stand there.
    Wall,
    /// Its length fills its wall, or the wall holds a run of its kind.
    SuitsWall,
    /// It takes the place of a seat, or leaves none for its own.
    TakesSeat,
    /// A seat of its own would stand in a door's way.
    SeatsInWays,
    /// It takes of the space that is good for others, or has less than is good itself.
    Tight { takes: bool, lacks: bool },
}

/// Calls `visit` with what counts for or against a place and its points, and answers whether the place is spoilt and whether
/// it is tight. The sum of the points is the score.
pub(crate) fn weigh<'a>(
    environment: &Environment<'a>,
    agent: AgentIndex,
    place: &Place,
    mut visit: impl FnMut(Factor<'a>, f64),
) -> (bool, bool) {
    let class = environment.class(agent);
    let is_before_window = stands_before_window(environment, agent, place);
    let mut is_at_swing = false;
    for relation in &class.relations {
        let value = match relation.kind {
            // All or nothing: a body is in the light or it is not.
            RelationKind::NotBefore => f64::from(u8::from(!is_before_window)),
            RelationKind::ClearOf => {
                let clear = clearness(environment, agent, place, relation.distance.0);
                // What nobody misses is not refused for it, as it is where it darkens a window.
                is_at_swing |= clear < 1.0 && environment.agents[agent].piece.is_required;
                clear
            }
            _ => fulfilment(environment, agent, place, relation),
        };
        visit(Factor::Wish(relation), relation.weight * value);
    }
    if is_before_window {
        visit(Factor::BeforeWindow, -WINDOW_PENALTY);
    }
    let likes = liking(environment, agent, place);
    if likes != 0.0 {
        visit(Factor::Wall, likes);
    }
    let suits = suits_wall(environment, agent, place);
    if suits > 0.0 {
        visit(Factor::SuitsWall, BUILT_IN_REWARD * suits);
    }
    // As with swings: what nobody misses is not refused for it. A room that does not come out well that way is tried without.
    let has_seats_in_ways = environment.heeds_tags
        && environment.agents[agent].piece.is_required
        && environment.has_seats_in_ways(agent, place);
    if has_seats_in_ways {
        visit(Factor::SeatsInWays, -SEAT_IN_WAY_PENALTY);
    }
    let takes_a_seat = environment.takes_a_seat(agent, place);
    if takes_a_seat {
        visit(Factor::TakesSeat, -SEAT_PENALTY);
    }
    let (takes, lacks) =
        (environment.takes_comfort(agent, place, &mut ()), environment.lacks_comfort(agent, place));
    if takes || lacks {
        // Points for each of the two, not for each object that is concerned: a row of chairs does not count five times.
        visit(Factor::Tight { takes, lacks }, -TIGHT_PENALTY * f64::from(u8::from(takes) + u8::from(lacks)));
    }
    (is_before_window || is_at_swing || has_seats_in_ways || takes_a_seat, takes || lacks)
}

/// The points of the wall that a place is at.
fn liking(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> f64 {
    let (ParentPart::Wall(index), WallWishes { tags, with, metre, .. }) =
        (place.parent, &environment.class(agent).walls)
    else {
        return 0.0;
    };
    let wall = &environment.brief.surroundings.room.walls[index];
    let of_tags = tags.iter().filter(|(tag, _)| wall.tags.contains(tag)).map(|(_, points)| points);
    let is_here = |other: AgentIndex| {
        environment.agents[other].rest().is_some_and(|rest| rest.parent == ParentPart::Wall(index))
    };
    // Once for each line, however many pieces of it stand there.
    let of_others = with.iter().filter(|(classes, _)| environment.resting_of(classes).any(is_here));
    of_tags.sum::<f64>()
        + corner_points(environment, agent, place)
        + of_others.map(|(_, points)| points).sum::<f64>()
        + metre * wall.length().min(LONG_WALL)
}

/// How well a wall suits a built-in piece: a bathtub belongs where its length fills the niche, the first unit of a
/// run where the wall is long enough for the others.
fn suits_wall(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> f64 {
    let ParentPart::Wall(wall) = place.parent else { return 0.0 };
    let (class, size) = (environment.class(agent), environment.agents[agent].size);
    if !environment.is_built_in(agent) {
        return 0.0;
    }
    let length = environment.brief.surroundings.room.walls[wall].length();
    let joins = [Side::Left, Side::Right].iter().any(|&side| class.offer(side).places > 0);
    if joins {
        // In proportion up to RUN_LENGTH: a longer wall holds the run no better.
        (length / RUN_LENGTH).min(1.0)
    } else if size.width >= LONG_PIECE * size.depth {
        // 1 where it fills the wall, 0 where it takes half of it or less.
        (2.0 * size.width / length - 1.0).clamp(0.0, 1.0)
    } else {
        0.0
    }
}

/// Whether a place meets the relations that an agent's class needs.
pub(crate) fn meets_needs(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    unmet_need(environment, agent, place).is_none()
}

/// The first relation that an agent's class needs and a place does not meet, by index. To face something, it must
/// be there.
pub(crate) fn unmet_need(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> Option<usize> {
    let is_met = |relation: &Relation| match relation.kind {
        RelationKind::NotBefore => !stands_before_window(environment, agent, place),
        RelationKind::ClearOf => clearness(environment, agent, place, relation.distance.0) >= 1.0,
        RelationKind::AwayFrom => {
            let own = Target::own(environment, agent, place);
            // From all of them, while one is enough to be near to.
            targets(environment, &relation.target).all(|target| way_to(own, target).0 >= relation.distance.0)
        }
        _ => {
            let own = Target::own(environment, agent, place);
            // Met in full: inside the range of distance and of angle, without the fade that a mere wish has.
            targets(environment, &relation.target).any(|target| {
                value(relation, own, target) >= 1.0 && is_seen(environment, relation, own, target)
            })
        }
    };
    let relations = &environment.class(agent).relations;
    relations.iter().position(|relation| relation.is_needed && !is_met(relation))
}

/// The thing that decides about a wish, and where it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measured {
    /// Its position among the things of the wish: of resting agents, that of [`Environment::resting_of`].
    pub(crate) index: usize,
    /// Metres between the two.
    pub(crate) distance: f64,
    /// Radians between the front and the direction to it.
    pub(crate) angle: f64,
    /// How well the wish is met, 0 to 1.
    pub(crate) value: f64,
}

/// The values that decide about a wish at a place; none where the room has no target for it.
pub(crate) fn measure(
    environment: &Environment<'_>,
    agent: AgentIndex,
    place: &Place,
    relation: &Relation,
) -> Option<Measured> {
    let own = Target::own(environment, agent, place);
    let measured = targets(environment, &relation.target).enumerate().map(|(index, other)| {
        let (distance, towards) = way_to(own, other);
        let angle = libm::acos(own.front.dot(towards).clamp(-1.0, 1.0));
        let value = value_in(environment, relation, own, other);
        Measured { index, distance, angle, value }
    });
    let is_bad_if_any = relation.kind == RelationKind::AwayFrom;
    let decides =
        |a: &Measured, b: &Measured| if is_bad_if_any { b.value < a.value } else { b.value > a.value };
    measured.reduce(|a, b| if decides(&a, &b) { b } else { a })
}

/// The quarter turn from `angle` that meets the wishes to face something best, seen from `position`; `None`
/// where there is no such wish or nothing to face.
pub(super) fn best_quarter(
    environment: &Environment<'_>,
    relations: &[Relation],
    position: Point,
    angle: f64,
) -> Option<f64> {
    let wishes: Vec<_> = facing(environment, relations).collect();
    let fulfilment = |turn: f64| -> f64 {
        let front = Pose::new(position, 0.0, turn).front();
        let own = Target { position, front, radius: 0.0 };
        wishes.iter().map(|&(relation, target)| relation.weight * value(relation, own, target)).sum()
    };
    let quarters = (0..4).map(|quarter| angle + FRAC_PI_2 * f64::from(quarter));
    // Of equals the first: no turn.
    let best = quarters.reduce(|best, next| if fulfilment(next) > fulfilment(best) { next } else { best });
    best.filter(|_| !wishes.is_empty())
}

/// Where the things are that some wishes want to face: the best places at a wall are across from them.
pub(super) fn facing_targets<'a>(
    environment: &'a Environment<'_>,
    relations: &'a [Relation],
) -> impl Iterator<Item = Point> + 'a {
    facing(environment, relations).map(|(_, target)| target.position)
}

/// The wishes to face something, with what they want to face.
fn facing<'a>(
    environment: &'a Environment<'_>,
    relations: &'a [Relation],
) -> impl Iterator<Item = (&'a Relation, Target)> + 'a {
    let is_facing = |relation: &&Relation| {
        matches!(relation.kind, RelationKind::Faces | RelationKind::Sees | RelationKind::Opposite)
            && matches!(relation.target, ParentName::Classes(_))
    };
    relations
        .iter()
        .filter(is_facing)
        .flat_map(|relation| targets(environment, &relation.target).map(move |target| (relation, target)))
}

/// The target of a wish: a point, the direction it faces, and half of its smaller side.
#[derive(Clone, Copy)]
struct Target {
    position: Point,
    front: Point,
    radius: f64,
}

impl Target {
    /// An agent at a place.
    fn own(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> Self {
        let size = environment.agents[agent].size;
        let radius = size.width.min(size.depth) / 2.0;
        Self { position: place.pose.position, front: place.pose.front(), radius }
    }
}

/// 1 where the wish is met, falling to 0; 1 where there is nothing to relate to.
fn fulfilment(environment: &Environment<'_>, agent: AgentIndex, place: &Place, relation: &Relation) -> f64 {
    let own = Target::own(environment, agent, place);
    let values =
        targets(environment, &relation.target).map(|target| value_in(environment, relation, own, target));
    let is_bad_if_any = relation.kind == RelationKind::AwayFrom;
    values.reduce(if is_bad_if_any { f64::min } else { f64::max }).unwrap_or(1.0)
}

/// Metres between two things, and the direction from one to the other.
fn way_to(own: Target, other: Target) -> (f64, Point) {
    let between = other.position - own.position;
    // About what is between the two: half of the smaller side is taken for each, whichever way it is turned.
    let distance = (between.length() - own.radius - other.radius).max(0.0);
    (distance, between.normalize_or(own.front))
}

/// How far a wish is met, in a room whose walls may be in the way.
fn value_in(environment: &Environment<'_>, relation: &Relation, own: Target, other: Target) -> f64 {
    let value = value(relation, own, other);
    if value > 0.0 && !is_seen(environment, relation, own, other) { 0.0 } else { value }
}

/// Whether no wall is in the way of a wish that has to do with sight.
fn is_seen(environment: &Environment<'_>, relation: &Relation, own: Target, other: Target) -> bool {
    relation.kind != RelationKind::Sees || is_in_sight(environment, own.position, other.position)
}

fn value(relation: &Relation, own: Target, other: Target) -> f64 {
    let between = other.position - own.position;
    let (distance, towards) = way_to(own, other);
    let faces = |front: Point, direction: Point| {
        let off = libm::acos(front.dot(direction).clamp(-1.0, 1.0));
        // Linear, and nothing from ANGLE_FADE on: somebody who looks away sees no more of it.
        1.0 - ((off - relation.angle).max(0.0) / ANGLE_FADE).min(1.0)
    };
    match relation.kind {
        RelationKind::Near | RelationKind::Beside => within(distance, relation.distance),
        RelationKind::AwayFrom => 1.0 - within(distance, (0.0, relation.distance.0)),
        // Walls between them are asked of the room.
        RelationKind::Faces | RelationKind::Sees => {
            faces(own.front, towards) * within(distance, relation.distance)
        }
        RelationKind::Opposite => {
            faces(own.front, towards) * faces(other.front, -towards) * within(distance, relation.distance)
        }
        RelationKind::AlignedWith => {
            let offset = between.dot(own.front).abs().min(between.perp_dot(own.front).abs());
            within(offset, relation.distance)
        }
        // Asked of the room as a whole.
        RelationKind::NotBefore | RelationKind::ClearOf => 1.0,
    }
}

/// 1 inside the range, a half at the fade's distance outside it, and so on.
fn within(distance: f64, (least, most): (f64, f64)) -> f64 {
    let off = (least - distance).max(distance - most).max(0.0);
    // Never nothing: also far outside of the range a nearer place is the better one.
    1.0 / (1.0 + off / DISTANCE_FADE)
}

fn targets<'a>(
    environment: &'a Environment<'_>,
    name: &'a ParentName,
) -> Box<dyn Iterator<Item = Target> + 'a> {
    let room = environment.brief.surroundings.room;
    let fixed = |position, front| Target { position, front, radius: 0.0 };
    match name {
        ParentName::Classes(classes) => Box::new(environment.resting_of(classes).filter_map(|other| {
            let other = &environment.agents[other];
            let pose = other.rest()?.pose;
            let radius = other.size.width.min(other.size.depth) / 2.0;
            Some(Target { position: pose.position, front: pose.front(), radius })
        })),
        ParentName::Window | ParentName::Door => Box::new(room.openings.iter().filter_map(move |side| {
            let kind = environment.brief.surroundings.level.openings[side.opening].kind;
            let is_wanted = (kind == OpeningKind::Window) == (*name == ParentName::Window);
            let wall = &room.walls[side.wall];
            let middle = wall.after(f64::midpoint(side.from, side.to));
            is_wanted.then(|| fixed(middle, wall.normal()))
        })),
        ParentName::Wall => {
            Box::new(room.walls.iter().map(move |wall| fixed((wall.start + wall.end) / 2.0, wall.normal())))
        }
        ParentName::Column => Box::new(
            environment.brief.surroundings.columns.iter().map(move |c| fixed(c.base.center(), Point::NEG_Y)),
        ),
        ParentName::Floor | ParentName::Ceiling => Box::new(std::iter::empty()),
    }
}

/// Whether something tall and wide would stand before a window. What hangs at the window itself may.
fn stands_before_window(environment: &Environment<'_>, agent: AgentIndex, place: &Place) -> bool {
    if matches!(place.parent, ParentPart::Opening(_)) {
        return false;
    }
    let size = environment.agents[agent].size;
    // As the audit: a slim plant leaves enough of the light, but a narrow bookcase or a stand full of coats does not.
    let windows = &environment.brief.catalog.audit.windows;
    let is_low = place.pose.elevation + size.height <= windows.low_piece;
    let is_thin = size.width.max(size.depth) < windows.slim_width;
    if is_thin && (is_low || LIGHT_GROUPS.iter().any(|group| environment.is_in(agent, group))) {
        return false;
    }
    let body = box_solid(size, &place.pose);
    environment.brief.surroundings.window_strips.iter().any(|strip| strip.overlaps(&body, CONTACT_TOLERANCE))
}
