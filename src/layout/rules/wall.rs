//! At a wall, between its openings: the paper's random position along the touching side, drawn from the
//! stretches that are really free, so that a piece that fits is not missed by bad luck.

use crate::catalog::{Along, Clearance, ParentName, ParentRule, Side, Size};
use crate::geometry::{Convex, Intervals, Point, Segment, Solid};
use crate::layout::agent::Agent;
use crate::layout::body::Pose;
use crate::layout::constants::{
    CLEARANCE_TOLERANCE, CONTACT_TOLERANCE, COVER_MARGIN, SEAT_DEPTH, SNAP_DISTANCE, TRIALS_PER_WALL,
};
use crate::layout::environment::Environment;
use crate::layout::place::{AgentIndex, ParentPart};
use crate::layout::seed::Stream;
use crate::layout::surroundings::Border;
use crate::plan::{OpeningKind, Wall, WallKind};

use super::View;
use super::relation::facing_targets;
use super::swing::wished_distance;
use super::turn::{self, Bearing, angle_of_front};

/// Poses along a wall.
pub(super) fn propose(view: &View<'_>, wall: usize, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let Some(strip) = Strip::new(view, wall, stream) else { return };
    let free = strip.free_stretches();
    // Across from what the agent wants to face comes first; the positions of the rule follow.
    for target in facing_targets(view.environment, &view.class.relations) {
        let across = (target - strip.wall.start).dot(strip.wall.direction());
        poses.extend(nearest_free(free.as_slice(), across).map(|at| strip.pose(at)));
    }
    let middle = middle(view, strip.wall);
    for trial in 0..TRIALS_PER_WALL {
        match choose(view.rule.along, middle, free.as_slice(), trial, stream) {
            Some(at) => poses.push(strip.pose(at)),
            None => return,
        }
    }
}

/// Where the middle of what stands in the middle is, in metres from the wall's start: that of the wall, or where the axis of the room
/// meets it.
fn middle(view: &View<'_>, wall: &Wall) -> f64 {
    let surroundings = &view.environment.brief.surroundings;
    let on_axis = || surroundings.room.long_axis(&surroundings.level.openings).map(|axis| axis.end);
    let end = if view.rule.along == Along::Axis { on_axis() } else { None };
    end.map_or(wall.length() / 2.0, |end| (end - wall.start).dot(wall.direction()))
}

/// What would stand along a wall.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    /// Who.
    pub(crate) agent: AgentIndex,
    /// Its size.
    pub(crate) size: Size,
    /// Index of the wall.
    pub(crate) wall: usize,
    /// Metres from an open side to its back, where it stands before one; 0 at walls.
    pub(crate) before_opening: f64,
}

/// The stretches that are free along a wall, in metres from the wall's start; none for a class that does not stand at walls.
pub(crate) fn free_stretches(
    environment: &Environment<'_>,
    line: &Line,
    stream: &mut Stream,
) -> Vec<(f64, f64)> {
    on_strip(environment, line, stream, |strip| {
        let free = strip.free_stretches();
        free.as_slice().iter().map(|&(from, to)| (from - strip.half, to + strip.half)).collect()
    })
}

/// Where along a wall something could begin, at even steps between its openings, in metres from the wall's start. What is free is
/// asked of each: the free stretches leave out the whole width of what only reaches into them.
pub(crate) fn steps_along(environment: &Environment<'_>, line: &Line, stream: &mut Stream) -> Vec<f64> {
    on_strip(environment, line, stream, |strip| strip.steps().map(|at| at - strip.half).collect())
}

