//! Bodies, columns and walls in the space that people need before the sides of objects.

use std::collections::BTreeMap;

use crate::catalog::{Clearance, Side};
use crate::geometry::{Point, Segment};
use crate::layout::{Parent, clearance_solids};
use crate::plan::OpeningKind;

use super::convex::clip_segment;
use super::fault::{FloorRegion, Named};
use super::rounding::ROUNDING;
use super::subject::{Body, Subject};
use super::zone::{NearPair, Purpose, Zone};

/// The smallest clearances of all bodies, and the good ones where they are deeper.
pub(crate) fn zones(subject: &Subject<'_>) -> Vec<Zone> {
    let mut zones = Vec::new();
    for (owner, body) in subject.bodies.iter().enumerate() {
        for (number, clearance) in body.class.all_clearances().enumerate() {
            if clearance.minimum > 0.0 {
                zones.push(zone(body, clearance, clearance.minimum, Purpose::Using(owner, number)));
            }
            // Where both depths are the same, nothing lies between them that could be taken.
            if clearance.good > clearance.minimum + ROUNDING {
                zones.push(zone(body, clearance, clearance.good, Purpose::Comfort(owner, number)));
            }
        }
    }
    zones
}

/// The region before a side, `depth` metres deep.
pub(crate) fn zone(body: &Body<'_>, clearance: &Clearance, depth: f64, purpose: Purpose) -> Zone {
    let elevation = body.placement.elevation;
    let base = body.strip(clearance.side, clearance.margin, depth);
    Zone {
        purpose,
        heights: (elevation, elevation + clearance.height),
        face: Segment::new(base[0], base[3]),
        base: base.to_vec(),
    }
}

/// Something in a clearance that should not be there.
pub(crate) struct Taking {
    /// The owner of the clearance, by index.
    pub(crate) owner: usize,
    /// Which of the clearances of its class.
    pub(crate) number: usize,
    /// The body, wall or column that takes it.
    pub(crate) blocker: Named,
    /// Metres that are left of it.
    pub(crate) free: f64,
}

impl Taking {
    /// The clearance that is taken, as deep as its minimum or its good figure.
    pub(crate) fn region(&self, subject: &Subject<'_>, is_good: bool) -> FloorRegion {
        let owner = &subject.bodies[self.owner];
        let clearance = owner.class.clearance(self.number);
        let depth = if is_good { clearance.good } else { clearance.minimum };
        zone(owner, clearance, depth, Purpose::Using(self.owner, self.number)).base
    }
}

/// The smallest or the good clearances of an object, of some kind.
pub(crate) fn clearance_regions(
    body: &Body<'_>,
    is_good: bool,
    is_meant: impl Fn(&Clearance) -> bool,
) -> Vec<FloorRegion> {
    let clearances = clearance_solids(body.class, body.placement, is_good).into_iter();
    let meant = clearances.filter(|(clearance, _)| is_meant(clearance));
    meant.map(|(_, solid)| solid.base.corners().to_vec()).collect()
}

/// For each object and what takes its clearances, the narrowest that is left.
pub(crate) fn narrowest(takings: &[Taking]) -> BTreeMap<(usize, &str), &Taking> {
    let mut narrowest: BTreeMap<(usize, &str), &Taking> = BTreeMap::new();
    for taking in takings {
        let known = narrowest.entry((taking.owner, taking.blocker.id.as_str())).or_insert(taking);
        if taking.free < known.free {
            *known = taking;
        }
    }
    narrowest
}

/// The takings of the clearances of some purpose; `select` gives their object and number.
pub(crate) fn takings(
    subject: &Subject<'_>,
    zones: &[Zone],
    hits: &[NearPair<'_>],
    select: impl Fn(Purpose) -> Option<(usize, usize)>,
) -> Vec<Taking> {
    let limit = subject.rules().clearances.intrusion + ROUNDING;
    let mut takings = Vec::new();
    for &(zone, body) in hits {
        let Some((owner, number)) = select(zone.purpose) else { continue };
        let other = &subject.bodies[body];
        if !is_welcome(subject, owner, number, body)
            && !is_flat(subject, other)
            && zone.intrusion(subject, other) > limit
        {
            takings.push(Taking {
                owner,
                number,
                blocker: subject.object(body),
                free: zone.free_depth(other),
            });
        }
    }
    for zone in zones {
        if let Some((owner, number)) = select(zone.purpose) {
            takings.extend(fixed_edges(subject, zone).into_iter().map(|(blocker, edge)| Taking {
                owner,
                number,
                blocker,
                free: zone.free_depth_to(edge),
            }));
        }
    }
    without_spare_sides(subject, takings)
}

/// The same without what takes a side of which another is enough and free; where all of them are taken, what takes the one
/// that has most.
fn without_spare_sides(subject: &Subject<'_>, mut takings: Vec<Taking>) -> Vec<Taking> {
    let mut free: BTreeMap<usize, BTreeMap<usize, f64>> = BTreeMap::new();
    for taking in takings.iter().filter(|taking| subject.bodies[taking.owner].class.is_either(taking.number))
    {
        let free = free.entry(taking.owner).or_default().entry(taking.number).or_insert(f64::INFINITY);
        *free = free.min(taking.free);
    }
    let best = |owner: usize| {
        let sides = &free[&owner];
        let are_all_taken = sides.len() == subject.bodies[owner].class.either.len();
        let most = sides.iter().reduce(|most, side| if side.1 > most.1 { side } else { most });
        most.filter(|_| are_all_taken).map(|(&number, _)| number)
    };
    takings.retain(|taking| {
        !subject.bodies[taking.owner].class.is_either(taking.number)
            || best(taking.owner) == Some(taking.number)
    });
    takings
}

/// The takings of the good clearances.
pub(crate) fn comfort_takings(subject: &Subject<'_>, zones: &[Zone], hits: &[NearPair<'_>]) -> Vec<Taking> {
    takings(subject, zones, hits, |purpose| match purpose {
        Purpose::Comfort(owner, number) => Some((owner, number)),
        _ => None,
    })
}

