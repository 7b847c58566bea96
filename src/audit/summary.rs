//! Counts over many rooms, for the manifest and for reports.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::checks::Code;
use super::finding::Grade;
use super::severity::Severity;
use super::verdict::Verdict;

/// Verdicts of a level, a building or a whole run. The order in which rooms are added does not matter.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct AuditSummary {
    /// Rooms by grade.
    #[serde(flatten)]
    pub grades: GradeCounts,
    /// Findings by code; codes without a finding are left out.
    #[serde(default)]
    pub findings: BTreeMap<Code, u64>,
    /// The same of what the plans leave no other choice in; no part of the grades.
    #[serde(default)]
    pub given: BTreeMap<Code, u64>,
    /// The scores of the furnished rooms.
    #[serde(default)]
    pub score: ScoreSum,
}

/// Rooms by the paper's three grades.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct GradeCounts {
    /// Without a finding.
    pub none: u64,
    /// With minor findings only.
    pub minor: u64,
    /// With a finding that fails the room.
    pub failed: u64,
}

impl AuditSummary {
    /// Adds the verdict on one room.
    pub fn add_room(&mut self, verdict: &Verdict) {
        match verdict.grade() {
            Grade::None => self.grades.none += 1,
            Grade::Minor => self.grades.minor += 1,
            Grade::Failed => self.grades.failed += 1,
        }
        for finding in &verdict.findings {
            let counts = match finding.severity {
                Severity::Given => &mut self.given,
                Severity::Minor | Severity::Failed => &mut self.findings,
            };
            *counts.entry(finding.code).or_insert(0) += 1;
        }
        if let Some(score) = verdict.score {
            self.score.add(score.value);
        }
    }

    /// Adds the counts of another part of the run.
    pub fn merge(&mut self, other: &Self) {
        self.grades.none = self.grades.none.saturating_add(other.grades.none);
        self.grades.minor = self.grades.minor.saturating_add(other.grades.minor);
        self.grades.failed = self.grades.failed.saturating_add(other.grades.failed);
        for (own, others) in [(&mut self.findings, &other.findings), (&mut self.given, &other.given)] {
            for (&code, &count) in others {
                let sum = own.entry(code).or_insert(0);
                *sum = sum.saturating_add(count);
            }
        }
        self.score.merge(other.score);
    }

    /// How many rooms were judged.
    #[must_use]
    pub fn room_count(&self) -> u64 {
        self.grades.none.saturating_add(self.grades.minor).saturating_add(self.grades.failed)
    }
}

/// The scores of many rooms. Counted in the ten-thousandths that a score is rounded to, so that sums of sums are
/// exact in whatever order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(from = "WrittenScores", into = "WrittenScores")]
pub struct ScoreSum {
    rooms: u64,
    ten_thousandths: u64,
}

/// [`ScoreSum`] as it is written.
#[derive(Serialize, Deserialize, JsonSchema)]
struct WrittenScores {
    /// Rooms that have a score.
    rooms: u64,
    /// The sum of their scores.
    sum: f64,
    /// Their mean to four decimals; left out where there are none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    mean: Option<f64>,
}

impl ScoreSum {
    /// Parts of one in a score.
    const PER_UNIT: f64 = 1e4;

    fn add(&mut self, score: f64) {
        self.rooms += 1;
        self.ten_thousandths += (score * Self::PER_UNIT).round() as u64;
    }

    fn merge(&mut self, other: Self) {
        self.rooms = self.rooms.saturating_add(other.rooms);
        self.ten_thousandths = self.ten_thousandths.saturating_add(other.ten_thousandths);
    }

    /// How many rooms have a score: those that were asked for furniture.
    #[must_use]
    pub fn room_count(self) -> u64 {
        self.rooms
    }

    /// The mean, to four decimals; `None` of no rooms.
    #[must_use]
    pub fn mean(self) -> Option<f64> {
        let mean = self.ten_thousandths as f64 / self.rooms as f64;
        (self.rooms > 0).then(|| mean.round() / Self::PER_UNIT)
    }
}

impl From<ScoreSum> for WrittenScores {
    fn from(sum: ScoreSum) -> Self {
        Self { rooms: sum.rooms, sum: sum.ten_thousandths as f64 / ScoreSum::PER_UNIT, mean: sum.mean() }
    }
}

impl From<WrittenScores> for ScoreSum {
    fn from(written: WrittenScores) -> Self {
        Self { rooms: written.rooms, ten_thousandths: (written.sum * Self::PER_UNIT).round() as u64 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::testing::{found, given};
    use crate::audit::{Finding, Score};

    fn verdict(findings: &[&Finding], score: Option<f64>) -> Verdict {
        let score = score.map(|value| Score { value, ..Score::default() });
        Verdict {
            findings: findings.iter().map(|&finding| finding.clone()).collect(),
            score,
            ..Verdict::default()
        }
    }

    fn rooms() -> [Verdict; 3] {
        let collision = found(Code::Collision, &["a.1"]);
        let unfulfilled = found(Code::Unfulfilled, &[]);
        [
            verdict(&[], Some(0.8123)),
            verdict(&[&collision, &collision, &unfulfilled], None),
            verdict(&[&unfulfilled, &given(&unfulfilled)], Some(0.4)),
        ]
    }

    #[test]
    fn rooms_and_codes_are_counted_and_parts_add_up() {
        let [one, two, three] = rooms();
        let (mut first, mut second) = (AuditSummary::default(), AuditSummary::default());
        first.add_room(&one);
        first.add_room(&two);
        second.add_room(&three);
        first.merge(&second);
        assert_eq!(first.grades, GradeCounts { none: 1, minor: 1, failed: 1 });
        assert_eq!(first.room_count(), 3);
        assert_eq!(first.findings, BTreeMap::from([(Code::Collision, 2), (Code::Unfulfilled, 2)]));
        assert_eq!(first.given, BTreeMap::from([(Code::Unfulfilled, 1)]));
        assert_eq!((first.score.room_count(), first.score.mean()), (2, Some(0.6062)));
    }

    #[test]
    fn what_is_written_is_read_back_exactly() {
        let mut summary = AuditSummary::default();
        assert_eq!(
            serde_json::to_string(&summary).unwrap(),
            r#"{"none":0,"minor":0,"failed":0,"findings":{},"given":{},"score":{"rooms":0,"sum":0.0}}"#
        );
        rooms().iter().for_each(|room| summary.add_room(room));
        let text = serde_json::to_string(&summary).unwrap();
        assert!(text.contains(r#""findings":{"collision":2,"unfulfilled":2}"#), "{text}");
        assert!(text.contains(r#""score":{"rooms":2,"sum":1.2123,"mean":0.6062}"#), "{text}");
        assert_eq!(serde_json::from_str::<AuditSummary>(&text).unwrap(), summary);
    }
}
