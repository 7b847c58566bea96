//! Standard output on a full disk, and closed before its end.

use std::fs::File;
use std::process::{Command, Stdio};

use super::world::{World, plan};

/// Commands that print a result, and a word of it.
const PRINTING: [&[&str]; 16] = [
    &["draw", "a.yaml"],
    &["draw", "a.yaml", "--sheet", "all"],
    &["check", "a.yaml"],
    &["check", "a.yaml", "--json"],
    &["explain", "a.yaml", "study"],
    &["formats"],
    &["catalog"],
    &["catalog", "classes", "desk"],
    &["audit", "out"],
    &["diff", "out", "other"],
    &["completions", "bash"],
    &["man"],
    &["--help"],
    &["bake", "--help"],
    &["--version"],
    &["help", "draw"],
];

fn world() -> World {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml", "--effort", "1"]);
    world.must(&["bake", "a.yaml", "--effort", "1", "--seed", "2", "--out", "other"]);
    world
}

#[test]
#[cfg(target_os = "linux")]
fn a_result_that_is_lost_is_a_failure() {
    let world = world();
    for words in PRINTING {
        if world.run(words).stdout.is_empty() {
            continue;
        }
        let full = File::options().write(true).open("/dev/full").unwrap();
        let output = world.command(words).stdout(Stdio::from(full)).stderr(Stdio::piped()).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{words:?}: {said}");
        assert_eq!(
            said.matches("standard output: the result cannot be written").count(),
            1,
            "{words:?}: {said}"
        );
    }
}

#[test]
#[cfg(unix)]
fn a_closed_pipe_is_no_failure() {
    let world = world();
    let program = env!("CARGO_BIN_EXE_roomwright");
    for words in ["draw a.yaml", "man", "completions bash", "catalog", "bake --help"] {
        let line =
            format!("set -o pipefail; '{program}' {words} | head -1 >first; echo \"${{PIPESTATUS[0]}}\"");
        let output = Command::new("bash").args(["-c", &line]).current_dir(world.path(".")).output();
        let Ok(output) = output else { return println!("skipped: no bash") };
        let (code, said) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert_eq!((code.trim(), said.contains("standard output")), ("0", false), "{words}: {said}");
    }
}
