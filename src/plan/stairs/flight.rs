//! Stairs that lead from one level to the next.

use crate::geometry::{Point, Polygon, Segment};

/// What leads up and down in a room of stairs.
#[derive(Clone, Debug, PartialEq)]
pub struct Stairs {
    /// Index into the rooms of the level.
    pub room: usize,
    /// The steps from this level's floor to that of the level above.
    pub up: Option<Flight>,
    /// Where the steps of the level below come through this level's floor.
    pub well: Option<Well>,
}

/// Steps from the floor of a level to that of the level above, in the level's frame. The last step is that floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    /// The steps and landings, the lowest first.
    pub steps: Vec<Step>,
    /// What stays open for them above: in the ceiling, and in the floor of the level above.
    pub opening: Polygon,
    /// Handrails on the sides where no wall is.
    pub handrails: Vec<Vec<RailPoint>>,
}

impl Stairs {
    /// What they take of the floor on which nobody walks: under the steps up, or the hole that one comes up through.
    #[must_use]
    pub fn footprint(&self) -> Option<&Polygon> {
        let flight = self.up.as_ref().map(|flight| &flight.opening);
        flight.or(self.well.as_ref().map(|well| &well.opening))
    }
}

impl Flight {
    /// The edges that one steps over on the way up, but for that of the upper floor.
    #[must_use]
    pub fn nosings(&self) -> Vec<Segment> {
        self.steps.iter().map(|step| Segment::new(step.corners[0], step.corners[1])).collect()
    }

    /// Metres from the floor where it begins to the one where it ends.
    #[must_use]
    pub fn rise(&self) -> f64 {
        self.steps.last().map_or(0.0, |step| step.top + step.rise)
    }
}

/// A step or a landing.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Its tread seen from above: convex, counter-clockwise; from the first corner to the second is the edge that one steps over.
    pub corners: Vec<Point>,
    /// Metres of its top above the floor.
    pub top: f64,
    /// Metres of its top above the step before it.
    pub rise: f64,
    /// Whether it is level underneath too, as landings are; else its underside slopes with the flight.
    pub is_landing: bool,
}

/// A place under a handrail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RailPoint {
    /// Where it is.
    pub at: Point,
    /// Metres of what one stands on there above the floor.
    pub foot: f64,
}

/// A hole in the floor, in the level's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Well {
    /// The hole.
    pub opening: Polygon,
    /// Its edges with a balustrade: those without a wall at which no step begins or ends.
    pub guards: Vec<Segment>,
    /// The edges of the steps that are seen through it.
    pub nosings: Vec<Segment>,
}
