//! Condenses the many schema faults of a "one of these" value to the one that the user needs.

use jsonschema::error::{TypeKind, ValidationErrorKind};
use jsonschema::{JsonType, ValidationError};
use serde_json::Value;

/// The fault of a value that fits none of several alternatives.
pub(super) enum Choice<'a> {
    /// The value is no alternative's type; the types that would do.
    Types(Vec<JsonType>),
    /// The value has the right type but is none of these words.
    Words(Vec<Value>),
    /// The alternative that it comes nearest to, and what is wrong with that.
    Nearest(Vec<&'a ValidationError<'static>>),
}

type Branch<'a> = Vec<&'a ValidationError<'static>>;

/// Condenses the faults of each alternative of the value at `place` (a JSON pointer).
pub(super) fn condense<'a>(alternatives: &'a [Vec<ValidationError<'static>>], place: &str) -> Choice<'a> {
    let mut branches = Vec::new();
    for alternative in alternatives {
        flatten(alternative, place, &mut branches);
    }
    let (fitting, others): (Vec<_>, Vec<_>) = branches
        .into_iter()
        .partition(|branch| !branch.iter().any(|error| wrong_type(error, place).is_some()));
    if fitting.is_empty() {
        let types = others.iter().flatten().filter_map(|error| wrong_type(error, place)).flatten();
        return Choice::Types(unique(types.filter(|kind| *kind != JsonType::Null)));
    }
    if fitting.iter().all(|branch| branch.iter().any(|error| words(error, place).is_some())) {
        let all = fitting.iter().flatten().filter_map(|error| words(error, place)).flatten();
        return Choice::Words(unique(all));
    }
    // A wrong word deep inside weighs most: it is the difference of tagged alternatives.
    let misfit = |branch: &Branch<'_>| {
        let tags =
            branch.iter().filter(|error| words(error, error.instance_path().as_str()).is_some()).count();
        (tags, branch.len())
    };
    Choice::Nearest(fitting.into_iter().min_by_key(misfit).unwrap_or_default())
}

/// Alternatives of alternatives are alternatives.
fn flatten<'a>(errors: &'a [ValidationError<'static>], place: &str, branches: &mut Vec<Branch<'a>>) {
    if let [only] = errors
        && only.instance_path().as_str() == place
        && let ValidationErrorKind::AnyOf { context } | ValidationErrorKind::OneOfNotValid { context } =
            only.kind()
    {
        context.iter().for_each(|inner| flatten(inner, place, branches));
    } else {
        branches.push(errors.iter().collect());
    }
}

fn wrong_type(error: &ValidationError<'static>, place: &str) -> Option<Vec<JsonType>> {
    match error.kind() {
        ValidationErrorKind::Type { kind } if error.instance_path().as_str() == place => Some(types(kind)),
        // A list of words is asked for, and this is no word.
        ValidationErrorKind::Enum { .. } | ValidationErrorKind::Constant { .. }
            if error.instance_path().as_str() == place && !error.instance().is_string() =>
        {
            Some(vec![JsonType::String])
        }
        _ => None,
    }
}

/// The words that would do, if it is a word that is wrong.
pub(super) fn words(error: &ValidationError<'_>, place: &str) -> Option<Vec<Value>> {
    if error.instance_path().as_str() != place {
        return None;
    }
    match error.kind() {
        ValidationErrorKind::Enum { options } => Some(options.as_array().cloned().unwrap_or_default()),
        ValidationErrorKind::Constant { expected_value } => Some(vec![expected_value.as_ref().clone()]),
        _ => None,
    }
}

/// The types that would do.
pub(super) fn types(kind: &TypeKind) -> Vec<JsonType> {
    match kind {
        TypeKind::Single(kind) => vec![*kind],
        TypeKind::Multiple(kinds) => kinds.iter().collect(),
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
