//! Regular interval layouts (section 3.3): lamps in rows, tables in a hall, desks in a classroom.
//!
//! The paper's agents look for neighbours of their own class and continue their pattern. Here the pattern is
//! worked out from the room and the number of agents of the class, which gives every agent the same lattice
//! without reading the others' positions.

use core::f64::consts::PI;

use crate::catalog::{Clearance, Grid, RelationKind, Side, Turn};
use crate::geometry::{Bounds, Point};
use crate::layout::body::Pose;
use crate::layout::constants::{LINE_STEP, SCAN_POINTS};
use crate::layout::lattice::{AskedBlock, Axis, Block, LaidBlock, Lattice, Member, Slots, columns_and_rows};
use crate::layout::place::ParentPart;
use crate::layout::seed::{Purpose, RoomKey, Stream};

use super::View;
use super::floor::elevation;
use super::relation::best_quarter;
use super::sight::{Watched, watched};
use super::turn::{self, Bearing, angle_of_front};

/// Metres beyond its margin at which the first row stands before what the pieces face, at most: in a hall that they do not fill,
/// they do not stand in its middle.
const FARTHEST_ROW: f64 = 1.5;
/// Blocks that are tried until one has a place over the floor for every lamp: the last has three times as many as there are lamps.
const MOST_BLOCKS: usize = 18;
/// Shares of its intervals at which a lattice of lamps is tried, until every lamp has a place of it over the floor: at the full ones the
/// box of a room with a corner cut off may have no more places than it has lamps.
const CLOSER: [f64; 4] = [1.0, 0.88, 0.78, 0.68];

/// The first poses on the lattice of the agent's class, starting with the first that no neighbour holds; and which slots of it they are.
pub(super) fn propose(view: &View<'_>, grid: &Grid, key: &RoomKey, poses: &mut Vec<Pose>) -> Slots {
    let lattice = lattice_of(view, grid, key);
    let resting = view.environment.resting[view.environment.agents[view.agent].piece.class].len();
    // Each agent begins behind those that rest, where its own slot is usually free.
    let slots = Slots::from(resting, lattice.block.len() * lattice.members.len());
    add_of_block(&lattice, (0..slots.at_once()).map(|index| slots.slot(index)), poses);
    view.environment.begin_slots(view.agent, view.parent, lattice);
    slots
}

/// All other poses of the lattice: of its block, then around it; and which slots they are.
pub(super) fn propose_others(
    view: &View<'_>,
    grid: &Grid,
    key: &RoomKey,
    slots: Slots,
    poses: &mut Vec<Pose>,
) -> Slots {
    let lattice = lattice_of(view, grid, key);
    let others = slots.others();
    add_of_block(&lattice, (0..others.in_block - others.before).map(|index| others.slot(index)), poses);
    add_outside(lattice.block, lattice.middles, &lattice.axes, |point| {
        poses.extend(lattice.members.iter().map(|member| lattice.pose(point, member)));
    });
    others
}

/// Appends the poses of some slots of a block.
fn add_of_block(lattice: &Lattice, slots: impl Iterator<Item = usize>, poses: &mut Vec<Pose>) {
    let Lattice { members, axes, block, .. } = lattice;
    // Members look the same way at all places: their directions are worked out once.
    let turned: Vec<Pose> = members.iter().map(|member| lattice.pose(Point::ZERO, member)).collect();
    poses.extend(slots.map(|slot| {
        let (place, member) = (slot / members.len(), slot % members.len());
        let place = block.place(axes, place) + members[member].offset;
        Pose { position: lattice.frame.turn(place), ..turned[member] }
    }));
}

