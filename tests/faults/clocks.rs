//! Wrong clocks: files from 1970, and from the future.

use std::fs::File;
use std::time::{Duration, SystemTime};

use super::world::{World, plan};

#[test]
fn times_of_files_do_not_matter() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world.must(&["bake", "a.yaml", "--out", "whole"]);
    world.must(&["bake", "a.yaml"]);
    let century = Duration::from_secs(100 * 365 * 24 * 3600);
    for time in [SystemTime::UNIX_EPOCH, SystemTime::now() + century] {
        for name in
            ["a.yaml", "out/manifest.json", "out/alpha/1.glb", "out/alpha/2.glb", "out/.roomwright/lock"]
        {
            File::options().append(true).open(world.path(name)).unwrap().set_modified(time).unwrap();
        }
        world.must(&["bake", "a.yaml"]);
        assert_eq!(world.files("out"), world.files("whole"));
        let ran = world.must(&["diff", "out", "whole"]);
        assert!(ran.stdout.contains("o difference") || ran.stdout.contains("same"), "{}", ran.stdout);
        // Another content of the same length, with the same time, is another plan.
        world.write("a.yaml", plan("alpha", 2).replace("[0, 0, 4, 4]", "[0, 0, 4, 5]"));
        File::options().append(true).open(world.path("a.yaml")).unwrap().set_modified(time).unwrap();
        assert!(world.must(&["bake", "a.yaml"]).stdout.contains("Baked 2 levels"));
        world.write("a.yaml", plan("alpha", 2));
        world.must(&["bake", "a.yaml", "--force"]);
    }
}

/// A run that was killed long ago, or seems to have been in the future, is given up all the same.
#[test]
fn abandoned_runs_of_any_time_are_cleared() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml", "--out", "whole"]);
    let day = Duration::from_secs(24 * 3600);
    for time in [SystemTime::UNIX_EPOCH, SystemTime::now() + day] {
        world.write("out/.roomwright/run-old/journal", "{\"program\":\"0\"}\n");
        world.write("out/.roomwright/run-old/alive", "");
        world.write("out/.roomwright/run-old/result-aB3dE6", "half a floor");
        for name in ["journal", "alive", "result-aB3dE6"] {
            let path = world.path("out/.roomwright/run-old").join(name);
            File::options().append(true).open(path).unwrap().set_modified(time).unwrap();
        }
        world.must(&["bake", "a.yaml", "--quiet"]);
        assert_eq!(world.files("out"), world.files("whole"));
    }
}
