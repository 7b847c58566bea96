//! Answers wrong arguments with advice, and prints the help pages.

use std::io::{IsTerminal, Write};
use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::exit::Outcome;
use super::screen::printed;
use crate::document::bounded;

/// Shows what clap has to say, with what was typed made harmless and short.
pub(super) fn show(mut error: clap::Error) -> Outcome {
    if !error.use_stderr() {
        printed(error.print());
        return Outcome::Done;
    }
    let hint = plan_in_place_of_command(&error).unwrap_or_default();
    show_words(&mut error);
    let rendered = error.render();
    let text =
        if std::io::stderr().is_terminal() { rendered.ansi().to_string() } else { rendered.to_string() };
    let _ = write!(std::io::stderr().lock(), "{text}{hint}");
    Outcome::NotStarted
}

/// Puts what people can read in place of each word that was typed.
fn show_words(error: &mut clap::Error) {
    let context: Vec<(ContextKind, ContextValue)> =
        error.context().map(|(kind, value)| (kind, value.clone())).collect();
    for (kind, value) in context {
        let shown = match value {
            ContextValue::String(word) => ContextValue::String(bounded(&word)),
            ContextValue::Strings(words) => {
                ContextValue::Strings(words.iter().map(|word| bounded(word)).collect())
            }
            // Advice repeats the word within its colours.
            ContextValue::StyledStrs(advice) if advice.iter().any(|line| repeats_harm(&line.to_string())) => {
                ContextValue::None
            }
            other => other,
        };
        error.insert(kind, shown);
    }
}

/// Whether a line, without its colours, is not what people may see; colours that a word brings along are gone with them.
fn repeats_harm(line: &str) -> bool {
    bounded(line) != line || std::env::args().any(|word| word.contains('\u{1b}'))
}

/// Advice if a plan stands in place of a command.
fn plan_in_place_of_command(error: &clap::Error) -> Option<String> {
    let typed = match error.get(ContextKind::InvalidSubcommand)? {
        ContextValue::String(typed) if error.kind() == ErrorKind::InvalidSubcommand => typed,
        _ => return None,
    };
    let is_path = Path::new(typed).exists() || typed.contains(['/', '.', '*']);
    is_path.then(|| format!("\nTo bake it: roomwright bake {}\n", bounded(typed)))
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::super::arguments::Arguments;
    use super::*;

    #[test]
    fn typed_words_are_shown_without_escapes_and_cut() {
        let long = "x".repeat(200);
        for words in [
            ["bake", "--seed", "\u{9b}31mred\n"],
            ["bake", "--seed", &long],
            ["bake", "a", &format!("--{long}")],
        ] {
            let mut error = Arguments::try_parse_from([&["roomwright"], &words[..]].concat()).unwrap_err();
            show_words(&mut error);
            let shown = error.render().ansi().to_string();
            assert!(!shown.contains('\u{9b}') && !shown.contains("red\n"), "{shown}");
            assert!(!shown.contains(&long) && shown.contains(['…', '\\']), "{shown}");
        }
    }
}
