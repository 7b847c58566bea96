//! Drafts to a checked building, with problems located in the file they came from.

use std::path::PathBuf;

use super::native::{LevelOrigins, NativeChecks, ProblemList, Report};
use crate::document::{Fault, Faults, Source};
use crate::plan::{Building, BuildingDraft, Level, Problem, assemble_level, mirror_building};

/// A building as it was read, and where from.
pub(super) struct Drafted {
    /// Unique in the plan.
    pub(super) id: String,
    /// Its levels.
    pub(super) draft: BuildingDraft,
    /// Where problems are reported.
    pub(super) provenance: Provenance,
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

/// Assembles all levels. What is wrong with a room or an opening leaves that out and is reported.
pub(super) fn finish(drafted: &Drafted, variation: &Variation) -> (Building, Faults) {
    let mut draft = match variation.is_mirrored {
        true => mirror_building(&drafted.draft),
        false => drafted.draft.clone(),
    };
    for room in draft.levels.iter_mut().flat_map(|level| &mut level.rooms) {
        room.style = room.style.take().or_else(|| variation.style.clone());
    }
    let mut building = Building { name: draft.name, levels: Vec::new() };
    let mut problems = Vec::new();
    for level in draft.levels {
        let checks = NativeChecks::of(&level);
        let (level, mut found) = assemble_level(level);
        if matches!(drafted.provenance, Provenance::Native(..)) {
            checks.run(&level, &mut found);
        }
        problems.push(found);
        building.levels.push(level);
    }
    let faults = drafted.provenance.faults(&building, problems);
    (building, faults)
}

impl Provenance {
    fn faults(&self, building: &Building, problems: Vec<Vec<Problem>>) -> Faults {
        match self {
            Self::Native(source, origins) => {
                let mut list = ProblemList::default();
                for (problems, origins) in problems.into_iter().zip(origins) {
                    list.add(problems, origins);
                }
                let mut report = Report::new(source);
                list.report(&mut report);
                report.finish()
            }
            // Nobody can be asked to mend a foreign file: what was left out is a warning.
            Self::Foreign(file) => {
                let with_levels = building.levels.iter().zip(problems);
                let fault = |level: &Level, problem: Problem| {
                    let message = format!("level \"{}\": {}", level.id, problem.message);
                    Fault { hint: problem.hint, ..Fault::of_file(file, message).as_warning() }
                };
                Faults(
                    with_levels
                        .flat_map(|(level, problems)| {
                            problems.into_iter().map(move |problem| fault(level, problem))
                        })
                        .collect(),
                )
            }
        }
    }
}
