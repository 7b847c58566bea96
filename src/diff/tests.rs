//! The published schema, and reports of generated manifests.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use super::*;

fn catalog() -> &'static Catalog {
    crate::catalog::builtin_catalog()
}

fn compared(old: &Path, new: &Path) -> Report {
    let catalog = catalog();
    let options =
        DiffOptions { tolerance: Tolerance::default(), catalog, is_thorough: false, observer: &|_, _| () };
    compare(old, new, &options).unwrap().0
}

/// A level with one chair, as small as a file can be.
fn level(number: usize, x: f64) -> String {
    serde_json::json!({"asset": {"version": "2.0"}, "nodes": [
        {"name": "level", "children": [1], "extras": {"kind": "level", "building": format!("b{}", number / 10),
            "level": format!("{}", number % 10), "elevation": 0.0, "height": 3.0}},
        {"name": "room:a", "children": [2], "extras": {"kind": "room", "room": "a", "type": "office", "style": "default",
            "seed": 7, "outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "holes": [], "height": 2.5, "requested": 1,
            "placed": 1, "removed": []}},
        {"name": "chair.1@a", "translation": [x, 0.0, -1.0], "extras": {"kind": "furniture", "class": "chair",
            "id": "chair.1", "parent": "floor", "side": "above", "size": [0.5, 0.5, 0.9], "variant": 0}},
    ]})
    .to_string()
}

/// A folder of `count` levels in which every `moved`-th has its chair elsewhere; the manifest is written last.
fn bake(root: &Path, count: usize, moved: usize) {
    let mut levels: Vec<String> = Vec::with_capacity(count);
    let filler =
        "{\"room\": \"12\", \"grade\": \"minor\", \"findings\": [{\"code\": \"tight_use\"}]}, ".repeat(30);
    for number in 0..count {
        let text = level(number, if moved > 0 && number % moved == 0 { 2.0 } else { 1.0 });
        let path = format!("b{}/{}.gltf", number / 10, number % 10);
        fs::create_dir_all(root.join(&path).parent().unwrap()).unwrap();
        fs::write(root.join(&path), &text).unwrap();
        let mut record = String::new();
        let _ = write!(
            record,
            "{{\"building\": \"b{}\", \"level\": \"{}\", \"inputs\": \"0\", \"files\": [{{\"path\": \"{path}\", \
             \"sha256\": \"{}\", \"bytes\": {}}}], \"totals\": {{\"rooms\": 1, \"placed\": 1}}, \
             \"rooms\": [{filler}{{\"room\": \"a\"}}]}}",
            number / 10,
            number % 10,
            crate::disk::content_hash(text.as_bytes()),
            text.len()
        );
        levels.push(record);
    }
    let text = format!("{{\"manifest\": 1, \"program\": \"x\", \"levels\": [{}]}}", levels.join(",\n"));
    fs::write(root.join("manifest.json"), text).unwrap();
}

#[test]
fn ten_thousand_levels_of_which_ten_changed_take_seconds() {
    let root = tempfile::tempdir().unwrap();
    let (old, new) = (root.path().join("old"), root.path().join("new"));
    bake(&old, 10_000, 0);
    bake(&new, 10_000, 1000);
    let started = Instant::now();
    let report = compared(&old, &new);
    let elapsed = started.elapsed();
    assert_eq!((report.summary.levels.identical, report.summary.levels.changed), (9_990, 10));
    assert_eq!((report.count(Kind::Moved), report.summary.changes.len()), (10, 1));
    println!("10,000 floors of which 10 changed: {elapsed:?}");
    // The aim is 5 s with an optimised build; other work on the machine may slow a test down.
    assert!(elapsed < Duration::from_secs(30), "{elapsed:?}");
}

