//! Prepares foreign texts for messages: one line, control characters replaced, long texts cut.

/// Letters of a word that are shown before it is cut.
const WORD_LENGTH: usize = 80;
/// Letters of a path, which is of use only whole, that are shown before it is cut.
const PATH_LENGTH: usize = 400;
/// Letters of a message or hint that are shown before it is cut.
const TEXT_LENGTH: usize = 600;
/// Beginnings of lines that services for continuous integration take for commands.
const COMMANDS: [&str; 2] = ["::", "##["];

/// Whether a letter has no business in a name or a message: control characters and line separators, which break lines in
/// logs and lists; what turns the direction of writing, which shows other words than are there; codes that are no
/// letters in Unicode.
#[must_use]
pub fn is_unprintable(letter: char) -> bool {
    let code = u32::from(letter);
    letter.is_control()
        || matches!(letter, '\u{2028}' | '\u{2029}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
        || (0xfdd0..=0xfdef).contains(&code)
        || code & 0xfffe == 0xfffe
}

/// The text in one line, with escapes for what is unprintable.
#[must_use]
pub fn printable(text: &str) -> String {
    replaced(text, |letter| is_unprintable(letter).then(|| escaped(letter)))
}

/// As [`printable`], but line breaks and tabs stay, and no line begins as a command to a service for continuous integration.
#[must_use]
pub fn printable_lines(text: &str) -> String {
    let text = replaced(text, |letter| breaks_lines(letter).then(|| escaped(letter)));
    if !COMMANDS.iter().any(|command| text.contains(command)) {
        return text;
    }
    let is_command = |line: &str| COMMANDS.iter().any(|command| line.trim_start().starts_with(command));
    let line = |line: &str| if is_command(line) { format!("\\{line}") } else { line.to_owned() };
    text.split('\n').map(line).collect::<Vec<_>>().join("\n")
}

/// A JSON document with the same values, in which what is unprintable is written as JSON escapes.
#[must_use]
pub fn printable_json(document: &str) -> String {
    let escape = |letter: char| {
        letter.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")).collect::<String>()
    };
    replaced(document, |letter| breaks_lines(letter).then(|| escape(letter)))
}

/// Whether a letter is unprintable even where a text has several lines.
fn breaks_lines(letter: char) -> bool {
    is_unprintable(letter) && !matches!(letter, '\n' | '\t')
}

fn escaped(letter: char) -> String {
    match letter {
        '\n' | '\r' | '\t' => letter.escape_default().collect(),
        _ => letter.escape_unicode().collect(),
    }
}

fn replaced(text: &str, replacement: impl Fn(char) -> Option<String>) -> String {
    if !text.contains(is_unprintable) {
        return text.to_owned();
    }
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        match replacement(letter) {
            Some(escape) => shown.push_str(&escape),
            None => shown.push(letter),
        }
    }
    shown
}

/// As [`printable`], with long words and long texts cut: an input may quote itself whole.
pub(crate) fn bounded(text: &str) -> String {
    if text.len() <= WORD_LENGTH && !text.contains(is_unprintable) {
        return text.to_owned();
    }
    let mut shown = String::new();
    let mut words = text.split_inclusive(' ');
    let (mut letters, mut is_cut) = (0, false);
    while letters < TEXT_LENGTH {
        let Some(word) = words.next() else { break };
        let part = cut_word(word);
        letters += part.chars().count();
        shown.push_str(&part);
    }
    is_cut |= words.next().is_some();
    if is_cut {
        shown.push('…');
    }
    printable(&shown)
}

/// A word with the space behind it, its middle cut out where it is long: quotes and brackets around it stay.
fn cut_word(word: &str) -> String {
    const END: usize = 8;
    let most = if word.contains(['/', '\\']) { PATH_LENGTH } else { WORD_LENGTH };
    if word.len() <= most || word.chars().count() <= most {
        return word.to_owned();
    }
    let start: String = word.chars().take(most - END - 1).collect();
    let end: Vec<char> = word.chars().rev().take(END).collect();
    start + "…" + &end.into_iter().rev().collect::<String>()
}

/// A count with its word, in the singular or the plural: `1 level`, `2 levels`.
pub(crate) fn counted(count: impl TryInto<u64>, one: &str) -> String {
    let count = count.try_into().unwrap_or(u64::MAX);
    if count == 1 { format!("1 {one}") } else { format!("{count} {one}s") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_escaped() {
        assert_eq!(printable("a\n::error::b"), "a\\n::error::b");
        assert_eq!(printable("a\u{fffe}\u{ffff}\u{7}"), "a\\u{fffe}\\u{ffff}\\u{7}");
        assert_eq!(printable("\u{202e}moor\u{2028}"), "\\u{202e}moor\\u{2028}");
        assert_eq!(printable("Küche 台所 é"), "Küche 台所 é");
    }

    #[test]
    fn escapes_of_terminals_are_shown_and_do_nothing() {
        assert_eq!(
            printable("a\u{1b}[2Jb\u{9b}1m\u{7f}\u{202e}c\n"),
            "a\\u{1b}[2Jb\\u{9b}1m\\u{7f}\\u{202e}c\\n"
        );
        assert_eq!(printable_lines("a\n\tb\r\u{1b}c"), "a\n\tb\\r\\u{1b}c");
    }

    #[test]
    fn no_printed_line_is_a_command_of_a_continuous_integration_service() {
        assert_eq!(
            printable_lines("a::b\n  ::warning::x\n##[error]y"),
            "a::b\n\\  ::warning::x\n\\##[error]y"
        );
    }

    #[test]
    fn json_keeps_its_values() {
        let value = serde_json::json!({"id": "a\u{1b}\u{9b}\u{202e}\u{1ffff}\nb"});
        let shown = printable_json(&serde_json::to_string_pretty(&value).unwrap());
        assert!(!shown.contains(['\u{1b}', '\u{9b}', '\u{202e}', '\u{1ffff}']));
        assert_eq!(serde_json::from_str::<serde_json::Value>(&shown).unwrap(), value);
    }

    #[test]
    fn a_word_of_megabytes_is_cut() {
        let shown = bounded(&format!("unknown key \"{}\"", "x".repeat(50 << 20)));
        assert!(shown.starts_with("unknown key \"xxx") && shown.ends_with("xxx\""), "{shown}");
        assert!(shown.chars().count() < 120);
        let many = bounded(&"key ".repeat(1 << 20));
        assert!(many.chars().count() < 700 && many.ends_with('…'));
        assert_eq!(bounded("short"), "short");
        let path = format!("cannot read \"{}\"", "folder/".repeat(30));
        assert_eq!(bounded(&path), path);
        assert_eq!(bounded(&"word ".repeat(100)), "word ".repeat(100));
    }
}
