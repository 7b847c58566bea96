//! Pipes, devices and folders where files are expected: nothing waits for them, nothing reads them without end.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

use super::world::{World, plan};

fn make_pipe(path: &Path) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

/// The ways in which something else than a file can stand at a path.
const KINDS: [fn(&Path); 3] = [
    make_pipe,
    |path| {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        symlink("/dev/zero", path).unwrap();
    },
    |path| fs::create_dir_all(path).unwrap(),
];

#[test]
fn in_the_output_folder() {
    let places = [
        ("manifest.json", 2),
        ("manifest.1-of-2.json", 2),
        (".roomwright", 2),
        (".roomwright/lock", 2),
        (".roomwright/run-x/alive", 0),
        (".roomwright/run-x/journal", 0),
        ("alpha", 2),
        ("alpha/1.glb", 1),
    ];
    for (place, code) in places {
        for (number, make) in KINDS.iter().enumerate() {
            // A folder is what belongs there.
            if number == 2 && matches!(place, ".roomwright" | "alpha") {
                continue;
            }
            let world = World::new();
            world.write("a.yaml", plan("alpha", 2));
            make(&world.path("out").join(place));
            let ran = world.run_bounded(&["bake", "a.yaml"]);
            assert_eq!(ran.code, Some(code), "{place}, kind {number}: {}", ran.stderr);
            assert!(code == 0 || ran.stderr.contains("hint"), "{place}, kind {number}: {}", ran.stderr);
            let ran = world.run_bounded(&["merge", "out"]);
            assert!(ran.code.is_some(), "{place}, kind {number}: {}", ran.stderr);
        }
    }
}

#[test]
fn in_place_of_a_recorded_file() {
    for make in KINDS {
        let world = World::new();
        world.write("a.yaml", plan("alpha", 2));
        world.must(&["bake", "a.yaml"]);
        fs::remove_file(world.path("out/alpha/1.glb")).unwrap();
        make(&world.path("out/alpha/1.glb"));
        let ran = world.run_bounded(&["bake", "a.yaml"]);
        assert_eq!(ran.code, Some(1), "{}", ran.stderr);
        assert!(ran.stderr.contains("error[wrong_kind]: alpha/1"), "{}", ran.stderr);
        for command in [&["diff", "out", "out"][..], &["audit", "out/alpha/1.glb"], &["merge", "out"]] {
            let ran = world.run_bounded(command);
            assert!(ran.code.is_some(), "{command:?}: {}", ran.stderr);
        }
    }
}
