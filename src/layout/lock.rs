//! Locked objects: somebody put them where they are; they stand there before anybody searches, and nobody sends them away.

use crate::catalog::{Catalog, ClassIndex, Side};
use crate::geometry::Point;

use super::agent::{AgentIndex, ParentPart};
use super::body::Pose;
use super::environment::{Environment, Place};
use super::furnished::Parent;
use super::programme::Piece;

/// An object at a place that is not searched for. It may stand where the layout would put nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Lock {
    /// Index into the catalogue's classes.
    pub class: ClassIndex,
    /// Counts the objects of the class; where the programme asks for none of this number there is one more.
    pub number: u32,
    /// Which of the class's variants; the one that is drawn where nothing is said.
    pub variant: Option<u32>,
    /// What it stands on or belongs to.
    pub on: LockSupport,
    /// The side of that which it touches.
    pub side: Side,
    /// Middle of its underside: in the level's plan frame, or in the frame of the object that it stands on (x to its
    /// right, y to its back).
    pub position: Point,
    /// Metres above the floor, or above the underside of that object; its top where nothing is said.
    pub elevation: Option<f64>,
    /// Radians counter-clockwise, in the same frame.
    pub angle: f64,
}

/// What a locked object stands on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LockSupport {
    /// A part of the room; not [`Parent::Object`].
    Part(Parent),
    /// Another object, by class and number; while it is not there, the locked object searches as others do.
    Object(ClassIndex, u32),
}

/// The pieces of a room with those that are locked: these have the variant that was asked for.
pub(crate) fn add_pieces(pieces: &mut Vec<Piece>, locks: &[Lock], catalog: &Catalog) {
    for lock in locks {
        let is_it = |piece: &&mut Piece| piece.class == lock.class && piece.number == lock.number;
        let known = pieces.iter_mut().find(is_it);
        let variant = lock.variant.filter(|&variant| variant < catalog.classes[lock.class].variant_count());
        match (known, variant) {
            (Some(piece), Some(variant)) => piece.variant = variant,
            (Some(_), None) => {}
            (None, variant) => pieces.push(Piece {
                class: lock.class,
                number: lock.number,
                variant: variant.unwrap_or(0),
                is_required: false,
                is_fill: false,
            }),
        }
    }
}

/// Lets the locked agents rest that stand on the room or on each other.
pub(crate) fn settle_locked(environment: &mut Environment<'_>) {
    let locked: Vec<AgentIndex> =
        (0..environment.agents.len()).filter(|&agent| is_locked(environment, agent)).collect();
    let mut has_settled = true;
    while has_settled {
        has_settled = false;
        for &agent in &locked {
            if environment.agents[agent].rest().is_none()
                && let Some(place) = locked_place(environment, agent)
            {
                environment.settle(agent, &place);
                has_settled = true;
            }
        }
    }
}

/// Whether somebody put an agent where it stands.
pub(crate) fn is_locked(environment: &Environment<'_>, agent: AgentIndex) -> bool {
    lock(environment, agent).is_some()
}

/// Where a locked agent stands; `None` while what it stands on is not there.
pub(crate) fn locked_place(environment: &Environment<'_>, agent: AgentIndex) -> Option<Place> {
    let lock = lock(environment, agent)?;
    let at = |parent, pose| Place { pose, parent, side: lock.side };
    match lock.on {
        LockSupport::Part(part) => {
            let pose = Pose::new(lock.position, lock.elevation.unwrap_or(0.0), lock.angle);
            Some(at(part_of(environment, part)?, pose))
        }
        LockSupport::Object(class, number) => {
            let is_parent = |parent: &AgentIndex| environment.agents[*parent].piece.number == number;
            let parent = environment.resting[class].iter().copied().find(is_parent)?;
            let under = environment.agents[parent].rest()?.pose;
            let elevation = lock.elevation.unwrap_or(environment.agents[parent].size.height);
            let pose =
                Pose::new(under.place(lock.position), under.elevation + elevation, under.angle + lock.angle);
            Some(at(ParentPart::Agent(parent), pose))
        }
    }
}

fn lock<'e>(environment: &'e Environment<'_>, agent: AgentIndex) -> Option<&'e Lock> {
    let piece = environment.agents[agent].piece;
    environment.locks.iter().find(|lock| lock.class == piece.class && lock.number == piece.number)
}

fn part_of(environment: &Environment<'_>, part: Parent) -> Option<ParentPart> {
    match part {
        Parent::Floor => Some(ParentPart::Floor),
        Parent::Ceiling => Some(ParentPart::Ceiling),
        Parent::Wall(wall) => Some(ParentPart::Wall(wall)),
        Parent::Column(column) => Some(ParentPart::Column(column)),
        Parent::Opening(opening) => {
            let mut sides = environment.surroundings.room.openings.iter();
            sides.position(|side| side.opening == opening).map(ParentPart::Opening)
        }
        Parent::Object(_) => None,
    }
}