/// Whether a body may be in a clearance: it belongs to its object, and the side takes children or it lies
/// below in the hierarchy. A side that takes children takes those of a twin, too: the nightstand between two beds.
fn is_welcome(subject: &Subject<'_>, owner: usize, number: usize, body: usize) -> bool {
    let clearance = subject.bodies[owner].class.clearance(number);
    // Parents come before their children in the placements: a body of a lower index is the owner or what that belongs to.
    (is_relative(subject, owner, clearance.side, body) && (clearance.allows_children || body <= owner))
        || (clearance.allows_children && is_at_same_side(subject, owner, body))
}

/// Whether a body belongs to the owner of a clearance: the owner itself, what it stands at, what stands on or
/// under it, a child at that side, or what rests on one of these (the cushion on the chair).
fn is_relative(subject: &Subject<'_>, owner: usize, side: Side, body: usize) -> bool {
    let is_welcome_child = |object: usize| {
        let placement = subject.bodies[object].placement;
        let is_out_of_the_way = matches!(placement.side, Side::Above | Side::Below);
        placement.parent == Parent::Object(owner) && (is_out_of_the_way || placement.side == side)
    };
    subject.descends_from(owner, body)
        || subject.ancestors(body).take_while(|&object| object > owner).any(is_welcome_child)
}

/// Whether a body, or what it rests on, stands at the same side of an object as another one does.
fn is_at_same_side(subject: &Subject<'_>, other: usize, body: usize) -> bool {
    let other = subject.bodies[other].placement;
    let is_beside = |object: usize| {
        let placement = subject.bodies[object].placement;
        (placement.parent, placement.side) == (other.parent, other.side)
    };
    matches!(other.parent, Parent::Object(_)) && subject.ancestors(body).any(is_beside)
}

/// Whether something hangs flat on a wall, where nobody walks into it.
fn is_flat(subject: &Subject<'_>, body: &Body<'_>) -> bool {
    let rules = subject.rules().clearances;
    matches!(body.placement.parent, Parent::Wall(_) | Parent::Opening(_))
        && body.placement.size.depth <= rules.flat_depth
        && body.low() >= rules.flat_elevation
}

/// The edges of walls and columns inside a zone, with the parts that they belong to. Where the wall is open, a
/// zone may reach into the next room.
fn fixed_edges(subject: &Subject<'_>, zone: &Zone) -> Vec<(Named, Segment)> {
    let room = subject.at.room;
    let margin = subject.rules().clearances.intrusion + ROUNDING;
    // Clipping takes the margin away again on every side: what touches the face then still lies inside.
    let base = reaching_back(&zone.base, 2.0 * margin);
    let inside = |edge: Segment| clip_segment(&base, edge, margin);
    let walls = room.region.borders().enumerate().filter_map(|(number, border)| {
        let segment = inside(border)?;
        (!is_open(subject, number, segment)).then(|| (Subject::wall(number), segment))
    });
    let tall = room.obstacles.iter().enumerate().filter(|(_, column)| column.height > zone.heights.0);
    let columns = tall.flat_map(|(number, column)| {
        column.outline.edges().filter_map(inside).map(move |segment| (Subject::column(number), segment))
    });
    walls.chain(columns).collect()
}

/// A zone that begins some metres inside its object: a wall that the object touches leaves nothing of the zone, though no part
/// of the wall lies inside it.
fn reaching_back(base: &[Point], metres: f64) -> Vec<Point> {
    let &[near, far, other_far, other_near] = base else { return base.to_vec() };
    let back = (near - far).normalize_or_zero() * metres;
    vec![near + back, far, other_far, other_near + back]
}

/// Whether a stretch of a wall lies in an opening that nothing closes.
fn is_open(subject: &Subject<'_>, wall: usize, stretch: Segment) -> bool {
    let face = &subject.at.room.walls[wall];
    let along = |point: Point| (point - face.start).dot(face.direction());
    let (start, end) = (along(stretch.start), along(stretch.end));
    let (from, to) = (start.min(end), start.max(end));
    subject.at.room.openings.iter().filter(|place| place.wall == wall).any(|place| {
        let kind = subject.at.level.openings[place.opening].kind;
        let is_free = matches!(kind, OpeningKind::OpenBoundary | OpeningKind::Passage);
        is_free && place.from - ROUNDING <= from && to <= place.to + ROUNDING
    })
}
