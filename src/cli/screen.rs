//! Prints results to stdout, and everything else to stderr.
//!
//! Names, words and ids come from files of unknown origin. All output goes through here, where characters that would
//! control a terminal or a continuous integration service are made visible.

use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use serde::Serialize;

use crate::document::{Faults, printable_json, printable_lines};

/// Whether a result was lost on its way to stdout; this process has one.
static IS_RESULT_LOST: AtomicBool = AtomicBool::new(false);

/// Takes note of how printing a result ended, and says on stderr if it was lost. A reader that has gone away is no error: it has
/// seen what it wanted.
pub(crate) fn printed(ended: io::Result<()>) {
    let Err(error) = ended.and_then(|()| io::stdout().flush()) else { return };
    if error.kind() != io::ErrorKind::BrokenPipe && !IS_RESULT_LOST.swap(true, Ordering::Relaxed) {
        let _ = writeln!(io::stderr().lock(), "standard output: the result cannot be written: {error}");
    }
}

/// Whether a result was lost.
pub(crate) fn is_result_lost() -> bool {
    IS_RESULT_LOST.load(Ordering::Relaxed)
}

/// Prints results, notes and errors, each to its stream.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Screen {
    /// No warnings, notes and summaries; errors are still shown.
    pub(crate) is_quiet: bool,
    /// Results for machines.
    pub(crate) is_json: bool,
}

impl Screen {
    /// Writes a result to stdout, with a newline.
    pub(crate) fn result(self, text: &str) {
        printed(writeln!(io::stdout().lock(), "{}", printable_lines(text)));
    }

    /// Writes a result for machines to stdout.
    pub(crate) fn json(self, value: &impl Serialize) {
        let document = serde_json::to_string_pretty(value).expect("reports are plain data");
        self.result(&printable_json(&document));
    }

    /// Tells people something on stderr, unless they asked for quiet.
    pub(crate) fn note(self, text: &str) {
        if !self.is_quiet {
            self.error(text);
        }
    }

    /// Tells people what went wrong, on stderr.
    #[expect(clippy::unused_self, reason = "one way to print, from a screen")]
    pub(crate) fn error(self, text: &str) {
        let _ = writeln!(io::stderr().lock(), "{}", printable_lines(text));
    }

    /// Shows errors, and warnings unless quiet, each with place, line and hint.
    pub(crate) fn faults(self, faults: &Faults) {
        for fault in faults {
            if fault.is_error() {
                self.error(&fault.report());
            } else {
                self.note(&fault.report());
            }
        }
    }
}
