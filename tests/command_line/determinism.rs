//! The same input gives the same bytes.

use super::world::{World, plan};

fn two_plans(world: &World) {
    world.write("plans/a.yaml", plan("alpha", 3));
    world.write("plans/b.yaml", plan("beta", 4));
}

#[test]
fn the_output_does_not_depend_on_threads() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "one", "--threads", "1"]);
    let one = world.files("one");
    assert_eq!(one.keys().filter(|name| name.ends_with(".glb")).count(), 7);
    for threads in ["2", "7", "32"] {
        world.must(&["bake", "plans", "--out", threads, "--threads", threads]);
        assert_eq!(world.files(threads), one, "{threads} threads");
    }
}

#[test]
fn the_output_does_not_depend_on_the_order_of_inputs_or_the_working_folder() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans/a.yaml", "plans/b.yaml", "--out", "one"]);
    world.must(&["bake", "plans/b.yaml", "plans/a.yaml", "--out", "two"]);
    let elsewhere = World::new();
    let absolute = world.path("plans");
    elsewhere.must(&["bake", absolute.to_str().unwrap(), "--out", "three"]);
    assert_eq!(world.files("one"), world.files("two"));
    assert_eq!(world.files("one"), elsewhere.files("three"));
}

#[test]
fn another_seed_gives_other_rooms() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans/a.yaml", "--out", "one"]);
    world.must(&["bake", "plans/a.yaml", "--out", "two", "--seed", "2"]);
    assert_ne!(world.read("one/alpha/1.glb"), world.read("two/alpha/1.glb"));
}

#[test]
fn shards_joined_are_one_run() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "whole"]);
    for shard in ["2/3", "1/3"] {
        let ran = world.must(&["bake", "plans", "--out", "shared", "--shard", shard]);
        assert!(ran.stdout.contains("roomwright merge"), "{}", ran.stdout);
        assert!(!world.path("shared/manifest.json").exists());
    }
    world.must(&["bake", "plans", "--out", "shared", "--shard", "3/3"]);
    assert_eq!(world.files("shared"), world.files("whole"), "the last shard joins");
}

#[test]
fn shards_from_several_machines_are_merged() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "whole"]);
    for (folder, shard) in [("one", "1/2"), ("two", "2/2")] {
        world.must(&["bake", "plans", "--out", folder, "--shard", shard]);
    }
    for folder in ["one", "two"] {
        for (name, content) in world.contents(folder) {
            world.write(&format!("joined/{name}"), content);
        }
    }
    world.must(&["merge", "joined"]);
    assert_eq!(world.files("joined"), world.files("whole"));
    world.must(&["merge", "joined"]);
    assert_eq!(world.files("joined"), world.files("whole"), "merging twice is merging once");
}

/// Bakes shares into folders of their own, and keeps nothing of them but their parts.
fn bake_parts(world: &World, shares: &[&str], extra: &[&str]) {
    for (number, share) in shares.iter().enumerate() {
        let folder = format!("machine-{number}");
        world.must(&[&["bake", "plans", "--out", &folder, "--shard", share][..], extra].concat());
        for (name, content) in world.contents(&folder) {
            if name.starts_with("manifest.") {
                world.write(&format!("records/{number}/{name}"), content);
            }
        }
    }
}

#[test]
fn records_whose_files_lie_elsewhere_are_joined_to_the_manifest_of_one_bake() {
    for extra in [&[][..], &["--shared-library", "--shared-textures"]] {
        let world = World::new();
        two_plans(&world);
        world.must(&[&["bake", "plans", "--out", "whole"][..], extra].concat());
        // More shares than levels: some are empty. One share was baked twice.
        let shares = ["1/9", "2/9", "3/9", "4/9", "5/9", "6/9", "7/9", "8/9", "9/9", "3/9"];
        bake_parts(&world, &shares, extra);
        let ran = world.must(&["merge", "--records", "records"]);
        assert!(ran.stdout.contains("14 rooms"), "{}", ran.stdout);
        assert_eq!(world.read("records/manifest.json"), world.read("whole/manifest.json"));
        world.must(&["merge", "--records", "records", "--out", "new/joined.json"]);
        assert_eq!(world.read("new/joined.json"), world.read("whole/manifest.json"));
        assert_eq!(world.names("new"), ["joined.json"], "nothing else is left");
    }
}

#[test]
fn records_that_miss_a_share_or_contradict_each_other_are_not_joined() {
    let refused = |shares: &[&str], seed: Option<&str>, reason: &str| {
        let world = World::new();
        two_plans(&world);
        bake_parts(&world, shares, &[]);
        if let Some(seed) = seed {
            world.must(&["bake", "plans", "--out", "other", "--shard", "1/3", "--seed", seed]);
            world.write("records/x/manifest.1-of-3.json", world.read("other/manifest.1-of-3.json"));
        }
        let ran = world.run(&["merge", "--records", "records"]);
        assert_eq!(ran.code, Some(2), "{}", ran.stdout);
        assert!(ran.stderr.contains(reason) && ran.stderr.contains("hint"), "{}", ran.stderr);
        assert!(!world.path("records/manifest.json").exists());
    };
    refused(&["1/4", "3/4"], None, "lacks 2 of 4 parts: 2, 4");
    refused(&["1/2", "2/3"], None, "of 2 shares, of 3 shares");
    refused(&[], Some("1"), "lacks 2 of 3 parts");
    refused(&["1/3", "2/3", "3/3"], Some("2"), "otherwise than");
}