/// What is to be known of the strip along a wall; nothing for a class that does not stand at walls.
fn on_strip<T: Default>(
    environment: &Environment<'_>,
    line: &Line,
    stream: &mut Stream,
    answer: impl FnOnce(&Strip<'_>) -> T,
) -> T {
    let Line { agent, size, wall, before_opening } = *line;
    let class = environment.class(agent);
    let Some(rule) = class.parents.iter().find(|rule| rule.parent == ParentName::Wall) else {
        return T::default();
    };
    // Copied where it is shifted only: most lines are those of walls.
    let shifted =
        (before_opening > 0.0).then(|| ParentRule { gap: (before_opening, before_opening), ..rule.clone() });
    let rule = shifted.as_ref().unwrap_or(rule);
    let view =
        View { environment, agent, class, size, rule, parent: ParentPart::Wall(wall), side: Side::Front };
    let Some(mut strip) = Strip::new(&view, wall, stream) else { return T::default() };
    strip.is_before_opening = before_opening > 0.0;
    answer(&strip)
}

/// The floor along a wall, its middle so many metres before it; `half` of it along the wall and across.
pub(crate) fn floor_along(wall: &Wall, distance: f64, half: Point) -> Convex {
    Convex::rectangle((wall.start + wall.end) / 2.0 + wall.normal() * distance, half, wall.direction())
}

/// What closes the sides of a box that stands along a wall, as ranges of metres from the wall's start: walls and bodies that come
/// into the middle half of its depth. Sides are open where an edge has no wall.
pub(crate) fn closings(environment: &Environment<'_>, line: &Line) -> Vec<(f64, f64)> {
    let Line { size, wall: index, before_opening, .. } = *line;
    let wall = &environment.brief.surroundings.room.walls[index];
    let (along, normal) = (wall.direction(), wall.normal());
    // Past the ends of the wall, too: the walls there are what closes most rows.
    let half = Point::new(wall.length() / 2.0 + SNAP_DISTANCE, size.depth / 4.0);
    let region = Solid::new(floor_along(wall, before_opening + size.depth / 2.0, half), 0.0, size.height);
    let start = wall.start.dot(along);
    let mut closings = Vec::new();
    environment.each_obstacle(&region, |solid, is_flat| {
        let (low, high) = solid.base.project(along);
        if !is_flat {
            closings.push((low - start, high - start));
        }
    });
    let (near, far) = region.base.project(normal);
    environment.each_border(&region, |border| {
        let range = clip(border.segment, along, near, far);
        if border.wall != index
            && !border.is_open
            && let Some((from, to)) = range
        {
            closings.push((from - start, to - start));
        }
    });
    closings
}

/// Poses all along a wall, in a fixed order, as [`steps_along`].
pub(super) fn scan(view: &View<'_>, wall: usize, stream: &mut Stream, poses: &mut Vec<Pose>) {
    let Some(strip) = Strip::new(view, wall, stream) else { return };
    poses.extend(strip.steps().map(|at| strip.pose(at)));
}

/// The position in the free stretches that is nearest to another.
fn nearest_free(free: &[(f64, f64)], at: f64) -> Option<f64> {
    let nearest = free.iter().map(|&(from, to)| at.max(from).min(to));
    nearest.min_by(|a, b| (a - at).abs().total_cmp(&(b - at).abs()))
}

/// The pose before an opening, in its middle.
pub(super) fn propose_at_opening(
    view: &View<'_>,
    opening: usize,
    stream: &mut Stream,
    poses: &mut Vec<Pose>,
) {
    let room = view.environment.brief.surroundings.room;
    let side = &room.openings[opening];
    let wall = &room.walls[side.wall];
    let bearing = Bearing { parent_angle: angle_of_front(wall.normal()), outward: wall.normal() };
    let angle = turn::angle(&view.rule.orientation, &bearing, stream);
    let right = crate::geometry::direction(angle);
    let is_window =
        view.environment.brief.surroundings.level.openings[side.opening].kind == OpeningKind::Window;
    if !is_window && 2.0 * Agent::half_extent(view.size, right, wall.direction()) > side.to - side.from {
        // What stands before a door came in through it: a car does not before that for people.
        return;
    }
    let reach = Agent::half_extent(view.size, right, wall.normal());
    let gap = stream.between(view.rule.gap.0, view.rule.gap.1);
    let drawn = stream.between(view.rule.elevation.0, view.rule.elevation.1);
    let elevation = match view.rule.above_head {
        Some(above) => {
            let opening = &view.environment.brief.surroundings.level.openings[side.opening];
            let most = Point::new(side.to - side.from, opening.top - opening.bottom) + COVER_MARGIN;
            let top = (opening.top + above).min(room.height);
            if view.size.width > most.x || view.size.height > most.y.min(top) {
                return;
            }
            top - view.size.height
        }
        None => drawn,
    };
    let middle = wall.after(f64::midpoint(side.from, side.to));
    poses.push(Pose::new(middle + wall.normal() * (gap + reach), elevation, angle));
}

/// A box that would slide along a wall.
#[derive(Clone, Copy)]
struct Strip<'a> {
    view: &'a View<'a>,
    wall: &'a Wall,
    index: usize,
    /// Metres between wall and box.
    from: f64,
    /// Metres of the box away from the wall.
    depth: f64,
    /// Half of the box along the wall, less half of the tolerance for contact: at the end of a stretch it touches
    /// what is there, and no rounding makes that a collision.
    half: f64,
    /// Underside of the box.
    low: f64,
    /// Top of the box.
    high: f64,
    /// The angle of the box.
    angle: f64,
    /// Whether it stands before an open side, behind the floor that is kept free there.
    is_before_opening: bool,
}

