//! The room types, by the file that they are written in.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::catalog::{Catalog, DefinitionKind, RoomType};

use super::markdown::{number, title_of_file};
use super::programme::programme_lines;
use super::{PICTURES, by_file, sample};

/// The names of pictures without their extension, by room type.
pub(super) struct Pictures<'a>(pub(super) BTreeMap<&'a str, &'a String>);

/// All furnished room types with their pictures, and the names of the others.
pub(super) fn room_section(catalog: &Catalog, pictures: &Pictures<'_>) -> String {
    let furnished = catalog.room_types.values().filter(|room_type| room_type.is_furnished);
    let mut files = by_file(
        catalog,
        DefinitionKind::RoomType,
        furnished.map(|room_type| (room_type.id.clone(), room_type)),
    );
    for (_, room_types) in &mut files {
        room_types.sort_by_key(|room_type| &room_type.label);
    }
    let mut text = format!("## Room types\n\n{}\n{}", sample::DESCRIPTION, list(&files));
    for (file, room_types) in &files {
        let _ = write!(text, "\n### {}\n\nIn `{file}`.\n", title_of_file(file));
        text.extend(room_types.iter().map(|room_type| entry(catalog, room_type, pictures)));
    }
    let rest: Vec<&str> = catalog
        .room_types
        .values()
        .filter(|room_type| !room_type.is_furnished)
        .map(|room_type| room_type.label.as_str())
        .collect();
    if !rest.is_empty() {
        let _ = write!(text, "\nNot furnished: {}.\n", rest.join(", "));
    }
    text
}

/// The overview.
fn list(files: &[(String, Vec<&RoomType>)]) -> String {
    let line = |(file, room_types): &(String, Vec<&RoomType>)| {
        let labels: Vec<&str> = room_types.iter().map(|room_type| room_type.label.as_str()).collect();
        format!("- **{}** ({}): {}\n", title_of_file(file), labels.len(), labels.join(", "))
    };
    let lines: String = files.iter().map(line).collect();
    lines
}

fn entry(catalog: &Catalog, room_type: &RoomType, pictures: &Pictures<'_>) -> String {
    let origin = catalog.origins.get(&(DefinitionKind::RoomType, room_type.id.clone()));
    let base = origin.and_then(|origin| origin.extends.as_ref());
    let base = base.map(|base| format!(", extends `{base}`")).unwrap_or_default();
    let area = match room_type.area {
        (least, most) if least > 0.0 => format!("{} to {} m²", number(least), number(most)),
        _ => "of any area".to_owned(),
    };
    let mut text = format!("\n#### {}\n\n`{}`{base}, {area}\n\n", room_type.label, room_type.id);
    text.extend(programme_lines(catalog, room_type));
    if let Some(name) = pictures.0.get(room_type.id.as_str()) {
        // A name may hold `%`, which an address would take for the beginning of a code.
        let name = name.replace('%', "%25");
        let _ = write!(text, "\n![{}]({PICTURES}/{name}.svg)\n", room_type.label);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_room_type_without_a_picture_is_listed_all_the_same() {
        let catalog = crate::catalog::builtin_catalog();
        let office = &catalog.room_types["administration"];
        let text = entry(catalog, office, &Pictures(BTreeMap::new()));
        assert!(text.starts_with("\n#### Administration\n\n`administration`, extends `office`, "), "{text}");
        assert!(!text.contains("!["));
    }
}
