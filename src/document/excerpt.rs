//! The source line of a fault, cut to a width that a terminal shows.

use super::limits::{EXCERPT_LEAD, EXCERPT_WIDTH};
use super::text::is_unprintable;

/// Marks a line whose beginning was cut.
const CUT: char = '…';

/// The text of a line (from 1) around a column (from 1, in characters), or `None` beyond the end.
///
/// A long line loses its beginning, shown as `…`, and its end; [`caret_column`] finds the column again.
pub(super) fn excerpt(text: &str, line: usize, column: usize) -> Option<String> {
    let line = text.lines().nth(line.checked_sub(1)?)?;
    let skipped = if column > EXCERPT_WIDTH { column - 1 - EXCERPT_LEAD } else { 0 };
    let mut shown: String = if skipped > 0 { String::from(CUT) } else { String::new() };
    let rest = line.chars().skip(skipped);
    shown.extend(rest.take(EXCERPT_WIDTH).map(|letter| if is_unprintable(letter) { ' ' } else { letter }));
    Some(shown)
}

/// The column of the fault within its excerpt, from 1.
pub(super) fn caret_column(excerpt: &str, column: usize) -> usize {
    if column > EXCERPT_WIDTH && excerpt.starts_with(CUT) { EXCERPT_LEAD + 2 } else { column }
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
