//! The configuration that comes with the program.

use crate::catalog::{DEFAULT_STYLE, builtin_file, builtin_files, load_catalog};
use crate::document::Source;
use crate::recipes::Slot;

#[test]
fn the_builtin_catalogue_loads_without_faults_or_warnings() {
    let loaded = load_catalog(&[]).unwrap_or_else(|faults| panic!("{faults}"));
    assert!(loaded.warnings.is_empty(), "{}", loaded.warnings);
    let catalog = loaded.value;
    assert!(catalog.classes.is_sorted_by(|a, b| a.id < b.id));
    assert!(catalog.styles.contains(DEFAULT_STYLE));
    for palette in catalog.palettes.values() {
        assert_eq!(palette.materials.len(), Slot::ALL.len(), "{}", palette.id);
    }
}

#[test]
fn every_definition_has_an_origin() {
    let catalog = load_catalog(&[]).unwrap().value;
    for ((kind, id), origin) in &catalog.origins {
        let file = origin.file.strip_prefix("configs").unwrap_or_else(|_| panic!("{kind:?} {id}"));
        let text = builtin_file(&file.display().to_string().replace('\\', "/")).unwrap();
        let table = ["classes", "room_types", "styles", "building_styles", "palettes"][*kind as usize];
        let key = Source::new(file, text).fault_of_key(&[table.into(), id.as_str().into()], "", None);
        assert_eq!(origin.line, key.position.map(|(line, _)| line), "{kind:?} {id}");
    }
}

#[test]
fn every_file_names_its_schema() {
    let files = builtin_files();
    for file in files.iter().filter(|file| file.path.ends_with(".yaml")) {
        let name =
            file.text.lines().next().and_then(|line| line.strip_prefix("# yaml-language-server: $schema="));
        let name = name.unwrap_or_else(|| panic!("{} does not name its schema", file.path));
        let depth = file.path.matches('/').count();
        let path = name.strip_prefix(&"../".repeat(depth));
        assert!(files.iter().any(|schema| Some(schema.path) == path), "{}: there is no {name}", file.path);
    }
}
