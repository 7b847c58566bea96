//! What an audit says.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::contract::FindingExtras;

use super::possible::Held;

/// A fault of a furnished room.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// What kind.
    pub code: Code,
    /// Whether the room fails by it.
    pub severity: Severity,
    /// Ids of the objects concerned, sorted; an opening is `door:<id>`, a missing piece its class.
    pub objects: Vec<String>,
    /// The measured value: metres, degrees, a share or a count.
    pub measured: f64,
    /// The threshold that it breaks.
    pub threshold: f64,
    /// Whether it was not searched further if the plan leaves another choice: the finding then counts as if it did.
    #[serde(skip_serializing_if = "is_false")]
    pub not_searched_further: bool,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for it")]
fn is_false(word: &bool) -> bool {
    !word
}

impl Finding {
    /// A finding of a kind; sorts the objects.
    pub(crate) fn new(code: Code, mut objects: Vec<String>, measured: f64, threshold: f64) -> Self {
        objects.sort_unstable();
        Self { code, severity: code.severity(), objects, measured, threshold, not_searched_further: false }
    }

    /// The same finding after a search for whether the plan leaves another choice.
    pub(crate) fn if_possible(self, is_possible: Held) -> Self {
        match is_possible {
            Held::Yes => self,
            Held::No => self.given(),
            Held::Unknown => Self { not_searched_further: true, ..self },
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

    /// The same finding where the plan leaves no other choice.
    pub(crate) fn given(self) -> Self {
        Self { severity: Severity::Given, ..self }
    }
}

/// Findings of a kind that begin with the same object at most.
const MOST_OF_ONE: usize = 32;

/// Leaves out further findings of those that begin with the same object: what lies in a heap of copies meets hundreds.
/// They are sorted by code and objects.
pub(crate) fn bound(findings: &mut Vec<Finding>) {
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

/// The kinds of findings; the words are part of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Code {
    /// Two bodies intersect.
    Collision,
    /// Part of a body lies outside the room.
    OutOfRoom,
    /// Not in contact with its support.
    Floating,
    /// Hangs over the edge of what it stands on.
    Unsupported,
    /// A body in a door's swing or approach.
    DoorBlocked,
    /// A door, or a side of an object that is used, cannot be walked to.
    Unreachable,
    /// A body in the clearance of a functional side.
    BlockedUse,
    /// A clearance between its minimum and its good depth.
    TightUse,
    /// A body before a window that takes its light.
    WindowBlocked,
    /// A screen that nobody sees from a seat or bed, or one before a window.
    TvPosition,
    /// A seat turned away from its table, a desk used from behind, a mirror over nothing.
    Facing,
    /// A tub or shower right before the toilet, a toilet that faces a kitchen.
    WetRoom,
    /// A double bed with one side to get in where the room allows two.
    Bedside,
    /// Nearly all furniture in one half of the room.
    CrowdedHalf,
    /// Wall furniture off its wall in a tidy style.
    Crooked,
    /// A required piece is absent.
    MissingRequired,
    /// Too few of the requested pieces rest.
    Unfulfilled,
    /// Much less furniture than style and room type ask for.
    Sparse,
    /// Surfaces that should carry small things are empty.
    Bare,
    /// A way too narrow for a wheelchair, where the style asks for access.
    NarrowWay,
    /// Nowhere to turn a wheelchair, where the style asks for access.
    NoTurningCircle,
}

impl Code {
    /// All kinds, in the order of their declaration.
    pub const ALL: [Self; 21] = [
        Self::Collision,
        Self::OutOfRoom,
        Self::Floating,
        Self::Unsupported,
        Self::DoorBlocked,
        Self::Unreachable,
        Self::BlockedUse,
        Self::TightUse,
        Self::WindowBlocked,
        Self::TvPosition,
        Self::Facing,
        Self::WetRoom,
        Self::Bedside,
        Self::CrowdedHalf,
        Self::Crooked,
        Self::MissingRequired,
        Self::Unfulfilled,
        Self::Sparse,
        Self::Bare,
        Self::NarrowWay,
        Self::NoTurningCircle,
    ];

    /// The word in the output.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Collision => "collision",
            Self::OutOfRoom => "out_of_room",
            Self::Floating => "floating",
            Self::Unsupported => "unsupported",
            Self::DoorBlocked => "door_blocked",
            Self::Unreachable => "unreachable",
            Self::BlockedUse => "blocked_use",
            Self::TightUse => "tight_use",
            Self::WindowBlocked => "window_blocked",
            Self::TvPosition => "tv_position",
            Self::Facing => "facing",
            Self::WetRoom => "wet_room",
            Self::Bedside => "bedside",
            Self::CrowdedHalf => "crowded_half",
            Self::Crooked => "crooked",
            Self::MissingRequired => "missing_required",
            Self::Unfulfilled => "unfulfilled",
            Self::Sparse => "sparse",
            Self::Bare => "bare",
            Self::NarrowWay => "narrow_way",
            Self::NoTurningCircle => "no_turning_circle",
        }
    }

