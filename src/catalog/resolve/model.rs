//! Resolves the model of a class.

use std::path::{Path, PathBuf};

use super::number::{PARAMETER, Quantity, TURN};
use super::sizes::find_model;
use crate::catalog::ModelSource;
use crate::catalog::file::{ClassEntry, ModelEntry, ModelFields, Parameter};
use crate::catalog::read::Files;
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::Chain;
use crate::recipes::{Recipe, find, recipes};

/// The model of a class, if it has one.
pub(super) fn resolve_model(
    chain: &Chain<'_, ClassEntry>,
    files: &Files,
    report: &mut Report<'_>,
) -> Option<ModelSource> {
    let Some(found) = find_model(chain) else {
        if !chain.own().entry.is_abstract {
            let message = format!("class \"{}\" has no model", chain.own().id);
            report.error_at_key(
                &chain.own().spot,
                message,
                "write `model:` with a recipe, or {file: name.glb}",
            );
        }
        return None;
    };
    match found.value {
        ModelEntry::Recipe(name) => {
            let recipe = find_recipe(name, &found.spot, report)?;
            Some(ModelSource::Recipe { recipe, parameters: Vec::new() })
        }
        ModelEntry::Fields(fields) => match (&fields.recipe, &fields.file) {
            (Some(name), None) => resolve_recipe(name, fields, &found.spot, report),
            (None, Some(file)) => resolve_file(file, fields, &found.spot, files, report),
            (Some(_), Some(_)) => {
                report.error_with_hint(
                    &found.spot,
                    "the model is both a recipe and a file",
                    "write one of the two",
                );
                None
            }
            (None, None) => {
                let hint = "write `model:` with a recipe, or {file: name.glb}";
                report.error_with_hint(&found.spot, "the model is neither a recipe nor a file", hint);
                None
            }
        },
    }
}

/// The recipe of a name; an unknown name is reported.
fn find_recipe(name: &str, spot: &Spot, report: &mut Report<'_>) -> Option<&'static Recipe> {
    let recipe = find(name);
    if recipe.is_none() {
        report.unknown(spot, "model recipe", name, recipes().iter().map(|recipe| recipe.name()));
    }
    recipe
}

fn resolve_recipe(
    name: &str,
    fields: &ModelFields,
    spot: &Spot,
    report: &mut Report<'_>,
) -> Option<ModelSource> {
    let recipe = find_recipe(name, &spot.key("recipe"), report);
    if fields.turn.is_some() {
        report.error_with_hint(
            &spot.key("turn"),
            "a recipe cannot be turned",
            "only models from files are turned",
        );
    }
    if fields.scale.is_some() {
        report.error_with_hint(
            &spot.key("scale"),
            "a recipe has no size of its own",
            "write `sizes`; only models from files are scaled",
        );
    }
    let recipe = recipe?;
    let known = recipe.parameters();
    let mut parameters = Vec::new();
    for (key, parameter) in &fields.parameters {
        if !known.iter().any(|(name, _)| name == key) {
            let candidates = known.iter().map(|(name, _)| *name);
            report.unknown(&spot.key(key), &format!("parameter of recipe \"{name}\""), key, candidates);
        }
        let value = match parameter {
            Parameter::Number(value) => {
                Quantity::plain("a parameter", PARAMETER).check(*value, &spot.key(key), report)
            }
            Parameter::Switch(is_on) => f64::from(u8::from(*is_on)),
        };
        parameters.push((key.clone(), value));
    }
    Some(ModelSource::Recipe { recipe, parameters })
}

/// The file of a model, where it can be read; where it cannot, that is reported with the model.
pub(super) fn model_path(file: &str, spot: &Spot, files: &Files) -> Option<PathBuf> {
    let path = beside(file, spot, files);
    (!files.is_builtin(spot.source) && is_gltf(&path) && path.is_file()).then_some(path)
}

/// Paths are relative to the file that names them.
fn beside(file: &str, spot: &Spot, files: &Files) -> PathBuf {
    files.sources[spot.source].file().parent().unwrap_or(Path::new("")).join(file)
}

fn is_gltf(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    ["glb", "gltf"].iter().any(|known| extension.eq_ignore_ascii_case(known))
}

fn resolve_file(
    file: &str,
    fields: &ModelFields,
    spot: &Spot,
    files: &Files,
    report: &mut Report<'_>,
) -> Option<ModelSource> {
    for name in fields.parameters.keys() {
        let message = format!("a model from a file has no parameter \"{name}\"");
        report.error_with_hint(&spot.key(name), message, "possible here: file, turn, scale");
    }
    let turn = Quantity::degrees("turn", TURN);
    let turn = turn.check(fields.turn.unwrap_or(0.0), &spot.key("turn"), report);
    let spot = spot.key("file");
    if files.is_builtin(spot.source) {
        report.error(&spot, "built-in classes have no model files");
        return None;
    }
    let path = beside(file, &spot, files);
    if !is_gltf(&path) {
        report.error_with_hint(
            &spot,
            format!("\"{file}\" is no glTF file"),
            "write a path that ends in .glb or .gltf",
        );
    } else if !path.is_file() {
        let hint = format!("paths are relative to the file that names them: {}", path.display());
        report.error_with_hint(&spot, format!("there is no model file \"{file}\""), &hint);
    }
    Some(ModelSource::File { path, turn: turn.to_radians() })
}
