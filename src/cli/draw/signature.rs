//! The last line of a drawing, by which `draw` recognises its own: the program, and a hash of all lines above.
//!
//! ```text
//! <!-- drawn by roomwright; unchanged while the lines above have sha256 3f1a… -->
//! ```

use crate::disk::content_hash;

const BEGINNING: &str = "<!-- drawn by roomwright; unchanged while the lines above have sha256 ";
const END: &str = " -->\n";

/// A drawing with the line that says whose it is.
pub(super) fn sign(mut svg: String) -> String {
    let hash = content_hash(svg.as_bytes());
    svg.push_str(BEGINNING);
    svg.push_str(&hash);
    svg.push_str(END);
    svg
}

/// Whether `draw` wrote a file that was not changed since: it may be replaced.
pub(super) fn is_own_drawing(content: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(content) else { return false };
    let Some((svg, line)) = text.rsplit_once(BEGINNING) else { return false };
    line.strip_suffix(END) == Some(content_hash(svg.as_bytes()).as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edited_drawing_is_not_recognised_as_the_programs_own() {
        let signed = sign("<svg/>\n".to_owned());
        assert!(is_own_drawing(signed.as_bytes()));
        for changed in [
            signed.replace("<svg/>", "<svg />"),
            format!("{signed}\n"),
            signed.trim_end().to_owned(),
            "<svg/>\n".to_owned(),
            String::new(),
        ] {
            assert!(!is_own_drawing(changed.as_bytes()), "{changed:?}");
        }
        assert!(!is_own_drawing(&[0xff, 0xfe]));
    }
}
