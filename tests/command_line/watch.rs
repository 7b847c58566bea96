//! `bake --watch` as a real process bakes again after a change of an input.

use std::io::Read;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::world::{World, plan};

/// A machine that is busy with other tests is slow; this long it is never.
const PATIENCE: Duration = Duration::from_secs(120);

/// Time between two looks.
const STEP: Duration = Duration::from_millis(50);

/// A process that watches, ended at the latest with the test.
struct Watching<'w> {
    world: &'w World,
    child: Child,
}

impl<'w> Watching<'w> {
    fn start(world: &'w World, inputs: &[&str]) -> Self {
        let words = [&["bake", "--watch", "--effort", "1"], inputs].concat();
        let log = std::fs::File::create(world.path("log")).unwrap();
        let child = world.command(&words).stdout(Stdio::null()).stderr(log).spawn().unwrap();
        let mut watching = Self { world, child };
        watching.wait_for(|world| log_of(world).contains("Watching"), "the first bake");
        watching
    }

    /// Waits until the folder is as it should be, while the process lives.
    #[expect(
        clippy::disallowed_methods,
        reason = "a test that waits for another process, which tells nobody when it is done"
    )]
    fn wait_for(&mut self, is_so: impl Fn(&World) -> bool, what: &str) {
        let started = Instant::now();
        while !is_so(self.world) {
            let ended = self.child.try_wait().unwrap();
            assert!(ended.is_none(), "{what}: ended with {ended:?}\n{}", log_of(self.world));
            assert!(started.elapsed() < PATIENCE, "{what} did not come\n{}", log_of(self.world));
            std::thread::sleep(STEP);
        }
    }

    /// Presses Ctrl-C; the exit code.
    #[cfg(unix)]
    fn interrupt(mut self) -> Option<i32> {
        let id = self.child.id().to_string();
        assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
        self.child.wait().unwrap().code()
    }
}

impl Drop for Watching<'_> {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn log_of(world: &World) -> String {
    let mut log = String::new();
    std::fs::File::open(world.path("log")).unwrap().read_to_string(&mut log).unwrap();
    log
}

fn has(path: &'static str) -> impl Fn(&World) -> bool {
    move |world| world.path(path).exists()
}

#[test]
#[cfg(unix)]
fn a_changed_plan_is_baked_again_also_after_a_fault_until_ctrl_c() {
    let world = World::new();
    world.write("plans/a.yaml", plan("alpha", 1));
    let mut watching = Watching::start(&world, &["plans"]);
    world.write("plans/a.yaml", plan("alpha", 2));
    watching.wait_for(has("out/alpha/2.glb"), "the second level");
    world.write("plans/a.yaml", "version: 1\nlevels: 7\n");
    watching.wait_for(|world| log_of(world).contains("a.yaml:2:"), "the fault");
    world.write("plans/a.yaml", plan("alpha", 3));
    watching.wait_for(has("out/alpha/3.glb"), "the level after the fault");
    world.write("plans/b.yaml", plan("beta", 1));
    watching.wait_for(has("out/beta/1.glb"), "a new plan");
    assert_eq!(watching.interrupt(), Some(0));
    assert!(log_of(&world).contains("plans/a.yaml changed: baking again."), "{}", log_of(&world));
}

#[test]
#[cfg(unix)]
fn edits_configuration_and_the_plans_of_a_project_are_watched() {
    let world = World::new();
    world.write("plans/a.yaml", plan("alpha", 1));
    world.write("project.yaml", "version: 1\nproject:\n  catalog: [mine]\n  plans: [{plan: plans/a.yaml}]\n");
    let style = |untidy: u32| {
        format!(
            "version: 1\nstyles:\n  mine: {{extends: default, label: Mine, untidiness: {{turn: {untidy}, distance: 0}}}}\n"
        )
    };
    world.write("mine/styles/mine.yaml", style(1));
    let mut watching = Watching::start(&world, &["project.yaml", "--style", "mine"]);
    let first = world.files("out")["alpha/1.glb"].clone();
    let is_other = |before: String| {
        move |world: &World| world.files("out").get("alpha/1.glb").is_some_and(|now| *now != before)
    };
    world.write("mine/styles/mine.yaml", style(20));
    watching.wait_for(is_other(first), "the level in the changed style");
    let second = world.files("out")["alpha/1.glb"].clone();
    let edits = "version: 1\nedits:\n- {level: \"1\", room: study, seed: 9}\n";
    world.write("plans/a.edits.yaml", edits);
    watching.wait_for(is_other(second), "the level with edits");
    world.write("plans/a.yaml", plan("alpha", 2));
    watching.wait_for(has("out/alpha/2.glb"), "the second level");
    assert_eq!(watching.interrupt(), Some(0));
}

#[test]
fn paths_that_cannot_be_watched_are_rejected() {
    let world = World::new();
    let ran = world.run(&["bake", "--watch"]);
    assert_eq!(ran.code, Some(2), "the demo does not change: {}", ran.stderr);
    let ran = world.run(&["bake", "--watch", "nowhere/a.yaml"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("nowhere/a.yaml"), "{}", ran.stderr);
}
