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

/// Resolves a plain word by the core schema, and by what people write besides: capitals, digits in groups (`10_000`), binary
/// numbers. Only `true` and `false` are booleans, and a number with a leading zero is a text.
pub(super) fn resolve(word: &str) -> Plain {
    let value = match word {
        "" | "~" => Value::Null,
        _ if word.eq_ignore_ascii_case("null") => Value::Null,
        _ if word.eq_ignore_ascii_case("true") => Value::Bool(true),
        _ if word.eq_ignore_ascii_case("false") => Value::Bool(false),
        _ => return number(word).unwrap_or_else(|| Plain::Value(Value::String(word.to_owned()))),
    };
    Plain::Value(value)
}

fn number(word: &str) -> Option<Plain> {
    let unsigned = word.strip_prefix(['+', '-']).unwrap_or(word);
    // Rust also parses "inf", "nan" and "infinity", which are texts in YAML.
    if !unsigned.starts_with(|letter: char| letter.is_ascii_digit() || letter == '.') {
        return None;
    }
    if matches!(unsigned.to_ascii_lowercase().as_str(), ".nan" | ".inf") {
        return Some(Plain::NotFinite);
    }
    if has_leading_zero(unsigned) {
        return None;
    }
    let whole = word.parse::<i64>().map(Number::from).or_else(|_| word.parse::<u64>().map(Number::from));
    if let Ok(number) = whole {
        return Some(Plain::Value(Value::Number(number)));
    }
    match word.parse::<f64>() {
        Ok(float) => Some(
            Number::from_f64(float).map_or(Plain::NotFinite, |number| Plain::Value(Value::Number(number))),
        ),
        Err(_) => odd_number(word).map(|number| Plain::Value(Value::Number(number.into()))),
    }
}

/// A whole number with a radix or in groups of digits.
fn odd_number(word: &str) -> Option<i64> {
    let (sign, unsigned) = word.strip_prefix('-').map_or((1, word), |rest| (-1, rest));
    let lower = unsigned.strip_prefix('+').unwrap_or(unsigned).to_ascii_lowercase();
    let prefixed = [("0x", 16), ("0o", 8), ("0b", 2)]
        .into_iter()
        .find_map(|(prefix, radix)| Some((lower.strip_prefix(prefix)?, radix)));
    let (digits, radix) = prefixed.unwrap_or((&lower, 10));
    let is_digits = |group: &str| !group.is_empty() && group.chars().all(|digit| digit.is_digit(radix));
    if !digits.split('_').all(is_digits) || (radix == 10 && digits.starts_with('0')) {
        return None;
    }
    Some(sign * i64::from_str_radix(&digits.replace('_', ""), radix).ok()?)
}

/// Whether a zero stands before another digit.
fn has_leading_zero(unsigned: &str) -> bool {
    unsigned.len() > 1 && unsigned.starts_with('0') && unsigned.bytes().all(|byte| byte.is_ascii_digit())
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
            ("NULL", json!(null)),
            ("False", json!(false)),
            ("0x1F", json!(31)),
            ("-0b10", json!(-2)),
            ("10_000", json!(10000)),
            ("1__0", json!("1__0")),
            ("0_7", json!("0_7")),
            ("007", json!("007")),
            ("0", json!(0)),
            ("00.5", json!(0.5)),
            ("18446744073709551615", json!(u64::MAX)),
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
