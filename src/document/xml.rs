//! Escapes texts for XML and HTML.

use super::text::is_unprintable;

/// A text between tags or in an attribute, on one line. What is unprintable is replaced by U+FFFD: most of it XML 1.0
/// (section 2.2) does not allow even as references.
#[must_use]
pub fn xml_text(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => shown.push_str("&amp;"),
            '<' => shown.push_str("&lt;"),
            '>' => shown.push_str("&gt;"),
            '"' => shown.push_str("&quot;"),
            '\t' | '\n' | '\r' => shown.push(' '),
            letter if is_unprintable(letter) => shown.push('\u{fffd}'),
            letter => shown.push(letter),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_that_xml_does_not_allow_are_replaced() {
        assert_eq!(xml_text("a<b>&\"c\"\n"), "a&lt;b&gt;&amp;&quot;c&quot; ");
        assert_eq!(xml_text("\u{0}\u{1b}\u{85}\u{fffe}\u{ffff}\u{1ffff}\u{fdd0}"), "\u{fffd}".repeat(7));
        assert_eq!(xml_text("Küche 部屋 \u{1f6cf}"), "Küche 部屋 \u{1f6cf}");
    }
}
