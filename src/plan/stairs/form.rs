//! The forms of stairs: what they take of the floor, and their steps, in a frame of their own.
//!
//! Rises, goings and widths are those of dwellings and of small public buildings in DIN 18065 (2015), tables 1 and 2, and of Approved
//! Document K of England (2013), section 1: a going of 0.21 m at least, a rise of 0.20 m at most (0.22 m in dwellings).

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::geometry::{Point, Segment, direction};

/// What stairs look like from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Two flights side by side, with a landing between.
    Dogleg,
    /// Two flights side by side, with steps that turn instead of a landing.
    Winding,
    /// One flight.
    Straight,
    /// Two flights around a corner, with steps that turn.
    Quarter,
    /// One flight with steps that turn at both ends: one comes in and leaves by the same side.
    Sideways,
    /// Steps around a post, a turn for each storey.
    Spiral,
}

/// A kind of stairs with its measures, but for the room that it gets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Design {
    /// The form.
    pub(super) kind: Kind,
    /// Metres across a flight, the widest first; of a spiral, half of its width.
    pub(super) lanes: &'static [f64],
    /// Metres from one edge of a step to the next.
    pub(super) going: f64,
    /// Metres of a rise at most.
    pub(super) riser: f64,
}

/// What is tried, in this order: comfort first, then what small rooms hold.
pub(super) const DESIGNS: &[Design] = &[
    Design { kind: Kind::Dogleg, lanes: &[1.2, 1.0], going: 0.28, riser: 0.18 },
    Design { kind: Kind::Dogleg, lanes: &[1.0, 0.9], going: 0.26, riser: 0.185 },
    Design { kind: Kind::Dogleg, lanes: &[0.9, 0.8], going: 0.24, riser: 0.2 },
    Design { kind: Kind::Straight, lanes: &[1.0, 0.9], going: 0.26, riser: 0.185 },
    Design { kind: Kind::Winding, lanes: &[1.0, 0.9], going: 0.26, riser: 0.185 },
    Design { kind: Kind::Quarter, lanes: &[1.0, 0.9], going: 0.26, riser: 0.185 },
    Design { kind: Kind::Sideways, lanes: &[1.0, 0.9], going: 0.25, riser: 0.19 },
    Design { kind: Kind::Straight, lanes: &[0.8], going: 0.24, riser: 0.2 },
    Design { kind: Kind::Winding, lanes: &[0.8, 0.7], going: 0.23, riser: 0.2 },
    Design { kind: Kind::Quarter, lanes: &[0.8, 0.7], going: 0.23, riser: 0.2 },
    Design { kind: Kind::Sideways, lanes: &[0.8, 0.7], going: 0.22, riser: 0.2 },
    Design { kind: Kind::Spiral, lanes: &[1.0, 0.85, 0.75], going: 0.21, riser: 0.2 },
];

/// Metres between two flights side by side, at least; what a wide room has more is between them too.
const GAP: f64 = 0.1;
/// Metres across the widest flight.
const WIDEST_LANE: f64 = 1.35;
/// Steps that turn by a quarter.
const QUARTER_WINDERS: usize = 3;
/// Radius of the post of a spiral.
const POST: f64 = 0.06;
/// The angle of a spiral's landing, around its front: the floor that one steps from and onto.
const SPIRAL_LANDING: f64 = PI * 0.42;
/// Metres that handrails stand inside the edge of a step.
const RAIL_INSET: f64 = 0.04;

/// Stairs with all their measures; x across from 0 to `width`, y from 0 to `length`. They begin towards +y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    pub(super) design: Design,
    pub(super) width: f64,
    pub(super) length: f64,
    /// Metres across a flight.
    pub(super) lane: f64,
}

/// A step in the frame of its form.
pub(super) struct LocalStep {
    pub(super) corners: Vec<Point>,
    pub(super) is_landing: bool,
}

/// A handrail: step by step, the place and the number of the step under it.
pub(super) struct LocalRail {
    pub(super) points: Vec<(Point, usize)>,
    /// Whether a wall may stand along it.
    pub(super) is_outer: bool,
}

impl Design {
    /// The steps from floor to floor that a rise takes, the upper floor counted.
    pub(super) fn risers(&self, rise: f64) -> usize {
        let least = (rise / self.riser - 1e-9).ceil().max(3.0) as usize;
        match self.kind {
            // Both flights have as many.
            Kind::Dogleg => least.next_multiple_of(2),
            _ => least,
        }
    }

