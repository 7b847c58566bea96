//! The configuration that comes with the program.

use crate::catalog::{
    DEFAULT_STYLE, ParentName, RelationKind, Request, builtin_catalog, builtin_file, builtin_files,
    load_catalog,
};
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
    let catalog = builtin_catalog();
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

#[test]
fn a_screen_on_a_stand_is_placed_across_from_a_seat_and_not_from_a_bed() {
    let catalog = builtin_catalog();
    for id in ["tv", "wide_tv_stand"] {
        let class = &catalog.classes[catalog.class_index(id).unwrap()];
        let faces = class.relations.iter().find(|relation| relation.kind == RelationKind::Opposite);
        let ParentName::Classes(targets) = &faces.unwrap().target else { panic!("{id} faces no class") };
        assert!(!targets.is_empty());
        let is_seat = |&target: &usize| catalog.classes[target].groups.iter().any(|group| group == "seat");
        assert!(targets.iter().all(is_seat), "{id}");
    }
}

/// Whether a room of a type and area asks for a class, and whether it cannot do without.
fn asks(room_type: &str, class: &str, area: f64) -> (bool, bool) {
    let catalog = builtin_catalog();
    let class = catalog.class_index(class).unwrap();
    let applies =
        |line: &&Request| line.classes.contains(&class) && (line.area.0..=line.area.1).contains(&area);
    let lines: Vec<_> = catalog.room_types[room_type].programme.iter().filter(applies).collect();
    (!lines.is_empty(), lines.iter().any(|line| line.is_required))
}

#[test]
fn rooms_below_their_usual_area_ask_for_less_beside_a_bed() {
    assert_eq!(asks("shared_room", "small_desk", 8.4), (true, false));
    assert_eq!(asks("shared_room", "small_desk", 9.5), (true, true));
    assert_eq!(asks("studio_kitchen", "worktop", 20.5), (false, false));
    assert_eq!(asks("studio_kitchen", "worktop", 22.5), (true, false));
}

#[test]
fn the_largest_main_rooms_of_planned_buildings_have_furniture_on_their_floor() {
    let catalog = builtin_catalog();
    for kind in catalog.typologies.typologies.values() {
        let Some(main) = &kind.main else { continue };
        let (room_type, area) = (&catalog.room_types[main], kind.area.1.min(5000.0));
        let stands = |&class: &usize| {
            let on_floor = |parent: &ParentName| matches!(parent, ParentName::Floor | ParentName::Wall);
            catalog.classes[class]
                .parents
                .iter()
                .any(|rule| on_floor(&rule.parent) && rule.elevation.0 == 0.0)
        };
        let applies = |line: &Request| (line.area.0..=line.area.1).contains(&area);
        let has_some =
            room_type.programme.iter().any(|line| applies(line) && line.classes.iter().any(stands));
        assert!(has_some || !room_type.is_furnished, "{main} is empty from some area on");
    }
}
