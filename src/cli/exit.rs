//! Exit codes.

/// How a command ended; the worst of its parts counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// Everything was done.
    Done = 0,
    /// Some inputs failed; the rest is done.
    SomeFailed = 1,
    /// Nothing could start, or the result was lost.
    NotStarted = 2,
}

/// The exit codes on the help pages of most commands.
pub(crate) const EXIT_CODES: &str = "\
Exit codes:
  0  everything was done
  1  some inputs failed; the rest is done
  2  nothing could start: bad arguments, no readable input, no output folder; or the result could
     not be written to standard output";

/// The exit codes on the help page of `audit`.
pub(crate) const AUDIT_EXIT_CODES: &str = "\
Exit codes:
  0  every room was judged, and none fails
  1  some rooms fail, or could not be judged
  2  nothing could be judged: bad arguments, bad configuration, no readable file; or the
     report could not be written";

/// The exit codes on the help page of `diff`.
pub(crate) const DIFF_EXIT_CODES: &str = "\
Exit codes:
  0  no difference of the kinds asked for with --fail-on
  1  differences of these kinds
  2  something could not be compared (no manifest, an unreadable file), the rest was; or the report
     could not be written";

impl Outcome {
    /// The worse of two.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        self.max(other)
    }

    /// `Done` if there was no failure, else `SomeFailed`.
    #[must_use]
    pub fn of_failures(has_failures: bool) -> Self {
        if has_failures { Self::SomeFailed } else { Self::Done }
    }
}

impl From<Outcome> for std::process::ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(outcome as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_outcome_counts() {
        assert_eq!(Outcome::Done.and(Outcome::SomeFailed), Outcome::SomeFailed);
        assert_eq!(Outcome::NotStarted.and(Outcome::SomeFailed), Outcome::NotStarted);
        assert_eq!(Outcome::of_failures(false), Outcome::Done);
    }

    #[test]
    fn the_help_page_lists_every_code() {
        for code in [Outcome::Done, Outcome::SomeFailed, Outcome::NotStarted] {
            let number = (code as u8).to_string();
            for page in [EXIT_CODES, AUDIT_EXIT_CODES, DIFF_EXIT_CODES] {
                assert!(page.lines().any(|line| line.trim().starts_with(&number)));
            }
        }
    }
}
