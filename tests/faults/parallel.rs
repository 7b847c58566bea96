//! Several processes at once: no work is lost, and their files are not mixed.

use super::world::{World, plan};

#[test]
fn parallel_edits_of_one_file_are_all_kept() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml"]);
    let glb = String::from_utf8_lossy(&world.read("out/alpha/1.glb")).into_owned();
    let has = |id: &&&str| glb.contains(&format!("\"{id}@study\""));
    let candidates =
        ["desk.1", "office_chair.1", "bookshelf.1", "armchair.1", "cabinet.1", "curtain.1", "lamp.1"];
    let objects: Vec<&str> = candidates.iter().filter(has).copied().collect();
    assert!(objects.len() >= 3, "the study holds too little: {objects:?}");
    for round in 0..5 {
        let file = format!("{round}.edits.yaml");
        let lock = |object: &&str| {
            let arguments =
                ["edits", "lock", "out/alpha/1.glb", "study", object, "--edits", &file, "--quiet"];
            world.command(&arguments).spawn().unwrap()
        };
        for mut process in objects.iter().map(lock).collect::<Vec<_>>() {
            assert!(process.wait().unwrap().success());
        }
        let text = String::from_utf8(world.read(&file)).unwrap();
        let lost: Vec<&&str> = objects.iter().filter(|object| !text.contains(**object)).collect();
        assert!(lost.is_empty(), "round {round} lost {lost:?}:\n{text}");
    }
    assert!(world.names(".").iter().all(|name| !name.contains(".roomwright-")), "no temporary file stays");
}

fn arguments<'a>(seed: &'a str, out: &'a str) -> [&'a str; 9] {
    ["bake", "a.yaml", "--quiet", "--format", "gltf", "--seed", seed, "--out", out]
}

#[test]
fn parallel_seeds_leave_files_of_one_run_together() {
    const SEEDS: [&str; 4] = ["1", "2", "3", "4"];
    let world = World::new();
    world.write("a.yaml", plan("alpha", 4));
    let whole = SEEDS.map(|seed| {
        world.must(&arguments(seed, seed));
        world.files(seed)
    });
    for round in 0..4 {
        let out = format!("shared{round}");
        let start = |seed: &&str| world.command(&arguments(seed, &out)).spawn().unwrap();
        for mut process in SEEDS.iter().map(start).collect::<Vec<_>>() {
            assert!(process.wait().unwrap().success());
        }
        let files = world.files(&out);
        let manifest = String::from_utf8(world.read(&format!("{out}/manifest.json"))).unwrap();
        for level in 1..=4 {
            let pair = ["gltf", "bin"].map(|kind| format!("alpha/{level}.{kind}"));
            let is_of =
                |whole: &std::collections::BTreeMap<_, _>| pair.iter().all(|file| files[file] == whole[file]);
            assert!(whole.iter().any(is_of), "round {round}: {pair:?} are of different runs");
            assert!(
                pair.iter().all(|file| manifest.contains(&files[file])),
                "round {round}: {pair:?}\n{manifest}"
            );
        }
        assert_eq!(files.len(), 10, "with the lock, nothing else stays: {:?}", files.keys());
    }
}

/// Without file locks, as in some network folders: a tracer makes every lock fail.
#[test]
#[cfg(target_os = "linux")]
fn without_file_locks_a_single_bake_is_done() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    for error in ["EOPNOTSUPP", "ENOLCK"] {
        let out = format!("out-{error}");
        let inner = world.command(&["bake", "a.yaml", "--quiet", "--out", &out]);
        let mut command = std::process::Command::new("strace");
        command.args(["-f", "-qq", "-e", "trace=flock", "-e"]).arg(format!("inject=flock:error={error}"));
        command.args(["-o", "/dev/null"]).arg(inner.get_program()).args(inner.get_args());
        let ran = command.env("ROOMWRIGHT_CACHE", "none").current_dir(world.path(".")).output();
        let Ok(ran) = ran else { return println!("skipped: no strace") };
        let stderr = String::from_utf8_lossy(&ran.stderr);
        if stderr.contains("ptrace") {
            return println!("skipped: no right to trace");
        }
        assert_eq!(ran.status.code(), Some(0), "{stderr}");
        world.must(&["bake", "a.yaml", "--out", "whole"]);
        assert_eq!(world.names(&out), world.names("whole"));
        let left: Vec<String> =
            world.contents(&out).into_keys().filter(|name| name.contains("run-")).collect();
        assert!(left.is_empty(), "{left:?}");
    }
}
