//! The values of an instance: `(#12,$,'text',.T.,(1.,2.),IFCLABEL('x'))`.

use super::strings::decode;

/// Lists in lists in lists; deeper ones are nothing that IFC knows.
const DEEPEST: usize = 32;

/// A value as written.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// `$` or `*`.
    Missing,
    /// `#12`.
    Reference(u64),
    /// Finite.
    Number(f64),
    /// Without its escapes.
    Text(String),
    /// Capital, without its dots.
    Word(String),
    List(Vec<Value>),
    /// A value with the name of its type.
    Typed(String, Vec<Value>),
    /// Bits, which nothing here needs.
    Binary,
}

impl Value {
    /// The items of a list; nothing for anything else.
    pub(super) fn items(&self) -> &[Self] {
        if let Self::List(items) = self { items } else { &[] }
    }

    /// The value within its type, if it has one.
    pub(super) fn bare(&self) -> &Self {
        match self {
            Self::Typed(_, inner) if inner.len() == 1 => &inner[0],
            _ => self,
        }
    }

    pub(super) fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self.bare() { Some(text) } else { None }
    }

    pub(super) fn number(&self) -> Option<f64> {
        if let Self::Number(number) = self.bare() { Some(*number) } else { None }
    }

    pub(super) fn reference(&self) -> Option<u64> {
        if let Self::Reference(id) = self { Some(*id) } else { None }
    }

    pub(super) fn word(&self) -> Option<&str> {
        if let Self::Word(word) = self.bare() { Some(word) } else { None }
    }
}

/// The capital keyword and the values of `KEYWORD(...)`.
///
/// # Errors
/// The byte within the text, and the fact.
pub(super) fn parse_arguments(text: &str) -> Result<(String, Vec<Value>), (usize, String)> {
    let mut parser = Parser { text, at: 0 };
    let keyword = parser.keyword().to_ascii_uppercase();
    if keyword.is_empty() {
        return Err((0, "instances of several types at once are not read".to_owned()));
    }
    let values = parser.list(0)?;
    parser.blank();
    match parser.peek() {
        None => Ok((keyword, values)),
        Some(_) => Err(parser.refuse("nothing may follow the last bracket")),
    }
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
}

type Parsed<T> = Result<T, (usize, String)>;