#[test]
fn equal_files_are_not_opened() {
    let root = tempfile::tempdir().unwrap();
    let (old, new) = (root.path().join("old"), root.path().join("new"));
    bake(&old, 3, 0);
    bake(&new, 3, 2);
    // Of the recorded length and older than the manifest: taken for what was recorded.
    for side in [&old, &new] {
        let path = side.join("b0/1.gltf");
        let length = fs::read(&path).unwrap().len();
        fs::write(&path, vec![b'x'; length]).unwrap();
        let past = std::time::SystemTime::now() - Duration::from_secs(3600);
        fs::File::options().write(true).open(&path).unwrap().set_modified(past).unwrap();
    }
    let report = compared(&old, &new);
    assert!(report.troubles.is_empty(), "{:?}", report.troubles);
    let names: Vec<&str> = report.levels.iter().map(|level| level.level.as_str()).collect();
    assert_eq!(names, ["0", "2"]);
    // Both are the same rubbish; with one of them in order, a thorough comparison notices the other.
    fs::write(old.join("b0/1.gltf"), level(1, 1.0)).unwrap();
    let catalog = catalog();
    let options =
        DiffOptions { tolerance: Tolerance::default(), catalog, is_thorough: true, observer: &|_, _| () };
    let (report, _) = compare(&old, &new, &options).unwrap();
    assert!(report.levels[1].state == Presence::Unreadable && report.troubles.len() == 1, "{report:?}");
}

#[test]
fn an_unreadable_file_is_one_entry_and_the_others_are_compared() {
    let root = tempfile::tempdir().unwrap();
    let (old, new) = (root.path().join("old"), root.path().join("new"));
    bake(&old, 4, 0);
    bake(&new, 4, 2);
    fs::write(new.join("b0/1.gltf"), "cut").unwrap();
    fs::remove_file(old.join("b0/3.gltf")).unwrap();
    let report = compared(&old, &new);
    let states: Vec<Presence> = report.levels.iter().map(|level| level.state).collect();
    use Presence::{Changed, Unreadable};
    assert_eq!(states, [Changed, Unreadable, Changed, Unreadable]);
    assert_eq!(report.troubles.len(), 2);
    assert!(report.troubles[0].file.ends_with("new/b0/1.gltf") && report.troubles[1].hint.is_some());
}

#[test]
fn an_unreadable_room_is_named_and_not_compared() {
    let root = tempfile::tempdir().unwrap();
    let (old, new) = (root.path().join("old.gltf"), root.path().join("new.gltf"));
    fs::write(&old, level(0, 1.0)).unwrap();
    fs::write(&new, level(0, 2.0).replace("\"variant\":0", "\"variant\":\"red\"")).unwrap();
    let report = compared(&old, &new);
    assert!(report.levels[0].rooms.is_empty() && report.troubles.len() == 1, "{report:?}");
    assert!(report.troubles[0].message.contains("chair.1@a"));
}

#[test]
fn a_folder_and_a_file_cannot_be_compared() {
    let root = tempfile::tempdir().unwrap();
    bake(root.path(), 1, 0);
    let catalog = catalog();
    let options =
        DiffOptions { tolerance: Tolerance::default(), catalog, is_thorough: false, observer: &|_, _| () };
    let faults = compare(root.path(), &root.path().join("b0/0.gltf"), &options).unwrap_err();
    assert!(faults.to_string().contains("two folders, or two files"), "{faults}");
    // The faults of both sides are reported, not only those of the first.
    let faults = compare(Path::new("no-old"), Path::new("no-new"), &options).unwrap_err();
    assert!(faults.to_string().contains("no-old") && faults.to_string().contains("no-new"));
}

#[test]
fn markdown_is_bounded_and_counts_what_it_leaves_out() {
    let root = tempfile::tempdir().unwrap();
    let (old, new) = (root.path().join("old"), root.path().join("new"));
    bake(&old, 200, 0);
    bake(&new, 200, 1);
    let report = compared(&old, &new);
    let whole = markdown(&report, usize::MAX);
    assert!(whole.matches("<details>").count() == 200 && !whole.contains("left out"));
    let cut = markdown(&report, 5000);
    let shown = cut.matches("<details>").count();
    assert!(cut.len() <= 5000 && shown > 10, "{}", cut.len());
    assert!(cut.contains(&format!("… and {} more entries left out", 200 - shown)), "{cut}");
}

#[test]
fn names_from_plans_mean_nothing_in_markdown_and_html() {
    let root = tempfile::tempdir().unwrap();
    let (old, new) = (root.path().join("old.gltf"), root.path().join("new.gltf"));
    let bad = |x: f64| level(0, x).replace("\"room\":\"a\"", "\"room\":\"<script>`@all` |\"");
    fs::write(&old, bad(1.0)).unwrap();
    fs::write(&new, bad(2.0)).unwrap();
    let report = compared(&old, &new);
    assert_eq!(report.count(Kind::Moved), 1);
    assert!(markdown(&report, usize::MAX).contains("**`<script>'@all' |`**"));
    let page = html(&report, &std::collections::BTreeMap::new(), HtmlLimits::default());
    assert!(page.contains("&lt;script&gt;") && !page.contains("<script>"));
}

