//! Turns doors and windows into openings of their walls.

use std::f64::consts::FRAC_PI_2;

use super::faces::Bodies;
use super::home::{Cut, Piece, Sash};
use crate::geometry::{Bounds, Point, Segment};
use crate::plan::{Leaf, LeafDraft, OpeningDraft, OpeningKind, OpeningPlace};

/// Metres above the floor of the highest threshold: what begins above it is a window.
const HIGHEST_THRESHOLD: f64 = 0.3;
/// Metres of the head of the lowest door.
const LOWEST_HEAD: f64 = 1.5;
/// Metres of the wall beside the box of a door that still is its wall.
const BESIDE: f64 = 0.05;
/// Sine of the largest angle between a door and its wall.
const PARALLEL_SINE: f64 = 0.26;
/// Radians that a leaf turns at least; one that turns by less slides.
const LEAST_TURN: f64 = 0.2;
/// Words of names of doors without leaves that slide or roll away.
const SLIDING_WORDS: [&str; 8] =
    ["slid", "garage", "schieb", "coulissant", "corredera", "scorrevole", "schuif", "pocket"];

/// The opening of a door or window; `round` says whether its wall is round.
pub(super) fn opening(piece: &Piece, cut: &Cut, id: String, bodies: &Bodies<'_>) -> (OpeningDraft, bool) {
    let width = piece.size[0] * cut.wall_width;
    let top = piece.elevation + piece.size[2] * (1.0 - cut.wall_top);
    let bottom = (top - piece.size[2] * cut.wall_height).max(0.0);
    let kind = kind(piece, cut, bottom, top);
    let drawn =
        piece.at([cut.wall_left + cut.wall_width / 2.0, cut.wall_distance + cut.wall_thickness / 2.0]);
    let (center, along, is_round) = on_wall(piece, drawn, bodies).unwrap_or((drawn, piece.axis(), false));
    let draft = OpeningDraft {
        id,
        kind,
        place: OpeningPlace::Points { center, along: Some(along) },
        rooms: Vec::new(),
        width,
        bottom: if kind == OpeningKind::Window { bottom } else { 0.0 },
        top,
        leaf: match kind {
            OpeningKind::Door => {
                LeafDraft::Points(cut.sashes.iter().map(|sash| leaf(piece, *sash)).collect())
            }
            _ => LeafDraft::None,
        },
    };
    (draft, is_round)
}

fn kind(piece: &Piece, cut: &Cut, bottom: f64, top: f64) -> OpeningKind {
    let id = piece.catalog_id.as_deref().unwrap_or_default().to_lowercase();
    let name = piece.name.to_lowercase();
    let slides = SLIDING_WORDS.iter().any(|word| id.contains(word) || name.contains(word));
    let turns = cut.sashes.iter().any(|sash| (sash.angles[1] - sash.angles[0]).abs() >= LEAST_TURN);
    if bottom > HIGHEST_THRESHOLD || top < LOWEST_HEAD {
        OpeningKind::Window
    } else if turns {
        OpeningKind::Door
    } else if slides || !cut.sashes.is_empty() {
        OpeningKind::SlidingDoor
    } else if id.contains("window") {
        OpeningKind::Window
    } else {
        OpeningKind::Passage
    }
}

/// The place on the centre line of the wall that a door stands in, the direction of the wall, and whether it is round.
fn on_wall(piece: &Piece, place: Point, bodies: &Bodies<'_>) -> Option<(Point, Point, bool)> {
    let reach = piece.size[1] / 2.0 + BESIDE;
    let mut best: Option<(f64, Point, Point, bool)> = None;
    for body in bodies.near(Bounds::around_point(place, reach)) {
        let is_round = body.axis.len() > 2;
        for segment in body.segments().filter(|segment| is_along(*segment, piece.axis())) {
            let nearest = segment.nearest(place);
            let distance = nearest.distance(place);
            let is_nearer = best.is_none_or(|(least, ..)| distance < least);
            if distance <= reach + body.thickness / 2.0 && is_nearer {
                // A round wall is made straight where the door stands, as the door has it.
                let along = if is_round { piece.axis() } else { segment.direction() };
                best = Some((distance, nearest, along, is_round));
            }
        }
    }
    best.map(|(_, center, along, is_round)| (center, along, is_round))
}

fn is_along(segment: Segment, axis: Point) -> bool {
    segment.direction().perp_dot(axis).abs() < PARALLEL_SINE
}

/// A leaf as the application draws it: shut it lies along the wall, whichever of its positions that is.
fn leaf(piece: &Piece, sash: Sash) -> Leaf {
    let hinge = piece.at(sash.hinge);
    let length = sash.width * piece.size[0];
    let axis = piece.axis();
    let tip = |angle: f64| {
        let (sine, cosine) = libm::sincos(angle);
        let right = if piece.is_mirrored { -cosine } else { cosine };
        hinge + axis * (right * length) + axis.perp() * (sine * length)
    };
    let [first, second] = sash.angles;
    let across = |angle: f64| libm::sin(angle).abs();
    // Of two positions across the wall the first counts as shut, for want of a better one.
    let (shut, open) = if across(second) < across(first) { (second, first) } else { (first, second) };
    let turn = open - shut;
    let open = if turn.abs() > 2.0 * FRAC_PI_2 { shut + turn.signum() * 2.0 * FRAC_PI_2 } else { open };
    Leaf { hinge, closed_tip: tip(shut), open_tip: tip(open) }
}
