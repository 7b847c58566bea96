//! Turns drafts into a checked building, and gives each problem its file.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::names::{replace_unprintable, replaced};
use super::native::{LevelOrigins, NativeChecks, NativeDraft, ProblemList, Report, read_native};
use crate::document::{Fault, Faults, Source, first_of_each_kind};
use crate::plan::assemble::Storeys;
use crate::plan::guess::Guessing;
use crate::plan::stairs::join_levels;
use crate::plan::{
    Building, BuildingDraft, Level, LevelDraft, LevelReport, Problem, RoomWords, SitePlacement, Subject,
    assemble_level, mirror_building, write_native,
};

/// A building as it was read, and where from.
pub(super) struct Drafted {
    /// Unique in the plan.
    pub(super) id: String,
    /// Its levels.
    pub(super) draft: BuildingDraft,
    /// Where its frame is on the site, if the file says.
    pub(super) placement: SitePlacement,
    /// Where problems are reported.
    pub(super) provenance: Provenance,
    /// Whether the building is taken as its native plan says it, so that both are furnished alike to the byte.
    pub(super) is_settled: bool,
}

/// Where a draft came from.
pub(super) enum Provenance {
    /// A native plan: problems point at a line.
    Native(Source, Vec<LevelOrigins>),
    /// A file of another format.
    Foreign(PathBuf),
}

/// How a project wants a building.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Variation {
    /// Whether east and west are exchanged.
    pub(super) is_mirrored: bool,
    /// Style of rooms that name none.
    pub(super) style: Option<String>,
}

/// A building that was put together.
pub(super) struct Finished {
    /// Without levels if none could be read.
    pub(super) building: Building,
    pub(super) faults: Faults,
    /// The report on each drafted level.
    pub(super) levels: Vec<LevelReport>,
}

/// Assembles all levels. A faulty room or opening is left out and reported. `told` counts the guesses of the input that
/// are reported one by one.
pub(super) fn finish(
    drafted: &Drafted,
    variation: &Variation,
    words: &RoomWords,
    told: &mut usize,
) -> Finished {
    let draft = match variation.is_mirrored {
        true => mirror_building(&drafted.draft),
        false => drafted.draft.clone(),
    };
    assembled(draft, drafted, variation, words, told)
}

/// As [`finish`], of a draft that is mirrored as is wanted; that of `drafted` is not looked at.
fn assembled(
    mut draft: BuildingDraft,
    drafted: &Drafted,
    variation: &Variation,
    words: &RoomWords,
    told: &mut usize,
) -> Finished {
    for room in draft.levels.iter_mut().flat_map(|level| &mut level.rooms) {
        room.style = room.style.take().or_else(|| variation.style.clone());
    }
    let unprintable = replace_unprintable(&mut draft);
    let mut guessing = Guessing::of(&draft, words, told);
    let mut building = Building { name: draft.name, attribution: draft.attribution, levels: Vec::new() };
    let mut problems = Vec::new();
    let mut reports = Vec::new();
    let mut ids = BTreeSet::new();
    let mut storeys = Storeys::default();
    for (place, level) in draft.levels.into_iter().enumerate() {
        if !ids.insert(level.id.clone()) {
            let problem = repeated_id();
            let notes = vec![problem.message.clone()];
            reports.push(LevelReport { notes, ..LevelReport::of_draft(&level) });
            problems.push((level.id, vec![problem]));
            continue;
        }
        let checks = NativeChecks::of(&level);
        let mut report = LevelReport::of_draft(&level);
        let drawn = level.openings.iter().map(|opening| opening.id.clone()).collect();
        let (mut level, mut found, guessed) =
            assemble_guessed(level, &mut storeys, (place, guessing.as_mut()));
        report.guessed = guessed;
        if matches!(drafted.provenance, Provenance::Native(..)) {
            checks.run(&level, &mut found);
        }
        let is_lost = report.rooms.drawn > 0 && level.rooms.is_empty();
        if is_lost {
            let message = format!("level \"{}\" has no room that can be read", level.id);
            found.push(Problem::impossible(Subject::Level, message, "it was left out"));
        }
        let errors = found.iter().filter(|problem| problem.is_error);
        level.left_out = errors.map(|problem| problem.message.clone()).collect();
        report.complete(&level, &found, &drawn);
        reports.push(report);
        problems.push((level.id.clone(), found));
        building.levels.extend((!is_lost).then_some(level));
    }
    if drafted.is_settled {
        building = settled(building, &drafted.id, words);
    }
    join_levels(&mut building.levels);
    let mut faults = drafted.provenance.faults(problems);
    if let Some((first, others)) = unprintable {
        faults.push(replaced(drafted.provenance.file(), &first, others));
    }
    Finished { building, faults, levels: reports }
}