    /// How bad a finding of this kind is, unless the plan leaves no other choice.
    #[must_use]
    pub fn severity(self) -> Severity {
        match self {
            Self::TightUse
            | Self::WindowBlocked
            | Self::Facing
            | Self::Bedside
            | Self::CrowdedHalf
            | Self::Crooked
            | Self::Unfulfilled
            | Self::Sparse
            | Self::Bare
            | Self::NarrowWay
            | Self::NoTurningCircle => Severity::Minor,
            _ => Severity::Failed,
        }
    }

    /// Whether no room may ever have it: the laws of bodies, as against the customs of use.
    #[must_use]
    pub fn is_physical(self) -> bool {
        matches!(self, Self::Collision | Self::OutOfRoom | Self::Floating | Self::Unsupported)
    }
}

/// How bad a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// The empty room already makes the rule impossible: no fault of the furniture, and no part of the grade.
    Given,
    /// The room is usable all the same.
    Minor,
    /// The room fails.
    Failed,
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

impl Severity {
    /// The word in the output.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::Minor => "minor",
            Self::Failed => "failed",
        }
    }
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

    #[test]
    fn what_meets_hundreds_is_told_with_some_of_them() {
        let meets = |code, a: usize, b: usize| {
            Finding::new(code, vec![format!("a.{a:04}"), format!("b.{b:04}")], 0.1, 0.001)
        };
        let mut findings: Vec<Finding> =
            (0..3).flat_map(|a| (0..100).map(move |b| meets(Code::Collision, a, b))).collect();
        findings.push(meets(Code::BlockedUse, 2, 0));
        bound(&mut findings);
        assert_eq!(findings.len(), 3 * MOST_OF_ONE + 1);
        let mut without_objects = vec![Finding::new(Code::Sparse, Vec::new(), 0.1, 0.2); 2 * MOST_OF_ONE];
        bound(&mut without_objects);
        assert_eq!(without_objects.len(), 2 * MOST_OF_ONE);
    }

    #[test]
    fn the_worst_finding_is_the_grade() {
        let minor = Finding::new(Code::Unfulfilled, Vec::new(), 0.5, 0.9);
        let failed = Finding::new(Code::Collision, vec!["b.1".into(), "a.1".into()], 0.1, 0.001);
        assert_eq!(Grade::of(&[]), Grade::None);
        assert_eq!(Grade::of(std::slice::from_ref(&minor)), Grade::Minor);
        assert_eq!(Grade::of(&[failed.clone(), minor.clone()]), Grade::Failed);
        assert_eq!(Grade::of(&[failed.clone().given()]), Grade::None);
        assert_eq!(Grade::of(&[failed.clone().given(), minor]), Grade::Minor);
        assert_eq!(failed.objects, ["a.1", "b.1"]);
    }

    #[test]
    fn names_are_the_serialized_words_and_all_lists_each_once_in_order() {
        for code in Code::ALL {
            assert_eq!(serde_json::to_value(code).unwrap(), code.name());
        }
        assert!(Code::ALL.is_sorted() && Code::ALL.last() == Some(&Code::NoTurningCircle));
    }
}
