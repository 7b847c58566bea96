//! Pieces that hang over or beside an object, or continue a built-in run, need a wall behind them.

use crate::catalog::{Side, Size};
use crate::geometry::Point;
use crate::layout::body::Pose;
use crate::layout::constants::HANGING_GAP;
use crate::layout::place::{AgentIndex, ParentPart, Place};

use super::Environment;

impl Environment<'_> {
    /// Whether something that hangs over or beside its parent (a mirror over a basin, a cupboard over a worktop)
    /// has no wall behind it, or a built-in piece where its parent has one: its back must lie on one wall, clear of
    /// that wall's openings.
    pub(super) fn hangs_in_the_air(&self, agent: AgentIndex, place: &Place) -> bool {
        let ParentPart::Agent(parent) = place.parent else { return false };
        let Some(rest) = self.agents[parent].rest() else { return true };
        let (holder, size) = (&self.agents[parent], self.agents[agent].size);
        let carried_from = match place.side {
            Side::Below => return false,
            Side::Above => self.class(parent).offer(Side::Above).surface.unwrap_or(holder.size.height),
            Side::Front | Side::Back | Side::Left | Side::Right => 0.0,
        };
        let is_above = place.pose.elevation > rest.pose.elevation + carried_from + HANGING_GAP;
        let hangs = is_above || (place.side != Side::Above && self.hangs_on_a_wall(parent));
        // A run of built-in pieces goes on along the wall, not past its end.
        let continues = || self.is_built_in(agent) && self.is_built_in(parent) && place.side != Side::Above;
        (hangs || (continues() && self.has_wall_behind(&rest.pose, holder.size)))
            && !self.has_wall_behind(&place.pose, size)
    }

    /// Whether a back lies on one wall, clear of that wall's openings.
    fn has_wall_behind(&self, pose: &Pose, size: Size) -> bool {
        let back = pose.place(Point::new(0.0, size.depth / 2.0));
        let room = self.brief.surroundings.room;
        room.walls.iter().enumerate().any(|(index, wall)| {
            let at = (back - wall.start).dot(wall.direction());
            let (from, to) = (at - size.width / 2.0, at + size.width / 2.0);
            let is_behind = (back - wall.start).dot(wall.normal()).abs() <= HANGING_GAP
                // A cosine: the front faces within 7 degrees of straight out of the wall.
                && wall.normal().dot(pose.front()) > 1.0 - HANGING_GAP
                && from >= -HANGING_GAP
                && to <= wall.length() + HANGING_GAP;
            is_behind
                && !room.openings.iter().filter(|side| side.wall == index).any(|side| {
                    let opening = &self.brief.surroundings.level.openings[side.opening];
                    from < side.to
                        && to > side.from
                        && pose.elevation < opening.top
                        && pose.elevation + size.height > opening.bottom
                })
        })
    }

    /// Whether a resting agent, or the one that it hangs beside, hangs on a wall: what joins a row of urinals or
    /// cupboards needs the wall as they do.
    fn hangs_on_a_wall(&self, agent: AgentIndex) -> bool {
        let mut agent = agent;
        while let Some(rest) = self.agents[agent].rest() {
            match rest.parent {
                ParentPart::Wall(_) => return rest.pose.elevation > HANGING_GAP,
                ParentPart::Agent(parent) if rest.side != Side::Above && rest.side != Side::Below => {
                    let base = self.agents[parent].rest().map_or(0.0, |parent| parent.pose.elevation);
                    if rest.pose.elevation > base + HANGING_GAP {
                        return true;
                    }
                    agent = parent;
                }
                _ => return false,
            }
        }
        false
    }
}
