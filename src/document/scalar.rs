//! Interprets plain YAML words as values, by the core schema of YAML 1.2.

use serde_json::{Number, Value};

/// The meaning of a plain (unquoted) word.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Plain {
    /// Null, a boolean, a number or a text.
    Value(Value),
    /// NaN or infinite, or a number too large to be held.
    NotFinite,
}

/// Resolves a plain word as [`serde_saphyr`] does with strict booleans.
pub(super) fn resolve(word: &str) -> Plain {
    let value = match word {
        "" | "~" | "null" | "Null" | "NULL" => Value::Null,
        "true" | "True" | "TRUE" => Value::Bool(true),
        "false" | "False" | "FALSE" => Value::Bool(false),
        _ => return number(word).unwrap_or_else(|| Plain::Value(Value::String(word.to_owned()))),
    };
    Plain::Value(value)
}

fn number(word: &str) -> Option<Plain> {
    let unsigned = word.trim_start_matches(['+', '-']);
    if matches!(unsigned.to_ascii_lowercase().as_str(), ".nan" | ".inf") {
        return Some(Plain::NotFinite);
    }
    // Rust also parses "inf", "nan" and "infinity", which are texts in YAML.
    if !unsigned.starts_with(|letter: char| letter.is_ascii_digit() || letter == '.') {
        return None;
    }
    if let Ok(integer) = word.parse::<i64>() {
        return Some(Plain::Value(Value::Number(integer.into())));
    }
    let float: f64 = word.parse().ok()?;
    Some(Number::from_f64(float).map_or(Plain::NotFinite, |number| Plain::Value(Value::Number(number))))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn words_become_values() {
        for (word, value) in [
            ("", json!(null)),
            ("true", json!(true)),
            ("yes", json!("yes")),
            ("12", json!(12)),
            ("-1.5", json!(-1.5)),
            (".5", json!(0.5)),
            ("1e3", json!(1000.0)),
            ("inf", json!("inf")),
            ("1.2.3", json!("1.2.3")),
            ("-", json!("-")),
        ] {
            assert_eq!(resolve(word), Plain::Value(value), "{word}");
        }
    }

    #[test]
    fn infinite_numbers_and_not_a_number_are_distinguished() {
        for word in [".nan", ".NaN", ".inf", "-.Inf", "1e999"] {
            assert_eq!(resolve(word), Plain::NotFinite, "{word}");
        }
    }
}
