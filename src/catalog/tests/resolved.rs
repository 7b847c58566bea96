//! Valid configuration resolves to the expected values.

use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::cases::load_above_base;
use crate::catalog::load::load_files;
use crate::catalog::read::Files;
use crate::catalog::{
    Along, Catalog, Class, Count, Dado, Extent, ForWhom, ModelSource, ParentName, RelationKind, Request,
    Shape, Side, Turn,
};
use crate::document::Faults;
use crate::recipes::{Slot, find};

/// A folder with the given files.
pub(super) fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        write(folder.path(), name, text);
    }
    folder
}

pub(super) fn write(folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// The catalogue of the base and folders of one file each; there must be no faults.
fn load(layers: &[(&str, &str)]) -> Catalog {
    let folders: Vec<TempDir> = layers.iter().map(|layer| folder(&[*layer])).collect();
    let paths: Vec<PathBuf> = folders.iter().map(|folder| folder.path().to_owned()).collect();
    let (catalog, warnings) = load_above_base(&paths).unwrap_or_else(|faults| panic!("{faults}"));
    assert!(warnings.is_empty(), "{warnings}");
    catalog
}

fn load_classes(classes: &str) -> Catalog {
    load(&[("classes/a.yaml", &format!("version: 1\nclasses:\n{classes}"))])
}

fn class<'a>(catalog: &'a Catalog, id: &str) -> &'a Class {
    &catalog.classes[catalog.class_index(id).unwrap()]
}

#[test]
fn a_class_takes_the_keys_that_it_does_not_have() {
    let catalog = load_classes(
        "  first: {abstract: true, label: First, looks: 2, groups: [old], sizes: [[1, 1, 1]], parents: {on: floor},
            model: table, sides: {front: {places: 1}, above: {places: 2, margin: 0.1}}}
  second: {extends: first, sides: {above: {places: 5}}, priority: 3}
  third: {extends: second, groups: new, label: Third}
",
    );
    assert!(catalog.class_index("first").is_none(), "an abstract class is no class");
    let (second, third) = (class(&catalog, "second"), class(&catalog, "third"));
    assert_eq!((second.label.as_str(), second.looks, second.priority), ("First", 2, 3));
    assert_eq!((third.label.as_str(), third.priority), ("Third", 3));
    assert_eq!((&second.groups, &third.groups), (&vec!["old".to_owned()], &vec!["new".to_owned()]));
    // Sides are merged side by side, each of them whole.
    assert_eq!(third.offer(Side::Front).places, 1);
    assert_eq!(third.offer(Side::Above).places, 5);
    assert!(third.offer(Side::Above).margin.iter().all(|&margin| margin == 0.0));
}

#[test]
fn a_later_folder_replaces_a_class_or_extends_it() {
    let chair = |entry: &str| format!("version: 1\nclasses:\n  chair: {entry}\n");
    let replacing = chair("{sizes: [[0.4, 0.4, 0.8]], parents: {on: floor}, model: stool}");
    let building = chair("{extends: chair, looks: 4}");
    let catalog = load(&[("classes/a.yaml", &replacing), ("classes/b.yaml", &building)]);
    let chair = class(&catalog, "chair");
    assert_eq!((chair.looks, chair.depth), (4, 0));
    assert!(chair.groups.is_empty(), "nothing of the base is left");
    assert_eq!(chair.model, ModelSource::Recipe { recipe: find("stool").unwrap(), parameters: Vec::new() });
}

#[test]
fn classes_that_extend_a_replaced_class_follow_the_replacement() {
    let first = "version: 1\nclasses: {desk: {extends: table}}\n";
    let second = "version: 1\nclasses: {table: {extends: table, looks: 7}}\n";
    let catalog = load(&[("classes/a.yaml", first), ("classes/b.yaml", second)]);
    assert_eq!(class(&catalog, "desk").looks, 7);
}

#[test]
fn words_mean_ids_and_groups_and_room_parts_have_their_sides() {
    let catalog = load_classes(
        "  lamp: {sizes: [[0.2, 0.2, 0.4]], model: desk_lamp, parents: [
    {on: [surface, table], side: above}, {on: wall}, {on: column}, {on: ceiling, turn: any, jitter: 90, gap: [0.1, 0.2]},
    {on: floor, along: center, elevation: 1.5}]}
  surface: {extends: lamp, parents: {on: floor}, sides: {above: {places: 1}}}
