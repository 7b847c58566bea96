//! How bad a finding is.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
