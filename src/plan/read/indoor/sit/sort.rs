//! Sorts the elements of a map into spaces, doors and outlines of buildings.

use std::collections::BTreeMap;

use super::levels::{LevelNumber, levels_of};
use super::mapped::{Mapped, Shape};
use crate::geometry::Point;
use crate::plan::read::indoor::remarks::Remarks;
use crate::plan::read::rings::Rings;

/// Degrees beyond which there is no place, or none on a plane.
const FARTHEST: (f64, f64) = (180.0, 85.0);
/// How often the corners of all spaces may be repeated on further levels: lifts of towers are, and little else.
const MOST_REPEATED: usize = 20;
/// Corners that may be repeated in any map.
const ALWAYS_REPEATED: usize = 100_000;

/// The parts of a map, in degrees; spaces and doors sorted by id.
#[derive(Debug, Default)]
pub(super) struct Sorted {
    pub(super) spaces: Vec<Space>,
    pub(super) doors: Vec<Door>,
    pub(super) outlines: Vec<(Mapped, Vec<Rings>)>,
    /// Titles of levels, where the map says them.
    pub(super) level_names: BTreeMap<LevelNumber, String>,
}

/// A room, a corridor or an area.
#[derive(Debug)]
pub(super) struct Space {
    pub(super) mapped: Mapped,
    pub(super) areas: Vec<Rings>,
    pub(super) levels: Vec<LevelNumber>,
}

/// A door or an entrance.
#[derive(Debug)]
pub(super) struct Door {
    pub(super) mapped: Mapped,
    pub(super) at: Point,
    /// None where the map does not say: then it is on all levels of its rooms.
    pub(super) levels: Vec<LevelNumber>,
}

/// Sorts all elements; those of no use are counted in a remark, faulty ones have one each.
pub(super) fn sorted(mut mapped: Vec<Mapped>, remarks: &mut Remarks) -> Sorted {
    let mut sorted = Sorted::default();
    let mut passed_over: BTreeMap<String, usize> = BTreeMap::new();
    mapped.sort_by(|a, b| a.id.cmp(&b.id));
    mapped.dedup_by(|a, b| a.id == b.id);
    let first = mapped.first().map_or(0, |element| element.place);
    for element in mapped {
        if element.is_space() {
            sorted.add_space(element, remarks);
        } else if element.is_building() {
            sorted.add_outline(element);
        } else if let Shape::Point(at) = element.shape
            && is_door(&element)
        {
            sorted.add_door(element, at, remarks);
        } else if element.tag("indoor") == Some("level") {
            sorted.add_level_names(&element);
        } else if let Some(word) = element.tag("indoor") {
            let word: String = word.chars().take(40).collect();
            *passed_over.entry(word).or_default() += 1;
        }
    }
    sorted.bound_repeats(remarks);
    report_passed_over(&passed_over, first, remarks);
    sorted
}

/// Whether a point with tags is an opening: `door=no` is one without a leaf, `entrance=no` is none.
fn is_door(element: &Mapped) -> bool {
    element.tag("door").is_some() || element.tag("entrance").is_some_and(|word| word != "no")
}

impl Sorted {
    fn add_space(&mut self, element: Mapped, remarks: &mut Remarks) {
        let place = element.place;
        let Some(areas) = areas_of(&element) else {
            return remarks.leave_out(place, format!("{} is a room without a closed outline", element.id));
        };
        let corners = areas.iter().flat_map(corners);
        if !corners.into_iter().all(is_on_earth) {
            let message = format!("{} has corners that are nowhere on Earth", element.id);
            return remarks.leave_out(place, message);
        }
        let mut levels = levels(&element, remarks);
        if levels.is_empty() {
            levels.push(LevelNumber::default());
        }
        if let (Some(name), [level]) = (element.tag("level:ref"), levels.as_slice()) {
            self.level_names.entry(*level).or_insert_with(|| name.to_owned());
        }
        self.spaces.push(Space { mapped: element, areas, levels });
    }