",
    );
    let index = |id| catalog.class_index(id).unwrap();
    let parents = &class(&catalog, "lamp").parents;
    // `surface` is a class here and the group of the table.
    let mut expected = vec![index("surface"), index("table")];
    expected.sort_unstable();
    assert_eq!(parents[0].parent, ParentName::Classes(expected));
    let stand_ins = |id| class(&catalog, id).stand_ins.clone();
    assert_eq!((stand_ins("surface"), stand_ins("table")), (vec![index("table")], vec![]));
    let sides: Vec<Vec<Side>> = parents.iter().skip(1).map(|rule| rule.sides.clone()).collect();
    let around = vec![Side::Front, Side::Back, Side::Left, Side::Right];
    assert_eq!(sides, [vec![Side::Front], around, vec![Side::Below], vec![Side::Above]]);
    assert_eq!((parents[1].orientation.turn, parents[4].orientation.turn), (Turn::Parallel, Turn::Quarter));
    assert_eq!((parents[3].orientation.turn, parents[3].gap), (Turn::Any, (0.1, 0.2)));
    assert!((parents[3].orientation.jitter - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    assert_eq!((parents[4].along, parents[4].elevation), (Along::Center, (1.5, 1.5)));
}

#[test]
fn depth_is_the_shortest_way_to_a_room_part() {
    let thing = |id: &str, parents: &str| {
        format!(
            "  {id}: {{sizes: [[0.1, 0.1, 0.1]], model: box, parents: {parents}, sides: {{above: {{places: 1}}}}}}\n"
        )
    };
    let classes = [
        thing("tray", "{on: table, side: above}"),
        thing("cup", "[{on: tray, side: above}, {on: saucer, side: above}]"),
        thing("saucer", "[{on: cup, side: above}, {on: tray, side: above}]"),
        thing("spoon", "[{on: saucer, side: above}, {on: table, side: above}]"),
    ]
    .concat()
    .replace("model: box", "model: tray");
    let catalog = load_classes(&classes);
    let depths = ["table", "chair", "tray", "cup", "saucer", "spoon"].map(|id| class(&catalog, id).depth);
    assert_eq!(depths, [0, 1, 1, 2, 2, 1]);
}

#[test]
fn sides_of_which_one_is_enough_are_clearances_apart() {
    let bed = |clearances: &str| {
        let parents = "parents: {on: floor}, model: bed, sizes: [[1.6, 2.0, 0.6]]";
        load_classes(&format!("  wide_bed: {{{parents}, clearances: {clearances}}}\n"))
    };
    let catalog =
        bed("[{side: front, minimum: 0.5}, {side: [left, right], minimum: 0.6, good: 1, either: true}]");
    let bed = class(&catalog, "wide_bed");
    let sides =
        |clearances: &[crate::catalog::Clearance]| clearances.iter().map(|one| one.side).collect::<Vec<_>>();
    assert_eq!(
        (sides(&bed.clearances), sides(&bed.either)),
        (vec![Side::Front], vec![Side::Left, Side::Right])
    );
    assert_eq!((bed.clearance(1).side, bed.is_either(0), bed.is_either(1)), (Side::Left, false, true));
}

#[test]
fn shapes_clearances_relations_and_grids_are_read() {
    let catalog = load_classes(
        "  desk:
    sizes: [[1.6, 0.8, 0.75]]
    model: {recipe: desk, drawers: 3}
    parents: {on: floor}
    shape: [{from: [0, 0, \"100%-0.03\"], to: [\"100%\", 0.5, \"100%\"]}, {disc: true, from: [0, 0, 0], to: [0.1, 0.1, 0.1]}]
    clearances: [{side: [left, right], minimum: 0.5}, {side: front, minimum: 0.7, good: 0.9, margin: 0.1, children: true}]
    relations: [{away_from: bed, distance: 2}, {near: window, distance: 2}, {faces: [chair, bed], angle: 90, weight: 2}]
    grid: {interval: 2, centered: true}
    sides: {above: {places: 2, surface: 0.7, margin: [0.1, 0.2, 0.3, 0.4], space: 1}}
",
    );
    let desk = class(&catalog, "desk");
    let Shape::Prisms(prisms) = &desk.shape else { panic!("{:?}", desk.shape) };
    assert_eq!(prisms[0].low[2], Extent { share: 1.0, offset: -0.03 });
    assert_eq!(prisms[0].high[1], Extent { share: 0.0, offset: 0.5 });
    assert_eq!((prisms[0].is_disc, prisms[1].is_disc), (false, true));
    let clearances: Vec<(Side, f64, f64, bool)> =
        desk.clearances.iter().map(|one| (one.side, one.minimum, one.good, one.allows_children)).collect();
    let expected =
        [(Side::Left, 0.5, 0.5, false), (Side::Right, 0.5, 0.5, false), (Side::Front, 0.7, 0.9, true)];
    assert_eq!(clearances, expected);
    let relations: Vec<(RelationKind, (f64, f64))> =
        desk.relations.iter().map(|relation| (relation.kind, relation.distance)).collect();
    assert_eq!(relations[0], (RelationKind::AwayFrom, (2.0, 1000.0)));
    assert_eq!(relations[1], (RelationKind::Near, (0.0, 2.0)));
    assert_eq!(desk.relations[1].target, ParentName::Window);
    assert!((desk.relations[2].angle - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    let grid = desk.grid.unwrap();
    assert_eq!((grid.interval.x, grid.interval.y, grid.is_centered), (2.0, 2.0, true));
    assert_eq!(
        desk.model,
        ModelSource::Recipe { recipe: find("desk").unwrap(), parameters: vec![("drawers".to_owned(), 3.0)] }
    );
    let above = desk.offer(Side::Above);
    assert_eq!((above.surface, above.margin, above.space), (Some(0.7), [0.1, 0.2, 0.3, 0.4], Some(1.0)));
}

#[test]
fn programmes_finishes_and_counts_are_read() {
    let rooms = "version: 1
room_types:
  base: {abstract: true, finish: {floor: tile, wall: tile_wall, dado: {slot: stone, height: 1.2}, sockets: 0}, density: [0.2, 0.4], furnish: false, excludes: seat}
  bath:
    extends: base
    finish: {floor: stone, switches: false}
    programme:
      - {class: table}
      - {class: [bed, surface], count: [1, 2], chance: 0.5, window: true, area: 9, required: true, or: table}
      - {class: table, count: {per: table, each: 4}}
      - {class: table, count: {per_area: 0.2, least: 1}}
      - {class: table, count: {fill: 10}, area: [4, 9]}
      - {class: table, count: {fill: 10, per_area: 0.5}}
";
    let catalog = load(&[("rooms/a.yaml", rooms)]);
    let (bath, index) = (&catalog.room_types["bath"], |id| catalog.class_index(id).unwrap());
    assert!(!catalog.room_types.contains_key("base") && !catalog.room_words.known.contains("base"));
    assert_eq!((bath.label.as_str(), bath.is_furnished, bath.density), ("Bath", false, (0.2, 0.4)));
    let finish = [bath.finish.floor, bath.finish.wall, bath.finish.ceiling];
    assert_eq!(finish, [Slot::Stone, Slot::TileWall, Slot::Ceiling]);
    assert_eq!(bath.finish.dado, Some(Dado { slot: Slot::Stone, height: 1.2 }));
    assert_eq!((bath.finish.sockets, bath.finish.has_switches), (None, false));
    let office = &catalog.room_types["office"].finish;
    assert_eq!((office.sockets, office.has_switches), (Some(3.0), true), "where nothing is said");
    assert_eq!(bath.excludes, ["seat"]);
    let second = Request {
        classes: vec![index("bed"), index("table")],
        substitutes: vec![index("table")],
        count: Count::Range(1, 2),
        area: (9.0, 1e6),
        is_required: true,
        chance: 0.5,
        needs_window: true,
        for_whom: ForWhom::default(),
    };
    assert_eq!(bath.programme[1], second);
    let counts: Vec<Count> = bath.programme.iter().map(|request| request.count).collect();
    let (per_piece, per_area) = (Count::PerPiece(index("table"), 4.0), Count::PerArea(0.2, 1, 1000));
    let fill_per_area = Count::FillPerArea(0.5, 10);
    assert_eq!(counts, [Count::Fixed(1), second.count, per_piece, per_area, Count::Fill(10), fill_per_area]);
    assert_eq!(bath.programme[4].area, (4.0, 9.0));
}

#[test]
fn styles_inherit_room_type_by_room_type() {
    let styles = "version: 1
styles:
  inn: {untidiness: {turn: 90, distance: 0.1}, density: 2, palette: modern, room_types: [office, generic],
        programmes: {office: [{class: table}], generic: [{class: bed}]}, additions: {office: [{class: table}]}}
  cheap_inn: {extends: inn, untidiness: {distance: 0.2}, geometry: traditional, programmes: {office: []}}
";
    let catalog = load(&[("styles/a.yaml", styles)]);
    let (cheap, office) = (catalog.styles.get("cheap_inn").unwrap(), &catalog.room_types["office"]);
    assert_eq!(
        (cheap.label.as_str(), cheap.density, cheap.geometry.name()),
        ("Cheap inn", 2.0, "traditional")
    );
    assert!((cheap.untidiness.turn - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    assert_eq!(cheap.untidiness.distance.to_bits(), 0.2_f64.to_bits());
    assert_eq!(cheap.programmes["generic"].len(), 1);
    assert_eq!(cheap.programme(office).count(), 1, "no programme of its own, one line added");
    assert_eq!(catalog.styles.get("inn").unwrap().programme(office).count(), 2);
    assert_eq!(cheap.room_types, ["generic", "office"]);
}

#[test]
fn materials_inherit_key_by_key_and_become_linear() {
    let palettes = "version: 1
palettes:
  warm: {extends: modern, materials: {wood: {color: \"#ff8000\", roughness: 0.4}, lamp: {emissive: \"#ffffff\", emissive_strength: 2.5}}}
  warmer: {extends: warm, materials: {wood: {roughness: 0.3, opacity: 0.5}}}
";
    let catalog = load(&[("palettes/a.yaml", palettes)]);
    let (wood, lamp) = (
        &catalog.palettes.get("warmer").unwrap().materials[&Slot::Wood],
        &catalog.palettes.get("warmer").unwrap().materials[&Slot::Lamp],
    );
    let [red, green, blue, opacity] = wood.base_color;
    assert!((red - 1.0).abs() < 1e-6 && (green - 0.215_86).abs() < 1e-4 && blue.abs() < 1e-6);
    assert!((wood.roughness - 0.3).abs() < 1e-6 && (opacity - 0.5).abs() < 1e-6);
    assert_eq!(lamp.emissive_strength.to_bits(), 2.5_f32.to_bits());
    assert!(lamp.emissive.iter().all(|channel| (channel - 1.0).abs() < 1e-6));
}

#[test]
fn room_words_are_merged_word_by_word() {
    let words = |table: &str| format!("version: 1\nformats: {{archilyse: {table}}}\n");
    let (first, second) = (words("{BEDROOM: generic, Shaft: generic}"), words("{bedroom: office}"));
    let catalog = load(&[
        ("room_words.yaml", &first),
        ("room_words.json", "{\"version\": 1, \"formats\": {\"x\": {\"a\": \"office\"}}}"),
        ("room_words.yml", &second),
    ]);
    let words = &catalog.room_words;
    assert_eq!(words.room_type("archilyse", "Bedroom"), Some("office"));
    assert_eq!(words.room_type("archilyse", "SHAFT"), Some("generic"));
    assert_eq!(words.room_type("x", "A"), Some("office"));
}

#[test]
fn rules_for_guesses_come_before_those_of_earlier_folders() {
    let rules =
        |kind: &str| format!("version: 1\nformats: {{}}\nguesses: [{{read_as: {kind}, area: [1, 2]}}]\n");
    let catalog = load(&[("room_words.yaml", &rules("office")), ("room_words.yml", &rules("generic"))]);
    let kinds: Vec<&str> = catalog.room_words.guesses.iter().map(|rule| rule.read_as.as_str()).collect();
    assert_eq!(kinds[..2], ["generic", "office"]);
}

#[test]
fn rules_for_guesses_name_existing_room_types_only() {
    let rules = "version: 1\nformats: {}\nfamilies: {farm: [barn]}\nguesses:\n  - {read_as: stable}\n  \
                 - {read_as: office, building: [farn], above_or_below: [hayloft], area: [9, 2], doors: [3, 1]}\n";
    let folder = folder(&[("room_words.yaml", rules)]);
    let Err(faults) = load_above_base(&[folder.path().to_owned()]) else { panic!("all of it is wrong") };
    let faults: Vec<String> = faults
        .0
        .iter()
        .map(|fault| format!("{}: {}", crate::document::show_path(&fault.path), fault.message))
        .collect();
    assert_eq!(
        faults,
        [
            "families.farm: unknown room type \"barn\"",
            "guesses[0].read_as: unknown room type \"stable\"",
            "guesses[1].building[0]: unknown family of buildings \"farn\"",
            "guesses[1].above_or_below[0]: unknown room type \"hayloft\"",
            "guesses[1].area: nothing lies in this range",
            "guesses[1].doors: nothing lies in this range",
        ]
    );
}

#[test]
fn origins_name_the_last_file() {
    let folder =
        folder(&[("classes/deep/a.yaml", "version: 1\nclasses: {table: {extends: table, looks: 2}}\n")]);
    let (catalog, _) = load_above_base(&[folder.path().to_owned()]).unwrap();
    let origin = &catalog.origins[&(crate::catalog::DefinitionKind::Class, "table".to_owned())];
    assert_eq!(origin.file, folder.path().join("classes/deep/a.yaml"));
    assert_eq!(
        (origin.extends.as_deref(), origin.line),
        (Some("table"), None),
        "its line begins with another key"
    );
}

#[test]
fn missing_and_empty_folders_are_reported() {
    let empty = tempfile::tempdir().unwrap();
    let misnamed = folder(&[("class/a.yaml", ""), ("classes/notes.txt", ""), (".classes/a.yaml", "")]);
    let missing = empty.path().join("missing");
    let show = |faults: Faults| faults.0.iter().map(|fault| fault.message.clone()).collect::<Vec<_>>();
    let Err(faults) = load_above_base(&[missing]) else { panic!("the folder is missing") };
    assert!(show(faults)[0].starts_with("cannot be listed"));
    let (_, warnings) = load_above_base(&[empty.path().to_owned()]).unwrap();
    assert_eq!(show(warnings), ["this folder holds no configuration"]);
    let (_, warnings) = load_above_base(&[misnamed.path().to_owned()]).unwrap();
    assert_eq!(show(warnings), ["this folder is not read"]);
}

#[test]
fn the_default_style_and_room_type_must_exist() {
    let mut files = Files::default();
    files.add_folder(folder(&[("classes/a.yaml", "version: 1\nclasses: {}\n")]).path());
    let faults = load_files(&files).unwrap_err().to_string();
    assert!(faults.contains("no folder defines the style \"default\""), "{faults}");
    assert!(faults.contains("no folder defines the room type \"generic\""), "{faults}");
}

#[test]
fn a_model_file_gives_the_size_unless_a_nearer_definition_does() {
    let text = "version: 1\nclasses:\n  stool: {parents: {on: floor}, sizes: [[1, 1, 1]], spare_sizes: [[0.5, 0.5, 0.5]], model: desk}\n  \
        own: {extends: stool, model: {file: stool.glb, scale: 2}}\n  \
        child: {extends: own, looks: 1}\n  \
        other: {extends: own, sizes: [[0.4, 0.4, 0.7]]}\n";
    let folder = folder(&[("classes/mine.yaml", text)]);
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/stool.glb");
    fs::copy(model, folder.path().join("classes/stool.glb")).unwrap();
    let (catalog, _) =
        load_above_base(&[folder.path().to_owned()]).unwrap_or_else(|faults| panic!("{faults}"));
    let sizes = |id: &str| {
        let class = &catalog.classes[catalog.class_index(id).unwrap()];
        class.sizes.iter().map(|size| [size.width, size.depth, size.height]).collect::<Vec<_>>()
    };
    assert_eq!(sizes("own"), [[0.72, 0.72, 1.3]], "twice that of the file, and no spare one");
    assert_eq!(sizes("child"), sizes("own"));
    assert_eq!(sizes("other"), [[0.4, 0.4, 0.7]]);
    let is_file = |id: &str| {
        matches!(catalog.classes[catalog.class_index(id).unwrap()].model, ModelSource::File { .. })
    };
    assert!(
        is_file("own") && is_file("child") && !is_file("other"),
        "a model of another size is not inherited"
    );
    assert_eq!(sizes("stool").len(), 2);
}

#[test]
fn thresholds_are_merged_one_by_one_and_angles_are_radians() {
    let builtin = load(&[]).audit;
    let changed = load(&[
        ("audit.yaml", "version: 1\nthresholds: {walking: {person: 0.5}, facing: {angle: 90}}\n"),
        ("audit.json", "{\"version\": 1, \"thresholds\": {\"walking\": {\"robot\": 0.4}}}"),
    ])
    .audit;
    assert_eq!((changed.walking.person, changed.walking.robot), (0.5, 0.4));
    assert_eq!(changed.walking.narrow_person, builtin.walking.narrow_person);
    assert!((changed.facing.angle - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
}