    /// The form for a flight of a width, as short as a rise allows.
    pub(super) fn form(self, lane: f64, rise: f64) -> Option<Form> {
        let risers = self.risers(rise);
        let run = |treads: usize| treads as f64 * self.going;
        let (width, length) = match self.kind {
            Kind::Dogleg => (2.0 * lane + GAP, run(risers / 2 - 1) + lane),
            Kind::Winding => (2.0 * lane + GAP, run(straight_treads(risers)?) + lane),
            Kind::Straight => (lane, run(risers - 1)),
            Kind::Quarter => {
                let (first, second) = around_corner(risers)?;
                (run(second) + lane, run(first) + lane)
            }
            Kind::Sideways => (lane, run(risers.checked_sub(1 + 2 * QUARTER_WINDERS)?) + 2.0 * lane),
            Kind::Spiral => (2.0 * lane, 2.0 * lane),
        };
        Some(Form { design: self, width, length, lane })
    }

    /// The form that takes a width of the floor, if flights as wide as that are usual.
    pub(super) fn across(self, width: f64, rise: f64) -> Option<Form> {
        let least = *self.lanes.last()?;
        let lane = match self.kind {
            Kind::Dogleg | Kind::Winding => ((width - GAP) / 2.0).min(WIDEST_LANE),
            Kind::Straight | Kind::Sideways => width,
            Kind::Quarter | Kind::Spiral => return None,
        };
        let is_one = matches!(self.kind, Kind::Straight | Kind::Sideways);
        let most = if is_one { WIDEST_LANE } else { f64::INFINITY };
        // Wells between two flights are no wider than these.
        let is_usual = lane >= least && lane <= most && width <= 4.0 * WIDEST_LANE;
        let form = is_usual.then(|| self.form(lane, rise)).flatten()?;
        Some(Form { width, ..form })
    }
}

/// The straight treads of each flight of stairs with steps that turn by half a turn, and those steps.
fn straight_treads(risers: usize) -> Option<usize> {
    let treads = risers.checked_sub(1)?;
    let winders = 2 * QUARTER_WINDERS - (treads % 2);
    Some(treads.checked_sub(winders)? / 2)
}

/// The straight treads before and after a corner.
fn around_corner(risers: usize) -> Option<(usize, usize)> {
    let straight = risers.checked_sub(1 + QUARTER_WINDERS)?;
    Some((straight.div_ceil(2), straight / 2))
}

impl Form {
    /// The edge that the first step begins at, the stairs on its left.
    pub(super) fn foot(&self) -> Segment {
        match self.design.kind {
            Kind::Spiral => Segment::new(
                self.spiral_at(self.spiral_start(), 0.0),
                self.spiral_at(self.spiral_start(), 1.0),
            ),
            Kind::Straight => segment((0.0, 0.0), (self.width, 0.0)),
            Kind::Sideways => segment((self.width, 0.0), (self.width, self.lane)),
            _ => segment((0.0, 0.0), (self.lane, 0.0)),
        }
    }

    /// The edge of the upper floor that the last step leads to, the stairs on its left.
    pub(super) fn head(&self) -> Segment {
        let (width, length, lane) = (self.width, self.length, self.lane);
        match self.design.kind {
            Kind::Dogleg | Kind::Winding => segment((width - lane, 0.0), (width, 0.0)),
            Kind::Straight => segment((width, length), (0.0, length)),
            Kind::Quarter | Kind::Sideways => segment((width, length - lane), (width, length)),
            Kind::Spiral => {
                let end = self.spiral_start() + TAU - SPIRAL_LANDING;
                Segment::new(self.spiral_at(end, 1.0), self.spiral_at(end, 0.0))
            }
        }
    }

    /// The edges of what they take of the floor in front of which one stands, before the first step and after the last.
    pub(super) fn approaches(&self) -> [Segment; 2] {
        match self.design.kind {
            Kind::Spiral => [segment((self.lane * 0.55, 0.0), (self.lane * 1.45, 0.0)); 2],
            _ => [self.foot(), self.head()],
        }
    }

