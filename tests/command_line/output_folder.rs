//! The output folder keeps files of other origin, and survives missing rights and full disks.

use std::fs;

use super::world::{World, plan};

#[test]
fn a_foreign_file_is_never_overwritten_without_force() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.write("out/alpha/1.glb", "precious");
    let ran = world.run(&["bake", "a.yaml"]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.stderr.contains("error[foreign_file]") && ran.stderr.contains("--force"), "{}", ran.stderr);
    assert_eq!(world.read("out/alpha/1.glb"), b"precious");
    assert!(world.path("out/alpha/2.glb").exists(), "the other level is written");
    assert!(!String::from_utf8(world.read("out/manifest.json")).unwrap().contains("alpha/1.glb"));

    world.must(&["bake", "a.yaml", "--force"]);
    world.must(&["bake", "a.yaml", "--out", "fresh"]);
    assert_eq!(world.files("out"), world.files("fresh"));
}

#[test]
fn an_edited_file_is_not_overwritten() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml"]);
    world.write("out/alpha/1.glb", "edited by hand");
    for extra in [&[][..], &["--seed", "2"]] {
        let ran = world.run(&[&["bake", "a.yaml"][..], extra].concat());
        assert_eq!(ran.code, Some(2), "nothing else was to be done: {}", ran.stderr);
        assert!(ran.stderr.contains("foreign_file"));
        assert_eq!(world.read("out/alpha/1.glb"), b"edited by hand");
    }
}

#[test]
fn a_file_edited_to_the_same_length_is_noticed() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml"]);
    let before = world.files("out");
    let mut edited = world.read("out/alpha/1.glb");
    *edited.last_mut().unwrap() ^= 1;
    world.write("out/alpha/1.glb", &edited);
    let ran = world.run(&["bake", "a.yaml"]);
    assert_eq!(ran.code, Some(1), "{}{}", ran.stdout, ran.stderr);
    assert!(
        ran.stderr.contains("error[foreign_file]: alpha/1") && ran.stderr.contains("--force"),
        "{}",
        ran.stderr
    );
    assert_eq!(world.read("out/alpha/1.glb"), edited);
    assert!(world.must(&["bake", "a.yaml", "--force"]).stdout.contains("Baked 1 level,"));
    assert_eq!(world.files("out"), before);
    // The same bytes written again, as by a copy of the folder, are no edit.
    world.write("out/alpha/1.glb", world.read("out/alpha/1.glb"));
    assert!(world.must(&["bake", "a.yaml"]).stdout.contains("Kept 2 levels"));
}

#[test]
fn a_foreign_manifest_stops_the_run() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.write("out/manifest.json", "{\"name\": \"my web app\"}");
    let ran = world.run(&["bake", "a.yaml"]);
    assert_eq!(ran.code, Some(2));
    assert!(
        ran.stderr.contains("no manifest of roomwright") && ran.stderr.contains("--force"),
        "{}",
        ran.stderr
    );
    assert_eq!(world.names("out"), ["manifest.json"]);
    world.must(&["bake", "a.yaml", "--force"]);
}

#[test]
fn a_file_in_place_of_the_folder_is_named() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.write("file", "I am a file");
    for out in ["file", "file/below"] {
        let ran = world.run(&["bake", "a.yaml", "--out", out]);
        assert_eq!(ran.code, Some(2), "{out}");
        assert!(
            ran.stderr.contains("file: is a file, not a folder") && ran.stderr.contains("--out"),
            "{}",
            ran.stderr
        );
    }
    assert_eq!(world.read("file"), b"I am a file");
}

#[test]
fn a_folder_in_place_of_a_result_fails_that_level_only() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    fs::create_dir_all(world.path("out/alpha/1.glb")).unwrap();
    let ran = world.run(&["bake", "a.yaml"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("error[wrong_kind]: alpha/1"), "{}", ran.stderr);
    assert!(world.path("out/alpha/2.glb").exists());
}

#[test]
#[cfg(unix)]
fn results_have_the_rights_of_any_new_file() {
    use std::os::unix::fs::PermissionsExt;
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml"]);
    let rights = |path: &str| world.path(path).metadata().unwrap().permissions().mode();
    for path in ["out/alpha/1.glb", "out/manifest.json"] {
        assert_eq!(rights(path), rights("a.yaml"), "{path}");
    }
}

#[test]
#[cfg(unix)]
fn a_folder_without_rights_is_named() {
    use std::os::unix::fs::PermissionsExt;
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    fs::create_dir(world.path("closed")).unwrap();
    fs::set_permissions(world.path("closed"), fs::Permissions::from_mode(0o555)).unwrap();
    if fs::write(world.path("closed/probe"), "").is_ok() {
        println!("skipped: this user may write anywhere");
        return;
    }
    let ran = world.run(&["bake", "a.yaml", "--out", "closed/out"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("error[no_rights]"), "{}", ran.stderr);
}

#[test]
fn ids_that_file_systems_reject_get_safe_names() {
    let world = World::new();
    for (file, id) in [("a", "CON"), ("b", "Haus 7 ü"), ("c", "Tower"), ("d", "tower")] {
        world.write(&format!("plans/{file}.yaml"), plan(id, 1));
    }
    world.must(&["bake", "plans"]);
    let names = world.names("out");
    assert!(names.contains(&"%43ON/1.glb".to_owned()), "{names:?}");
    assert!(names.contains(&"Haus%207%20%C3%BC/1.glb".to_owned()), "{names:?}");
    let mut lower: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
    lower.dedup();
    assert_eq!(lower.len(), 5, "four levels and the manifest, whatever the case: {names:?}");
}

/// A file system of a few pages in an own mount namespace, so that the disk really is full.
#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_stops_cleanly_and_a_later_run_continues() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 12));
    fs::create_dir(world.path("small")).unwrap();
    let script = format!(
        "mount -t tmpfs -o size=400k none small || exit 77; '{}' bake a.yaml --textures none --out small/out; code=$?; \
         find small -name '*.glb' | wc -l; find small -type f -name '.tmp*' | wc -l; \
         mount -o remount,size=64m small; '{0}' bake a.yaml --textures none --out small/out --quiet || exit 78; cp -r small/out joined; exit $code",
        env!("CARGO_BIN_EXE_roomwright")
    );
    let output = std::process::Command::new("unshare")
        .args(["--mount", "--map-root-user", "sh", "-c", &script])
        .current_dir(world.path("."))
        .env("ROOMWRIGHT_CACHE", "none")
        .output();
    let Ok(output) = output else { return println!("skipped: no unshare") };
    if output.status.code() == Some(77) || String::from_utf8_lossy(&output.stderr).contains("unshare:") {
        return println!("skipped: no right to mount");
    }
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(matches!(output.status.code(), Some(1 | 2)), "{stderr}");
    assert!(stderr.contains("error[disk_full]") && stderr.contains("run the same command again"), "{stderr}");
    world.must(&["bake", "a.yaml", "--out", "whole"]);
    assert_eq!(world.files("joined"), world.files("whole"));
}