/// The problem of a level whose id an earlier one has: both would be written into one file.
fn repeated_id() -> Problem {
    let message = "another level of the building has this id".to_owned();
    Problem::impossible(Subject::Level, message, "the second was left out: ids are unique in a building")
}

/// A building as it comes back from its native plan, whose lengths are rounded. One that does not come back whole stays as it is.
fn settled(building: Building, id: &str, words: &RoomWords) -> Building {
    let source = Source::new(Path::new("settled.yaml"), &write_native(&building, id));
    let Ok(NativeDraft { draft, .. }) = read_native(&source, words) else { return building };
    let mut levels = Vec::with_capacity(building.levels.len());
    let mut storeys = Storeys::default();
    for (level, draft) in building.levels.iter().zip(draft.levels) {
        let (mut settled, problems) = storeys.assemble(draft);
        let is_whole = settled.id == level.id
            && settled.rooms.len() == level.rooms.len()
            && settled.openings.len() == level.openings.len();
        if !is_whole || problems.iter().any(|problem| problem.is_error) {
            return building;
        }
        settled.left_out.clone_from(&level.left_out);
        levels.push(settled);
    }
    if levels.len() == building.levels.len() { Building { levels, ..building } } else { building }
}

/// A draft that no file holds, put together; problems are faults of the building.
pub(crate) fn finish_draft(id: &str, draft: &BuildingDraft, words: &RoomWords) -> (Building, Faults) {
    let drafted = Drafted {
        id: id.to_owned(),
        draft: BuildingDraft::default(),
        placement: SitePlacement::default(),
        provenance: Provenance::Foreign(PathBuf::from(id)),
        is_settled: false,
    };
    let Finished { building, faults, .. } =
        assembled(draft.clone(), &drafted, &Variation::default(), words, &mut 0);
    (building, faults)
}