/// Poses between the places of the lattice on its rows, then on its columns: who finds no place of its own stays in line with
/// the others.
pub(super) fn scan(view: &View<'_>, grid: &Grid, key: &RoomKey, poses: &mut Vec<Pose>) {
    let lattice = lattice_of(view, grid, key);
    let Lattice { middles, axes, block: Block { first, counts }, .. } = &lattice;
    let lines = |axis: usize| {
        let before = axes[axis].count_before(first[axis] - middles.low[axis]);
        let after = axes[axis].count(middles.high[axis] - first[axis]) as i64;
        (-before..after).map(move |index| first[axis] + axes[axis].at(index, counts[axis]))
    };
    let lengths = (middles.high - middles.low).max(Point::ZERO);
    // A hall gets no more points than a room, but farther apart: the time of a scan is bounded.
    let all = lines(1).count() as f64 * lengths.x + lines(0).count() as f64 * lengths.y;
    let step = LINE_STEP.max(all / SCAN_POINTS);
    let steps = |axis: usize| {
        let count = (lengths[axis] / step) as usize;
        (0..=count).map(move |index| middles.low[axis] + index as f64 * step)
    };
    let on_rows = lines(1).flat_map(|y| steps(0).map(move |x| Point::new(x, y)));
    let on_columns = lines(0).flat_map(|x| steps(1).map(move |y| Point::new(x, y)));
    for point in on_rows.chain(on_columns) {
        poses.extend(lattice.members.iter().map(|member| lattice.pose(point, member)));
    }
}

/// The lattice of an agent's class.
fn lattice_of(view: &View<'_>, grid: &Grid, key: &RoomKey) -> Lattice {
    // One stream for the class: all its agents must agree on the lattice.
    let mut stream = key.stream(Purpose::Placement, &view.class.id, 0);
    let watched = watched(view);
    let angle = watched.map_or_else(|| angle(view, &mut stream), |watched| angle_of_front(-watched.front));
    // Rows and aisles go by the side of the pieces, not by the walls: pupils sit beside each other.
    let frame = Pose::new(Point::ZERO, 0.0, angle);
    let whole = extent(view, &frame);
    let before = watched.map_or(whole, |watched| before(&frame, watched, grid));
    let bounds = within_margins(view, grid, before);
    let members = members(view, grid);
    let half = half_of_place(view, grid);
    let wanted = wanted(view).div_ceil(members.len());
    let mut lay = |wanted, closer| {
        let grid = Grid { interval: grid.interval * closer, ..*grid };
        block_of(view, &grid, bounds, wanted, &mut stream)
    };
    let (block, axes) = match view.parent {
        ParentPart::Ceiling => {
            // Nothing else decides it: the lamps of a corridor do not work out hundreds of places each.
            let asked = AskedBlock {
                class: view.environment.agents[view.agent].piece.class,
                grid: *grid,
                angle,
                bounds,
                half,
                wanted,
            };
            let find = || over_floor(wanted, lay, |place| is_over_floor(view, &frame, place, half));
            view.environment.known_block.get_or(asked, find)
        }
        _ => lay(wanted, 1.0),
    };
    // Beyond the floor before what they look at are places for those who have none on it: in the arms of a cross.
    let outer = if watched.is_some() { whole } else { bounds };
    let middles = Bounds::new(outer.low + half, outer.high - half);
    Lattice { frame, elevation: elevation(view), axes, members, block, middles }
}

/// One at each place, or two whose backs meet there.
fn members(view: &View<'_>, grid: &Grid) -> Vec<Member> {
    let back = Point::new(0.0, view.size.depth / 2.0);
    match grid.is_back_to_back {
        true => vec![Member { offset: -back, turn: 0.0 }, Member { offset: back, turn: PI }],
        false => vec![Member { offset: Point::ZERO, turn: 0.0 }],
    }
}

/// Half of the width and depth that the members of a place take.
fn half_of_place(view: &View<'_>, grid: &Grid) -> Point {
    let depths = if grid.is_back_to_back { 2.0 } else { 1.0 };
    Point::new(view.size.width, depths * view.size.depth) / 2.0
}

/// How far the middles of the outermost places keep from the ends of the room.
struct Margins {
    low: Point,
    high: Point,
}

