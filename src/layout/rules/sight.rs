//! What pieces see: a stage, a screen, an altar; and the part of the room that lies before it.

use crate::catalog::{ParentName, Relation, RelationKind};
use crate::geometry::{Point, Segment, ray_hit};
use crate::layout::environment::Environment;
use crate::layout::place::AgentIndex;

use super::View;

/// Lines across the room before what is looked at, by which its usual width is known.
const LINES: usize = 15;
/// Borders that are looked at in the time of a step: what a room of thousands of corners costs counts, that of others does not.
const BORDERS_A_STEP: usize = 256;

/// Whether no wall of the room is between two points. Columns are: people look past them.
pub(super) fn is_in_sight(environment: &Environment<'_>, from: Point, to: Point) -> bool {
    let sight = Segment::new(from, to);
    let borders = environment.brief.surroundings.borders.iter();
    environment.count_steps((borders.len() / BORDERS_A_STEP) as u64);
    !borders.filter(|border| !border.is_open).any(|border| sight.crosses(border.segment))
}

/// What the pieces of a class look at, with the floor before it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watched {
    /// Its middle.
    pub(super) position: Point,
    /// Where its front points.
    pub(super) front: Point,
    /// Metres before it to the wall that it faces.
    depth: f64,
    /// Metres to the walls on both sides of its axis, as they usually are: on the left of those who look at it, and on their right.
    sides: (f64, f64),
}

/// What the agents of a view's class wish to see, if it is there.
pub(super) fn watched(view: &View<'_>) -> Option<Watched> {
    let mut wishes = view.class.relations.iter();
    let target = wishes.find_map(|wish| first_seen(view.environment, wish))?;
    let pose = view.environment.agents[target].rest()?.pose;
    let (position, front) = (pose.position, pose.front());
    let borders = &view.environment.brief.surroundings.borders;
    view.environment.count_steps((2 * LINES * borders.len() / BORDERS_A_STEP) as u64);
    let reach = |from: Point, way: Point| {
        let hits = borders.iter().filter_map(|border| ray_hit(from, way, border.segment));
        hits.filter(|&metres| metres > 0.0).reduce(f64::min).unwrap_or_default()
    };
    let depth = reach(position, front);
    let at = |line: usize| position + front * (depth * (line as f64 + 0.5) / LINES as f64);
    let usual = |way: Point| {
        let mut widths = [0; LINES].map(|_| 0.0);
        widths.iter_mut().enumerate().for_each(|(line, width)| *width = reach(at(line), way));
        widths.sort_by(f64::total_cmp);
        widths[LINES / 2]
    };
    // Who looks at it has its front before him: his left is to the right of where it looks.
    Some(Watched { position, front, depth, sides: (usual(front.perp()), usual(-front.perp())) })
}

impl Watched {
    /// The ends of the floor before it, along the left and right of those who look at it and away from it.
    pub(super) fn floor(&self, is_halved: bool) -> (f64, f64, f64) {
        let (left, right) = self.sides;
        let least = left.min(right);
        if is_halved { (least, least, self.depth) } else { (left, right, self.depth) }
    }
}

