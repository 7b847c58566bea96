//! Texts from outside as people see them: in one line, without signs that no screen shows, not longer than they read.

/// Letters of a word that are shown before it is cut.
const WORD_LENGTH: usize = 80;
/// Letters of a message or hint that are shown before it is cut.
const TEXT_LENGTH: usize = 600;

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
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            _ if !is_unprintable(letter) => shown.push(letter),
            '\n' | '\r' | '\t' => shown.extend(letter.escape_default()),
            _ => shown.extend(letter.escape_unicode()),
        }
    }
    shown
}

/// As [`printable`], with long words and long texts cut: an input may quote itself whole.
pub(super) fn bounded(text: &str) -> String {
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
    if word.len() <= WORD_LENGTH || word.chars().count() <= WORD_LENGTH {
        return word.to_owned();
    }
    const END: usize = 8;
    let start: String = word.chars().take(WORD_LENGTH - END - 1).collect();
    let end: Vec<char> = word.chars().rev().take(END).collect();
    start + "…" + &end.into_iter().rev().collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_that_no_screen_shows_are_escaped() {
        assert_eq!(printable("a\n::error::b"), "a\\n::error::b");
        assert_eq!(printable("a\u{fffe}\u{ffff}\u{7}"), "a\\u{fffe}\\u{ffff}\\u{7}");
        assert_eq!(printable("\u{202e}moor\u{2028}"), "\\u{202e}moor\\u{2028}");
        assert_eq!(printable("Küche 台所 é"), "Küche 台所 é");
    }

    #[test]
    fn a_word_of_megabytes_is_cut() {
        let shown = bounded(&format!("unknown key \"{}\"", "x".repeat(50 << 20)));
        assert!(shown.starts_with("unknown key \"xxx") && shown.ends_with("xxx\""), "{shown}");
        assert!(shown.chars().count() < 120);
        let many = bounded(&"key ".repeat(1 << 20));
        assert!(many.chars().count() < 700 && many.ends_with('…'));
        assert_eq!(bounded("short"), "short");
        assert_eq!(bounded(&"word ".repeat(100)), "word ".repeat(100));
    }
}