    /// What they take of the floor, and of the floor above: corners, counter-clockwise.
    pub(super) fn ring(&self) -> Vec<Point> {
        let (width, length, lane) = (self.width, self.length, self.lane);
        let corners: &[(f64, f64)] = match self.design.kind {
            Kind::Dogleg | Kind::Winding => {
                &[(0.0, 0.0), (lane, 0.0), (width - lane, 0.0), (width, 0.0), (width, length), (0.0, length)]
            }
            Kind::Straight => &[(0.0, 0.0), (width, 0.0), (width, length), (0.0, length)],
            Kind::Quarter => &[
                (0.0, 0.0),
                (lane, 0.0),
                (lane, length - lane),
                (width, length - lane),
                (width, length),
                (0.0, length),
            ],
            Kind::Sideways => &[
                (0.0, 0.0),
                (width, 0.0),
                (width, lane),
                (width, length - lane),
                (width, length),
                (0.0, length),
            ],
            Kind::Spiral => return self.spiral_ring(),
        };
        corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    /// The boxes that nothing else may be in: low corner, high corner.
    pub(super) fn boxes(&self) -> Vec<[Point; 2]> {
        let (width, length, lane) = (self.width, self.length, self.lane);
        match self.design.kind {
            Kind::Quarter => vec![
                [Point::ZERO, Point::new(lane, length)],
                [Point::new(0.0, length - lane), Point::new(width, length)],
            ],
            _ => vec![[Point::ZERO, Point::new(width, length)]],
        }
    }

    /// The steps of a rise that is no more than that which the form was made for, and the handrails. The last step is the upper
    /// floor and is not among them.
    pub(super) fn steps(&self, rise: f64) -> (Vec<LocalStep>, Vec<LocalRail>) {
        let risers = self.design.risers(rise);
        match self.design.kind {
            Kind::Dogleg => self.dogleg(risers),
            Kind::Winding => self.winding(risers),
            Kind::Straight => self.straight(risers),
            Kind::Quarter => self.quarter(risers),
            Kind::Sideways => self.sideways(risers),
            Kind::Spiral => self.spiral(risers),
        }
    }

    fn dogleg(&self, risers: usize) -> (Vec<LocalStep>, Vec<LocalRail>) {
        let treads = risers / 2 - 1;
        let run = treads as f64 * self.design.going;
        let mut flights = Flights::default();
        flights.up(0.0, self.lane, (0.0, run), treads);
        let landing = [(0.0, run), (self.width, run), (self.width, self.length), (0.0, self.length)];
        let corners = landing.map(|(x, y)| Point::new(x, y)).to_vec();
        flights.steps.push(LocalStep { corners, is_landing: true });
        flights.down(self.width - self.lane, self.width, (run, 0.0), treads);
        let (inner, outer) = (self.lane - RAIL_INSET, RAIL_INSET);
        let far = self.width - self.lane + RAIL_INSET;
        flights.rail(0, treads, inner, false);
        flights.rail(treads + 1, risers - 1, far, false);
        flights.rail(0, treads, outer, true);
        flights.rail(treads + 1, risers - 1, self.width - RAIL_INSET, true);
        let back = self.length - RAIL_INSET;
        flights.around(
            treads,
            &[(outer, run), (outer, back), (self.width - outer, back), (self.width - outer, run)],
        );
        if self.width - 2.0 * self.lane > 2.0 * GAP {
            flights.between(treads, [(inner, run + RAIL_INSET), (far, run + RAIL_INSET)]);
        }
        (flights.steps, flights.rails)
    }

    fn straight(&self, risers: usize) -> (Vec<LocalStep>, Vec<LocalRail>) {
        let mut flights = Flights::default();
        flights.up(0.0, self.width, (0.0, self.length), risers - 1);
        flights.rail(0, risers - 1, RAIL_INSET, true);
        flights.rail(0, risers - 1, self.width - RAIL_INSET, true);
        (flights.steps, flights.rails)
    }

    fn winding(&self, risers: usize) -> (Vec<LocalStep>, Vec<LocalRail>) {
        let treads = straight_treads(risers).unwrap_or_default();
        let run = treads as f64 * self.design.going;
        let winders = risers - 1 - 2 * treads;
        let mut flights = Flights::default();
        flights.up(0.0, self.lane, (0.0, run), treads);
        let turn = Turn {
            center: Point::new(self.width / 2.0, run),
            inner: (self.width / 2.0 - self.lane).max(0.02),
            low: Point::new(0.0, run),
            high: Point::new(self.width, self.length),
        };
        flights.turn(&turn, (PI, 0.0), winders);
        flights.down(self.width - self.lane, self.width, (run, 0.0), treads);
        flights.rail(0, treads, self.lane - RAIL_INSET, false);
        flights.rail(treads + winders, risers - 1, self.width - self.lane + RAIL_INSET, false);
        flights.rail(0, treads, RAIL_INSET, true);
        flights.rail(treads + winders, risers - 1, self.width - RAIL_INSET, true);
        (flights.steps, flights.rails)
    }

    fn quarter(&self, risers: usize) -> (Vec<LocalStep>, Vec<LocalRail>) {
        let (first, second) = around_corner(risers).unwrap_or_default();
        let (run, lane) = (self.length - self.lane, self.lane);
        let mut flights = Flights::default();
        flights.up(0.0, lane, (0.0, run), first);
        let turn = Turn {
            center: Point::new(lane, run),
            inner: 0.02,
            low: Point::new(0.0, run),
            high: Point::new(lane, self.length),
        };
        flights.turn(&turn, (PI, FRAC_PI_2), QUARTER_WINDERS);
        let going = (self.width - lane) / second.max(1) as f64;
        for tread in 0..second {
            let (from, to) = (lane + tread as f64 * going, lane + (tread + 1) as f64 * going);
            flights.tread([(from, self.length), (from, run), (to, run), (to, self.length)]);
        }
        flights.rail(0, first, lane - RAIL_INSET, false);
        flights.rail(0, first, RAIL_INSET, true);
        let start = first + QUARTER_WINDERS;
        for (y, is_outer) in [(run + RAIL_INSET, false), (self.length - RAIL_INSET, true)] {
            let at = |tread: usize| Point::new(lane + (tread as f64 + 0.5) * going, y);
            let points = (0..second).map(|tread| (at(tread), start + tread)).collect();
            flights.rails.push(LocalRail { points, is_outer });
        }
        (flights.steps, flights.rails)
    }

    fn sideways(&self, risers: usize) -> (Vec<LocalStep>, Vec<LocalRail>) {
        let (lane, length) = (self.lane, self.length);
        let straight = risers.saturating_sub(1 + 2 * QUARTER_WINDERS);
        let turn = |from: f64| Turn {
            center: Point::new(lane, if from == 0.0 { lane } else { from }),
            inner: 0.02,
            low: Point::new(0.0, from),
            high: Point::new(lane, from + lane),
        };
        let mut flights = Flights::default();
        flights.turn(&turn(0.0), (-FRAC_PI_2, -PI), QUARTER_WINDERS);
        flights.up(0.0, lane, (lane, length - lane), straight);
        flights.turn(&turn(length - lane), (PI, FRAC_PI_2), QUARTER_WINDERS);
        let flight = (QUARTER_WINDERS, QUARTER_WINDERS + straight);
        flights.rail(flight.0, flight.1, lane - RAIL_INSET, true);
        flights.rail(flight.0, flight.1, RAIL_INSET, true);
        (flights.steps, flights.rails)
    }

    fn spiral(&self, risers: usize) -> (Vec<LocalStep>, Vec<LocalRail>) {
        let treads = risers - 1;
        let angle = (TAU - SPIRAL_LANDING) / treads as f64;
        let start = self.spiral_start();
        let at = |tread: f64, share: f64| self.spiral_at(start + tread * angle, share);
        let inner = POST / self.lane;
        let mut flights = Flights::default();
        for tread in 0..treads {
            let (from, to) = (tread as f64, (tread + 1) as f64);
            let corners = vec![at(from, inner), at(from, 1.0), at(to, 1.0), at(to, inner)];
            flights.steps.push(LocalStep { corners, is_landing: false });
        }
        let rail = (0..treads).map(|tread| (at(tread as f64 + 0.5, 1.0 - RAIL_INSET / self.lane), tread));
        flights.rails.push(LocalRail { points: rail.collect(), is_outer: false });
        (flights.steps, flights.rails)
    }

    /// The angle at which a spiral begins; its landing is around the angle of −y.
    fn spiral_start(&self) -> f64 {
        -FRAC_PI_2 + SPIRAL_LANDING / 2.0
    }

    /// A place of a spiral: at an angle, and a share of its radius from the middle.
    fn spiral_at(&self, angle: f64, share: f64) -> Point {
        Point::splat(self.lane) + direction(angle) * (self.lane * share)
    }

    fn spiral_ring(&self) -> Vec<Point> {
        /// Corners of the arc.
        const CORNERS: usize = 18;
        let step = (TAU - SPIRAL_LANDING) / (CORNERS - 1) as f64;
        let arc = (0..CORNERS).map(|corner| self.spiral_at(self.spiral_start() + corner as f64 * step, 1.0));
        std::iter::once(Point::splat(self.lane)).chain(arc).collect()
    }
}

fn segment(start: (f64, f64), end: (f64, f64)) -> Segment {
    Segment::new(Point::new(start.0, start.1), Point::new(end.0, end.1))
}

/// A part of the floor in which steps turn clockwise about a point.
struct Turn {
    center: Point,
    /// Metres around the centre that no step reaches into.
    inner: f64,
    low: Point,
    high: Point,
}

impl Turn {
    /// Where the ray at an angle leaves the box.
    fn outer(&self, angle: f64) -> Point {
        let along = direction(angle);
        let reach = |axis: usize| {
            let wall = if along[axis] > 0.0 { self.high[axis] } else { self.low[axis] };
            if along[axis].abs() < 1e-9 { f64::INFINITY } else { (wall - self.center[axis]) / along[axis] }
        };
        (self.center + along * reach(0).min(reach(1))).clamp(self.low, self.high)
    }