impl Margins {
    /// Half of what stands at a place, and a depth of the clearances on the side that meets the wall.
    fn new(view: &View<'_>, grid: &Grid, depth: impl Fn(&Clearance) -> f64) -> Self {
        let half = half_of_place(view, grid);
        let clearances = view.class.clearances.iter();
        let deepest =
            |side: Side| clearances.clone().filter(|c| c.side == side).map(&depth).fold(0.0, f64::max);
        let low = Point::new(deepest(Side::Left), deepest(Side::Front));
        let high = Point::new(deepest(Side::Right), deepest(Side::Back));
        if grid.is_back_to_back {
            // Each end meets the front of somebody.
            let both = Point::new(low.x.max(high.x), low.y);
            return Self { low: half + both, high: half + both };
        }
        Self { low: half + low, high: half + high }
    }
}

/// How many agents of the class there are.
fn wanted(view: &View<'_>) -> usize {
    let agents = &view.environment.agents;
    let class = agents[view.agent].piece.class;
    agents.iter().filter(|agent| agent.piece.class == class).count()
}

/// The angle of all agents of the class: towards what they want to face, where it is in the room, else as the
/// rule says.
fn angle(view: &View<'_>, stream: &mut Stream) -> f64 {
    let surroundings = &view.environment.brief.surroundings;
    let bearing = Bearing { parent_angle: surroundings.main_angle, outward: Point::ZERO };
    let drawn = turn::angle(&view.rule.orientation, &bearing, stream);
    if view.rule.orientation.turn != Turn::Quarter {
        return drawn;
    }
    let middle = surroundings.room.region.outline.bounds().center();
    best_quarter(view.environment, &view.class.relations, middle, surroundings.main_angle).unwrap_or(drawn)
}

/// The floor before what the agents look at, in their frame: as wide as the room usually is there.
fn before(frame: &Pose, watched: Watched, grid: &Grid) -> Bounds {
    let at = Point::new(watched.position.dot(frame.right), watched.position.dot(frame.right.perp()));
    let (left, right, depth) = watched.floor(grid.is_halved);
    Bounds::new(at - Point::new(left, 0.0), at + Point::new(right, depth))
}

/// What the margins of a grid leave of the room. Along an axis where no piece would fit they are given up.
fn within_margins(view: &View<'_>, grid: &Grid, room: Bounds) -> Bounds {
    let [left, front, right, back] = grid.margin;
    let inner = Bounds::new(room.low + Point::new(left, front), room.high - Point::new(right, back));
    let fits = inner.size().cmpge(2.0 * half_of_place(view, grid));
    Bounds::new(Point::select(fits, inner.low, room.low), Point::select(fits, inner.high, room.high))
}

/// The block of so many places within some bounds, and its axes.
fn block_of(view: &View<'_>, grid: &Grid, bounds: Bounds, wanted: usize, stream: &mut Stream) -> LaidBlock {
    let axes = [Axis::new(grid, 0), Axis::new(grid, 1)];
    let frame_room = |margins: &Margins| (bounds.size() - margins.low - margins.high).max(Point::ZERO);
    let most_in = |room: Point| [axes[0].count(room.x), axes[1].count(room.y)];
    let has_places = |margins: &Margins| most_in(frame_room(margins)).iter().product::<usize>() >= wanted;
    // At the walls the good clearances if the lattice then has places for all, else the smallest, else none.
    let depths: [fn(&Clearance) -> f64; 3] =
        [|clearance| clearance.good, |clearance| clearance.minimum, |_| 0.0];
    let margins = depths.map(|depth| Margins::new(view, grid, depth));
    let margins = margins.iter().find(|margins| has_places(margins)).unwrap_or(&margins[2]);
    let room = frame_room(margins);
    let counts = columns_and_rows(wanted, most_in(room), room / grid.interval, axes[0].step());
    let axes = match view.parent {
        // Lamps light the whole room, however few they are.
        ParentPart::Ceiling => [0, 1].map(|axis| axes[axis].spread(counts[axis], bounds.size()[axis])),
        _ => axes,
    };
    let span = Point::new(axes[0].span(counts[0]), axes[1].span(counts[1]));
    let slack = (room - span).max(Point::ZERO);
    let share = if grid.is_centered { Point::splat(0.5) } else { Point::new(stream.unit(), stream.unit()) };
    let mut offset = slack * share;
    let is_facing = |kind: RelationKind| matches!(kind, RelationKind::Faces | RelationKind::Sees);
    if view.class.relations.iter().any(|wish| is_facing(wish.kind)) {
        offset.y = offset.y.min(FARTHEST_ROW);
    }
    (Block { first: bounds.low + margins.low + offset, counts }, axes)
}