impl<'a> Strip<'a> {
    /// Positions of its middle at even steps between the openings of its wall, in metres from the wall's start.
    fn steps(&self) -> impl Iterator<Item = f64> {
        let mut free = Intervals::new(self.half, self.wall.length() - self.half);
        self.block_openings(&mut free);
        let wall_step = self.view.environment.brief.surroundings.wall_step;
        let stretches = free.as_slice().to_vec();
        stretches.into_iter().flat_map(move |(from, to)| {
            let steps = ((to - from) / wall_step).ceil();
            (0..=steps as u32).map(move |step| from + (to - from) * f64::from(step) / steps.max(1.0))
        })
    }

    /// The strip for an agent at a wall; `None` where it would hang over a railing.
    fn new(view: &'a View<'a>, index: usize, stream: &mut Stream) -> Option<Self> {
        let wall = &view.environment.brief.surroundings.room.walls[index];
        let normal = wall.normal();
        let low = stream.between(view.rule.elevation.0, view.rule.elevation.1);
        let high = low + view.size.height;
        if matches!(wall.kind, WallKind::Railing(height) if low > 0.0 && high > height) {
            return None;
        }
        let bearing = Bearing { parent_angle: angle_of_front(normal), outward: normal };
        let angle = turn::angle(&view.rule.orientation, &bearing, stream);
        let right = crate::geometry::direction(angle);
        let from = stream.between(view.rule.gap.0, view.rule.gap.1);
        let depth = 2.0 * Agent::half_extent(view.size, right, normal);
        let half = Agent::half_extent(view.size, right, wall.direction()) - CONTACT_TOLERANCE / 2.0;
        Some(Self { view, wall, index, from, depth, half, low, high, angle, is_before_opening: false })
    }

    /// The box with its middle so far from the wall's start.
    fn pose(&self, at: f64) -> Pose {
        let (start, along) = (self.wall.start, self.wall.direction());
        let position = start + along * at + self.wall.normal() * (self.from + self.depth / 2.0);
        Pose::new(position, self.low, self.angle)
    }

    /// Where the middle of the box may be, in metres from the wall's start.
    fn free_stretches(&self) -> Intervals {
        let environment = self.view.environment;
        let mut free = Intervals::new(self.half, self.wall.length() - self.half);
        self.block_openings(&mut free);
        // Nothing frees a wall that is too short, as most are to large pieces.
        if free.is_empty() {
            return free;
        }
        let region = self.region(self.from, self.depth, self.high);
        environment.each_obstacle(&region, |solid, _| self.block(&mut free, solid));
        environment.each_kept_free(&region, |solid| self.block(&mut free, solid));
        self.block_borders(&mut free, &region, |_| true);
        if free.is_empty() {
            return free;
        }
        if let Some(front) = self.view.class.clearances.iter().find(|clearance| clearance.side == Side::Front)
        {
            let depth = front.minimum - CLEARANCE_TOLERANCE;
            let region = self.region(self.from + self.depth, depth, self.low + front.height);
            environment.each_obstacle(&region, |solid, is_flat| {
                if !is_flat {
                    self.block(&mut free, solid);
                }
            });
            // People who use it may stand across an open side; how far is asked of each candidate.
            self.block_borders(&mut free, &region, |border| !border.is_open);
            let spacious = self.without_seats(free.clone(), front);
            if !spacious.is_empty() {
                free = spacious;
            }
        }
        let clear = self.without_swings(free.clone());
        if !clear.is_empty() {
            free = clear;
        }
        // Stretches that take space from others are used only where there are no others.
        let comfortable = self.without_comfort(free.clone(), &region);
        if comfortable.is_empty() { free } else { comfortable }
    }

