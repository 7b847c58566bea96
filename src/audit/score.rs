//! A number for how good a room is, to rank rooms by; it stands beside the grade and hides no finding.
//!
//! The weighted mean of six terms from 0 to 1 (weights: `score` in `configs/audit.yaml`). After P. Merrell et
//! al., "Interactive Furniture Layout Using Interior Design Guidelines", 2011, section 4, whose terms are costs
//! without a bound; here each has one, so that rooms of different sizes can be compared.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;

use super::checks::{Rates, angle_off, middle_of, stands_straight};
use super::evidence::Evidence;
use super::groups::MOVABLE;
use super::mean::weighted_mean;
use super::relations;
use super::subject::{Body, Subject};
use super::zone::Purpose;
use crate::geometry::{Point, Segment};
use crate::layout::Parent;

/// Parts of one that a score keeps: enough to rank by, and the same in every sum.
const PER_UNIT: f64 = 1e4;

/// How good a room is, from 0 to 1, and the terms that this is the mean of; `None` is a term that does not apply.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Score {
    /// The weighted mean of the terms, to four decimals.
    pub value: f64,
    /// How much of the space between the minimum and the good depth is free at the sides that people use.
    pub clearance: Option<f64>,
    /// The share of the floor that is walked to, the mean over the doors.
    pub walking: Option<f64>,
    /// How near the middle of the furniture is to that of the room, in half sides of a square of its area.
    pub balance: Option<f64>,
    /// How parallel furniture stands to the nearest wall: 0 at an eighth of a turn.
    pub alignment: Option<f64>,
    /// The share of the wishes of the classes that is met, by weight.
    pub relations: Option<f64>,
    /// The share of the requested pieces that rest.
    pub fulfilment: Option<f64>,
}

/// The score of a room, with the walkable rates of its doors; `None` where nothing was asked for.
pub(crate) fn score(evidence: &Evidence<'_, '_>, rates: &Rates) -> Option<Score> {
    let subject = evidence.subject;
    if subject.furnished.requested == 0 {
        return None;
    }
    let terms = Score {
        value: 0.0,
        clearance: mean(slacks(evidence)),
        walking: mean(rates.iter().map(|&(_, rate)| rate)),
        balance: balance(subject),
        alignment: mean(alignments(subject)),
        relations: relations::met(subject, evidence.hits),
        fulfilment: Some((subject.bodies.len() as f64 / f64::from(subject.furnished.requested)).min(1.0)),
    };
    let weights = subject.rules().score;
    // Shares of one, so that only the ratios of the weights matter; a term that does not apply takes no part.
    let weighted = [
        (terms.clearance, weights.clearance),
        (terms.walking, weights.walking),
        (terms.balance, weights.balance),
        (terms.alignment, weights.alignment),
        (terms.relations, weights.relations),
        (terms.fulfilment, weights.fulfilment),
    ];
    let value = weighted_mean(weighted.into_iter().filter_map(|(term, weight)| Some((term?, weight))))?;
    Some(Score { value: (value * PER_UNIT).round() / PER_UNIT, ..terms })
}

fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    weighted_mean(values.map(|value| (value, 1.0)))
}

/// For each side that asks for comfort, how much of it is free: 0 at its minimum.
fn slacks<'e>(evidence: &'e Evidence<'_, '_>) -> impl Iterator<Item = f64> + 'e {
    let subject = evidence.subject;
    let tolerated = subject.rules().clearances.intrusion;
    let mut free: BTreeMap<(usize, usize), f64> = BTreeMap::new();
    for taking in evidence.comfort {
        let known = free.entry((taking.owner, taking.number)).or_insert(f64::INFINITY);
        *known = known.min(taking.free);
    }
    evidence.zones.iter().filter_map(move |zone| {
        let Purpose::Comfort(owner, number) = zone.purpose else { return None };
        let clearance = subject.bodies[owner].class.clearance(number);
        // What is tolerated is free: a millimetre less does not make the score jump.
        let free = free.get(&(owner, number)).map_or(clearance.good, |free| free + tolerated);
        // Space beyond the good depth makes no room better.
        let free = free.min(clearance.good);
        Some(((free - clearance.minimum) / (clearance.good - clearance.minimum)).max(0.0))
    })
}

