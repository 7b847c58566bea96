//! Completions and manual pages.

use std::process::{Command, Stdio};

use super::world::World;

#[test]
fn every_shell_gets_completions_of_all_commands() {
    let world = World::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = world.must(&["completions", shell]).stdout;
        for word in ["capture", "markdown-limit", "completions"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    assert_eq!(world.run(&["completions", "tcsh"]).code, Some(2));
}

#[test]
fn bash_completes_commands_and_options() {
    let world = World::new();
    world.write("complete.bash", world.must(&["completions", "bash"]).stdout);
    let script = "source complete.bash; COMP_WORDS=(roomwright draw --she); COMP_CWORD=2; \
                  _roomwright roomwright --she draw; echo \"${COMPREPLY[@]}\"";
    let output =
        Command::new("bash").args(["-c", script]).current_dir(world.path(".")).stdin(Stdio::null()).output();
    let Ok(output) = output else { return println!("skipped: no bash") };
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "--sheet", "{output:?}");
}

#[test]
fn each_command_has_a_manual_page() {
    let world = World::new();
    let page = world.must(&["man"]).stdout;
    assert!(page.contains(".TH roomwright 1") && page.contains("roomwright\\-bake(1)"), "{page}");
    world.must(&["man", "--out", "man"]);
    let names = world.names("man");
    for name in ["roomwright.1", "roomwright-bake.1", "roomwright-edits-capture.1"] {
        assert!(names.iter().any(|known| known == name), "{names:?}");
    }
    let bake = String::from_utf8(world.read("man/roomwright-bake.1")).unwrap();
    assert!(bake.contains("nothing could start"), "exit codes are documented");
    assert_eq!(world.run(&["man", "--out", "man"]).code, Some(2), "the pages exist");
}
