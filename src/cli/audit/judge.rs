//! Judges the rooms of one file.

use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;

use super::shown;
use crate::audit::{AuditSummary, Finding, Grade, Score};
use crate::batch::catch_bug;
use crate::catalog::Catalog;
use crate::contract::FindingExtras;
use crate::document::{Fault, Faults};
use crate::layout::Furnished;
use crate::read_back::{ReadLevel, read_level};
use crate::solve::judge_room;

/// A level with what the audit says about it; as it is written for machines.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct JudgedLevel {
    pub(crate) file: String,
    pub(crate) building: String,
    pub(crate) level: String,
    pub(crate) totals: AuditSummary,
    pub(crate) rooms: Vec<JudgedRoom>,
    /// The faults that keep rooms from being judged; listed apart.
    #[serde(skip)]
    pub(crate) faults: Faults,
}

/// A room with what the audit says about it.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct JudgedRoom {
    pub(crate) room: String,
    #[serde(rename = "type")]
    pub(crate) room_type: String,
    pub(crate) grade: Grade,
    /// The score with its terms; none if no piece was requested.
    pub(crate) score: Option<Score>,
    #[schemars(with = "Vec<FindingExtras>")]
    pub(crate) findings: Vec<Finding>,
}

/// Reads a file and judges all of its rooms that can be judged.
pub(crate) fn judge_file(file: &Path, catalog: &Catalog) -> Result<JudgedLevel, Faults> {
    let ReadLevel { building, level, furnished, faults } = read_level(file, catalog)?;
    let mut judged = JudgedLevel {
        file: shown(file),
        building,
        level: level.id.clone(),
        totals: AuditSummary::default(),
        rooms: Vec::new(),
        faults,
    };
    let known = furnished.iter().enumerate().filter_map(|(room, known)| Some((room, known.as_ref()?)));
    let known: Vec<(usize, &Furnished)> = known.collect();
    for (index, furnished) in known {
        let room = &level.rooms[index];
        match catch_bug(|| judge_room(level.room(index), furnished, catalog)) {
            Ok(verdict) => {
                judged.totals.add_room(&verdict);
                judged.rooms.push(JudgedRoom {
                    room: room.id.clone(),
                    room_type: room.room_type.clone(),
                    grade: verdict.grade(),
                    score: verdict.score,
                    findings: verdict.findings,
                });
            }
            Err(bug) => {
                let fault =
                    Fault::of_file(file, format!("the program failed on room \"{}\": {bug}", room.id));
                judged
                    .faults
                    .push(fault.with_hint("this is a fault of roomwright; please report it with the file"));
            }
        }
    }
    Ok(judged)
}