/// How near the middle of what stands on the floor is to the middle of the floor (Merrell's visual balance).
fn balance(subject: &Subject<'_>) -> Option<f64> {
    let rules = subject.rules();
    let standing = subject.bodies.iter().filter(|body| body.is_standing(rules));
    let add = |(moment, all): (Point, f64), body: &Body<'_>| {
        let area = body.footprint_area();
        // By area, for the weight of furniture is not known; a wardrobe counts for more than a stool.
        (moment + body.placement.position * area, all + area)
    };
    let (moment, all) = standing.fold((Point::ZERO, 0.0), add);
    if all == 0.0 {
        return None;
    }
    // Metres from the middle to a side of a square of the same area: there the term is zero.
    let extent = subject.at.room.region.area().sqrt() / 2.0;
    // Never below zero: rooms with all furniture at one end are equally bad, however long they are.
    Some((1.0 - (moment / all).distance(middle_of(subject)) / extent).max(0.0))
}

/// How parallel each piece stands to its wall, or else to the nearest one. What may stand at any angle, what is
/// round and what people push about is not asked.
fn alignments<'s>(subject: &'s Subject<'_>) -> impl Iterator<Item = f64> + 's {
    let rules = subject.rules();
    let is_asked = |body: &&Body<'_>| {
        let is_low = body.is_standing(rules) || matches!(body.placement.parent, Parent::Wall(_));
        is_low && !body.is_in(MOVABLE) && stands_straight(body, rules.alignment.angle)
    };
    subject.bodies.iter().filter(is_asked).map(|body| {
        let wall = match body.placement.parent {
            Parent::Wall(wall) => subject.at.room.walls[wall].direction(),
            _ => nearest_wall(subject, body.placement.position),
        };
        1.0 - angle_off(body, wall) / core::f64::consts::FRAC_PI_4
    })
}

/// Share of a squared distance by which another counts as equal.
const EQUAL_DISTANCE: f64 = 1e-4;

/// Unit vector along the wall that is nearest to a point.
fn nearest_wall(subject: &Subject<'_>, point: Point) -> Point {
    let apart = |edge: Segment| edge.distance_squared(point);
    let edges = subject.at.room.region.borders();
    // Of walls at equal distances the first, however the file has rounded them.
    let is_nearer = |one: f64, other: f64| one < other * (1.0 - EQUAL_DISTANCE);
    let nearest =
        edges.map(|edge| (apart(edge), edge)).reduce(|a, b| if is_nearer(b.0, a.0) { b } else { a });
    nearest.map_or(Point::X, |(_, edge)| edge.direction())
}

#[cfg(test)]
mod tests {
    use super::Score;
    use crate::audit::testing::{TestRoom, at};
    use crate::audit::{Code, Grade};
    use crate::plan::OpeningKind;

    fn score(room: &TestRoom) -> Score {
        room.judge().score.expect("the room was asked for something")
    }

    /// A room with one desk, its back at the north wall; 0.75 m are needed before it, 0.9 m are good.
    fn desk_room(width: f64, depth: f64) -> TestRoom {
        let mut room = TestRoom::rectangle(width, depth);
        room.stand("desk", at(width / 2.0, depth - 0.375));
        room.requested = Some(1);
        room
    }

    #[test]
    fn a_room_that_was_asked_for_nothing_has_none() {
        let mut room = desk_room(4.0, 3.0);
        assert!(room.judge().score.is_some());
        room.requested = Some(0);
        assert_eq!(room.judge().score, None);
    }

    #[test]
    fn clearance_is_what_is_free_between_minimum_and_good() {
        let free = |free: f64| score(&desk_room(4.0, 0.75 + free)).clearance.unwrap();
        assert!((free(0.95) - 1.0).abs() < 1e-9);
        assert!((free(0.889) - 0.99333).abs() < 1e-4, "a centimetre is tolerated");
        assert!((free(0.815) - 0.5).abs() < 1e-9);
        assert!(free(0.74).abs() < 1e-9);
        assert!(free(0.6).abs() < 1e-9, "no less than nothing");
    }

