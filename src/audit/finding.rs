//! Findings, which an audit reports, and the grade that they make.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::contract::FindingExtras;

use super::checks::Code;
use super::fault::{Element, Fault, FloorRegion, Named};
use super::possible::Held;
use super::quantity::Quantity;
use super::severity::Severity;

/// A fault of a furnished room.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// Its kind.
    pub code: Code,
    /// Whether the room fails by it.
    pub severity: Severity,
    /// Ids of the objects concerned, sorted; an opening is `door:<id>`, a missing piece its class.
    pub objects: Vec<String>,
    /// The measured value, in the unit of the quantity.
    pub measured: f64,
    /// The threshold that it breaks, in the same unit.
    pub threshold: f64,
    /// Whether it was not searched further if the plan leaves another choice: the finding then counts as if it did.
    #[serde(skip_serializing_if = "is_false")]
    pub not_searched_further: bool,
    /// The elements with the ids in `objects`, in their order.
    #[serde(skip)]
    pub elements: Vec<Element>,
    /// The measured quantity.
    #[serde(skip)]
    pub quantity: Quantity,
    /// The floor that it is about; empty where it is about elements only.
    #[serde(skip)]
    pub region: Vec<FloorRegion>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for it")]
fn is_false(word: &bool) -> bool {
    !word
}

impl Finding {
    /// The finding of a fault.
    pub(crate) fn new(code: Code, fault: Fault) -> Self {
        let Fault { mut subjects, quantity, measured, threshold, region, is_possible } = fault;
        subjects.sort_unstable();
        let (objects, elements) = subjects.into_iter().map(|Named { id, element }| (id, element)).unzip();
        // A search that was given up counts against the furniture: only a proof excuses it.
        let severity = if is_possible == Held::No { Severity::Given } else { code.severity() };
        let not_searched_further = is_possible == Held::Unknown;
        Self {
            code,
            severity,
            objects,
            measured,
            threshold,
            not_searched_further,
            elements,
            quantity,
            region,
        }
    }

    /// The finding as files hold it.
    #[must_use]
    pub fn extras(&self) -> FindingExtras {
        FindingExtras {
            code: self.code.name().into(),
            severity: self.severity.name().into(),
            objects: self.objects.clone(),
            measured: self.measured,
            threshold: self.threshold,
            not_searched_further: self.not_searched_further,
        }
    }
}

/// The findings of faults: sorted by code and objects, each once, and of those that begin with the same object not too many.
pub(crate) fn findings(faults: impl Iterator<Item = (Code, Fault)>) -> Vec<Finding> {
    let mut findings: Vec<Finding> = faults.map(|(code, fault)| Finding::new(code, fault)).collect();
    // By code and ids, so that the order does not depend on how the checks went through the room.
    findings.sort_by(|a, b| a.code.cmp(&b.code).then_with(|| a.objects.cmp(&b.objects)));
    // Two pieces in each other's way are one finding, about the floor that either lacks.
    findings.dedup_by(|further, kept| {
        let is_same =
            further.code == kept.code && !kept.objects.is_empty() && further.objects == kept.objects;
        if is_same {
            kept.region.append(&mut further.region);
        }
        is_same
    });
    bound(&mut findings);
    findings
}

impl fmt::Display for Finding {
    /// Code, elements, figure and threshold in their unit.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = self.quantity.unit();
        f.write_str(self.code.name())?;
        if !self.objects.is_empty() {
            write!(f, " {}", self.objects.join(", "))?;
        }
        write!(f, ": {}, threshold {}", unit.show(self.measured), unit.show(self.threshold))?;
        if self.not_searched_further { f.write_str(", not searched further") } else { Ok(()) }
    }
}

/// Findings of a kind that begin with the same object at most.
const MOST_OF_ONE: usize = 32;

/// Leaves out further findings of those that begin with the same object: what lies in a heap of copies meets hundreds.
/// They are sorted by code and objects.
fn bound(findings: &mut Vec<Finding>) {
    let mut kept: Vec<Finding> = Vec::with_capacity(findings.len());
    let mut count = 0;
    for finding in findings.drain(..) {
        let begins_alike =
            |last: &Finding| last.code == finding.code && last.objects.first() == finding.objects.first();
        let is_further = !finding.objects.is_empty() && kept.last().is_some_and(begins_alike);
        count = if is_further { count + 1 } else { 1 };
        if count <= MOST_OF_ONE {
            kept.push(finding);
        }
    }
    *findings = kept;
}

/// The paper's three grades (section 6).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Grade {
    /// No finding, or none of the furniture's.
    None,
    /// Minor findings only.
    Minor,
    /// At least one finding that fails the room.
    Failed,
}

impl Grade {
    /// The word in the output.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Minor => "minor",
            Self::Failed => "failed",
        }
    }

    /// The grade of a room with these findings.
    #[must_use]
    pub fn of(findings: &[Finding]) -> Self {
        findings.iter().fold(Self::None, |grade, finding| {
            grade.max(match finding.severity {
                Severity::Given => Self::None,
                Severity::Minor => Self::Minor,
                Severity::Failed => Self::Failed,
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::testing::{found, given};

    #[test]
    fn an_object_that_meets_hundreds_is_reported_with_some_of_them() {
        let meets = |code, a: usize, b: usize| found(code, &[&format!("a.{a:04}"), &format!("b.{b:04}")]);
        let mut findings: Vec<Finding> =
            (0..3).flat_map(|a| (0..100).map(move |b| meets(Code::Collision, a, b))).collect();
        findings.push(meets(Code::BlockedUse, 2, 0));
        bound(&mut findings);
        assert_eq!(findings.len(), 3 * MOST_OF_ONE + 1);
        let mut without_objects = vec![found(Code::Sparse, &[]); 2 * MOST_OF_ONE];
        bound(&mut without_objects);
        assert_eq!(without_objects.len(), 2 * MOST_OF_ONE);
    }

    #[test]
    fn the_worst_finding_is_the_grade() {
        let minor = found(Code::Unfulfilled, &[]);
        let failed = found(Code::Collision, &["b.1", "a.1"]);
        assert_eq!(Grade::of(&[]), Grade::None);
        assert_eq!(Grade::of(std::slice::from_ref(&minor)), Grade::Minor);
        assert_eq!(Grade::of(&[failed.clone(), minor.clone()]), Grade::Failed);
        assert_eq!(Grade::of(&[given(&failed)]), Grade::None);
        assert_eq!(Grade::of(&[given(&failed), minor]), Grade::Minor);
        assert_eq!(failed.objects, ["a.1", "b.1"]);
    }
}
