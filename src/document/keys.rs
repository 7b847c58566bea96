//! Lists the outermost keys of a text without reading its values.

/// The keys of the outermost mapping.
///
/// In YAML without braces these are the words before a colon at the beginning of a line. In braces, as in JSON,
/// strings are skipped and braces counted; a text that ends too early gives the keys up to there.
pub(crate) fn top_keys(text: &str) -> Vec<String> {
    let first = text.lines().find(|line| {
        let line = line.trim_start();
        !(line.is_empty() || line.starts_with(['#', '%']) || line.starts_with("---"))
    });
    match first {
        Some(line) if line.trim_start().starts_with('{') => keys_in_braces(text),
        _ => text.lines().filter_map(key_of_line).collect(),
    }
}

fn key_of_line(line: &str) -> Option<String> {
    let (key, rest) = line.split_once(':')?;
    let key = key.trim_end().trim_matches(['"', '\'']);
    let is_word = !key.is_empty() && key.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
    (is_word && (rest.is_empty() || rest.starts_with(char::is_whitespace))).then(|| key.to_owned())
}

fn keys_in_braces(text: &str) -> Vec<String> {
    let (mut keys, mut depth) = (Vec::new(), 0_u32);
    // The last word or string at depth 1, a key if a colon follows.
    let mut word = String::new();
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '"' => {
                let string = string_end(&mut letters);
                if depth == 1 {
                    word = string;
                }
            }
            '{' | '[' => depth += 1,
            '}' | ']' => depth = depth.saturating_sub(1),
            ':' if depth == 1 => keys.push(std::mem::take(&mut word)),
            ',' => word.clear(),
            letter if depth == 1 && !letter.is_whitespace() => word.push(letter),
            _ => {}
        }
    }
    keys
}

/// The rest of a string whose opening quote has been read.
fn string_end(letters: &mut std::str::Chars<'_>) -> String {
    let mut string = String::new();
    while let Some(letter) = letters.next() {
        match letter {
            '"' => break,
            '\\' => drop(letters.next()),
            letter => string.push(letter),
        }
    }
    string
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_of_block_and_brace_documents() {
        let block = "# plan\n---\nversion: 1\nlevels:\n  - id: a\n    rooms: []\n\"project\": x\nurl://x\n";
        assert_eq!(top_keys(block), ["version", "levels", "project"]);
        let json = "{\n \"version\": 1, \"levels\": [{\"id\": \"a:b}\", \"x\": 1}], \"project\": {\"y\": \"\\\"z\\\":\"}}";
        assert_eq!(top_keys(json), ["version", "levels", "project"]);
        assert_eq!(top_keys("{version: 1, levels: [a"), ["version", "levels"]);
        assert_eq!(top_keys(""), Vec::<String>::new());
    }
}