    #[test]
    fn the_narrowest_of_several_takers_counts_and_each_side_once() {
        let mut room = desk_room(4.0, 4.0);
        room.stand("desk", at(1.0, 0.375));
        room.placements[1].angle = core::f64::consts::PI;
        assert!((score(&room).clearance.unwrap() - 1.0).abs() < 1e-9);
        room.stand("stool", at(2.0, 3.25 - 0.8 - 0.2));
        room.stand("stool", at(2.5, 3.25 - 0.83 - 0.2));
        assert!((score(&room).clearance.unwrap() - (0.4 + 1.0) / 2.0).abs() < 1e-9);
    }

    #[test]
    fn walking_is_the_mean_of_the_doors_rates() {
        let divided = |gap: f64| {
            let mut room = TestRoom::rectangle(6.0, 3.0);
            room.open(1, OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
            room.open(3, OpeningKind::Door, (0.3, 1.2), (0.0, 2.0));
            room.stand("chest", at(3.0, 1.5));
            room.placements[0].size.depth = 3.0 - 2.0 * gap;
            room.requested = Some(1);
            score(&room).walking.unwrap()
        };
        assert!(divided(0.6) > 0.99);
        assert!((divided(0.0) - 0.5).abs() < 0.03);
    }

    #[test]
    fn balance_falls_with_the_distance_of_the_middles() {
        let chest_at = |x: f64| {
            let mut room = TestRoom::rectangle(4.0, 4.0);
            room.stand("chest", at(x, 2.0));
            room.requested = Some(1);
            score(&room).balance.unwrap()
        };
        assert!((chest_at(2.0) - 1.0).abs() < 1e-9);
        assert!((chest_at(1.0) - 0.5).abs() < 1e-9, "a metre off, half a side is two");
    }

    #[test]
    fn alignment_is_asked_of_the_nearest_wall_modulo_a_quarter_turn() {
        let turned = |degrees: f64| {
            let mut room = TestRoom::outline(&[(0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (2.0, 4.0)]);
            room.stand("chest", at(4.0, 1.0));
            room.placements[0].angle = degrees.to_radians();
            room.requested = Some(1);
            score(&room).alignment.unwrap()
        };
        assert!((turned(0.0) - 1.0).abs() < 1e-9 && (turned(270.0) - 1.0).abs() < 1e-9);
        assert!((turned(9.0) - 0.8).abs() < 1e-9);
        assert!(turned(45.0).abs() < 1e-9);
    }

    #[test]
    fn fulfilment_is_the_share_that_rests() {
        let mut room = desk_room(4.0, 3.0);
        assert_eq!(score(&room).fulfilment, Some(1.0));
        room.requested = Some(4);
        assert_eq!(score(&room).fulfilment, Some(0.25));
    }

    #[test]
    fn terms_that_do_not_apply_are_left_out_and_weights_count() {
        let mut room = TestRoom::rectangle(4.0, 4.0);
        room.stand("chest", at(2.0, 2.0));
        room.requested = Some(2);
        let all = score(&room);
        assert_eq!((all.clearance, all.walking, all.relations), (None, None, None));
        // Balance and alignment of one weigh 0.1 each, fulfilment of a half 0.2.
        assert_eq!(all.value, 0.75);
        room.catalog.audit.score.fulfilment = 0.0;
        assert_eq!(score(&room).value, 1.0);
    }

    #[test]
    fn a_good_score_hides_no_failure() {
        let mut room = desk_room(4.0, 3.0);
        room.placements[0].elevation = 0.02;
        let verdict = room.judge();
        assert_eq!((verdict.findings[0].code, verdict.grade()), (Code::Floating, Grade::Failed));
        assert!(verdict.score.unwrap().value > 0.9);
    }
}
