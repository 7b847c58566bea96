//! The example for continuous integration works: its `run:` steps, in their order, in a repository made for the test.

use std::path::Path;
use std::process::{Command, Stdio};

use roomwright::internals::document::Source;
use serde_json::Value;

use super::world::{World, plan};

const EXAMPLE: &str = include_str!("../../docs/examples/roomwright.yml");

/// The steps of the only job.
fn steps() -> Vec<Value> {
    let workflow: Value = Source::new("text.yaml".as_ref(), EXAMPLE).parse().unwrap();
    let jobs = workflow["jobs"].as_object().unwrap();
    assert_eq!(jobs.len(), 1);
    jobs.values().next().unwrap()["steps"].as_array().unwrap().clone()
}

/// Runs the steps as the service does, up to the first that fails; the answer names that one.
fn run_steps(world: &World) -> Option<String> {
    let program = Path::new(env!("CARGO_BIN_EXE_roomwright")).parent().unwrap();
    let path = std::env::join_paths(
        std::iter::once(program.to_owned()).chain(std::env::split_paths(&std::env::var_os("PATH").unwrap())),
    );
    let path = path.unwrap();
    for step in steps() {
        let Some(script) = step["run"].as_str() else { continue };
        let status = Command::new("bash")
            .args(["--noprofile", "--norc", "-eo", "pipefail", "-c", script])
            .current_dir(world.path("."))
            .env("PATH", &path)
            .env("ROOMWRIGHT_CACHE", "none")
            .env("GITHUB_STEP_SUMMARY", world.path("summary.md"))
            .stdin(Stdio::null())
            .status()
            .unwrap();
        if !status.success() {
            return Some(step["name"].as_str().unwrap().to_owned());
        }
    }
    None
}

/// A target branch, and a pull request with another plan.
fn repository(head: &str) -> World {
    let world = World::new();
    world.write("base/plans/house.yaml", plan("house", 2));
    world.write("head/plans/house.yaml", head);
    world
}

fn text(world: &World, path: &str) -> String {
    String::from_utf8(world.read(path)).unwrap()
}

#[test]
fn steps_are_actions_or_scripts_and_have_names() {
    let steps = steps();
    let is_action = |step: &&Value| step["uses"].is_string();
    assert_eq!(steps.iter().filter(is_action).count(), 5);
    for step in &steps {
        assert!(step["name"].is_string() && (step["uses"].is_string() != step["run"].is_string()), "{step}");
        // Actions are named with a version.
        assert!(step["uses"].as_str().is_none_or(|action| action.contains("@v")), "{step}");
    }
}

#[test]
fn a_pull_request_that_does_no_harm_is_reported_and_passes() {
    let world = repository(&plan("house", 3));
    assert_eq!(run_steps(&world), None);
    let comment = text(&world, "furniture.md");
    assert!(comment.contains("1 added") && comment.contains("house / 3"), "{comment}");
    assert_eq!(text(&world, "summary.md"), comment);
    assert!(text(&world, "furniture.html").contains("house / 3"));
}

#[test]
fn a_pull_request_that_makes_a_room_worse_fails_and_is_reported() {
    // A bedroom in which no bed has a place.
    let narrow = plan("house", 2).replace("rectangle: [0, 0, 4, 4]", "rectangle: [2.6, 0, 1.4, 4]");
    let world = repository(&narrow.replace("at: [2, 0], width: 1.2", "at: [3.3, 0], width: 0.6"));
    assert_eq!(run_steps(&world).as_deref(), Some("Compare"));
    let comment = text(&world, "furniture.md");
    assert!(comment.contains("outline") && comment.contains("missing"), "{comment}");
    assert_eq!(text(&world, "summary.md"), comment);
    assert!(text(&world, "furniture.html").contains("<svg"));
}

#[test]
fn a_faulty_plan_fails_the_job_on_the_pull_request_but_not_on_the_target_branch() {
    let world = repository(&plan("house", 2));
    world.write("base/plans/bad.yaml", "version: 1\nid: bad\nlevels: 3\n");
    assert_eq!(run_steps(&world), None);
    let world = repository(&plan("house", 2));
    world.write("head/plans/bad.yaml", "version: 1\nid: bad\nlevels: 3\n");
    assert_eq!(run_steps(&world).as_deref(), Some("Bake the pull request"));
}