    /// The free stretches less those where the box would be nearer to the swing of a leaf than its class wishes.
    fn without_swings(&self, mut free: Intervals) -> Intervals {
        let least = wished_distance(self.view);
        let near = self.region(self.from - least, self.depth + 2.0 * least, self.high);
        for swing in self.view.environment.brief.surroundings.swings.iter().filter(|_| least > 0.0) {
            let swing = Solid::new(*swing, self.low, self.high);
            if near.overlaps(&swing, CONTACT_TOLERANCE) {
                self.block_grown(&mut free, &swing, least);
            }
        }
        free
    }

    /// The free stretches less those where the box would take what others have beyond their need.
    fn without_comfort(&self, mut free: Intervals, region: &Solid) -> Intervals {
        self.view.environment.each_comfort(region, |solid| self.block(&mut free, solid));
        free
    }

    /// The free stretches less those where the floor before the box is claimed by others, if this one's seat
    /// needs it, or is where their seats stand.
    fn without_seats(&self, mut free: Intervals, front: &Clearance) -> Intervals {
        let depth = if front.allows_children { front.minimum.min(SEAT_DEPTH) } else { front.minimum };
        let region =
            self.region(self.from + self.depth, depth - CLEARANCE_TOLERANCE, self.low + front.height);
        self.view
            .environment
            .each_claim(&region, front.allows_children, |solid| self.block(&mut free, solid));
        free
    }

    /// What stands may stand before a window (and pays for it in its score); what hangs may not.
    fn block_openings(&self, free: &mut Intervals) {
        let surroundings = &self.view.environment.brief.surroundings;
        for side in surroundings.room.openings.iter().filter(|side| side.wall == self.index) {
            let opening = &surroundings.level.openings[side.opening];
            let is_passable = match opening.kind {
                OpeningKind::Window => self.low <= 0.0,
                OpeningKind::OpenBoundary => self.is_before_opening,
                _ => false,
            };
            if !is_passable && self.low < opening.top && self.high > opening.bottom {
                free.subtract(side.from - self.half, side.to + self.half);
            }
        }
    }

    /// The region over the whole length of the wall, `from` to `from + depth` metres before it.
    fn region(&self, from: f64, depth: f64, high: f64) -> Solid {
        // Thinner by a tolerance on both sides: bodies that only touch the region do not block it.
        let depth = (depth - 2.0 * CONTACT_TOLERANCE).max(CONTACT_TOLERANCE);
        let distance = from + CONTACT_TOLERANCE + depth / 2.0;
        let half = Point::new(self.wall.length() / 2.0, depth / 2.0);
        Solid::new(floor_along(self.wall, distance, half), self.low, high)
    }

    fn block(&self, free: &mut Intervals, solid: &Solid) {
        self.block_grown(free, solid, 0.0);
    }

    /// Blocks where the box would come nearer to a solid than so many metres, along the wall.
    fn block_grown(&self, free: &mut Intervals, solid: &Solid, metres: f64) {
        let (low, high) = solid.base.project(self.wall.direction());
        let start = self.wall.start.dot(self.wall.direction());
        // The stretches hold the middle of the box: half of it is blocked beyond each end.
        let reach = self.half + metres;
        free.subtract(low - start - reach, high - start + reach);
    }

    /// Other walls that come into the region: concave corners, slanted neighbours.
    fn block_borders(&self, free: &mut Intervals, region: &Solid, counts: impl Fn(&Border) -> bool) {
        let (along, normal) = (self.wall.direction(), self.wall.normal());
        let (near, far) = region.base.project(normal);
        let start = self.wall.start.dot(along);
        self.view.environment.each_border(region, |border| {
            if border.wall != self.index
                && counts(border)
                && let Some((from, to)) = clip(border.segment, along, near, far)
            {
                free.subtract(from - start - self.half, to - start + self.half);
            }
        });
    }
}

