//! Splits the exchange file (ISO 10303-21) into statements, and finds the place of each instance.
//!
//! This is own code, because no crate fits: `ruststep` and `step-p21` (Apache-2.0) reject a whole file at its first fault
//! and keep all of it in memory, and `openbim-step` and `ifc-lite` have licences that do not go with this project's.
//!
//! The text is read once. An instance is parsed only when it is asked for, so that shapes and properties, most of a file,
//! cost no time.

use std::collections::BTreeMap;
use std::ops::Range;

use super::value::{Value, parse_arguments, shown};

/// Digits of the largest instance number.
const NUMBER_DIGITS: usize = 19;

/// Something wrong with the text at a byte.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Flaw {
    pub(super) at: usize,
    pub(super) message: String,
    pub(super) hint: Option<&'static str>,
}

/// An instance: `#12=IFCWALL(...)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Record {
    pub(super) id: u64,
    /// Byte of its `#`.
    pub(super) start: usize,
    /// Bytes from its keyword to before the semicolon.
    pub(super) body: Range<usize>,
}

/// The content of a file.
#[derive(Debug, Default)]
pub(super) struct Exchange {
    /// Sorted by id; of two with one id the first.
    pub(super) records: Vec<Record>,
    /// Capital keyword → ids, ascending.
    pub(super) kinds: BTreeMap<String, Vec<u64>>,
    /// Capital names of the schemas, as `IFC2X3`.
    pub(super) schemas: Vec<String>,
    pub(super) flaws: Vec<Flaw>,
}

/// One statement, without its semicolon.
struct Statement {
    range: Range<usize>,
    /// Where the next one may begin.
    next: usize,
    flaw: Option<&'static str>,
}

impl Exchange {
    /// Goes through a text once; what is no statement is left out and noted.
    pub(super) fn scan(text: &str) -> Self {
        let mut exchange = Self::default();
        let mut is_whole = false;
        let mut at = 0;
        while let Some(statement) = next_statement(text.as_bytes(), at) {
            at = statement.next;
            let words = &text[statement.range.clone()];
            if let Some(flaw) = statement.flaw {
                exchange.flaw(statement.range.start, flaw.to_owned());
            } else if words.starts_with('#') {
                exchange.instance(text, statement.range);
            } else if starts_with(words, "FILE_SCHEMA") {
                exchange.schema(words, statement.range.start);
            } else {
                is_whole |= starts_with(words, "END-ISO-10303-21");
            }
        }
        if !is_whole {
            let message = "the file ends without END-ISO-10303-21".to_owned();
            exchange.flaws.push(Flaw { at: text.len(), message, hint: Some("was it copied whole?") });
        }
        exchange.sort();
        exchange
    }

    fn flaw(&mut self, at: usize, message: String) {
        self.flaws.push(Flaw { at, message, hint: Some("it was left out") });
    }

    fn instance(&mut self, text: &str, range: Range<usize>) {
        let words = &text[range.clone()];
        let Some((number, rest)) = words[1..].split_once('=') else {
            return self.flaw(range.start, format!("\"{}\" is no instance", shown(words)));
        };
        let number = number.trim();
        let Some(id) = number.parse().ok().filter(|_| number.len() <= NUMBER_DIGITS) else {
            return self.flaw(range.start, format!("\"#{}\" is no number of an instance", shown(number)));
        };
        let body = &text[skip_blank(text.as_bytes(), range.end - rest.len()).min(range.end)..range.end];
        let keyword: String = body.chars().take_while(|letter| is_keyword(*letter)).collect();
        self.kinds.entry(keyword.to_ascii_uppercase()).or_default().push(id);
        self.records.push(Record { id, start: range.start, body: range.end - body.len()..range.end });
    }

    fn schema(&mut self, words: &str, at: usize) {
        match parse_arguments(words) {
            Ok((_, arguments)) => {
                let names = arguments.iter().flat_map(Value::items);
                self.schemas.extend(names.filter_map(Value::text).map(str::to_ascii_uppercase));
            }
            Err((_, message)) => self.flaw(at, message),
        }
    }

    fn sort(&mut self) {
        self.records.sort_by_key(|record| (record.id, record.start));
        let repeated = self.records.windows(2).filter(|pair| pair[0].id == pair[1].id);
        let flaws: Vec<(usize, String)> = repeated
            .map(|pair| (pair[1].start, format!("#{} is there twice: the first counts", pair[1].id)))
            .collect();
        flaws.into_iter().for_each(|(at, message)| self.flaw(at, message));
        self.records.dedup_by_key(|record| record.id);
        for ids in self.kinds.values_mut() {
            ids.sort_unstable();
            ids.dedup();
        }
    }

