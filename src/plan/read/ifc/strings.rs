//! Decodes escapes in texts: `\X2\00E9\X0\`, `\X\E9`, `\S\i`, `\\` and doubled quotes.

/// The text that is meant; escapes that are none stay as they are.
pub(super) fn decode(raw: &str) -> String {
    let mut text = String::with_capacity(raw.len());
    let mut rest = raw;
    while let Some(place) = rest.find(['\\', '\'']) {
        text.push_str(&rest[..place]);
        rest = &rest[place..];
        let (letters, length) = escape(rest);
        text.push_str(&letters);
        rest = &rest[length..];
    }
    text.push_str(rest);
    text
}

/// The meaning of the escape at the start of a text, and its length in bytes.
fn escape(text: &str) -> (String, usize) {
    let as_it_is = || (text.chars().take(1).collect(), 1);
    if text.starts_with("''") || text.starts_with("\\\\") {
        return (text[..1].to_owned(), 2);
    }
    if let Some(coded) = text.strip_prefix("\\X2\\") {
        return wide(coded, 4).unwrap_or_else(as_it_is);
    }
    if let Some(coded) = text.strip_prefix("\\X4\\") {
        return wide(coded, 8).unwrap_or_else(as_it_is);
    }
    if let Some(coded) = text.strip_prefix("\\X\\") {
        let code = coded.get(..2).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        return code.map_or_else(as_it_is, |code| (char::from(code).to_string(), 5));
    }
    if let Some(coded) = text.strip_prefix("\\S\\") {
        // The upper half of an alphabet; only that of Western Europe (ISO 8859-1) is known here.
        let letter = coded.chars().next().filter(char::is_ascii);
        let moved = letter.map(|letter| char::from(letter as u8 | 0x80).to_string());
        return moved.map_or_else(as_it_is, |moved| (moved, 4));
    }
    if text.starts_with("\\N\\") {
        return (" ".to_owned(), 3);
    }
    let is_alphabet = text.starts_with("\\P") && text.as_bytes().get(3) == Some(&b'\\');
    if is_alphabet && text.is_char_boundary(4) { (String::new(), 4) } else { as_it_is() }
}

/// Letters of so many hexadecimal digits each up to `\X0\`, and the bytes of the whole escape.
fn wide(coded: &str, digits: usize) -> Option<(String, usize)> {
    let end = coded.find("\\X0\\")?;
    let codes = coded.as_bytes()[..end].chunks(digits).map(|code| {
        let code = std::str::from_utf8(code).ok().filter(|code| code.len() == digits)?;
        u32::from_str_radix(code, 16).ok()
    });
    let codes: Vec<u32> = codes.collect::<Option<_>>()?;
    let text = if digits == 4 {
        let units: Vec<u16> = codes.into_iter().filter_map(|code| u16::try_from(code).ok()).collect();
        String::from_utf16_lossy(&units)
    } else {
        codes.into_iter().map(|code| char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
    };
    Some((text, "\\X2\\".len() + end + "\\X0\\".len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_become_letters() {
        let cases = [
            ("K\\X2\\00FC\\X0\\che", "Küche"),
            ("\\X2\\D83DDE00\\X0\\", "😀"),
            ("\\X4\\0001F600\\X0\\!", "😀!"),
            ("caf\\X\\E9", "café"),
            ("caf\\S\\i", "café"),
            ("\\PA\\a\\\\b", "a\\b"),
            ("it''s", "it's"),
            ("a\\N\\b", "a b"),
            ("Bäder", "Bäder"),
        ];
        for (raw, meant) in cases {
            assert_eq!(decode(raw), meant);
        }
    }

    #[test]
    fn other_backslashes_stay() {
        for raw in
            ["\\", "\\X", "\\X2\\00E", "\\X2\\00Eé\\X0\\", "\\X\\é", "\\S\\é", "\\Pé", "\\S\\", "c:\\dir"]
        {
            assert_eq!(decode(raw), raw);
        }
    }
}
