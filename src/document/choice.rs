//! "One of these" faults of a schema, condensed to what a person meant.

use serde_json::Value;

use super::fault::PathStep;
use super::schema::{JsonType, SchemaFault, SchemaProblem};

/// The problems of a value that fits none of several alternatives.
pub(super) enum Choice<'a> {
    /// The value is no alternative's type; the types that would do.
    Types(Vec<JsonType>),
    /// The value has the right type but is none of these words.
    Words(Vec<Value>),
    /// The alternative that it comes nearest to, and what is wrong with that.
    Nearest(Vec<&'a SchemaFault>),
}

/// Condenses the faults of each alternative of the value at a path.
pub(super) fn condense<'a>(alternatives: &'a [Vec<SchemaFault>], path: &[PathStep]) -> Choice<'a> {
    let mut branches = Vec::new();
    for alternative in alternatives {
        flatten(alternative, path, &mut branches);
    }
    let (fitting, others): (Vec<_>, Vec<_>) = branches
        .into_iter()
        .partition(|branch| !branch.iter().any(|fault| wrong_type(fault, path).is_some()));
    if fitting.is_empty() {
        let types = others.iter().flatten().filter_map(|fault| wrong_type(fault, path)).flatten();
        return Choice::Types(unique(types.filter(|kind| *kind != JsonType::Null)));
    }
    if fitting.iter().all(|branch| branch.iter().any(|fault| words(fault, path).is_some())) {
        let all = fitting.iter().flatten().filter_map(|fault| words(fault, path)).flatten();
        return Choice::Words(unique(all.cloned()));
    }
    // A wrong word deep inside weighs most: it is what tells tagged alternatives apart.
    let distance = |branch: &Vec<&SchemaFault>| {
        let tags = branch.iter().filter(|fault| words(fault, &fault.path).is_some()).count();
        (tags, branch.len())
    };
    Choice::Nearest(fitting.into_iter().min_by_key(distance).unwrap_or_default())
}

/// Alternatives of alternatives are alternatives.
fn flatten<'a>(faults: &'a [SchemaFault], path: &[PathStep], branches: &mut Vec<Vec<&'a SchemaFault>>) {
    match faults {
        [SchemaFault { path: of_only, problem: SchemaProblem::Alternatives(inner) }] if of_only == path => {
            inner.iter().for_each(|inner| flatten(inner, path, branches));
        }
        _ => branches.push(faults.iter().collect()),
    }
}

fn wrong_type(fault: &SchemaFault, path: &[PathStep]) -> Option<Vec<JsonType>> {
    match &fault.problem {
        SchemaProblem::Type(types) if fault.path == path => Some(types.clone()),
        // A word is asked for, and this is none.
        SchemaProblem::Words { is_text: false, .. } if fault.path == path => Some(vec![JsonType::String]),
        _ => None,
    }
}

/// The words that would do, if it is a word that is wrong.
fn words<'a>(fault: &'a SchemaFault, path: &[PathStep]) -> Option<&'a [Value]> {
    match &fault.problem {
        SchemaProblem::Words { options, .. } if fault.path == path => Some(options),
        _ => None,
    }
}

fn unique<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    items.fold(Vec::new(), |mut kept, item| {
        if !kept.contains(&item) {
            kept.push(item);
        }
        kept
    })
}
