//! Pipes, devices and folders in place of files: no command waits for them or reads them endlessly.

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

#[test]
fn in_place_of_a_plan_or_a_model() {
    for make in KINDS {
        let world = World::new();
        make(&world.path("plans/a.yaml"));
        world.write("plans/b.yaml", plan("beta", 1));
        // In a folder of plans it is none.
        let ran = world.run_bounded(&["check", "plans"]);
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        for command in [&["check", "plans/a.yaml"], &["bake", "plans/a.yaml"]] {
            let ran = world.run_bounded(command);
            assert!(matches!(ran.code, Some(1 | 2)), "{command:?}: {:?} {}", ran.code, ran.stderr);
            let said = ran.stdout + &ran.stderr;
            assert!(said.contains("a.yaml"), "{command:?}: {said}");
        }
        make(&world.path("mine/classes/crate.glb"));
        world.write("mine/classes/mine.yaml", CRATE);
        let ran = world.run_bounded(&["bake", "plans/b.yaml", "--catalog", "mine"]);
        assert_eq!(ran.code, Some(2), "{}", ran.stderr);
        assert!(ran.stderr.contains("crate.glb") && ran.stderr.contains("it is a"), "{}", ran.stderr);
    }
}

const CRATE: &str = "version: 1\nclasses:\n  crate:\n    label: Crate\n    sizes: [[1, 1, 1]]\n    parents: [{on: floor}]\n    \
                     model: {file: crate.glb}\n";

/// A model of two gigabytes fits no address space of half as many; one that hundreds of classes name is read once.
#[test]
fn a_model_of_gigabytes_is_refused_unread() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.write("mine/classes/mine.yaml", CRATE);
    fs::File::create(world.path("mine/classes/crate.glb")).unwrap().set_len(8 << 30).unwrap();
    let ran = world.run_bounded(&["bake", "a.yaml", "--catalog", "mine"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("8192 MB, 128 MB are the most"), "{}", ran.stderr);
}
