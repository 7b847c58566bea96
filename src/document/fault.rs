//! Faults of an input: the place, the fact, the value and a hint.

use std::fmt;
use std::path::{Path, PathBuf};

use super::excerpt::caret_column;
use super::text::{bounded, printable};

/// One step of a path inside a document: `levels[0].rooms[3].outline`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PathStep {
    /// A key of a mapping.
    Key(String),
    /// An item of a sequence, from 0.
    Index(usize),
}

impl From<&str> for PathStep {
    fn from(key: &str) -> Self {
        Self::Key(key.to_owned())
    }
}

impl From<usize> for PathStep {
    fn from(index: usize) -> Self {
        Self::Index(index)
    }
}

/// A document path as people write it: `levels[0].rooms[3].outline`.
#[must_use]
pub fn show_path(path: &[PathStep]) -> String {
    let mut shown = String::new();
    for step in path {
        match step {
            PathStep::Key(key) if shown.is_empty() => shown.push_str(&bounded(key)),
            PathStep::Key(key) => {
                shown.push('.');
                shown.push_str(&bounded(key));
            }
            PathStep::Index(index) => shown.push_str(&format!("[{index}]")),
        }
    }
    shown
}

/// One error or doubt in an input file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The file.
    pub file: PathBuf,
    /// Line and column, both from 1, where known.
    pub position: Option<(usize, usize)>,
    /// The text of that line, where known; a long line is cut around the column, its lost beginning is
    /// shown as `…`.
    pub line: Option<String>,
    /// Where in the document.
    pub path: Vec<PathStep>,
    /// The fact, with the value.
    pub message: String,
    /// Advice for the user, if there is any.
    pub hint: Option<String>,
    /// Whether the file can be used all the same.
    pub severity: FaultSeverity,
}

/// How bad a fault is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FaultSeverity {
    /// The file is used; the user should look at it.
    Warning,
    /// The file cannot be used.
    Error,
}

impl Fault {
    /// An error about a file as a whole. What cannot be printed is escaped, what is long is cut.
    #[must_use]
    pub fn of_file(file: &Path, message: impl Into<String>) -> Self {
        Self {
            file: file.to_owned(),
            position: None,
            line: None,
            path: Vec::new(),
            message: bounded(&message.into()),
            hint: None,
            severity: FaultSeverity::Error,
        }
    }

    /// The same fault with a hint.
    #[must_use]
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(bounded(&hint.into()));
        self
    }

    /// The same fault with a hint, if there is one.
    #[must_use]
    pub fn with_some_hint(self, hint: Option<String>) -> Self {
        match hint {
            Some(hint) => self.with_hint(hint),
            None => self,
        }
    }

    /// The same fault as a warning.
    #[must_use]
    pub fn as_warning(mut self) -> Self {
        self.severity = FaultSeverity::Warning;
        self
    }

    /// Whether the file cannot be used.
    #[must_use]
    pub fn is_error(&self) -> bool {
        self.severity == FaultSeverity::Error
    }

    /// Everything about the fault on several lines, without a newline at the end: place and fact, the
    /// source line with a caret, the document path, the hint.
    ///
    /// ```text
    /// house.yaml:12:13: unknown room type "kitchin"
    ///   12 |       type: kitchin
    ///      |             ^
    ///   in levels[0].rooms[3].type
    ///   hint: did you mean "kitchen"?
    /// ```
    #[must_use]
    pub fn report(&self) -> String {
        let mut report = self.to_string();
        if let (Some((number, column)), Some(line)) = (self.position, &self.line) {
            let number = number.to_string();
            let (margin, indent) = (" ".repeat(number.len()), " ".repeat(caret_column(line, column) - 1));
            report.push_str(&format!("\n  {number} | {line}\n  {margin} | {indent}^"));
        }
        if !self.path.is_empty() {
            report.push_str(&format!("\n  in {}", bounded(&show_path(&self.path))));
        }
        if let Some(hint) = &self.hint {
            report.push_str(&format!("\n  hint: {hint}"));
        }
        report
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.file.to_string_lossy()))?;
        if let Some((line, column)) = self.position {
            write!(f, ":{line}:{column}")?;
        }
        let severity = if self.is_error() { "" } else { "warning: " };
        write!(f, ": {severity}{}", self.message)
    }
}

impl std::error::Error for Fault {}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Fault {
        Fault {
            position: Some((12, 13)),
            line: Some("      type: kitchin".to_owned()),
            path: vec!["levels".into(), 0.into(), "rooms".into(), 3.into(), "type".into()],
            ..Fault::of_file(Path::new("house.yaml"), "unknown room type \"kitchin\"")
        }
        .with_hint("did you mean \"kitchen\"?")
    }

    #[test]
    fn the_report_shows_place_line_path_and_hint() {
        let expected = "house.yaml:12:13: unknown room type \"kitchin\"\n\
            \x20 12 |       type: kitchin\n\
            \x20    |             ^\n\
            \x20 in levels[0].rooms[3].type\n\
            \x20 hint: did you mean \"kitchen\"?";
        assert_eq!(sample().report(), expected);
    }

    #[test]
    fn a_warning_says_so() {
        assert_eq!(
            Fault::of_file(Path::new("a.yaml"), "odd").as_warning().to_string(),
            "a.yaml: warning: odd"
        );
    }
}