    fn add_outline(&mut self, element: Mapped) {
        let areas = areas_of(&element).unwrap_or_default();
        if !areas.is_empty() && areas.iter().flat_map(corners).all(is_on_earth) {
            self.outlines.push((element, areas));
        }
    }

    fn add_door(&mut self, element: Mapped, at: Point, remarks: &mut Remarks) {
        if is_on_earth(at) {
            let levels = levels(&element, remarks);
            self.doors.push(Door { mapped: element, at, levels });
        } else {
            remarks.leave_out(element.place, format!("{} is nowhere on Earth", element.id));
        }
    }

    fn add_level_names(&mut self, element: &Mapped) {
        let name = element.tag("name").or(element.tag("level:ref"));
        let levels = element.tag("level").and_then(|words| levels_of(words).ok()).unwrap_or_default();
        // The area of several levels is the title of none.
        if let (Some(name), [level]) = (name, levels.as_slice()) {
            self.level_names.insert(*level, name.to_owned());
        }
    }

    /// Leaves out spaces that are on so many levels that the plan would fill the memory.
    fn bound_repeats(&mut self, remarks: &mut Remarks) {
        let count = |space: &Space| space.areas.iter().flat_map(corners).count();
        let mut left = MOST_REPEATED * self.spaces.iter().map(count).sum::<usize>() + ALWAYS_REPEATED;
        self.spaces.retain(|space| {
            let corners = count(space) * space.levels.len();
            let rest = left.checked_sub(corners);
            left = rest.unwrap_or(left);
            if rest.is_none() {
                let message =
                    format!("{} is on {} levels, too many for this map", space.mapped.id, space.levels.len());
                remarks.leave_out(space.mapped.place, message);
            }
            rest.is_some()
        });
    }
}

/// The levels of `level` and `repeat_on`.
fn levels(element: &Mapped, remarks: &mut Remarks) -> Vec<LevelNumber> {
    let mut levels = Vec::new();
    for words in ["level", "repeat_on"].into_iter().filter_map(|key| element.tag(key)) {
        match levels_of(words) {
            Ok(found) => levels.extend(found),
            Err(fault) => {
                let message = format!("{}: {fault}", element.id);
                remarks.note(element.place, message, "write numbers as 0, -1, 0;1 or 0-3");
            }
        }
    }
    levels.sort_unstable();
    levels.dedup();
    levels
}

/// The areas of a closed line or of an area, in canonical form; `None` of anything else.
fn areas_of(element: &Mapped) -> Option<Vec<Rings>> {
    let areas = match &element.shape {
        Shape::Areas(areas) => areas.clone(),
        Shape::Line(line) if line.len() > 3 && line.first() == line.last() => {
            vec![Rings { outer: line.clone(), holes: Vec::new() }]
        }
        Shape::Line(_) | Shape::Point(_) => return None,
    };
    let areas: Vec<Rings> =
        areas.into_iter().map(Rings::canonical).filter(|area| area.outer.len() > 2).collect();
    (!areas.is_empty()).then_some(areas)
}

/// All corners of an area.
pub(super) fn corners(area: &Rings) -> impl Iterator<Item = Point> {
    area.outer.iter().chain(area.holes.iter().flatten()).copied()
}

fn is_on_earth(at: Point) -> bool {
    at.x.abs() <= FARTHEST.0 && at.y.abs() <= FARTHEST.1
}

fn report_passed_over(passed_over: &BTreeMap<String, usize>, place: u64, remarks: &mut Remarks) {
    /// Words that are listed.
    const MOST: usize = 8;
    if passed_over.is_empty() {
        return;
    }
    let listed = passed_over.iter().take(MOST).map(|(word, count)| format!("{count} × indoor={word}"));
    let mut parts: Vec<String> = listed.collect();
    let others: usize = passed_over.values().skip(MOST).sum();
    parts.extend((others > 0).then(|| format!("{others} × other words")));
    let message = format!("elements that are no rooms: {}", parts.join(", "));
    remarks.note(
        place,
        message,
        "they were left out: furniture, pillars and walls have no size in these maps",
    );
}
