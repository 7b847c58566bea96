//! Agents: pieces of furniture that arrange themselves (section 3.2).

use crate::catalog::{Side, Size};
use crate::geometry::Point;

use super::body::Pose;
use super::furnished::RemovalReason;
use super::place::{AgentIndex, ParentPart, Place};
use super::programme::Piece;

/// One piece of furniture.
#[derive(Clone, Debug)]
pub(crate) struct Agent {
    /// The piece of the programme.
    pub(crate) piece: Piece,
    /// Size of its variant.
    pub(crate) size: Size,
    /// Its state.
    pub(crate) state: State,
    /// Children on each of its sides, by [`Side::index`].
    pub(crate) taken: [u32; 6],
    /// Metres that they occupy along each side.
    pub(crate) occupied: [f64; 6],
    /// The agents that stand on or belong to it.
    pub(crate) children: Vec<AgentIndex>,
    /// Its solid parts, as a range of [`super::environment::Environment::bodies`].
    pub(crate) bodies: std::ops::Range<usize>,
    /// Its clearances, as a range of [`super::environment::Environment::clearances`].
    pub(crate) clearances: std::ops::Range<usize>,
    /// Its box where others could slide under it, as a range of the environment's roofs; one or none.
    pub(crate) roofs: std::ops::Range<usize>,
    /// How often it has searched, for the random stream.
    pub(crate) searches: u32,
    /// Whether it was sent away from the only way to something.
    pub(crate) is_in_the_way: bool,
    /// The suggestion whose place it took, by index, until it is sent away.
    pub(crate) suggestion: Option<usize>,
    /// In how many earlier attempts the room missed it, or what stands by it: who is urgent searches first.
    pub(crate) urgency: u32,
}

/// The states of figure 3, and what is left of an agent without a parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum State {
    /// Is not asked for, unless something changes: it stands in for a piece that is there, or would carry something that is
    /// not.
    Unasked,
    /// Looks for a parent. (Arranging happens within one step: a candidate is tried as soon as it is found.)
    Search,
    /// Stands where it is.
    Rest(Rest),
    /// Found no parent.
    Removed(RemovalReason),
}

/// Where a resting agent is, and by whom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rest {
    /// Where it stands.
    pub(crate) pose: Pose,
    /// The object or room part that it stands on or belongs to.
    pub(crate) parent: ParentPart,
    /// The parent's side that it touches.
    pub(crate) side: Side,
    /// Metres that it takes along that side.
    pub(crate) extent: f64,
}

impl Rest {
    /// The place that it took.
    pub(crate) fn place(&self) -> Place {
        Place { pose: self.pose, parent: self.parent, side: self.side }
    }
}

impl Agent {
    /// A searching agent for a piece.
    pub(crate) fn new(piece: Piece, size: Size) -> Self {
        Self {
            piece,
            size,
            state: if piece.substitute_for.is_some() { State::Unasked } else { State::Search },
            taken: [0; 6],
            occupied: [0.0; 6],
            children: Vec::new(),
            bodies: 0..0,
            clearances: 0..0,
            roofs: 0..0,
            searches: 0,
            is_in_the_way: false,
            suggestion: None,
            urgency: 0,
        }
    }

    /// Where it rests, if it does.
    pub(crate) fn rest(&self) -> Option<&Rest> {
        match &self.state {
            State::Rest(rest) => Some(rest),
            State::Unasked | State::Search | State::Removed(_) => None,
        }
    }

    /// Half of its extent along a direction of the plan, turned as in `right`.
    pub(crate) fn half_extent(size: Size, right: Point, along: Point) -> f64 {
        // The support function of a rectangle: half of each side, as far as it points along.
        (size.width * right.dot(along).abs() + size.depth * right.perp().dot(along).abs()) / 2.0
    }
}
