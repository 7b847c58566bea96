//! Fills numbers into ids: `"{level}{n:02}"` gives `101`, `102`...

/// Most digits that a number is padded to.
const MOST_DIGITS: usize = 20;

/// The values of the names in a pattern.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PatternValues<'a> {
    /// `{n}`.
    pub(crate) n: Option<i64>,
    /// `{level}`.
    pub(crate) level: Option<i64>,
    /// `{id}`.
    pub(crate) id: Option<&'a str>,
}

impl PatternValues<'_> {
    /// The names that mean something.
    fn names(&self) -> Vec<&'static str> {
        let all = [("n", self.n.is_some()), ("level", self.level.is_some()), ("id", self.id.is_some())];
        all.into_iter().filter(|(_, is_known)| *is_known).map(|(name, _)| name).collect()
    }
}

/// Whether a pattern names a value.
pub(crate) fn names_value(pattern: &str, name: &str) -> bool {
    pattern.contains(&format!("{{{name}}}")) || pattern.contains(&format!("{{{name}:"))
}

/// Puts values in the place of names.
///
/// # Errors
/// The fault of the pattern, and a hint.
pub(crate) fn expand(pattern: &str, values: &PatternValues<'_>) -> Result<String, (String, String)> {
    let mut expanded = String::with_capacity(pattern.len());
    let mut rest = pattern;
    while let Some(start) = rest.find(['{', '}']) {
        expanded.push_str(&rest[..start]);
        let end = rest[start..].find('}').filter(|end| *end > 0).map(|end| start + end);
        let Some(end) = end else {
            return Err((format!("\"{pattern}\" has a lone brace"), example(values)));
        };
        let filled = fill(&rest[start + 1..end], values).ok_or_else(|| {
            (format!("\"{}\" in \"{pattern}\" means nothing here", &rest[start..=end]), example(values))
        })?;
        expanded.push_str(&filled);
        rest = &rest[end + 1..];
    }
    expanded.push_str(rest);
    Ok(expanded)
}

fn fill(field: &str, values: &PatternValues<'_>) -> Option<String> {
    let (name, width) = match field.split_once(':') {
        Some((name, digits)) => (name, digits.strip_prefix('0')?.parse::<usize>().ok()?),
        None => (field, 0),
    };
    if width > MOST_DIGITS {
        return None;
    }
    match name {
        "n" => values.n.map(|number| format!("{number:0width$}")),
        "level" => values.level.map(|number| format!("{number:0width$}")),
        "id" if width == 0 => values.id.map(str::to_owned),
        _ => None,
    }
}

fn example(values: &PatternValues<'_>) -> String {
    let names: Vec<String> = values.names().iter().map(|name| format!("{{{name}}}")).collect();
    if names.is_empty() {
        return "no braces can stand here".to_owned();
    }
    format!("possible here: {}; {{n:02}} writes two digits", names.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    const VALUES: PatternValues<'_> = PatternValues { n: Some(7), level: Some(3), id: Some("east") };

    #[test]
    fn names_become_values() {
        for (pattern, expanded) in [
            ("{level}{n:02}", "307"),
            ("{id}-bath", "east-bath"),
            ("plain", "plain"),
            ("{n}{n:03}", "7007"),
            ("", ""),
        ] {
            assert_eq!(expand(pattern, &VALUES).as_deref(), Ok(expanded));
        }
    }

    #[test]
    fn wrong_patterns_are_named() {
        for pattern in ["{n", "n}", "{}", "{m}", "{n:2}", "{n:0x}", "{n:099}", "{id:02}", "}{"] {
            let (message, hint) = expand(pattern, &VALUES).unwrap_err();
            assert!(message.contains(pattern), "{message}");
            assert!(hint.contains("{n}, {level}, {id}"), "{hint}");
        }
        assert!(expand("{id}", &PatternValues { id: None, ..VALUES }).is_err());
    }

    #[test]
    fn names_are_found() {
        assert!(names_value("room {n:02}", "n") && names_value("{n}", "n") && !names_value("{level}", "n"));
    }
}
