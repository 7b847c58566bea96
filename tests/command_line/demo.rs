//! The first commands of a new user: the demo, and the help.

use super::world::World;

#[test]
fn without_arguments_the_demo_is_baked_and_its_place_printed() {
    let world = World::new();
    let ran = world.must(&[]);
    for word in ["Baked", "rooms/s", "Rooms by verdict", "out/manifest.json", "roomwright draw"] {
        assert!(ran.stdout.contains(word), "{word} is missing in: {}", ran.stdout);
    }
    let names = world.names("out");
    assert!(names.iter().filter(|name| name.ends_with(".glb")).count() >= 4, "{names:?}");
    assert_eq!(world.must(&["bake", "--out", "again"]).code, Some(0));
    assert_eq!(world.files("out"), world.files("again"), "`bake` without a path is the same");
}

#[test]
fn the_demo_is_read_back_by_another_library() {
    let world = World::new();
    world.must(&["bake", "--quiet"]);
    for name in world.names("out").iter().filter(|name| name.ends_with(".glb")) {
        let document = gltf::Gltf::from_slice(&world.read(&format!("out/{name}"))).unwrap();
        let root = document.default_scene().unwrap().nodes().next().unwrap();
        let expected = name.strip_suffix(".glb").unwrap();
        assert_eq!(root.name(), Some(expected));
        assert!(root.children().any(|room| room.name().unwrap_or_default().starts_with("room:")));
    }
}

#[test]
fn the_demo_can_be_checked_and_drawn() {
    let world = World::new();
    assert!(world.must(&["check"]).stdout.contains("0 errors"));
    world.must(&["draw", "--out", "drawings"]);
    let drawings = world.contents("drawings");
    assert!(!drawings.is_empty());
    for (name, content) in drawings {
        let text = String::from_utf8(content).unwrap();
        assert!(
            name.ends_with(".svg")
                && text.starts_with("<svg")
                && text.contains("</svg>\n<!-- drawn by roomwright")
        );
    }
    assert!(!world.path("out").exists(), "neither command bakes");
}

#[test]
fn help_documents_the_exit_codes() {
    let world = World::new();
    for arguments in [&["--help"][..], &["bake", "--help"]] {
        let help = world.must(arguments).stdout;
        assert!(help.contains("0  everything was done") && help.contains("2  nothing could start"));
    }
    assert!(world.must(&["--version"]).stdout.contains(env!("CARGO_PKG_VERSION")));
}