/// As [`assemble_level`], with guesses for rooms with unknown words, and their number. Such a level is assembled
/// anew with them: what a room is decides where doors open and which walls have pipes.
fn assemble_guessed(
    mut draft: LevelDraft,
    storeys: &mut Storeys,
    (place, guessing): (usize, Option<&mut Guessing<'_>>),
) -> (Level, Vec<Problem>, usize) {
    let is_known = draft.rooms.iter().all(|room| room.unknown_word.is_none());
    let Some(guessing) = guessing.filter(|_| !is_known) else {
        let (level, problems) = storeys.assemble(draft);
        return (level, problems, 0);
    };
    let (level, _) = assemble_level(draft.clone());
    let (count, guesses) = guessing.guess(&mut draft, place, &level);
    let (level, mut problems) = assemble_level(draft);
    problems.extend(guesses);
    (level, problems, count)
}

impl Provenance {
    fn file(&self) -> &Path {
        match self {
            Self::Native(source, _) => source.file(),
            Self::Foreign(file) => file,
        }
    }

    /// The problems of the levels, by id, as faults of the file.
    fn faults(&self, problems: Vec<(String, Vec<Problem>)>) -> Faults {
        match self {
            Self::Native(source, origins) => {
                let mut list = ProblemList::default();
                for ((_, problems), origins) in problems.into_iter().zip(origins) {
                    list.add(problems, origins);
                }
                let mut report = Report::new(source);
                list.report(&mut report);
                report.finish()
            }
            // Nobody can be asked to mend a foreign file: what was left out is a warning, unless no building is so.
            Self::Foreign(file) => {
                let fault = |level: &str, problem: Problem| {
                    let named = format!("level \"{level}\"");
                    let is_named = problem.message.starts_with(&named);
                    let message =
                        if is_named { problem.message } else { format!("{named}: {}", problem.message) };
                    let fault = Fault::of_file(file, message).with_some_hint(problem.hint);
                    if problem.is_impossible { fault } else { fault.as_warning() }
                };
                let mut faults = Faults::default();
                for (level, problems) in problems {
                    problems.into_iter().for_each(|problem| faults.push(fault(&level, problem)));
                }
                first_of_each_kind(faults)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Polygon};
    use crate::plan::{OpeningDraft, OpeningKind, OpeningPlace, RoomDraft};

    /// A square of 4 m; `east` are the metres of its left edge.
    fn room(id: &str, east: f64) -> RoomDraft {
        let outline = Polygon::rectangle(Point::new(east, 0.0), Point::splat(4.0)).corners().to_vec();
        RoomDraft { id: id.to_owned(), room_type: "office".to_owned(), outline, ..RoomDraft::default() }
    }

    /// A door in the middle of the wall between the rooms at 0 and at 4.1.
    fn door(id: &str, rooms: &[&str]) -> OpeningDraft {
        OpeningDraft {
            id: id.to_owned(),
            kind: OpeningKind::Door,
            place: OpeningPlace::Points { center: Point::new(4.05, 2.0), along: None },
            rooms: rooms.iter().map(|room| (*room).to_owned()).collect(),
            width: 0.8,
            bottom: 0.0,
            top: 2.0,
            leaf: crate::plan::LeafDraft::Automatic,
        }
    }

    fn level(id: &str, rooms: Vec<RoomDraft>, openings: Vec<OpeningDraft>) -> LevelDraft {
        LevelDraft { id: id.to_owned(), height: 3.0, rooms, openings, ..LevelDraft::default() }
    }

    /// The building of some levels, and the messages about it.
    fn finished(levels: Vec<LevelDraft>) -> (Building, Vec<String>) {
        let draft = BuildingDraft { levels, ..BuildingDraft::default() };
        let (building, faults) = finish_draft("house", &draft, &RoomWords::default());
        (building, faults.0.into_iter().map(|fault| fault.message).collect())
    }

    #[test]
    fn of_equal_ids_the_first_stays() {
        let rooms = vec![room("a", 0.0), room("a", 4.1), room("b", 4.1)];
        let openings = vec![door("d", &["a", "b"]), door("d", &["a"])];
        let levels = vec![level("0", rooms, openings), level("0", vec![room("c", 0.0)], Vec::new())];
        let (building, messages) = finished(levels);
        let expected = [
            "level \"0\": room id \"a\" is used twice",
            "level \"0\": opening id \"d\" is used twice",
            "level \"0\": another level of the building has this id",
        ];
        assert_eq!(messages, expected);
        let [level] = &building.levels[..] else { panic!("{} levels", building.levels.len()) };
        let ids: Vec<&str> = level.rooms.iter().map(|room| room.id.as_str()).collect();
        assert_eq!((ids, level.openings[0].sides.len()), (vec!["a", "b"], 2));
    }

    #[test]
    fn an_opening_of_no_room_is_left_out() {
        let flat = RoomDraft { outline: vec![Point::ZERO, Point::X], ..room("flat", 0.0) };
        let rooms = vec![room("a", 0.0), room("b", 4.1), flat];
        let openings =
            vec![door("1", &["a", "kitchen"]), door("2", &["flat"]), door("3", &["b", "a", "flat"])];
        let (building, messages) = finished(vec![level("0", rooms, openings)]);
        let expected = [
            "level \"0\": room \"flat\": outline has 2 distinct corners, three are needed",
            "level \"0\": opening \"2\" names room \"flat\", which was left out",
            "level \"0\": opening \"3\" names room \"flat\", which was left out",
            "level \"0\": opening \"1\" names the unknown room \"kitchen\"",
        ];
        assert_eq!(messages, expected);
        assert!(building.levels[0].openings.is_empty());
    }

    #[test]
    fn levels_keep_their_order_and_those_without_a_room_stay() {
        let upper = LevelDraft { elevation: 3.0, ..level("upper", vec![room("a", 0.0)], Vec::new()) };
        let flat = RoomDraft { outline: vec![Point::ZERO], ..room("flat", 0.0) };
        let levels =
            vec![upper, level("roof", Vec::new(), Vec::new()), level("cellar", vec![flat], Vec::new())];
        let (building, messages) = finished(levels);
        let ids: Vec<&str> = building.levels.iter().map(|level| level.id.as_str()).collect();
        assert_eq!(ids, ["upper", "roof"]);
        assert_eq!(messages[1], "level \"cellar\" has no room that can be read");
    }

    #[test]
    fn rooms_may_be_higher_than_their_level() {
        let with = |height: Option<f64>| RoomDraft { height, ..room("a", 0.0) };
        let height_of = |height: Option<f64>| {
            let (building, messages) = finished(vec![level("0", vec![with(height)], Vec::new())]);
            (building.levels.first().map(|level| level.rooms[0].height), messages.len())
        };
        assert_eq!(height_of(None), (Some(2.7), 0));
        assert_eq!(height_of(Some(6.0)), (Some(6.0), 0));
        assert_eq!(height_of(Some(0.5)), (Some(2.7), 1));
        assert_eq!(height_of(Some(200.0)), (None, 2));
    }
}
