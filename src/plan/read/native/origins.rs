//! Remembers the place of each drafted part in its file, so that its problems point there.

use std::collections::BTreeMap;

use super::report::{Report, item, step};
use crate::document::{FaultSeverity, PathStep};
use crate::plan::{Problem, Subject};

/// Where a drafted room, opening or column was written.
#[derive(Clone, Debug, Default)]
pub(crate) struct Origin {
    /// Document path of its description; inside a prototype for what a level places.
    pub(crate) path: Vec<PathStep>,
    /// Key of its corners.
    pub(crate) shape_key: &'static str,
}

/// The origins of all parts of a level, in the order of its draft.
#[derive(Clone, Debug, Default)]
pub(crate) struct LevelOrigins {
    /// Document path of the level.
    pub(crate) path: Vec<PathStep>,
    /// Id of the level, for messages.
    pub(crate) id: String,
    /// By room of the draft.
    pub(crate) rooms: Vec<Origin>,
    /// By opening of the draft.
    pub(crate) openings: Vec<Origin>,
    /// By column of the draft.
    pub(crate) obstacles: Vec<Origin>,
}

impl LevelOrigins {
    /// The document path of a problem's subject.
    pub(crate) fn path_of(&self, subject: Subject) -> Vec<PathStep> {
        let room = |index: usize| self.rooms.get(index);
        let path = match subject {
            Subject::Level => None,
            Subject::Room(index) => room(index).map(|origin| origin.path.clone()),
            Subject::RoomCorner(index, corner) => room(index).map(|origin| {
                let shape = step(&origin.path, origin.shape_key);
                // The corners of a rectangle are not written one by one.
                if origin.shape_key == "outline" { step(&shape, corner) } else { shape }
            }),
            Subject::Hole(index, hole) => room(index).map(|origin| item(&origin.path, "holes", hole)),
            Subject::Opening(index) => self.openings.get(index).map(|origin| origin.path.clone()),
            Subject::Obstacle(index) => self.obstacles.get(index).map(|origin| origin.path.clone()),
        };
        path.unwrap_or_else(|| self.path.clone())
    }
}

/// Turns problems of drafted levels into faults; what a prototype or a repeated level brings up many times is
/// reported once, with the count of the others.
#[derive(Debug, Default)]
pub(crate) struct ProblemList {
    /// By path, rank among the problems of one part, and severity.
    found: BTreeMap<(Vec<PathStep>, usize, bool), RepeatedProblem>,
}

/// A problem, the first level that has it, and how often it came up.
#[derive(Debug)]
struct RepeatedProblem {
    problem: Problem,
    level: String,
    count: usize,
}

impl ProblemList {
    /// Adds the problems of one level.
    pub(crate) fn add(&mut self, problems: Vec<Problem>, origins: &LevelOrigins) {
        let mut ranks: BTreeMap<String, usize> = BTreeMap::new();
        for problem in problems {
            let rank = ranks.entry(format!("{:?}", problem.subject)).or_default();
            let key = (origins.path_of(problem.subject), *rank, problem.is_error);
            *rank += 1;
            let entry = self.found.entry(key).or_insert_with(|| RepeatedProblem {
                problem,
                level: origins.id.clone(),
                count: 0,
            });
            entry.count += 1;
        }
    }

    /// Reports what was added.
    pub(crate) fn report(self, report: &mut Report<'_>) {
        for ((path, _, is_error), RepeatedProblem { problem, level, count }) in self.found {
            let severity = if is_error { FaultSeverity::Error } else { FaultSeverity::Warning };
            let message = match count {
                1 => problem.message,
                _ => format!("{} (level \"{level}\"; {} more like it)", problem.message, count - 1),
            };
            report.push(report.source().fault(&path, message, problem.hint, severity));
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::document::Source;

    fn problem(subject: Subject, message: &str) -> Problem {
        Problem { subject, message: message.to_owned(), hint: None, is_error: true, is_impossible: false }
    }

    #[test]
    fn a_prototypes_problem_is_reported_once_with_a_count() {
        let text = "prototypes:\n  p:\n    rooms:\n      - {id: a, outline: [[0, 0],\n          [1, 1]]}\n";
        let source = Source::new(Path::new("a.yaml"), text);
        let room = ["prototypes".into(), "p".into(), "rooms".into(), 0.into()].to_vec();
        let origins = LevelOrigins {
            id: "1".to_owned(),
            rooms: vec![Origin { path: room, shape_key: "outline" }; 3],
            ..LevelOrigins::default()
        };
        let mut list = ProblemList::default();
        let crossing = |room| problem(Subject::RoomCorner(room, 1), &format!("room {room} is crossed"));
        list.add((0..3).map(crossing).collect(), &origins);
        list.add(vec![problem(Subject::Room(0), "first"), problem(Subject::Room(0), "second")], &origins);
        let mut report = Report::new(&source);
        list.report(&mut report);
        let faults: Vec<String> = report.finish().0.iter().map(ToString::to_string).collect();
        assert_eq!(
            faults,
            [
                "a.yaml:4:9: first",
                "a.yaml:4:9: second",
                "a.yaml:5:11: room 0 is crossed (level \"1\"; 2 more like it)",
            ]
        );
    }
}
