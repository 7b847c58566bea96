//! The descriptions of `catalog`.

use super::cases::load_above_base;
use crate::catalog::{Catalog, DefinitionKind, builtin_catalog, describe};

fn base() -> Catalog {
    let (mut catalog, _) = load_above_base(&[]).unwrap();
    for origin in catalog.origins.values_mut() {
        origin.file = origin.file.file_name().unwrap().into();
    }
    catalog
}

#[test]
fn the_description_of_a_class_has_all_its_facts() {
    let description = describe(&base(), Some(DefinitionKind::Class), Some("table")).unwrap();
    let expected = "class table
  label       Table
  groups      surface
  size        1.2 × 0.8 × 0.75 m
  looks       4 of each size, one for all that are furnished together
  shape       box
  stands      above of floor; turned quarter, along random
  offers      front 2, above 3
  priority    0
  depth       0
  model       recipe table
  children    chair
  asked for   office
  written in  furniture.yaml:4

            back
  ########################
  ########################
  ########################
  ########################
  ########################
  ########################
  ########################
  ########################
            front
  one letter is 0.05 m wide
";
    assert_eq!(description.text, expected);
    assert_eq!(description.value["sizes"], serde_json::json!([[1.2, 0.8, 0.75]]));
    assert_eq!(description.value["parents"][0]["on"], serde_json::json!(["floor"]));
    assert_eq!(description.value["children"], serde_json::json!(["chair"]));
    assert_eq!(description.value["file"], "furniture.yaml");
}

#[test]
fn a_room_type_lists_its_programme() {
    let description = describe(&base(), Some(DefinitionKind::RoomType), Some("office")).unwrap();
    let expected = "room type office
  label       Office
  furnished   yes
  usually     0 to 1000000 m²
  density     0 to 1
  excludes    sleeping
  finish      floor parquet, wall plaster, ceiling ceiling
  alike in a  building
  fitted      a socket for 3 m of wall, switches at doors
  holds       1 table
              2 per table: chair
  styles      default
  written in  rooms.yaml:5
";
    assert_eq!(description.text, expected);
    let count = &description.value["programme"][1]["count"];
    assert_eq!(count, &serde_json::json!({"per": "table", "each": 2.0}));
}

#[test]
fn lists_have_a_line_for_each_definition() {
    let catalog = base();
    let list = describe(&catalog, Some(DefinitionKind::Class), None).unwrap();
    let expected = "bed    Bed    0.9 × 2 × 0.9 m     furniture.yaml
chair  Chair  0.5 × 0.5 × 0.9 m   furniture.yaml
table  Table  1.2 × 0.8 × 0.75 m  furniture.yaml
";
    assert_eq!(list.text, expected);
    assert_eq!(list.value["classes"].as_array().unwrap().len(), 3);
    let all = describe(&catalog, None, None).unwrap();
    assert_eq!(
        all.text,
        "  classes          3\n  room types       2\n  styles           1\n  building styles  0\n  palettes         1\n"
    );
    assert_eq!(all.value["room_types"], 2);
}

#[test]
fn the_description_of_a_style_lists_its_changes() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("styles")).unwrap();
    let text = "version: 1
styles:
  full:
    extends: default
    density: 2
    additions: {office: [{class: chair, count: 1}]}
  fuller:
    extends: full
    untidiness: {turn: 3}
";
    std::fs::write(folder.path().join("styles/more.yaml"), text).unwrap();
    let (catalog, _) = load_above_base(&[folder.path().to_owned()]).unwrap();
    let text = |id: &str| describe(&catalog, Some(DefinitionKind::Style), Some(id)).unwrap().text;
    assert!(text("full").contains("2 (in default: 1)"), "{}", text("full"));
    assert!(text("full").contains("office, also  1 chair"), "{}", text("full"));
    assert!(text("fuller").contains("3°, 0 m (in full: 0°, 0 m)"), "{}", text("fuller"));
    assert!(text("fuller").contains("office, also  as in full") && !text("fuller").contains("(in full: 2)"));
    assert!(text("fuller").contains("more.yaml:7\n"), "{}", text("fuller"));
}

#[test]
fn an_unknown_id_is_a_fault_with_a_hint() {
    let faults = describe(&base(), Some(DefinitionKind::Class), Some("tabel")).unwrap_err();
    assert_eq!(faults.0[0].message, "there is no class \"tabel\"");
    assert_eq!(faults.0[0].hint.as_deref(), Some("did you mean \"table\"?"));
    assert!(describe(&base(), None, Some("office")).is_ok(), "the kind may be left out");
}

#[test]
fn everything_that_is_built_in_can_be_shown() {
    let catalog = builtin_catalog();
    for (kind, id) in catalog.origins.keys() {
        let is_abstract = match kind {
            DefinitionKind::Class => catalog.class_index(id).is_none(),
            DefinitionKind::RoomType => !catalog.room_types.contains_key(id),
            DefinitionKind::Style | DefinitionKind::BuildingStyle | DefinitionKind::Palette => false,
        };
        assert_eq!(describe(catalog, Some(*kind), Some(id)).is_err(), is_abstract, "{kind:?} {id}");
    }
    for kind in DefinitionKind::ALL {
        let list = describe(catalog, Some(kind), None).unwrap();
        assert!(list.text.lines().count() > 1 && !list.value.is_null());
    }
}
