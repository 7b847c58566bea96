//! The source line of a fault, cut to a width that a terminal shows.

use super::limits::{EXCERPT_LEAD, EXCERPT_WIDTH};
use super::text::is_unprintable;

/// Marks a line whose beginning was cut.
const CUT: char = '…';

/// Characters between two marks of a long line.
const STEP: usize = 1024;

/// Where the lines of a text begin, with marks within long ones: machine-written files have one line, and may have a fault in
/// each of its values, for which it is not read again.
#[derive(Debug)]
pub(super) struct Lines {
    /// The byte at which each line begins.
    starts: Vec<usize>,
    /// Line from 0, characters before the mark, byte of the mark.
    marks: Vec<(usize, usize, usize)>,
}

impl Lines {
    /// Reads the text once.
    pub(super) fn new(text: &str) -> Self {
        let newlines = memchr::memchr_iter(b'\n', text.as_bytes()).map(|newline| newline + 1);
        let starts: Vec<usize> = std::iter::once(0).chain(newlines).collect();
        let mut marks = Vec::new();
        for (line, &start) in starts.iter().enumerate() {
            let end = starts.get(line + 1).map_or(text.len(), |next| next - 1);
            if end - start > STEP {
                let places = text[start..end].char_indices().enumerate().step_by(STEP).skip(1);
                marks.extend(places.map(|(count, (byte, _))| (line, count, start + byte)));
            }
        }
        Self { starts, marks }
    }

    /// The text of a line (from 1) around a column (from 1, in characters), or `None` beyond the end; of the same text.
    ///
    /// A long line loses its beginning, shown as `…`, and its end; [`caret_column`] finds the column again.
    pub(super) fn excerpt(&self, text: &str, line: usize, column: usize) -> Option<String> {
        let line = line.checked_sub(1)?;
        let start = *self.starts.get(line).filter(|&&start| start < text.len())?;
        let skipped = if column > EXCERPT_WIDTH { column - 1 - EXCERPT_LEAD } else { 0 };
        let before = self.marks.partition_point(|&(other, count, _)| (other, count) <= (line, skipped));
        let mark = before.checked_sub(1).map(|mark| self.marks[mark]).filter(|mark| mark.0 == line);
        let (_, counted, byte) = mark.unwrap_or((line, 0, start));
        let rest = text[byte..].chars().take_while(|&letter| letter != '\n').skip(skipped - counted);
        let rest: String = rest.take(EXCERPT_WIDTH).collect();
        let mut shown: String = if skipped > 0 { String::from(CUT) } else { String::new() };
        let letters = rest.strip_suffix('\r').unwrap_or(&rest).chars();
        shown.extend(letters.map(|letter| if is_unprintable(letter) { ' ' } else { letter }));
        Some(shown)
    }
}

/// The column of the fault within its excerpt, from 1.
pub(super) fn caret_column(excerpt: &str, column: usize) -> usize {
    if column > EXCERPT_WIDTH && excerpt.starts_with(CUT) { EXCERPT_LEAD + 2 } else { column }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn excerpt(text: &str, line: usize, column: usize) -> Option<String> {
        Lines::new(text).excerpt(text, line, column)
    }

    #[test]
    fn a_short_line_is_shown_whole() {
        assert_eq!(excerpt("a\n\tb: 1\n", 2, 2).as_deref(), Some(" b: 1"));
        assert_eq!(excerpt("a\n", 5, 1), None);
        assert_eq!(excerpt("a\n", 0, 1), None);
    }

    #[test]
    fn the_caret_of_a_long_line_stands_under_its_letter() {
        let text = format!("{}X{}", "a".repeat(1000), "b".repeat(1000));
        let shown = excerpt(&text, 1, 1001).unwrap();
        assert!(shown.chars().count() <= EXCERPT_WIDTH + 1);
        assert_eq!(shown.chars().nth(caret_column(&shown, 1001) - 1), Some('X'));
    }

    #[test]
    fn a_long_line_is_not_read_again_for_each_fault() {
        let text: String = format!("short\n{}\r\n", "äbcdefghij".repeat(3000));
        let lines = Lines::new(&text);
        assert_eq!(lines.marks.len(), 29);
        let letters: Vec<char> = "äbcdefghij".chars().collect();
        for column in [1, 120, 121, 1024, 1025, 1065, 1066, 2048, 29_999, 30_000] {
            let shown = lines.excerpt(&text, 2, column).unwrap();
            let under = shown.chars().nth(caret_column(&shown, column) - 1);
            assert_eq!(under, Some(letters[(column - 1) % 10]), "{column}");
            assert!(!shown.ends_with(' '));
        }
        assert_eq!(lines.excerpt(&text, 2, 40_000).as_deref(), Some("…"));
    }
}
