//! The fitted units of a room, by the part that they play.

use crate::catalog::FittedPart;
use crate::layout::agent::State;
use crate::layout::arrange::sizes_by;
use crate::layout::environment::Environment;
use crate::layout::locked::is_locked;
use crate::layout::place::AgentIndex;

/// Metres from the back of the deepest slim unit to its front; usual ones are 0.6 m deep.
const SLIM: f64 = 0.53;

/// How deep the units of a row are: all are of one depth, so that their fronts are in line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Depth {
    /// As they are drawn.
    Usual,
    /// As slim as they are made, for kitchens in which nobody could stand before the usual ones.
    Slim,
}

/// One of the widths that a unit is made in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Width {
    /// Metres along the row.
    pub(super) metres: f64,
    /// The variant of its class that is so wide.
    pub(super) variant: u32,
}

/// The widest of some widths that fits, whatever was drawn.
pub(super) fn widest_within(widths: &[Width], metres: f64) -> Option<Width> {
    let fitting = widths.iter().copied().filter(|width| width.metres <= metres);
    fitting.max_by(|a, b| a.metres.total_cmp(&b.metres))
}

/// An agent that stands in a row.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    /// Who.
    pub(super) agent: AgentIndex,
    /// What it is there for.
    pub(super) part: FittedPart,
    /// The width that was drawn, then the others, widest first.
    pub(super) widths: Vec<Width>,
    /// The slim ones of a filler, which pass what comes into the depth of a row at its end; empty for others.
    pub(super) slim: Vec<Width>,
    /// Whether the room is wrong without it.
    pub(super) is_required: bool,
    /// Whether it only fills what wall is left.
    pub(super) is_fill: bool,
}

impl Unit {
    /// The width that was drawn if it fits, else the widest that does.
    pub(super) fn width_within(&self, metres: f64) -> Option<Width> {
        self.widths.iter().copied().find(|width| width.metres <= metres)
    }

    /// The narrowest width.
    pub(super) fn narrowest(&self) -> Width {
        let narrowest = self.widths.iter().copied().min_by(|a, b| a.metres.total_cmp(&b.metres));
        narrowest.expect("a class has a size")
    }
}

/// The units of a room, those of a part in the order of the programme. A unit is named by its index.
#[derive(Clone)]
pub(super) struct Units {
    units: Vec<Unit>,
}

impl Units {
    /// Those that nobody locked, in the widths that they have in a depth.
    pub(super) fn of(environment: &Environment<'_>, depth: Depth) -> Self {
        let mut units: Vec<Unit> = (0..environment.agents.len())
            .filter(|&agent| {
                environment.agents[agent].state == State::Search && !is_locked(environment, agent)
            })
            .filter_map(|agent| Some((agent, environment.class(agent).fitted?)))
            .map(|(agent, part)| unit(environment, agent, part, depth))
            .collect();
        // Stable; those that only fill come after those that are asked for.
        units.sort_by_key(|unit| (unit.part, unit.is_fill));
        Self { units }
    }

    /// Whether there is nothing to make a row of: it begins with a sink or a hob and holds more than that.
    pub(super) fn is_no_row(&self) -> bool {
        let has = |part| self.units.iter().any(|unit| unit.part == part);
        let is_low = |unit: &&Unit| !matches!(unit.part, FittedPart::WallUnit | FittedPart::Filler);
        let low = self.units.iter().filter(is_low).count();
        low < 2 || !(has(FittedPart::Sink) || has(FittedPart::Hob))
    }

    /// A unit by its index.
    pub(super) fn unit(&self, index: usize) -> &Unit {
        &self.units[index]
    }

    /// The indices of all units.
    pub(super) fn indices(&self) -> core::ops::Range<usize> {
        0..self.units.len()
    }

    /// Whether some that stand are slim.
    pub(super) fn are_slim(&self, environment: &Environment<'_>) -> bool {
        let is_slim = |unit: &Unit| environment.class(unit.agent).size(unit.widths[0].variant).depth <= SLIM;
        self.units.iter().any(|unit| unit.part != FittedPart::WallUnit && is_slim(unit))
    }

    /// All agents.
    pub(super) fn agents(&self) -> impl Iterator<Item = AgentIndex> {
        self.units.iter().map(|unit| unit.agent)
    }

    /// The units of a part, with their indices.
    pub(super) fn of_part(&self, part: FittedPart) -> impl Iterator<Item = (usize, &Unit)> {
        self.units.iter().enumerate().filter(move |(_, unit)| unit.part == part)
    }

    /// The units for corners.
    pub(super) fn corners(&self) -> impl Iterator<Item = (usize, &Unit)> {
        self.of_part(FittedPart::Corner)
    }

    /// Their metres along both walls.
    pub(super) fn corner_widths(&self) -> Vec<f64> {
        self.corners().map(|(_, unit)| unit.narrowest().metres).collect()
    }

    /// Metres from the backs of low units to their fronts.
    pub(super) fn depth(&self, environment: &Environment<'_>) -> f64 {
        let low = self.units.iter().filter(|unit| unit.part != FittedPart::WallUnit);
        low.map(|unit| environment.agents[unit.agent].size.depth).fold(0.0, f64::max)
    }
}

fn unit(environment: &Environment<'_>, agent: AgentIndex, part: FittedPart, depth: Depth) -> Unit {
    let (class, piece) = (environment.class(agent), environment.agents[agent].piece);
    let mut variants = sizes_by(environment, agent, |size| size.width);
    let is_slim = |variant: u32| class.size(variant).depth <= SLIM;
    let width = |variant: u32| Width { metres: class.size(variant).width, variant };
    let is_filler = part == FittedPart::Filler;
    let slim = variants.iter().copied().filter(|&variant| is_filler && is_slim(variant)).map(width).collect();
    let is_of_depth = |&variant: &u32| is_slim(variant) == (depth == Depth::Slim);
    // What is made in one of the depths only, as wall units are, goes with both.
    if variants.iter().any(is_of_depth) {
        variants.retain(is_of_depth);
    }
    // Stable: the width that was drawn moves to the front.
    let drawn = class.size(piece.variant).width;
    let is_other_width = |variant: u32| class.size(variant).width.total_cmp(&drawn).is_ne();
    variants.sort_by_key(|&variant| (variant != piece.variant, is_other_width(variant)));
    let widths = variants.into_iter().map(width).collect();
    Unit { agent, part, widths, slim, is_required: piece.is_required, is_fill: piece.is_fill }
}
