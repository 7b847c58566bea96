//! Resolves sizes, as written or as a user's model gives them.

use super::model::model_path;
use super::number::{FACTOR, LENGTH, Quantity, TURN};
use super::shape::AXES;
use crate::catalog::Size;
use crate::catalog::file::{ClassEntry, ModelEntry, ModelFields};
use crate::catalog::read::Files;
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::{Chain, FoundValue};
use crate::model_file::model_file_size;

/// Sizes are kept to a tenth of a millimetre, whatever the arithmetic of the model's file gives.
const STEPS_PER_METRE: f64 = 10_000.0;

/// The sizes of a class; empty where there is none, which is reported for classes that are not abstract. The nearest
/// definition that gives sizes counts: as a list, or by the `scale` of a model file.
pub(super) fn resolve_sizes(
    chain: &Chain<'_, ClassEntry>,
    files: &Files,
    report: &mut Report<'_>,
) -> Vec<Size> {
    let Some(found) = chain.find("sizes", sized) else {
        if !chain.own().entry.is_abstract {
            let message = format!("class \"{}\" has no sizes", chain.own().id);
            report.error_at_key(
                &chain.own().spot,
                message,
                "write `sizes: [[width, depth, height]]` in metres",
            );
        }
        return Vec::new();
    };
    let model = found.definition.spot.key("model");
    let Some(written) = found.value.sizes.as_deref() else {
        let of_model = found
            .value
            .sized_file()
            .and_then(|(fields, scale)| size_of_model(fields, scale, &model, files, report));
        return of_model.into_iter().collect();
    };
    if found.value.sized_file().is_some() {
        let message = "the size is given by `sizes` and by the model's `scale`";
        report.error_with_hint(&model.key("scale"), message, "write one of the two");
    }
    if written.is_empty() {
        report.error_with_hint(
            &found.spot,
            "the list of sizes is empty",
            "write at least [[width, depth, height]]",
        );
    }
    check_sizes(written, &found.spot, report)
}

/// Sizes under a further key: those that a class falls back on, or that only fill niches. They belong to the entry that gives the
/// sizes: a class with sizes of its own inherits none of its base's.
pub(super) fn resolve_further_sizes(
    chain: &Chain<'_, ClassEntry>,
    key: &'static str,
    written: impl Fn(&ClassEntry) -> &[[f64; 3]],
    report: &mut Report<'_>,
) -> Vec<Size> {
    let found = chain.find(key, |entry| sized(entry).map(&written));
    found.map_or_else(Vec::new, |found| check_sizes(found.value, &found.spot, report))
}

/// The model of the nearest definition that has one. A model that gives its size is that of its own definition and of
/// those that do not write sizes: a new model for `desk` is not meant for `small_desk`.
pub(super) fn find_model<'a>(
    chain: &Chain<'a, ClassEntry>,
) -> Option<FoundValue<'a, ClassEntry, ModelEntry>> {
    let gives_sizes = chain.find("sizes", sized).map(|found| found.value);
    chain.find("model", |entry| {
        let is_of_other_size =
            entry.sized_file().is_some() && gives_sizes.is_some_and(|other| !std::ptr::eq(other, entry));
        entry.model.as_ref().filter(|_| !is_of_other_size)
    })
}

/// The entry, if it gives sizes.
fn sized(entry: &ClassEntry) -> Option<&ClassEntry> {
    (entry.sizes.is_some() || entry.sized_file().is_some()).then_some(entry)
}

fn check_sizes(written: &[[f64; 3]], spot: &Spot, report: &mut Report<'_>) -> Vec<Size> {
    let sizes = written.iter().enumerate();
    sizes.map(|(index, lengths)| check_size(lengths, &spot.index(index), report)).collect()
}

fn check_size(lengths: &[f64; 3], spot: &Spot, report: &mut Report<'_>) -> Size {
    let mut check = |axis: usize| {
        let quantity = Quantity::metres(AXES[axis].0, LENGTH);
        quantity.check(lengths[axis], &spot.index(axis), report)
    };
    Size { width: check(0), depth: check(1), height: check(2) }
}

/// The size of a model file times its scale. What else is wrong with the entry is reported with the model.
fn size_of_model(
    fields: &ModelFields,
    scale: f64,
    spot: &Spot,
    files: &Files,
    report: &mut Report<'_>,
) -> Option<Size> {
    let scale = Quantity::plain("scale", FACTOR).check(scale, &spot.key("scale"), report);
    let path = model_path(fields.file.as_deref()?, spot, files)?;
    let turn = fields.turn.filter(|turn| TURN.contains(turn)).unwrap_or(0.0);
    match model_file_size(&path, turn.to_radians()) {
        Ok(size) => {
            let kept = |length: f64| (length * scale * STEPS_PER_METRE).round() / STEPS_PER_METRE;
            let lengths = [size.width, size.depth, size.height].map(kept);
            for (length, (name, ..)) in lengths.into_iter().zip(AXES) {
                if !LENGTH.contains(&length) {
                    let message = format!("the {name} of the model times its scale is {length} m");
                    let hint =
                        format!("furniture has {} m to {} m; change `scale`", LENGTH.start(), LENGTH.end());
                    report.error_with_hint(&spot.key("scale"), message, &hint);
                    return None;
                }
            }
            let [width, depth, height] = lengths;
            Some(Size { width, depth, height })
        }
        Err(faults) => {
            report.faults.merge(faults);
            None
        }
    }
}
