//! One dwelling on all storeys of a house.

use crate::layout::seed::Stream;

use super::brief::Brief;
use super::dwelling::{
    Cell, Division, MOST_PROGRAMMES, Planned, Port, Strips, Task, fitting, plan, plan_alike, studio,
};
use super::ring::area;
use super::spine::Ground;
use super::typology::Typologies;

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
    let programmes = list(&brief.typology.programme)?;
    let hall = brief.typology.hall.as_deref().unwrap_or("corridor");
    let mut strips = Strips::of(ground);
    let mut ways: Vec<Option<Vec<Division>>> = vec![None; ports.len()];
    for programme in fitting(programmes, floor, ground, typologies) {
        let mut plans = Vec::new();
        let task = Task {
            ground,
            port: Some(port),
            typologies,
            programme,
            hall,
            hall_width: brief.typology.hall_width,
            has_stairs,
        };
        for (port, way) in ports.iter().zip(&mut ways) {
            let task = Task { port: Some(*port), ..task };
            let divisions = way.get_or_insert_with(|| strips.divisions(task));
            plans.extend(plan(task, divisions, GROUND_PLANS.div_ceil(2), stream));
            if plans.iter().any(|planned| planned.cost < GOOD_LEVEL) {
                break;
            }
        }
        plans.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        for planned in plans.into_iter().take(GROUND_PLANS) {
            if !has_stairs {
                return Some(vec![one_unit(planned.cells)]);
            }
            let uppers = list(&brief.typology.upper_programme)?;
            let upper = uppers
                .iter()
                .rev()
                .filter(|programme| programme.from <= floor * 1.25)
                .take(MOST_PROGRAMMES)
                .find_map(|programme| {
                    let task = Task { port: None, programme, ..task };
                    plan_alike(task, &planned.scheme, &mut strips, stream).into_iter().next()
                });
            if let Some(Planned { cells, .. }) = upper {
                return Some(vec![one_unit(planned.cells), one_unit(cells)]);
            }
        }
    }
    let is_small = !has_stairs && area(&ground.ring) < 60.0;
    is_small.then(|| studio(ground, port, typologies).map(|cells| vec![one_unit(cells)])).flatten()
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