/// The part of a segment whose height over a wall of a direction lies between `near` and `far`, as a range along the wall.
fn clip(segment: Segment, along: Point, near: f64, far: f64) -> Option<(f64, f64)> {
    let (Segment { start: a, end: b }, normal) = (segment, along.perp());
    let (height_a, height_b) = (a.dot(normal), b.dot(normal));
    if height_a.max(height_b) <= near || height_a.min(height_b) >= far {
        return None;
    }
    let rise = height_b - height_a;
    if rise == 0.0 {
        let (from, to) = (a.dot(along), b.dot(along));
        return Some((from.min(to), from.max(to)));
    }
    let at = |height: f64| (a + (b - a) * ((height - height_a) / rise).clamp(0.0, 1.0)).dot(along);
    let (from, to) = (at(near), at(far));
    Some((from.min(to), from.max(to)))
}

/// A position in one of the free stretches, or `None` if there is none.
fn choose(along: Along, middle: f64, free: &[(f64, f64)], trial: usize, stream: &mut Stream) -> Option<f64> {
    // Every stretch counts, the exact fit of hardly any length too.
    let weight = |&(from, to): &(f64, f64)| to - from + SNAP_DISTANCE;
    let mut left = stream.unit() * free.iter().map(weight).sum::<f64>();
    let drawn = free.iter().find(|stretch| {
        left -= weight(stretch);
        left < 0.0
    });
    let &(from, to) = drawn.or(free.last())?;
    Some(match along {
        Along::Center | Along::Axis | Along::Even if trial == 0 => {
            let off = |&(from, to): &(f64, f64)| (middle.max(from).min(to) - middle).abs();
            let &(from, to) = free.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
            middle.max(from).min(to)
        }
        Along::Center | Along::Axis | Along::Even => f64::midpoint(from, to),
        Along::Ends => [from, to][stream.below(2)],
        Along::Random | Along::Back | Along::Front => snap(stream.between(from, to), from, to),
    })
}

/// Slides a position to the nearer end of its stretch if it is close to it.
fn snap(at: f64, from: f64, to: f64) -> f64 {
    if (at - from).min(to - at) > SNAP_DISTANCE {
        at
    } else if at - from < to - at {
        from
    } else {
        to
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Count, ParentName, Turn, Untidiness};
    use crate::layout::tests::{WIDE, catalog, level, rule, run};

    #[test]
    fn what_stands_before_a_door_fits_through_it() {
        let placed = |width: f64| {
            let mut catalog = catalog(&[(4, Count::Fixed(1))], Untidiness::default());
            let shelf = &mut catalog.classes[4];
            shelf.sizes[0].width = width;
            let before_door = rule(ParentName::Door, &[Side::Front], Turn::Facing, Along::Center);
            shelf.parents = vec![crate::catalog::ParentRule { gap: (1.2, 1.2), ..before_door }];
            run(&level(WIDE), &catalog, 1).placements.len()
        };
        assert_eq!([placed(0.88), placed(0.92)], [1, 0]);
    }

    #[test]
    fn a_slanted_neighbour_takes_only_what_it_covers() {
        let neighbour = Segment::new(Point::ZERO, Point::new(1.0, 1.0));
        let range = clip(neighbour, Point::X, 0.0, 0.5).unwrap();
        assert!(range.0.abs() < 1e-12 && (range.1 - 0.5).abs() < 1e-12);
        assert_eq!(clip(neighbour.moved(2.0 * Point::Y), Point::X, 0.0, 0.5), None);
    }

    #[test]
    fn a_piece_near_the_end_slides_flush() {
        assert_eq!(snap(0.7, 0.5, 3.0), 0.5);
        assert_eq!(snap(2.9, 0.5, 3.0), 3.0);
        assert_eq!(snap(1.5, 0.5, 3.0), 1.5);
    }
}
