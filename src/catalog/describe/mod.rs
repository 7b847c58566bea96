//! Describes the catalogue: lists and single definitions, as text for people and as values for programs.

mod building_style;
mod class;
mod lines;
mod palette;
mod plan;
mod programme;
mod room;
mod style;

use std::path::Path;

use serde_json::{Value, json};

use super::{Catalog, DefinitionKind, Style};
use crate::document::{Fault, Faults, did_you_mean};
use lines::Lines;

/// An answer about the catalogue.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// For people: lines of text, each ended by a newline.
    pub text: String,
    /// For programs: the same as JSON, keys as in configuration files, lengths in metres, angles in degrees,
    /// colours in sRGB.
    pub value: Value,
}

/// Describes one definition, all of a kind, or (with no kind) how many there are of each.
///
/// # Errors
/// If there is no definition of that id; the fault names the kind and hints at a similar id.
pub fn describe(
    catalog: &Catalog,
    kind: Option<DefinitionKind>,
    id: Option<&str>,
) -> Result<Description, Faults> {
    match (kind, id) {
        (None, None) => Ok(describe_all(catalog)),
        (Some(DefinitionKind::Style), None) => Ok(describe_styles(catalog)),
        (Some(kind), None) => Ok(describe_kind(catalog, kind)),
        (Some(DefinitionKind::Style), Some(id)) => {
            describe_any(catalog, &[DefinitionKind::Style, DefinitionKind::BuildingStyle], id)
        }
        (Some(kind), Some(id)) => describe_any(catalog, &[kind], id),
        (None, Some(id)) => describe_any(catalog, &DefinitionKind::ALL, id),
    }
}

/// The definition of an id, of the first of the kinds that has one.
fn describe_any(catalog: &Catalog, kinds: &[DefinitionKind], id: &str) -> Result<Description, Faults> {
    let mut found = kinds.iter().filter_map(|&kind| describe_one(catalog, kind, id));
    found.next().ok_or_else(|| unknown(catalog, kinds, id))
}

/// Styles and building styles: plans name both by the same key.
fn describe_styles(catalog: &Catalog) -> Description {
    let mut styles = describe_kind(catalog, DefinitionKind::Style);
    if catalog.building_styles.is_empty() {
        return styles;
    }
    let mut buildings = describe_kind(catalog, DefinitionKind::BuildingStyle);
    styles.text += &format!("\nbuilding styles\n{}", buildings.text);
    styles.value["building_styles"] = buildings.value["building_styles"].take();
    styles
}

/// The ids of a kind, sorted; what is abstract is left out.
fn ids(catalog: &Catalog, kind: DefinitionKind) -> Vec<&str> {
    match kind {
        DefinitionKind::Class => catalog.classes.iter().map(|class| class.id.as_str()).collect(),
        DefinitionKind::RoomType => catalog.room_types.keys().map(String::as_str).collect(),
        DefinitionKind::Style => catalog.styles.ids().collect(),
        DefinitionKind::BuildingStyle => catalog.building_styles.keys().map(String::as_str).collect(),
        DefinitionKind::Palette => catalog.palettes.ids().collect(),
    }
}

fn unknown(catalog: &Catalog, kinds: &[DefinitionKind], id: &str) -> Faults {
    let names: Vec<&str> = kinds.iter().map(|kind| kind.name()).collect();
    let candidates: Vec<&str> = kinds.iter().flat_map(|&kind| ids(catalog, kind)).collect();
    let fault = Fault::of_file(Path::new("catalog"), format!("there is no {} \"{id}\"", names.join(" or ")));
    match did_you_mean(id, candidates) {
        Some(hint) => fault.with_hint(hint).into(),
        None => fault.into(),
    }
}

fn describe_all(catalog: &Catalog) -> Description {
    let mut lines = Lines::default();
    let mut value = serde_json::Map::new();
    for kind in DefinitionKind::ALL {
        let count = ids(catalog, kind).len();
        lines.add(kind.plural(), &count.to_string());
        value.insert(kind.plural().replace(' ', "_"), json!(count));
    }
    Description { text: lines.text(), value: Value::Object(value) }
}

/// One line for each: id, label, what matters most, file.
fn describe_kind(catalog: &Catalog, kind: DefinitionKind) -> Description {
    let mut rows = Vec::new();
    let mut values = Vec::new();
    for id in ids(catalog, kind) {
        let (label, fact) = match kind {
            DefinitionKind::Class => class::summary(catalog, id),
            DefinitionKind::RoomType => room::summary(catalog, id),
            DefinitionKind::Style => style::summary(catalog, id),
            DefinitionKind::BuildingStyle => building_style::summary(catalog, id),
            DefinitionKind::Palette => palette::summary(catalog, id),
        };
        let file = file_of(catalog, kind, id);
        values.push(describe_one(catalog, kind, id).map(|description| description.value));
        rows.push([id.to_owned(), label, fact, file]);
    }
    let key = kind.plural().replace(' ', "_");
    Description { text: lines::table(&rows), value: json!({ key: values }) }
}

fn describe_one(catalog: &Catalog, kind: DefinitionKind, id: &str) -> Option<Description> {
    let (mut lines, mut value) = match kind {
        DefinitionKind::Class => class::describe_class(catalog, catalog.class_index(id)?),
        DefinitionKind::RoomType => room::describe_room_type(catalog, catalog.room_types.get(id)?),
        DefinitionKind::Style => {
            style::describe_style(catalog, catalog.styles.get(id)?, base_style(catalog, id))
        }
        DefinitionKind::BuildingStyle => {
            building_style::describe_building_style(catalog, catalog.building_styles.get(id)?)
        }
        DefinitionKind::Palette => palette::describe_palette(catalog, catalog.palettes.find(id)?),
    };
    let file = file_of(catalog, kind, id);
    let origin = catalog.origins.get(&(kind, id.to_owned()));
    let line = origin.and_then(|origin| origin.line);
    let base = origin.and_then(|origin| origin.extends.as_deref());
    lines.add("extends", base.unwrap_or_default());
    lines.add("written in", &line.map_or_else(|| file.clone(), |line| format!("{file}:{line}")));
    value["file"] = json!(file);
    value["line"] = json!(line);
    value["extends"] = json!(base);
    value["id"] = json!(id);
    let mut text = format!("{} {id}\n{}", kind.name(), lines.text());
    if let (DefinitionKind::Class, Some(class)) = (kind, catalog.class_index(id)) {
        text += "\n";
        text.extend(
            plan::plan(&catalog.classes[class])
                .iter()
                .map(|line| format!("  {line}").trim_end().to_owned() + "\n"),
        );
    }
    Some(Description { text, value })
}

/// The differences of a style from the one that it extends: names of facts, and their values in words.
#[must_use]
pub fn style_differences(catalog: &Catalog, style: &Style) -> Vec<(&'static str, String)> {
    style::differences(catalog, style, base_style(catalog, &style.id))
}

/// The style that another extends; one that replaces an earlier one of its own name has none to compare with.
fn base_style<'a>(catalog: &'a Catalog, id: &str) -> Option<&'a Style> {
    let base = catalog.origins.get(&(DefinitionKind::Style, id.to_owned()))?.extends.as_ref()?;
    catalog.styles.get(base).filter(|style| style.id != id)
}

/// The file that defines it, with `/` on every system.
fn file_of(catalog: &Catalog, kind: DefinitionKind, id: &str) -> String {
    let origin = catalog.origins.get(&(kind, id.to_owned()));
    origin.map(|origin| origin.file.display().to_string().replace('\\', "/")).unwrap_or_default()
}
