//! Reads curtain walls: their panes are windows, joined where they stand above each other.
//!
//! ```text
//!   +----+----+-----+      panes of one wall, seen from outside: a window for each column of them on each storey,
//!   |    |    |     |      down to the floor where they are; bars between columns stay walls, and doors that are
//!   +----+----+ door|      parts of the wall are read with the other doors
//!   |    |    |     |
//! ```
//!
//! A file that draws some panes as glass means the opaque ones as solid panels; one that draws none so says nothing of it.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;

use super::columns::Products;
use super::level::Storey;
use super::looks::Looks;
use super::model::{Entity, Read};
use super::openings::Hole;
use super::panes::{Line, Span, columns, enlist};
use super::swing::Doorway;
use crate::geometry::{Bounds, Point, edges};
use crate::plan::assemble::BoxIndex;
use crate::plan::{LeafDraft, OpeningDraft, OpeningKind, OpeningPlace};

const CURTAINS: [&str; 1] = ["IFCCURTAINWALL"];
const PANES: [&str; 2] = ["IFCPLATE", "IFCPLATESTANDARDCASE"];
/// Panes of one wall that are compared with each other.
const MOST_PANES: usize = 4_000;
/// Openings beside a pane that are looked at.
const MOST_BESIDE: usize = 256;
/// Parts of parts.
const MOST_PARTS: usize = 20_000;
/// Metres of the smallest pane on a storey, along the wall and in height; less is a frame.
const SMALLEST: f64 = 0.2;
/// Metres across the wall of the thickest pane, and heights to depths of the most slanting one.
const THICKEST: f64 = 0.6;
const STEEP: f64 = 1.5;
/// Cosine of the angle between a pane and an opening beside it.
const PARALLEL: f64 = 0.999;
/// Metres from a pane to the edge of a room that it lights.
const REACH: f64 = 0.6;

/// The rooms of a storey by their place, and its doors and windows.
struct Places {
    rooms: BoxIndex<usize>,
    openings: BoxIndex<usize>,
}

impl Places {
    fn of(storey: &Storey) -> Self {
        let openings = storey.draft.openings.iter().map(|opening| match opening.place {
            OpeningPlace::Points { center, .. } => Bounds::around_point(center, opening.width / 2.0),
            OpeningPlace::Edge { .. } => Bounds::around_point(Point::ZERO, 0.0),
        });
        Self { rooms: storey.rooms_by_place(), openings: BoxIndex::of(openings.zip(0..)) }
    }

    fn is_at_room(&self, storey: &Storey, center: Point) -> bool {
        self.rooms.near(Bounds::around_point(center, REACH)).into_iter().any(|room| {
            let room = &storey.draft.rooms[room];
            let mut rings = std::iter::once(&room.outline).chain(&room.holes);
            rings.any(|ring| edges(ring).any(|edge| edge.distance(center) <= REACH))
        })
    }

    /// What doors and windows of a storey leave of a pane: a wall of glass around them is drawn as one.
    fn free(&self, storey: &Storey, line: &Line, span: &Span) -> Vec<Span> {
        let ends = [span.from, span.to].map(|at| line.origin + line.along * at);
        let mut taken: Vec<(f64, f64)> = Vec::new();
        let beside = Bounds::around(ends).inflated(REACH);
        let mut near: Vec<usize> = self.openings.meeting(beside).take(MOST_BESIDE).collect();
        near.sort_unstable();
        for number in near {
            let opening = &storey.draft.openings[number];
            let OpeningPlace::Points { center, along: Some(along) } = opening.place else { continue };
            let off = center - line.origin;
            let is_in = off.perp_dot(line.along).abs() < REACH && along.dot(line.along).abs() > PARALLEL;
            let middle = off.dot(line.along);
            taken.extend(is_in.then_some((middle - opening.width / 2.0, middle + opening.width / 2.0)));
        }
        taken.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut free = Vec::new();
        let mut from = span.from;
        for (start, end) in taken.into_iter().chain([(span.to, span.to)]) {
            let to = start.min(span.to);
            if to - from >= SMALLEST {
                free.push(Span { from, to, ..span.clone() });
            }
            from = from.max(end);
        }
        free
    }
}