#[test]
fn records_are_joined_by_the_program_that_wrote_them_and_replace_no_other_file() {
    let world = World::new();
    two_plans(&world);
    bake_parts(&world, &["1/2", "2/2"], &[]);
    world.write("records/manifest.json", "mine");
    let ran = world.run(&["merge", "--records", "records"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("is no manifest of roomwright"), "{}", ran.stderr);
    let part = String::from_utf8(world.read("records/1/manifest.2-of-2.json")).unwrap();
    let other = part.replacen("\"program\": \"", "\"program\": \"0.0.9-", 1);
    world.write("records/1/manifest.2-of-2.json", other);
    let ran = world.run(&["merge", "--records", "records", "--out", "joined.json"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("was baked by 0.0.9-"), "{}", ran.stderr);
    assert_eq!(world.run(&["merge", "--records", "plans"]).code, Some(2), "no part is there");
}

#[test]
fn a_merge_names_the_files_that_are_not_there() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "whole"]);
    for share in ["1/3", "2/3"] {
        world.must(&["bake", "plans", "--out", "shared", "--shard", share]);
    }
    for (name, content) in world.contents("shared") {
        if name.starts_with("manifest.") {
            world.write(&format!("parts/{name}"), &content);
        }
        world.write(&format!("most/{name}"), content);
    }
    let ran = world.run(&["merge", "parts"]);
    assert_eq!(ran.code, Some(2), "{}", ran.stdout);
    assert!(ran.stderr.contains("alpha/1.glb") && ran.stderr.contains("--records"), "{}", ran.stderr);
    assert_eq!(world.names("parts").len(), 2, "the parts stay");
    let gone = world.read("most/alpha/1.glb");
    std::fs::remove_file(world.path("most/alpha/1.glb")).unwrap();
    let ran = world.run(&["merge", "most"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stdout);
    assert!(ran.stderr.contains("alpha/1.glb") && ran.stderr.contains("is not there"), "{}", ran.stderr);
    world.write("most/alpha/1.glb", gone);
    world.must(&["bake", "plans", "--out", "most", "--shard", "3/3"]);
    assert_eq!(world.files("most"), world.files("whole"));
}

#[test]
fn a_merge_says_which_shares_were_never_baked() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "shared", "--shard", "1/3"]);
    let ran = world.run(&["merge", "shared"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stdout);
    assert!(ran.stderr.contains("lacks 2 of 3 parts: 2 to 3"), "{}", ran.stderr);
    // What is known is in the manifest, and the other shares add theirs.
    world.must(&["bake", "plans", "--out", "shared", "--shard", "2/3"]);
    world.must(&["bake", "plans", "--out", "shared", "--shard", "3/3"]);
    world.must(&["bake", "plans", "--out", "whole"]);
    assert_eq!(world.files("shared"), world.files("whole"));
}

#[test]
fn variables_that_say_nothing_or_too_much_are_no_harm() {
    let world = World::new();
    two_plans(&world);
    for (variable, value) in [("ROOMWRIGHT_CACHE", ""), ("RAYON_NUM_THREADS", "99999999")] {
        let mut command = world.command(&["bake", "plans", "--out", variable, "--list-levels"]);
        let output = command.env(variable, value).output().unwrap();
        assert!(output.status.success(), "{variable}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn processes_side_by_side_do_not_disturb_each_other() {
    let world = World::new();
    two_plans(&world);
    world.must(&["bake", "plans", "--out", "whole"]);
    let start = || world.command(&["bake", "plans", "--out", "shared", "--quiet"]).spawn().unwrap();
    let processes: Vec<_> = (0..4).map(|_| start()).collect();
    for mut process in processes {
        assert!(process.wait().unwrap().success());
    }
    assert_eq!(world.files("shared"), world.files("whole"));
}

/// The words of `--format`, as the program names them to who asks for another.
fn formats(world: &World) -> Vec<String> {
    let refused = world.run(&["bake", "--format", "no-format"]).stderr;
    let (_, values) = refused.split_once("[possible values: ").unwrap();
    let (values, _) = values.split_once(']').unwrap();
    values.split(", ").map(str::to_owned).collect()
}

#[test]
fn all_formats_and_the_shared_library_are_the_same_every_time() {
    let world = World::new();
    two_plans(&world);
    let formats = formats(&world);
    assert!(["glb", "gltf", "web", "tiles"].iter().all(|name| formats.contains(&(*name).to_owned())));
    let with = |format: &str| vec!["--format".to_owned(), format.to_owned()];
    let shared = |options: Vec<String>| [options, vec!["--shared-library".to_owned()]].concat();
    let runs = formats.iter().map(|format| with(format)).chain([shared(Vec::new()), shared(with("gltf"))]);
    for extra in runs {
        let extra: Vec<&str> = extra.iter().map(String::as_str).collect();
        for (folder, threads) in [("one", "1"), ("two", "5")] {
            let _ = std::fs::remove_dir_all(world.path(folder));
            let common = ["bake", "plans", "--out", folder, "--threads", threads];
            world.must(&[&common[..], &extra].concat());
        }
        assert_eq!(world.files("one"), world.files("two"), "{extra:?}");
    }
    let names = world.names("one");
    let shared: Vec<&String> = names.iter().filter(|name| name.contains("/shared-geometry/")).collect();
    assert!(shared.len() > 5 && shared.iter().all(|name| name.ends_with(".bin")), "{names:?}");
}