/// Pictures of the only room of two files.
fn pictures(old: &str, new: &str) -> RoomPictures {
    let root = tempfile::tempdir().unwrap();
    let (before, after) = (root.path().join("old.gltf"), root.path().join("new.gltf"));
    fs::write(&before, old).unwrap();
    fs::write(&after, new).unwrap();
    let report = compared(&before, &after);
    let level = &report.levels[0];
    let rooms: Vec<&RoomDiff> = level.rooms.iter().collect();
    draw_rooms(level, &rooms, &before, &after, catalog()).remove(0)
}

#[test]
fn pictures_mark_differences_and_have_one_frame() {
    use crate::draw::MarkKind::{Added, Changed, Removed};
    let marks = |svg: &Option<String>| {
        let svg = svg.as_ref().unwrap();
        [Added, Removed, Changed]
            .map(|kind| svg.matches(&format!("fill=\"{}\" fill-opacity", kind.color())).count())
    };
    let size = |svg: &Option<String>| {
        svg.as_ref().unwrap().split("viewBox").nth(1).map(|rest| rest[..20].to_owned())
    };
    let moved = pictures(&level(0, 1.0), &level(0, 2.0));
    assert_eq!((marks(&moved.old), marks(&moved.new)), ([0, 0, 1], [0, 0, 1]));
    assert_eq!(size(&moved.old), size(&moved.new));
    // An arrow from where it was, in the picture after only.
    let arrows = |svg: &Option<String>| svg.as_ref().unwrap().matches("stroke-width=\"1.6\"").count();
    assert_eq!((arrows(&moved.old), arrows(&moved.new)), (0, 1));
    // Another class, too far away to be a swap, that no catalogue knows: drawn as a box.
    let other =
        level(0, 3.0).replace("\"class\":\"chair\"", "\"class\":\"throne\"").replace("chair.1", "throne.1");
    let swapped = pictures(&level(0, 1.0), &other);
    assert_eq!((marks(&swapped.old), marks(&swapped.new)), ([0, 1, 0], [1, 0, 0]));
    assert!(
        swapped.new.unwrap().contains("stroke-dasharray=\"3 2\"") && !swapped.old.unwrap().contains("3 2")
    );
}

#[test]
fn a_room_on_one_side_has_one_picture() {
    let other = level(0, 1.0).replace("\"room\":\"a\"", "\"room\":\"b\"");
    let root = tempfile::tempdir().unwrap();
    let (before, after) = (root.path().join("old.gltf"), root.path().join("new.gltf"));
    fs::write(&before, level(0, 1.0)).unwrap();
    fs::write(&after, other).unwrap();
    let report = compared(&before, &after);
    let rooms: Vec<&RoomDiff> = report.levels[0].rooms.iter().collect();
    let drawn = draw_rooms(&report.levels[0], &rooms, &before, &after, catalog());
    let sides: Vec<(bool, bool)> =
        drawn.iter().map(|pair| (pair.old.is_some(), pair.new.is_some())).collect();
    assert_eq!(sides, [(true, false), (false, true)]);
}

#[test]
fn text_and_page_count_what_they_leave_out() {
    let root = tempfile::tempdir().unwrap();
    let (old, new) = (root.path().join("old"), root.path().join("new"));
    bake(&old, 50, 0);
    bake(&new, 50, 1);
    let report = compared(&old, &new);
    let lines =
        |is_short: bool| text(&report, is_short).lines().filter(|line| line.starts_with("~ ")).count();
    assert_eq!((lines(true), lines(false)), (40, 50));
    assert!(text(&report, true).contains("… and 10 more levels; --all shows them"));
    let limits = HtmlLimits { rooms: 7, levels: 9 };
    let page = html(&report, &std::collections::BTreeMap::new(), limits);
    assert_eq!((page.matches("<h2").count(), page.matches("<tr><td").count()), (7, 9 + 1));
    assert_eq!((page.matches("href=\"#level-").count(), page.matches("id=\"level-").count()), (7, 7));
    assert!(page.contains("43 more rooms left out") && page.contains("41 more levels left out"));
}
