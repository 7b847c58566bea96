//! Numeric tolerances of the audit, which decide nothing by themselves; the thresholds of findings stand in
//! `configs/audit.yaml` ([`crate::catalog::AuditRules`]).

/// Rounding that never decides: values this close to a threshold keep it.
pub(crate) const ROUNDING: f64 = 1e-6;