    fn inner(&self, angle: f64) -> Point {
        self.center + direction(angle) * self.inner
    }

    /// The corner of the box between two angles, the first the greater.
    fn corner(&self, from: f64, to: f64) -> Option<Point> {
        let (low, high) = (self.low, self.high);
        let corners = [Point::new(low.x, high.y), high, Point::new(high.x, low.y), low];
        corners.into_iter().find(|corner| {
            let away = *corner - self.center;
            let angle = libm::atan2(away.y, away.x);
            angle < from - 1e-6 && angle > to + 1e-6
        })
    }
}

/// Steps being laid one after the other.
#[derive(Default)]
struct Flights {
    steps: Vec<LocalStep>,
    rails: Vec<LocalRail>,
}

impl Flights {
    fn tread(&mut self, corners: [(f64, f64); 4]) {
        let corners = corners.map(|(x, y)| Point::new(x, y)).to_vec();
        self.steps.push(LocalStep { corners, is_landing: false });
    }

    /// A flight towards +y.
    fn up(&mut self, left: f64, right: f64, (from, to): (f64, f64), treads: usize) {
        let going = (to - from) / treads.max(1) as f64;
        for tread in 0..treads {
            let (front, back) = (from + tread as f64 * going, from + (tread + 1) as f64 * going);
            self.tread([(left, front), (right, front), (right, back), (left, back)]);
        }
    }

