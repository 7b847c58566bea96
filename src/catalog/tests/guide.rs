//! The guide's examples work.

use super::resolved::folder;
use crate::catalog::load_catalog;

const GUIDE: &str = include_str!("../../../docs/adding-furniture.md");

#[test]
fn the_examples_of_the_guide_are_one_good_folder() {
    let blocks: Vec<&str> =
        GUIDE.split("```yaml\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    let files: Vec<(&str, &str)> =
        blocks.iter().map(|block| (block.lines().next().unwrap().trim_start_matches("# "), *block)).collect();
    assert_eq!(files.len(), 8, "{:?}", files.iter().map(|(name, _)| name).collect::<Vec<_>>());
    let folder = folder(&files);
    let loaded = load_catalog(&[folder.path().to_owned()]).unwrap_or_else(|faults| panic!("{faults}"));
    assert!(loaded.warnings.is_empty(), "{}", loaded.warnings);
    let catalog = loaded.value;
    assert!(catalog.class_index("wide_reading_chair").is_some());
    assert!(catalog.styles["club"].programme(&catalog.room_types["reading_room"]).count() == 7);
    assert_eq!(catalog.building_styles["residence"].style("bedroom", 0.7), Some("home_modern"));
    assert_eq!(catalog.room_words.room_type("imdf", "readingroom"), Some("reading_room"));
    let class = catalog.class_index("bookshelf").unwrap();
    assert_eq!(catalog.classes[class].priority, 90);
}

#[test]
fn the_fault_that_the_guide_shows_is_reported_so() {
    let block = GUIDE.split("```yaml\n").nth(1).unwrap().split("```").next().unwrap();
    let folder = folder(&[("classes/reading.yaml", &block.replace("{on: bookshelf", "{on: bookself"))]);
    let faults = load_catalog(&[folder.path().to_owned()]).unwrap_err();
    assert_eq!(faults.0.len(), 1, "{faults}");
    let shown = faults.0[0].to_string().replace(&folder.path().display().to_string(), "my-furniture");
    assert!(
        GUIDE.contains(&format!("    {shown}\n      hint: {}\n", faults.0[0].hint.as_ref().unwrap())),
        "{shown}"
    );
}