/// The block of which as many places as wanted are over the floor: the box of a room with wings has others, too. Where no block has
/// so many at any interval, the first.
fn over_floor(
    wanted: usize,
    mut lay: impl FnMut(usize, f64) -> LaidBlock,
    is_over_floor: impl Fn(Point) -> bool,
) -> LaidBlock {
    for closer in CLOSER {
        let mut asked = wanted;
        for _ in 0..MOST_BLOCKS {
            let (block, axes) = lay(asked, closer);
            let places = (0..block.len()).map(|index| block.place(&axes, index));
            let lacking = wanted.saturating_sub(places.filter(|&place| is_over_floor(place)).count());
            if lacking == 0 {
                return (block, axes);
            }
            if block.len() < asked {
                break;
            }
            // Small steps: what is over the floor beyond those wanted stays dark.
            asked += lacking.max(asked / 16);
        }
    }
    lay(wanted, CLOSER[0])
}

/// Whether what takes a place, half of it from the middle, has floor under its corners.
fn is_over_floor(view: &View<'_>, frame: &Pose, place: Point, half: Point) -> bool {
    let region = &view.environment.brief.surroundings.room.region;
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    corners.iter().all(|&(x, y)| region.contains(frame.turn(place + half * Point::new(x, y))))
}

/// Lattice points of an area outside the chosen block, for agents whose slot is taken by a column or a door.
fn add_outside(block: Block, area: Bounds, axes: &[Axis; 2], mut add: impl FnMut(Point)) {
    let (Block { first, counts }, Bounds { low, high }) = (block, area);
    let before = [0, 1].map(|axis| axes[axis].count_before((first - low)[axis]));
    let after = [axes[0].count(high.x - first.x) as i64, axes[1].count(high.y - first.y) as i64];
    let at = |axis: usize, index: i64| axes[axis].at(index, counts[axis]);
    // Lines between a place and the block; none for those of the block.
    let beyond = |axis: usize, index: i64| (-index).max(index - (counts[axis] as i64 - 1)).max(0);
    let mut places: Vec<(i64, Point)> = Vec::new();
    for row in -before[1]..after[1] {
        for column in -before[0]..after[0] {
            let lines = beyond(0, column) + beyond(1, row);
            if lines > 0 {
                places.push((lines, first + Point::new(at(0, column), at(1, row))));
            }
        }
    }
    // Who has no place in the block stays beside it: a seat at the other end of a hall is alone.
    places.sort_by_key(|(lines, _)| *lines);
    places.into_iter().for_each(|(_, place)| add(place));
}

