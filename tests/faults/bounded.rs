//! Commands with a time limit: one that blocks or reads endlessly is killed and fails its test.

use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;

use super::world::{Ran, World};

/// Far more than any command here takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// Kilobytes of address space: threads' stacks and the allocator's reserves fit, a file of gigabytes does not.
const MEMORY: u32 = 6_000_000;

impl World {
    /// As [`World::run`], in limited time and memory.
    pub(crate) fn run_bounded(&self, arguments: &[&str]) -> Ran {
        self.run_within(&format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\""), arguments)
    }

    /// As [`World::run`], in limited time, by a line of shell that starts `"$0" "$@"`.
    pub(crate) fn run_within(&self, shell: &str, arguments: &[&str]) -> Ran {
        let inner = self.command(arguments);
        let mut command = Command::new("sh");
        command.args(["-c", shell]).arg(inner.get_program());
        command.args(inner.get_args()).current_dir(self.path(".")).stdin(Stdio::null());
        for (key, value) in inner.get_envs() {
            command.env(key, value.unwrap_or_default());
        }
        ended(command, &format!("{arguments:?}"))
    }
}

/// Runs a command to its end.
pub(crate) fn ended(mut command: Command, what: &str) -> Ran {
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let id = child.id().to_string();
    let (sender, receiver) = mpsc::channel();
    std::thread::spawn(move || sender.send(child.wait_with_output()));
    let Ok(output) = receiver.recv_timeout(PATIENCE) else {
        Command::new("kill").args(["-KILL", &id]).status().unwrap();
        panic!("{what} does not end");
    };
    let output = output.unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let ran = Ran { code: output.status.code(), stdout: text(&output.stdout), stderr: text(&output.stderr) };
    assert!(!ran.stderr.contains("panicked"), "{what}: {}", ran.stderr);
    ran
}
