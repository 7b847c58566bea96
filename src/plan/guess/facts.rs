//! The facts about a room that guesses rest on.

use std::collections::BTreeSet;

use super::GuessRule;
use crate::document::printable;
use crate::geometry::Polygon;
use crate::plan::clean::mean_width;
use crate::plan::{Level, OpeningKind, Room, Wall, WallKind};

/// Share of the rooms of a level that must have a way in before a room without one is taken to be closed: many maps
/// draw few doors.
const DOORED_SHARE: f64 = 0.75;
/// Square metres below which a room need not have a way in: ducts say nothing of how a plan draws doors.
const CLOSET: f64 = 1.5;
/// Share of a room's border that is a railing where it lies in the open air.
const RAILED_SHARE: f64 = 0.2;
/// Metres of width below which the width is reported as a reason.
const NARROW: f64 = 2.0;

/// The facts about a room.
pub(super) struct Facts<'a> {
    area: f64,
    width: f64,
    /// None where the level draws no window at all.
    windows: Option<usize>,
    /// None where most rooms have no way in.
    doors: Option<usize>,
    leads_to: usize,
    is_railed: bool,
    fixtures: &'a BTreeSet<String>,
    /// Those of all rooms of the level.
    level_fixtures: &'a BTreeSet<String>,
    /// Types of the rooms above and below.
    stacked: BTreeSet<&'a str>,
    building: Option<&'a str>,
}

/// The facts that the rooms of a level share.
pub(super) struct Surroundings<'a> {
    level: &'a Level,
    building: Option<&'a str>,
    draws_windows: bool,
    fixtures: &'a BTreeSet<String>,
    is_doored: bool,
}

impl<'a> Surroundings<'a> {
    pub(super) fn of(level: &'a Level, building: Option<&'a str>, fixtures: &'a BTreeSet<String>) -> Self {
        let rooms: Vec<&Room> = level.rooms.iter().filter(|room| room.region.area() >= CLOSET).collect();
        let reached = rooms.iter().filter(|room| !ways(level, room).is_empty()).count();
        let draws_windows = level.openings.iter().any(|opening| opening.kind == OpeningKind::Window);
        let is_doored = reached as f64 >= rooms.len() as f64 * DOORED_SHARE;
        Self { level, building, draws_windows, fixtures, is_doored }
    }

    pub(super) fn facts(
        &self,
        place: usize,
        fixtures: &'a BTreeSet<String>,
        stacked: BTreeSet<&'a str>,
    ) -> Facts<'a> {
        let room = &self.level.rooms[place];
        let openings = room.openings.iter().map(|entry| &self.level.openings[entry.opening]);
        let windows = openings.filter(|opening| opening.kind == OpeningKind::Window).count();
        let ways = ways(self.level, room);
        let sides = ways.iter().flat_map(|way| &self.level.openings[*way].sides);
        let others: BTreeSet<usize> = sides.map(|side| side.room).filter(|other| *other != place).collect();
        let railed = room.walls.iter().filter(|wall| wall.is_exterior && wall.kind != WallKind::Solid);
        let railed: f64 = railed.map(Wall::length).sum();
        let border: f64 = room.walls.iter().map(Wall::length).sum();
        Facts {
            area: room.region.area(),
            width: width_of(&room.region.outline),
            windows: self.draws_windows.then_some(windows),
            doors: self.is_doored.then_some(ways.len()),
            leads_to: others.len(),
            is_railed: railed > border * RAILED_SHARE,
            fixtures,
            level_fixtures: self.fixtures,
            stacked,
            building: self.building,
        }
    }
}

/// Metres across the rectangle that has a room's area and perimeter; of shapes rounder than any rectangle, of the square.
fn width_of(outline: &Polygon) -> f64 {
    // Of a rectangle `a` by `b`: area a b over half the perimeter a + b.
    let mean = mean_width(outline);
    let half = outline.area() / mean / 2.0;
    half - (half * half - outline.area()).max(0.0).sqrt()
}

/// The openings of a room that people walk through.
fn ways(level: &Level, room: &Room) -> BTreeSet<usize> {
    let openings = room.openings.iter().map(|entry| entry.opening);
    openings.filter(|opening| level.openings[*opening].kind.is_walkable()).collect()
}

impl Facts<'_> {
    pub(super) fn fit(&self, rule: &GuessRule) -> bool {
        let holds = |range: Option<[f64; 2]>, value: f64| {
            range.is_none_or(|[low, high]| (low..=high).contains(&value))
        };
        let counts = |range: Option<[usize; 2]>, value: Option<usize>| match (range, value) {
            (Some([low, high]), Some(value)) => (low..=high).contains(&value),
            _ => true,
        };
        let one_of = |wanted: &[String], is_present: &dyn Fn(&str) -> bool| {
            wanted.is_empty() || wanted.iter().any(|name| is_present(name))
        };
        holds(rule.area, self.area)
            && holds(rule.width, self.width)
            && counts(rule.windows, self.windows)
            && counts(rule.doors, self.doors)
            && counts(rule.leads_to, Some(self.leads_to))
            && rule.railing.is_none_or(|railing| railing == self.is_railed)
            && !rule.none_on_level.iter().any(|name| self.level_fixtures.contains(name))
            && one_of(&rule.fixtures, &|name| self.fixtures.contains(name))
            && one_of(&rule.above_or_below, &|name| self.stacked.contains(name))
            && one_of(&rule.building, &|name| self.building == Some(name))
    }

    /// The reasons of a guess, as "3.1 m², no window, one door".
    pub(super) fn in_words(&self) -> String {
        let counted = |count: usize, what: &str| match count {
            0 => format!("no {what}"),
            1 => format!("one {what}"),
            count => format!("{count} {what}s"),
        };
        let mut facts = vec![format!("{:.1} m²", self.area)];
        if self.width < NARROW {
            facts.push(format!("{:.2} m wide", self.width));
        }
        facts.extend(self.windows.map(|count| counted(count, "window")));
        facts.extend(self.doors.map(|count| counted(count, "door")));
        if self.leads_to > 2 {
            facts.push(format!("leads to {} rooms", self.leads_to));
        }
        facts.extend(self.is_railed.then(|| "with a railing".to_owned()));
        facts.extend((!self.fixtures.is_empty()).then(|| format!("with {}", joined(self.fixtures))));
        facts.extend((!self.stacked.is_empty()).then(|| format!("{} above or below", joined(&self.stacked))));
        facts.extend(self.building.map(|family| format!("among rooms of the family {family}")));
        facts.join(", ")
    }
}

fn joined(names: &BTreeSet<impl AsRef<str>>) -> String {
    printable(&names.iter().map(AsRef::as_ref).collect::<Vec<&str>>().join(" and "))
}