impl Parser<'_> {
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn refuse(&self, message: &str) -> (usize, String) {
        (self.at, format!("\"{}\": {message}", shown(self.rest())))
    }

    fn blank(&mut self) {
        loop {
            if self.rest().starts_with("/*") {
                self.at = self.rest().find("*/").map_or(self.text.len(), |end| self.at + end + 2);
            } else if self.peek().is_some_and(|byte| byte.is_ascii_whitespace()) {
                self.at += 1;
            } else {
                return;
            }
        }
    }

    fn take(&mut self, length: usize) -> String {
        let taken = self.rest().get(..length).unwrap_or_default().to_owned();
        self.at += taken.len();
        taken
    }

    fn take_while(&mut self, belongs: impl Fn(u8) -> bool) -> String {
        let length = self.rest().bytes().take_while(|byte| byte.is_ascii() && belongs(*byte)).count();
        self.take(length)
    }

    fn keyword(&mut self) -> String {
        self.blank();
        self.take_while(|byte| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'!')
    }

    fn list(&mut self, depth: usize) -> Parsed<Vec<Value>> {
        self.blank();
        if self.peek() != Some(b'(') {
            return Err(self.refuse("a bracket ( is missing"));
        }
        if depth > DEEPEST {
            return Err(self.refuse("lists are nested too deep"));
        }
        self.at += 1;
        let mut values = Vec::new();
        self.blank();
        if self.peek() == Some(b')') {
            self.at += 1;
            return Ok(values);
        }
        loop {
            values.push(self.value(depth)?);
            self.blank();
            match self.peek() {
                Some(b',') => self.at += 1,
                Some(b')') => {
                    self.at += 1;
                    return Ok(values);
                }
                _ => return Err(self.refuse("a comma or a bracket ) is missing")),
            }
        }
    }

    fn value(&mut self, depth: usize) -> Parsed<Value> {
        self.blank();
        match self.peek() {
            Some(b'$' | b'*') => {
                self.at += 1;
                Ok(Value::Missing)
            }
            Some(b'#') => self.reference(),
            Some(b'\'') => self.string(),
            Some(b'"') => self.binary(),
            Some(b'.') => self.word(),
            Some(b'(') => self.list(depth + 1).map(Value::List),
            Some(byte) if byte.is_ascii_alphabetic() || byte == b'!' => {
                let name = self.keyword().to_ascii_uppercase();
                self.list(depth + 1).map(|inner| Value::Typed(name, inner))
            }
            _ => self.number(),
        }
    }

    fn reference(&mut self) -> Parsed<Value> {
        let start = self.at;
        self.at += 1;
        let digits = self.take_while(|byte| byte.is_ascii_digit());
        digits.parse().map(Value::Reference).map_err(|_| (start, format!("\"#{digits}\" is no instance")))
    }

    fn string(&mut self) -> Parsed<Value> {
        let start = self.at;
        self.at += 1;
        let mut length = 0;
        let bytes = self.rest().as_bytes();
        loop {
            let Some(quote) = memchr::memchr(b'\'', &bytes[length..]) else {
                return Err((start, "a text has no end".to_owned()));
            };
            length += quote;
            if bytes.get(length + 1) != Some(&b'\'') {
                break;
            }
            length += 2;
        }
        let raw = self.take(length);
        self.at += 1;
        Ok(Value::Text(decode(&raw)))
    }

    fn binary(&mut self) -> Parsed<Value> {
        let start = self.at;
        self.at += 1;
        self.take_while(|byte| byte.is_ascii_hexdigit());
        if self.peek() != Some(b'"') {
            return Err((start, "bits have no end".to_owned()));
        }
        self.at += 1;
        Ok(Value::Binary)
    }

    fn word(&mut self) -> Parsed<Value> {
        let start = self.at;
        self.at += 1;
        let word = self.take_while(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
        if self.peek() != Some(b'.') || word.is_empty() {
            // ".5" is no number of the standard, but written.
            self.at = start;
            return self.number();
        }
        self.at += 1;
        Ok(Value::Word(word.to_ascii_uppercase()))
    }

    fn number(&mut self) -> Parsed<Value> {
        let start = self.at;
        let digits =
            self.take_while(|byte| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'e' | b'E'));
        match digits.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Value::Number(number)),
            Ok(_) => Err((start, format!("\"{}\" is no finite number", shown(&digits)))),
            Err(_) => {
                self.at = start;
                Err(self.refuse("a value is missing"))
            }
        }
    }
}

/// The beginning of a text, for messages.
pub(super) fn shown(text: &str) -> String {
    const MOST: usize = 40;
    let mut shown: String = text.chars().take(MOST).collect();
    if shown.len() < text.len() {
        shown.push('…');
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_all_kinds() {
        let (keyword, values) =
            parse_arguments("IfcThing ( #12 , $,*,'it''s',.T.,(1.,-2.5E-1,7),IFCLABEL('x'),\"0F\", ())")
                .unwrap();
        assert_eq!(keyword, "IFCTHING");
        let numbers = [1.0, -0.25, 7.0].map(Value::Number).to_vec();
        let expected = vec![
            Value::Reference(12),
            Value::Missing,
            Value::Missing,
            Value::Text("it's".to_owned()),
            Value::Word("T".to_owned()),
            Value::List(numbers),
            Value::Typed("IFCLABEL".to_owned(), vec![Value::Text("x".to_owned())]),
            Value::Binary,
            Value::List(Vec::new()),
        ];
        assert_eq!(values, expected);
        assert_eq!(values[6].text(), Some("x"));
    }

    #[test]
    fn broken_values_are_refused_with_their_place() {
        let cases = [
            ("A(1,", 4, "a value is missing"),
            ("A(1 2)", 4, "a comma or a bracket ) is missing"),
            ("A(1e999)", 2, "no finite number"),
            ("A(#)", 2, "no instance"),
            ("A('x)", 2, "a text has no end"),
            ("A(1)2", 4, "nothing may follow"),
            ("A", 1, "a bracket ( is missing"),
            ("(A())", 0, "several types"),
            ("A(ä)", 2, "a value is missing"),
        ];
        for (text, at, message) in cases {
            let (found_at, found) = parse_arguments(text).unwrap_err();
            assert!(found.contains(message), "{text}: {found}");
            assert_eq!(found_at, at, "{text}");
        }
        assert!(parse_arguments(&format!("A{}", "(".repeat(100_000))).unwrap_err().1.contains("too deep"));
    }
}
