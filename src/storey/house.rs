//! One dwelling on all storeys of a house.

use crate::layout::seed::Stream;

use super::brief::Brief;
use super::dwelling::{
    Cell, Division, MOST_PROGRAMMES, Planned, Port, Strips, Task, fitting, plan, plan_alike, studio,
};
use super::ring::area;
use super::spine::Ground;
use super::typology::{Programme, Typologies};

/// Plans of the ground floor that are tried until the floors above fit on one.
const GROUND_PLANS: usize = 6;
/// The cost of a ground floor that is good enough: no other place of the door is looked at.
const GOOD_LEVEL: f64 = 4.0;

/// The ground floor of a house and the level that all others are like. `None` if no way is sound.
pub(super) fn house(
    ground: &Ground,
    brief: &Brief<'_>,
    typologies: &Typologies,
    stream: &mut Stream,
) -> Option<Vec<Vec<Cell>>> {
    let ports = outer_ports(ground);
    let port = *ports.first()?;
    let has_stairs = brief.storeys > 1;
    let floor = area(&ground.ring) * if has_stairs { 0.9 } else { 1.0 };
    let list = |name: &Option<String>| name.as_ref().and_then(|name| typologies.programmes.get(name));
    let hall = brief.typology.hall.as_deref().unwrap_or("corridor");
    let mut search = Search {
        ports,
        programmes: fitting(list(&brief.typology.programme)?, floor, ground, typologies),
        uppers: uppers_of(list(&brief.typology.upper_programme), floor),
        strips: Strips::of(ground),
    };
    let task = |programme| Task {
        ground,
        port: Some(port),
        typologies,
        programme,
        hall,
        hall_width: brief.typology.hall_width,
        has_stairs,
    };
    let levels =
        search.levels(&task, Form::Through, stream).or_else(|| search.levels(&task, Form::WithEnds, stream));
    let is_small = !has_stairs && area(&ground.ring) < 60.0;
    let or_studio = || is_small.then(|| studio(ground, port, typologies).map(|cells| vec![cells])).flatten();
    Some(levels.or_else(or_studio)?.into_iter().map(one_unit).collect())
}

/// Where the strip of a house lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// From end to end, with rooms beside it.
    Through,
    /// Between rooms that are as wide as the house.
    WithEnds,
}

/// What the levels of a house are looked for with.
struct Search<'a> {
    /// Places of the door.
    ports: Vec<Port>,
    /// The rooms of the ground floor, the most first.
    programmes: Vec<&'a Programme>,
    /// The rooms of the levels above, the most first.
    uppers: Vec<&'a Programme>,
    strips: Strips<'a>,
}

impl<'a> Search<'a> {
    /// The ground floor, and the level above it where there are stairs.
    fn levels(
        &mut self,
        task: &impl Fn(&'a Programme) -> Task<'a>,
        form: Form,
        stream: &mut Stream,
    ) -> Option<Vec<Vec<Cell>>> {
        let mut ways: Vec<Option<Vec<Division>>> = vec![None; self.ports.len()];
        for programme in self.programmes.clone() {
            let mut plans = Vec::new();
            for (port, way) in self.ports.iter().zip(&mut ways) {
                let task = Task { port: Some(*port), ..task(programme) };
                let divisions = way.get_or_insert_with(|| match form {
                    Form::Through => self.strips.divisions(task),
                    Form::WithEnds => self.strips.divisions_with_ends(task),
                });
                let wanted = if form == Form::Through { GROUND_PLANS.div_ceil(2) } else { GROUND_PLANS };
                plans.extend(plan(task, divisions, wanted, stream));
                if plans.iter().any(|planned| planned.cost < GOOD_LEVEL) {
                    break;
                }
            }
            plans.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            plans.truncate(GROUND_PLANS);
            let levels = match task(programme).has_stairs {
                true => self.with_level_above(plans, form, task, stream),
                false => plans.into_iter().next().map(|planned| vec![planned.cells]),
            };
            if levels.is_some() {
                return levels;
            }
        }
        None
    }

    /// The first ground floor that a level fits on; with rooms at the ends of the strip the place of the stairs decides how many
    /// bedrooms there are above, and the one with most is taken.
    fn with_level_above(
        &mut self,
        plans: Vec<Planned>,
        form: Form,
        task: &impl Fn(&'a Programme) -> Task<'a>,
        stream: &mut Stream,
    ) -> Option<Vec<Vec<Cell>>> {
        let mut most = self.uppers.len();
        let mut best = None;
        for planned in plans {
            let upper = self.uppers[..most].iter().enumerate().find_map(|(rank, programme)| {
                let task = Task { port: None, ..task(programme) };
                let upper = plan_alike(task, &planned.scheme, &mut self.strips, stream).into_iter().next()?;
                Some((rank, upper))
            });
            let Some((rank, upper)) = upper else { continue };
            best = Some(vec![planned.cells, upper.cells]);
            if form == Form::Through || rank == 0 {
                break;
            }
            most = rank;
        }
        best
    }
}

/// The programmes of a level above the ground floor that fit a floor of so many square metres, the largest first.
fn uppers_of(programmes: Option<&Vec<Programme>>, floor: f64) -> Vec<&Programme> {
    let fitting = programmes.into_iter().flatten().rev().filter(|programme| programme.from <= floor * 1.25);
    fitting.take(MOST_PROGRAMMES).collect()
}

fn one_unit(mut cells: Vec<Cell>) -> Vec<Cell> {
    cells.iter_mut().for_each(|cell| cell.unit = Some(0));
    cells
}

/// The way in from the street, on the inner face of the wall.
pub(super) fn outer_port(ground: &Ground) -> Option<Port> {
    outer_ports(ground).into_iter().next()
}

/// Ways in from the street: where the entrance is, then at the ends of that wall, where the map does not show the door.
pub(super) fn outer_ports(ground: &Ground) -> Vec<Port> {
    entrance_edge(ground).unwrap_or_default()
}

fn entrance_edge(ground: &Ground) -> Option<Vec<Port>> {
    let (span, at) = ground.facade.entrance?;
    let line = ground.facade.spans.get(span)?.line;
    let way = line.normal();
    let nearest = crate::geometry::edges(&ground.ring)
        .map(|edge| (edge.distance(at), edge))
        .filter(|(_, edge)| edge.normal().dot(way) > 0.7)
        .reduce(|best, next| if next.0 < best.0 { next } else { best });
    let (_, edge) = nearest.filter(|(gap, _)| *gap < ground.wall * 3.0 + 0.5)?;
    let is_drawn = at.distance(line.middle()) > 0.01;
    // Away from the corners, so that a door has a place.
    let length = edge.length();
    let margin = 0.8f64.min(length / 2.0);
    let place = (at - edge.start).dot(edge.direction()).clamp(margin, length - margin);
    let port = |place: f64| Port { at: edge.after(place), way: edge.normal() };
    let mut places = vec![place];
    if !is_drawn {
        // Within the free part of the wall.
        let ends = [line.start, line.end].map(|end| (end - edge.start).dot(edge.direction()));
        let (low, high) = ((ends[0] + margin).max(margin), (ends[1] - margin).min(length - margin));
        places.extend([low, high].into_iter().filter(|end| (*end - place).abs() > 0.5 && low <= high));
    }
    Some(places.into_iter().map(port).collect())
}