/// Bounding box of the room in the frame of its longest wall.
fn extent(view: &View<'_>, frame: &Pose) -> Bounds {
    let corners = view.environment.brief.surroundings.room.region.outline.corners();
    let local = |corner: &Point| Point::new(corner.dot(frame.right), corner.dot(frame.right.perp()));
    Bounds::around(corners.iter().map(local))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::{Along, Count, ParentName, Untidiness};
    use crate::geometry::direction;
    use crate::layout::Placement;
    use crate::layout::tests::{catalog, level, rule, run};

    const LIGHT: usize = 3;

    #[test]
    fn few_lamps_are_spread_over_the_room() {
        let level = level(&[(0.0, 0.0), (12.0, 0.0), (12.0, 3.0), (0.0, 3.0)]);
        let placements =
            run(&level, &catalog(&[(LIGHT, Count::Fixed(2))], Untidiness::default()), 1).placements;
        let mut across: Vec<f64> = placements.iter().map(|one| one.position.x).collect();
        across.sort_by(f64::total_cmp);
        assert!((across[0] - 3.0).abs() < 1e-9 && (across[1] - 9.0).abs() < 1e-9, "{across:?}");
    }

    #[test]
    fn the_lamps_of_a_room_with_wings_all_hang_in_the_lattice() {
        let level = level(&[(0.0, 0.0), (18.0, 0.0), (18.0, 4.0), (4.0, 4.0), (4.0, 15.0), (0.0, 15.0)]);
        for count in [5, 12, 17] {
            let lamps = catalog(&[(LIGHT, Count::Fixed(count))], Untidiness::default());
            let placements = run(&level, &lamps, 1).placements;
            assert_eq!(placements.len(), count as usize);
            let nearest = |one: &Placement| {
                let others = placements.iter().filter(|other| other.position != one.position);
                others.map(|other| other.position.distance(one.position)).fold(f64::INFINITY, f64::min)
            };
            let least = placements.iter().map(nearest).fold(f64::INFINITY, f64::min);
            assert!(least >= 2.0, "{count} lamps, two of them {least} m apart");
        }
    }

    #[test]
    fn lamps_hang_closer_where_a_cut_off_corner_leaves_too_few_places() {
        // Five by five places in the box; the small rooms at its lower side take five of them.
        let level = level(&[
            (0.0, 2.2),
            (2.0, 2.2),
            (2.0, 0.0),
            (11.0, 0.0),
            (11.0, 2.2),
            (11.4, 2.2),
            (11.4, 11.0),
            (0.0, 11.0),
        ]);
        for count in [18, 22, 25] {
            let lamps = catalog(&[(LIGHT, Count::Fixed(count))], Untidiness::default());
            let placements = run(&level, &lamps, 1).placements;
            assert_eq!(placements.len(), count as usize);
            let gaps = placements.iter().enumerate().flat_map(|(number, one)| {
                placements[..number].iter().map(|other| other.position.distance(one.position))
            });
            let least = gaps.fold(f64::INFINITY, f64::min);
            assert!(least >= 1.5, "{count} lamps, two of them {least} m apart");
        }
    }

    #[test]
    fn who_has_no_place_in_the_rows_stays_in_line_with_others() {
        let mut catalog = catalog(&[(LIGHT, Count::Fixed(30))], Untidiness::default());
        let light = &mut catalog.classes[LIGHT];
        light.parents = vec![rule(ParentName::Floor, &[Side::Above], Turn::Quarter, Along::Random)];
        // Places of the lattice in the corners of its box are outside.
        let level = level(&[(4.0, 0.0), (12.0, 5.0), (4.0, 10.0), (0.0, 5.0)]);
        let placements = run(&level, &catalog, 1).placements;
        let along = direction(placements[0].angle);
        let is_in_line = |one: &Placement, other: &Placement| {
            let offset = other.position - one.position;
            offset.dot(along).abs().min(offset.dot(along.perp()).abs()) < 1e-6 && offset.length() > 0.5
        };
        let has_line = |one: &Placement| placements.iter().any(|other| is_in_line(one, other));
        assert!(placements.len() > 6 && placements.iter().all(has_line), "{}", placements.len());
    }

    #[test]
    fn a_grid_keeps_its_margins_where_they_leave_something() {
        let level = level(&[(0.0, 0.0), (9.0, 0.0), (9.0, 8.0), (0.0, 8.0)]);
        let nearest_to_walls = |margin: [f64; 4]| {
            let mut catalog = catalog(&[(LIGHT, Count::Fill(100))], Untidiness::default());
            catalog.classes[LIGHT].grid.as_mut().expect("lights hang in a grid").margin = margin;
            let placements = run(&level, &catalog, 1).placements;
            let x = placements.iter().map(|one| one.position.x.min(9.0 - one.position.x));
            let y = placements.iter().map(|one| one.position.y.min(8.0 - one.position.y));
            (x.fold(f64::INFINITY, f64::min), y.fold(f64::INFINITY, f64::min))
        };
        let half = 0.3;
        let (x, y) = nearest_to_walls([1.5, 2.0, 1.5, 2.0]);
        assert!(x >= 1.5 + half - 1e-9 && y >= 2.0 + half - 1e-9, "{x} {y}");
        let (x, y) = nearest_to_walls([1.5, 4.0, 1.5, 4.0]);
        assert!(x >= 1.5 + half - 1e-9 && y < 2.0, "{x} {y}");
    }
}
