//! Names of agents, room parts and wishes, for explanations.

use crate::catalog::{ParentName, RelationKind};
use crate::layout::environment::Environment;
use crate::layout::place::AgentIndex;
use crate::layout::rules::Measured;
use crate::layout::trace::Obstacle;
use crate::plan::OpeningKind;

/// The word of a kind of wish.
pub(super) fn relation_word(kind: RelationKind) -> &'static str {
    match kind {
        RelationKind::Faces => "faces",
        RelationKind::Sees => "sees",
        RelationKind::Opposite => "opposite",
        RelationKind::Near => "near",
        RelationKind::AwayFrom => "away from",
        RelationKind::NotBefore => "not before",
        RelationKind::Beside => "beside",
        RelationKind::AlignedWith => "aligned with",
        RelationKind::ClearOf => "clear of",
    }
}

/// A room part, a group, or the classes that are meant.
pub(super) fn target_name(environment: &Environment<'_>, target: &ParentName) -> String {
    match target {
        ParentName::Classes(classes) => environment.brief.catalog.class_names(classes),
        part => part_name(part).to_owned(),
    }
}

fn part_name(part: &ParentName) -> &'static str {
    match part {
        ParentName::Floor => "floor",
        ParentName::Ceiling => "ceiling",
        ParentName::Wall => "wall",
        ParentName::Door => "door",
        ParentName::Window => "window",
        ParentName::Column => "column",
        ParentName::Classes(_) => "object",
    }
}

/// The object or room part that decides about a wish.
pub(super) fn decider(environment: &Environment<'_>, target: &ParentName, measured: &Measured) -> String {
    let surroundings = &environment.brief.surroundings;
    let opening = |is_window: bool| {
        let all = surroundings.room.openings.iter().map(|side| &surroundings.level.openings[side.opening]);
        all.filter(|opening| (opening.kind == OpeningKind::Window) == is_window).nth(measured.index)
    };
    let found = match target {
        ParentName::Classes(classes) => {
            environment.resting_of(classes).nth(measured.index).map(|agent| id(environment, agent))
        }
        ParentName::Window => opening(true).map(|opening| format!("window:{}", opening.id)),
        ParentName::Door => opening(false).map(|opening| format!("door:{}", opening.id)),
        ParentName::Wall => Some(format!("wall.{}", measured.index)),
        ParentName::Floor | ParentName::Ceiling | ParentName::Column => None,
    };
    found.unwrap_or_else(|| part_name(target).to_owned())
}

/// `<class>.<number>`.
pub(super) fn id(environment: &Environment<'_>, agent: AgentIndex) -> String {
    format!("{}.{}", environment.class(agent).id, environment.agents[agent].piece.number)
}

/// An object's id, a room part, or what is wrong with a place.
pub(super) fn obstacle_name(environment: &Environment<'_>, agent: AgentIndex, obstacle: Obstacle) -> String {
    let object = |other| id(environment, other);
    match obstacle {
        Obstacle::Body(other) => object(other),
        Obstacle::ClearanceOf(other) => format!("space before {}", object(other)),
        Obstacle::InOwnClearance(other) => format!("{} in its own space", object(other)),
        Obstacle::WallInOwnClearance(wall) => format!("wall.{wall} in its own space"),
        Obstacle::OwnClearanceOutside => "its own space beyond the walls".to_owned(),
        Obstacle::ColumnInOwnClearance => "a column in its own space".to_owned(),
        Obstacle::Wall(wall) => format!("wall.{wall}"),
        Obstacle::BeyondWalls => "beyond the walls".to_owned(),
        Obstacle::Column => "a column".to_owned(),
        Obstacle::Opening(index) => {
            format!("door:{}", environment.brief.surroundings.level.openings[index].id)
        }
        Obstacle::Way => "the only way".to_owned(),
        Obstacle::WindowBehind => "a window behind it".to_owned(),
        Obstacle::Seat => "the place of a seat".to_owned(),
        Obstacle::OwnComfort => "its own space".to_owned(),
        Obstacle::NoWall => "no wall behind it".to_owned(),
        Obstacle::Height => "floor or ceiling".to_owned(),
        Obstacle::Relation(index) => {
            let relation = &environment.class(agent).relations[index];
            let target = target_name(environment, &relation.target);
            format!("{} {target}", relation_word(relation.kind))
        }
    }
}