    /// Where an instance stands.
    pub(super) fn record(&self, id: u64) -> Option<&Record> {
        let index = self.records.binary_search_by_key(&id, |record| record.id).ok()?;
        self.records.get(index)
    }
}

/// Letters of a keyword; `!` begins those of users.
fn is_keyword(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_' || letter == '!'
}

fn starts_with(text: &str, word: &str) -> bool {
    text.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word))
}

/// The next statement from a byte on; `None` behind the last.
fn next_statement(text: &[u8], from: usize) -> Option<Statement> {
    let start = skip_blank(text, from);
    if start >= text.len() {
        return None;
    }
    let mut at = start;
    let mut is_text = false;
    while at < text.len() {
        match text[at] {
            b'\'' => is_text = !is_text,
            b';' if !is_text => {
                return Some(Statement { range: start..at, next: at + 1, flaw: None });
            }
            b'/' if !is_text && text.get(at + 1) == Some(&b'*') => {
                at = end_of_comment(text, at);
                continue;
            }
            // No text and no statement goes on with the next instance: its end is missing.
            b'\n' if begins_statement(text, at + 1) => {
                let flaw = if is_text { "a text has no end" } else { "there is no semicolon at the end" };
                return Some(Statement { range: start..at, next: at + 1, flaw: Some(flaw) });
            }
            _ => {}
        }
        at += 1;
    }
    let flaw = Some("the file ends in the middle of it");
    Some(Statement { range: start..text.len(), next: text.len(), flaw })
}

fn skip_blank(text: &[u8], mut at: usize) -> usize {
    loop {
        match text.get(at) {
            Some(byte) if byte.is_ascii_whitespace() || *byte == 0 => at += 1,
            Some(b'/') if text.get(at + 1) == Some(&b'*') => at = end_of_comment(text, at),
            _ => return at,
        }
    }
}

/// The byte behind a comment that begins at a byte.
fn end_of_comment(text: &[u8], start: usize) -> usize {
    memchr::memmem::find(&text[start + 2..], b"*/").map_or(text.len(), |end| start + 2 + end + 2)
}

/// Whether a line begins with an instance or ends a section.
fn begins_statement(text: &[u8], start: usize) -> bool {
    let line = &text[start..];
    if line.starts_with(b"ENDSEC;") || line.starts_with(b"END-ISO-10303-21") {
        return true;
    }
    let Some(number) = line.strip_prefix(b"#") else { return false };
    let digits = number.iter().take(NUMBER_DIGITS + 1).take_while(|byte| byte.is_ascii_digit()).count();
    let behind = number[digits..].iter().find(|byte| **byte != b' ');
    digits > 0 && behind == Some(&b'=')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(data: &str) -> Exchange {
        Exchange::scan(&format!(
            "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n{data}\nENDSEC;\nEND-ISO-10303-21;\n"
        ))
    }

    fn ids(exchange: &Exchange) -> Vec<u64> {
        exchange.records.iter().map(|record| record.id).collect()
    }

    #[test]
    fn instances_are_found_in_any_order_and_layout() {
        let text = "#7 = IfcWall('a;b''c', $) ;\n/* #8=X(); */ #2= /* a; */\n  IFCDOOR(\n #7);#3=(A()B());";
        let exchange = scan(text);
        assert_eq!(ids(&exchange), [2, 3, 7]);
        assert_eq!(exchange.schemas, ["IFC4"]);
        assert_eq!((&exchange.kinds["IFCWALL"], &exchange.kinds["IFCDOOR"]), (&vec![7], &vec![2]));
        assert!(exchange.flaws.is_empty(), "{:?}", exchange.flaws);
    }

    #[test]
    fn only_a_statement_without_its_end_is_left_out() {
        let exchange = scan("#1=A('open);\n#2=B();\n#3=C(\n#4=D();\n#5=E(");
        assert_eq!(ids(&exchange), [2, 4]);
        let messages: Vec<&str> = exchange.flaws.iter().map(|flaw| flaw.message.as_str()).collect();
        let semicolon = "there is no semicolon at the end";
        assert_eq!(messages, ["a text has no end", semicolon, semicolon]);
    }

    #[test]
    fn repeated_and_impossible_numbers_are_flaws() {
        let exchange = scan("#1=A();\n#1=B();\n#=C();\n#99999999999999999999999=D();\n#x=E();");
        assert_eq!(ids(&exchange), [1]);
        assert_eq!(exchange.flaws.len(), 4);
        assert_eq!(exchange.record(1).map(|record| record.body.len()), Some(3));
    }

    #[test]
    fn a_truncated_file_is_reported() {
        for text in ["", "ISO-10303-21;", "ISO-10303-21;DATA;#1=A('", "/* no end", "'", "#"] {
            assert!(!Exchange::scan(text).flaws.is_empty(), "{text}");
        }
    }
}
