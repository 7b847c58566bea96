//! The guide works: its files are written and its commands run in order, and their answers are those on the page.

use roomwright::internals::catalog::load_catalog;
use serde_json::Value;

use super::world::World;

const GUIDE: &str = include_str!("../../docs/guide.md");

/// A block of the guide between fences.
#[derive(Clone, Copy)]
enum Block {
    /// A file: its path and its text, of which the path is the first line.
    File(&'static str, &'static str),
    /// Commands after `$ `, each followed by lines of its answer.
    Commands(&'static str),
}

/// All files and commands of a page, in order.
fn blocks(page: &'static str) -> Vec<Block> {
    // Fences open and close in turn: every other piece is inside.
    let inside = page.split("```").skip(1).step_by(2);
    inside
        .filter_map(|text| {
            let (kind, text) = text.split_once('\n').unwrap();
            match kind {
                "yaml" => {
                    let path = text.lines().next().unwrap().strip_prefix("# ");
                    Some(Block::File(path.expect("the first line names the file"), text))
                }
                "console" => Some(Block::Commands(text)),
                _ => None,
            }
        })
        .collect()
}

/// Whether a line of an answer is as the guide shows it, where `...` stands for anything.
fn is_as_shown(line: &str, shown: &str) -> bool {
    let mut rest = line.trim_start();
    let starts_anywhere = shown.trim_start().starts_with("...");
    for (index, part) in shown.trim().split("...").enumerate() {
        match rest.find(part) {
            Some(0) => rest = &rest[part.len()..],
            Some(at) if index > 0 || starts_anywhere => rest = &rest[at + part.len()..],
            _ => return false,
        }
    }
    rest.is_empty() || shown.ends_with("...")
}

/// Runs the commands of a block; each must succeed and answer the lines below it, in that order.
fn run_all(world: &World, commands: &str) {
    for command in commands.split("$ ").skip(1) {
        let (command, answer) = command.split_once('\n').unwrap();
        let words: Vec<&str> = command.split(' ').collect();
        assert_eq!(words[0], "roomwright");
        let ran = world.must(&words[1..]);
        let printed = ran.stdout + &ran.stderr;
        let mut lines = printed.lines();
        for shown in answer.lines().filter(|line| !line.is_empty()) {
            assert!(lines.any(|line| is_as_shown(line, shown)), "{command}: no {shown:?} in\n{printed}");
        }
    }
}

/// The folder after all that a page says was done.
pub(super) fn world_of(page: &'static str) -> World {
    let world = World::new();
    for block in blocks(page) {
        match block {
            Block::File(path, text) => world.write(path, text),
            Block::Commands(commands) => run_all(&world, commands),
        }
    }
    world
}

/// The extras of the nodes of a finished file, of one kind.
pub(super) fn extras(world: &World, path: &str, kind: &str) -> Vec<Value> {
    let document = gltf::Gltf::from_slice(&world.read(path)).unwrap().document;
    let extras = document.nodes().filter_map(|node| {
        let text = node.extras().as_ref()?.get().to_owned();
        serde_json::from_str::<Value>(&text).ok()
    });
    extras.filter(|extras| extras["kind"] == kind).collect()
}

#[test]
fn the_new_piece_stands_in_the_new_room_in_the_new_style() {
    let world = world_of(GUIDE);
    for (folder, bedroom_styles) in
        [("club", &["default"][..]), ("residence", &["home_modern", "home_traditional"])]
    {
        let path = format!("{folder}/house/ground.glb");
        let rooms = extras(&world, &path, "room");
        let room = |id: &str| rooms.iter().find(|room| room["room"] == id).unwrap();
        assert_eq!(
            (&room("reading")["type"], &room("reading")["style"]),
            (&"reading_room".into(), &"club".into())
        );
        assert!(
            bedroom_styles.iter().any(|style| room("bed")["style"] == *style),
            "{}",
            room("bed")["style"]
        );
        let furniture = extras(&world, &path, "furniture");
        let count = |class: &str| furniture.iter().filter(|piece| piece["class"] == class).count();
        assert_eq!((count("reading_chair"), count("wide_reading_chair")), (3, 1), "{folder}");
        assert!(room("reading")["removed"].as_array().unwrap().is_empty());
    }
    assert!(world.read("house.svg").starts_with(b"<svg"));
    let catalog = load_catalog(&[world.path("my-furniture")]).unwrap().value;
    let bookshelf = catalog.class_index("bookshelf").unwrap();
    assert_eq!(catalog.classes[bookshelf].priority, 90, "a changed key");
    assert_eq!(catalog.room_words.room_type("imdf", "readingroom"), Some("reading_room"));
}

#[test]
fn the_guide_has_files_and_commands_for_each_kind_of_definition() {
    let blocks = blocks(GUIDE);
    let files: Vec<&str> = blocks
        .iter()
        .filter_map(|block| match block {
            Block::File(path, _) => Some(*path),
            Block::Commands(_) => None,
        })
        .collect();
    for folder in ["classes", "rooms", "styles", "palettes"] {
        let prefix = format!("my-furniture/{folder}/");
        assert!(files.iter().any(|path| path.starts_with(&prefix)), "{folder}");
    }
    assert_eq!(blocks.len() - files.len(), 4);
}

#[test]
fn the_fault_that_the_guide_shows_is_reported_so() {
    let Some(Block::File(path, text)) = blocks(GUIDE).first().copied() else {
        panic!("the chair comes first")
    };
    let world = World::new();
    world.write(path, text.replace("{on: bookshelf", "{on: bookself"));
    let ran = world.run(&["check", "--catalog", "my-furniture", "--json"]);
    let report: Value = serde_json::from_str(&ran.stdout).unwrap();
    let fault = &report["faults"][0];
    let shown = format!(
        "    {path}:{}:{}: {}\n      hint: {}\n",
        fault["line"],
        fault["column"],
        fault["message"].as_str().unwrap(),
        fault["hint"].as_str().unwrap()
    );
    assert!(GUIDE.contains(&shown), "{shown}");
}

#[test]
fn dots_stand_for_anything() {
    assert!(is_as_shown("  Baked 1 level, 25 objects", "Baked 1 level, ..."));
    assert!(is_as_shown("3 buildings: 0 errors", "...: 0 errors"));
    assert!(!is_as_shown("3 buildings: 10 errors", "3 buildings: 1 errors"));
    assert!(!is_as_shown("3 buildings: 10 errors", "...: 0 errors"));
    assert!(!is_as_shown("Baked 1 level, 25 objects", "Baked 1 level"));
}
