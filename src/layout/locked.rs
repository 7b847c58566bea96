//! Locked agents: they rest before anybody searches, and nobody sends them away.

use super::body::Pose;
use super::environment::Environment;
use super::furnished::Parent;
use super::lock::{Lock, LockSupport};
use super::place::{AgentIndex, ParentPart, Place};

/// Lets the locked agents rest that stand on the room or on each other.
pub(crate) fn settle_locked(environment: &mut Environment<'_>) {
    let locked: Vec<AgentIndex> =
        (0..environment.agents.len()).filter(|&agent| is_locked(environment, agent)).collect();
    // In rounds, for a locked object may stand on one that comes later in the programme.
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
            // On top, where nothing is said: most of what somebody puts on something lies there.
            let elevation = lock.elevation.unwrap_or(environment.agents[parent].size.height);
            let pose =
                Pose::new(under.place(lock.position), under.elevation + elevation, under.angle + lock.angle);
            Some(at(ParentPart::Agent(parent), pose))
        }
    }
}

fn lock<'e>(environment: &'e Environment<'_>, agent: AgentIndex) -> Option<&'e Lock> {
    let piece = environment.agents[agent].piece;
    environment.brief.locks.iter().find(|lock| lock.class == piece.class && lock.number == piece.number)
}

fn part_of(environment: &Environment<'_>, part: Parent) -> Option<ParentPart> {
    match part {
        Parent::Floor => Some(ParentPart::Floor),
        Parent::Ceiling => Some(ParentPart::Ceiling),
        Parent::Wall(wall) => Some(ParentPart::Wall(wall)),
        Parent::Column(column) => Some(ParentPart::Column(column)),
        Parent::Opening(opening) => {
            let mut sides = environment.brief.surroundings.room.openings.iter();
            sides.position(|side| side.opening == opening).map(ParentPart::Opening)
        }
        Parent::Object(_) => None,
    }
}