fn first_seen(environment: &Environment<'_>, wish: &Relation) -> Option<AgentIndex> {
    match (&wish.target, wish.kind) {
        (ParentName::Classes(classes), RelationKind::Sees) => environment.resting_of(classes).next(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::catalog::{
        Along, Catalog, Count, Grid, ParentName, Relation, RelationKind, Side, Size, Turn, Untidiness,
    };
    use crate::geometry::Point;
    use crate::layout::Placement;
    use crate::layout::tests::{catalog, level, rule, run};

    const DESK: usize = 1;
    const LAMP: usize = 2;

    /// Desks in the axis of the room, and lamps in halves of rows that need to see one.
    fn stage_and_rows(seats: u32) -> Catalog {
        let mut catalog =
            catalog(&[(DESK, Count::Fixed(1)), (LAMP, Count::Fill(seats))], Untidiness::default());
        let on_axis = rule(ParentName::Floor, &[Side::Above], Turn::Parallel, Along::Axis);
        catalog.classes[DESK].parents = vec![crate::catalog::ParentRule { gap: (1.0, 1.0), ..on_axis }];
        catalog.classes[DESK].priority = 90;
        let seat = &mut catalog.classes[LAMP];
        seat.sizes = vec![Size { width: 0.5, depth: 0.5, height: 0.9 }];
        seat.depth = 0;
        seat.parents = vec![rule(ParentName::Floor, &[Side::Above], Turn::Quarter, Along::Random)];
        seat.grid = Some(Grid {
            interval: Point::new(0.6, 1.0),
            block: [4, 0],
            aisle: 1.2,
            is_centered: true,
            is_halved: true,
            is_back_to_back: false,
            margin: [0.5, 1.0, 0.5, 0.5],
        });
        seat.relations = vec![Relation {
            kind: RelationKind::Sees,
            target: ParentName::Classes(vec![DESK]),
            distance: (0.5, 100.0),
            angle: 1.1,
            weight: 1.0,
            is_needed: true,
        }];
        catalog
    }

    fn of_class(placements: &[Placement], class: usize) -> Vec<&Placement> {
        placements.iter().filter(|placement| placement.class == class).collect()
    }

    #[test]
    fn rows_are_halved_at_the_axis_of_what_they_look_at() {
        // A nave from the door in the south to an apse in the north, with an arm to the west alone.
        let nave = [
            (0.0, 0.0),
            (9.0, 0.0),
            (9.0, 20.0),
            (6.5, 23.0),
            (2.5, 23.0),
            (0.0, 20.0),
            (0.0, 15.0),
            (-6.0, 15.0),
            (-6.0, 9.0),
            (0.0, 9.0),
        ];
        let placements = run(&level(&nave), &stage_and_rows(60), 1).placements;
        let stage = of_class(&placements, DESK)[0];
        assert!((stage.position.x - 4.5).abs() < 0.2 && stage.position.y > 20.0, "{:?}", stage.position);
        assert!(stage.angle.abs() < 1e-6, "its front points down the nave, to the south");
        let seats = of_class(&placements, LAMP);
        assert!(seats.len() >= 50, "{}", seats.len());
        let gap =
            seats.iter().map(|seat| (seat.position.x - stage.position.x).abs()).fold(f64::INFINITY, f64::min);
        assert!(gap > 0.85, "an aisle in the axis, {gap} m to the middle of a seat");
        let half =
            |seat: &&&Placement| (0.0..9.0).contains(&seat.position.x) && seat.position.x < stage.position.x;
        let other = |seat: &&&Placement| seat.position.x > stage.position.x;
        let (left, right) = (seats.iter().filter(half).count(), seats.iter().filter(other).count());
        assert!(left.abs_diff(right) <= 2, "{left} on one side, {right} on the other");
    }

    #[test]
    fn at_the_end_wall_the_stage_is_in_the_axis_and_not_in_the_middle_of_the_wall() {
        let mut level =
            level(&[(0.0, 0.0), (20.0, 0.0), (20.0, 10.0), (14.0, 10.0), (14.0, 6.0), (0.0, 6.0)]);
        level.rooms[0].walls[1].tags = vec!["end".to_owned()];
        let mut catalog = stage_and_rows(0);
        let at_end = rule(ParentName::Wall, &[Side::Front], Turn::Parallel, Along::Axis);
        catalog.classes[DESK].parents =
            vec![crate::catalog::ParentRule { tag: Some("end".to_owned()), ..at_end }];
        let stage = run(&level, &catalog, 1).placements[0].position;
        assert!((stage.y - 3.0).abs() < 0.2 && stage.x > 19.0, "{stage}");
    }

    #[test]
    fn nobody_sits_where_a_wall_hides_the_stage() {
        let bent = [(0.0, 0.0), (30.0, 0.0), (30.0, 8.0), (8.0, 8.0), (8.0, 20.0), (0.0, 20.0)];
        let placements = run(&level(&bent), &stage_and_rows(300), 1).placements;
        let stage = of_class(&placements, DESK)[0].position;
        assert!(
            stage.x > 25.0 && stage.y < 8.0,
            "at the end of the longer wing, away from the door: {stage}"
        );
        let seats = of_class(&placements, LAMP);
        assert!(seats.len() > 60, "{}", seats.len());
        // Past the inner corner one sees 2 m of the other wing.
        assert!(seats.iter().all(|seat| seat.position.y < 10.0), "none farther into the other wing");
    }
}