impl Products<'_> {
    /// Whether a product is part of a curtain wall.
    pub(super) fn is_panel(&self, product: u64) -> bool {
        self.relations.wholes(product).any(|whole| self.geometry.model.is(whole, &CURTAINS))
    }

    /// Enters the panes of a building's curtain walls into its storeys.
    pub(super) fn glaze(&self, storeys: &mut [Storey]) {
        let places: Vec<Places> = storeys.iter().map(Places::of).collect();
        let mut unread: Vec<u64> = Vec::new();
        let curtains: Vec<Vec<u64>> = self.all(&CURTAINS).map(|curtain| self.panes(&curtain)).collect();
        for panes in self.glass(curtains) {
            let mut lines: Vec<Line> = Vec::new();
            for pane in panes {
                match self.pane(pane) {
                    Ok(Some(hole)) => enlist(&mut lines, pane, &hole),
                    Ok(None) | Err(_) => unread.push(pane),
                }
            }
            for line in &lines {
                for (storey, places) in storeys.iter_mut().zip(&places) {
                    self.light(storey, places, line);
                }
            }
        }
        if let [first, ..] = unread[..] {
            let message = format!(
                "panes of curtain walls: {} of them stand slanting or have no flat body",
                unread.len()
            );
            self.geometry.model.warn(first, message, "they are no windows");
        }
    }

    /// Without the panes that are drawn opaque, where others are drawn as glass.
    fn glass(&self, mut curtains: Vec<Vec<u64>>) -> Vec<Vec<u64>> {
        let model = self.geometry.model;
        if curtains.is_empty() {
            return curtains;
        }
        let looks = Looks::of(model);
        let is_glass = |pane: &u64| looks.is_glass(self.geometry, &model.get(*pane).ok()?);
        let drawn: BTreeMap<u64, Option<bool>> =
            curtains.iter().flatten().map(|pane| (*pane, is_glass(pane))).collect();
        if drawn.values().any(|is_glass| *is_glass == Some(true)) {
            curtains.iter_mut().for_each(|panes| panes.retain(|pane| drawn[pane] != Some(false)));
        }
        curtains
    }

    /// The panes of a curtain wall, parts of parts too; the wall itself where it says nothing of its parts.
    fn panes(&self, curtain: &Entity) -> Vec<u64> {
        let mut parts: BTreeSet<u64> = BTreeSet::new();
        let mut open = self.relations.parts(curtain.id).to_vec();
        while let Some(part) = open.pop() {
            if parts.len() < MOST_PARTS && part != curtain.id && parts.insert(part) {
                open.extend(self.relations.parts(part));
            }
        }
        if parts.is_empty() {
            return vec![curtain.id];
        }
        parts.into_iter().filter(|part| self.geometry.model.is(*part, &PANES)).take(MOST_PANES).collect()
    }

    /// A pane along the direction in which it is thinnest; `None` if it is not thin or slants.
    fn pane(&self, id: u64) -> Read<Option<Hole>> {
        let pane = self.geometry.model.get(id)?;
        let axes = self.frame * self.geometry.place(&pane)?;
        let corners: Vec<DVec3> =
            self.geometry.bodies(&pane, &self.frame)?.iter().flat_map(|body| body.corners()).collect();
        let own = [DVec3::X, DVec3::Y].map(|axis| axes.transform_vector3(axis).truncate());
        let mut best: Option<Hole> = None;
        for along in own.into_iter().chain([diagonal(&corners)]) {
            let Some(along) = along.try_normalize() else { continue };
            let hole = hole_of(&corners, along);
            if best.as_ref().is_none_or(|best| hole.depth + 1e-6 < best.depth) {
                best = Some(hole);
            }
        }
        Ok(best.filter(|hole| hole.depth <= THICKEST && hole.high - hole.low >= STEEP * hole.depth))
    }

    /// Drafts the windows of a line of panes on a storey, where rooms are behind it.
    fn light(&self, storey: &mut Storey, places: &Places, line: &Line) {
        let (floor, ceiling) = (storey.floor, storey.floor + storey.draft.height);
        let mut spans: Vec<Span> = line.spans.clone();
        for span in &mut spans {
            (span.low, span.high) = (span.low.max(floor), span.high.min(ceiling));
        }
        spans.retain(|span| span.high - span.low >= SMALLEST);
        let free = columns(spans).into_iter().flat_map(|span| places.free(storey, line, &span));
        for span in free.collect::<Vec<_>>() {
            let width = span.to - span.from;
            let center = line.origin + line.along * span.from.midpoint(span.to);
            if width < SMALLEST || !places.is_at_room(storey, center) {
                continue;
            }
            let Ok(pane) = self.geometry.model.get(span.pane) else { continue };
            let id = storey.free_opening_id(&pane);
            storey.draft.openings.push(OpeningDraft {
                id,
                kind: OpeningKind::Window,
                place: OpeningPlace::Points { center, along: Some(line.along) },
                rooms: Vec::new(),
                width,
                bottom: span.low - floor,
                top: span.high - floor,
                leaf: LeafDraft::None,
            });
        }
    }
}

/// The box of corners along a direction.
fn hole_of(corners: &[DVec3], along: Point) -> Hole {
    let span = |axis: DVec3| {
        let places = corners.iter().map(|corner| corner.dot(axis));
        places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
    };
    let [x, y, z] = [along.extend(0.0), along.perp().extend(0.0), DVec3::Z].map(span);
    let center = along * x.0.midpoint(x.1) + along.perp() * y.0.midpoint(y.1);
    let doorway = Doorway { center, along, width: x.1 - x.0 };
    Hole { doorway, low: z.0, high: z.1, depth: y.1 - y.0 }
}

/// From the corner farthest left to the one farthest from it.
fn diagonal(corners: &[DVec3]) -> Point {
    let flat = || corners.iter().map(|corner| corner.truncate());
    let Some(start) =
        flat().reduce(|best, next| if (next.x, next.y) < (best.x, best.y) { next } else { best })
    else {
        return Point::ZERO;
    };
    flat().map(|corner| corner - start).fold(Point::ZERO, |best, next| {
        if next.length_squared() > best.length_squared() { next } else { best }
    })
}