    /// A flight towards −y, from `from` down to `to`.
    fn down(&mut self, left: f64, right: f64, (from, to): (f64, f64), treads: usize) {
        let going = (from - to) / treads.max(1) as f64;
        for tread in 0..treads {
            let (front, back) = (from - tread as f64 * going, from - (tread + 1) as f64 * going);
            self.tread([(right, front), (left, front), (left, back), (right, back)]);
        }
    }

    /// Steps that turn clockwise.
    fn turn(&mut self, turn: &Turn, (from, to): (f64, f64), count: usize) {
        let angle = |step: usize| from + (to - from) * step as f64 / count as f64;
        for step in 0..count {
            let (front, back) = (angle(step), angle(step + 1));
            let mut corners = vec![turn.outer(front), turn.inner(front), turn.inner(back), turn.outer(back)];
            corners.extend(turn.corner(front, back));
            self.steps.push(LocalStep { corners, is_landing: false });
        }
    }

    /// A handrail along straight treads at an x.
    fn rail(&mut self, from: usize, to: usize, x: f64, is_outer: bool) {
        let middle = |step: &LocalStep| {
            step.corners.iter().map(|corner| corner.y).sum::<f64>() / step.corners.len() as f64
        };
        let points = (from..to).map(|step| (Point::new(x, middle(&self.steps[step])), step)).collect();
        self.rails.push(LocalRail { points, is_outer });
    }

    /// Handrails around a landing, one for each side.
    fn around(&mut self, landing: usize, corners: &[(f64, f64)]) {
        for side in corners.windows(2) {
            let points = side.iter().map(|&(x, y)| (Point::new(x, y), landing)).collect();
            self.rails.push(LocalRail { points, is_outer: true });
        }
    }

    /// A handrail between two flights that are apart.
    fn between(&mut self, landing: usize, ends: [(f64, f64); 2]) {
        let points = ends.map(|(x, y)| (Point::new(x, y), landing)).to_vec();
        self.rails.push(LocalRail { points, is_outer: false });
    }
}
