//! Finds instances by number, parses them on demand, and collects their faults.

use std::cell::{Cell, RefCell};

use super::step::Exchange;
use super::value::{Value, parse_arguments};
use crate::document::{Fault, FaultSeverity, Faults, Source};

/// Faults beyond these are counted only: a file may be broken in every line.
const MOST_FAULTS: usize = 500;
/// Letters of a line on each side of a fault that are looked at; more than are shown.
const SHOWN: usize = 300;
/// A file whose instances refer to each other is looked through this many times over, and this many bytes at least:
/// some share what a few lines say, and hostile ones make nothing else.
const READINGS: u64 = 64;
const LEAST_BYTES: u64 = 16 << 20;

/// A file's instances.
#[derive(Debug)]
pub(super) struct Model {
    pub(super) source: Source,
    pub(super) exchange: Exchange,
    /// Bytes that may still be looked into.
    budget: Cell<u64>,
    noted: RefCell<Vec<Noted>>,
}

/// A fault whose line is worked out at the end, for all at once.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Noted {
    at: usize,
    message: String,
    hint: Option<String>,
    severity: FaultSeverity,
}

/// Why an instance is of no use.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Trouble {
    /// The instance to look at.
    pub(super) id: u64,
    pub(super) message: String,
}

/// The value of an instance, or its fault.
pub(super) type Read<T> = Result<T, Trouble>;

/// An instance and its values.
#[derive(Clone, Debug)]
pub(super) struct Entity {
    pub(super) id: u64,
    /// In capitals.
    pub(super) kind: String,
    pub(super) values: Vec<Value>,
}

impl Model {
    pub(super) fn new(source: Source) -> Self {
        let exchange = Exchange::scan(source.text());
        let budget = (source.text().len() as u64).saturating_mul(READINGS).max(LEAST_BYTES);
        let model = Self { source, exchange, budget: Cell::new(budget), noted: RefCell::default() };
        for flaw in &model.exchange.flaws {
            let hint = flaw.hint.map(str::to_owned);
            model.note_at(flaw.at, flaw.message.clone(), hint, FaultSeverity::Error);
        }
        model
    }

    /// Looks into an instance.
    pub(super) fn get(&self, id: u64) -> Read<Entity> {
        let Some(record) = self.exchange.record(id) else {
            return Err(Trouble { id, message: format!("#{id} is not in the file") });
        };
        let trouble = |message: String| Trouble { id, message };
        let body = &self.source.text()[record.body.clone()];
        let Some(left) = self.budget.get().checked_sub(body.len() as u64) else {
            return Err(trouble(format!("#{id} is referred to too often: the file turns in circles")));
        };
        self.budget.set(left);
        match parse_arguments(body) {
            Ok((kind, values)) => Ok(Entity { id, kind, values }),
            Err((_, message)) => Err(trouble(format!("#{id}: {message}"))),
        }
    }

    /// Takes work that is more than looking off the budget, as bytes; whether there was enough.
    pub(super) fn charge(&self, bytes: usize) -> bool {
        let left = self.budget.get().checked_sub(bytes as u64);
        self.budget.set(left.unwrap_or(0));
        left.is_some()
    }

    /// The numbers of all instances of some kinds, ascending by kind.
    pub(super) fn ids<'a>(&'a self, kinds: &'a [&'a str]) -> impl Iterator<Item = u64> + 'a {
        kinds.iter().filter_map(|kind| self.exchange.kinds.get(*kind)).flatten().copied()
    }

    /// Whether an instance is of one of some kinds.
    pub(super) fn is(&self, id: u64, kinds: &[&str]) -> bool {
        let of =
            |kind: &&str| self.exchange.kinds.get(*kind).is_some_and(|ids| ids.binary_search(&id).is_ok());
        kinds.iter().any(of)
    }

    /// All sound instances of some kinds; the others are noted.
    pub(super) fn all<'a>(&'a self, kinds: &'a [&'a str]) -> impl Iterator<Item = Entity> + 'a {
        self.ids(kinds).filter_map(|id| self.sound(self.get(id)))
    }

    /// The value, or a note of the reason for which it was left out.
    pub(super) fn sound<T>(&self, read: Read<T>) -> Option<T> {
        match read {
            Ok(value) => Some(value),
            Err(trouble) => {
                self.error(&trouble, "", "it was left out");
                None
            }
        }
    }

    /// Notes an error; `what` says what suffers from it.
    pub(super) fn error(&self, trouble: &Trouble, what: &str, hint: &str) {
        let message = format!("{what}{}", trouble.message);
        self.note_at(self.place(trouble.id), message, Some(hint.to_owned()), FaultSeverity::Error);
    }

    /// Notes a warning about an instance.
    pub(super) fn warn(&self, id: u64, message: String, hint: &str) {
        self.note_at(self.place(id), message, Some(hint.to_owned()), FaultSeverity::Warning);
    }

    fn place(&self, id: u64) -> usize {
        self.exchange.record(id).map_or(0, |record| record.start)
    }

    fn note_at(&self, at: usize, message: String, hint: Option<String>, severity: FaultSeverity) {
        self.noted.borrow_mut().push(Noted { at, message, hint, severity });
    }

    /// All that was noted, with lines. The text is gone through once.
    pub(super) fn faults(&self) -> Faults {
        let mut noted = self.noted.take();
        noted.sort();
        noted.dedup();
        let left_out = noted.len().saturating_sub(MOST_FAULTS);
        noted.truncate(MOST_FAULTS);
        let text = self.source.text();
        let end = text.trim_end().len();
        let mut faults = Faults::default();
        let (mut line, mut column, mut last) = (1, 1, 0);
        for Noted { at, message, hint, severity } in noted {
            let at = at.min(end).max(last);
            let between = &text[last..at];
            line += memchr::memchr_iter(b'\n', between.as_bytes()).count();
            column = match memchr::memrchr(b'\n', between.as_bytes()) {
                Some(newline) => between[newline + 1..].chars().count() + 1,
                None => column + between.chars().count(),
            };
            last = at;
            let fault = Fault { severity, ..self.fault_at((line, column), at, message) };
            faults.push(fault.with_some_hint(hint));
        }
        if left_out > 0 {
            let message = format!("{left_out} more faults are not listed");
            faults.push(Fault::of_file(self.source.file(), message).as_warning());
        }
        faults
    }

    /// A fault with the part of its line around it: some files are a single line.
    fn fault_at(&self, position: (usize, usize), at: usize, message: String) -> Fault {
        let text = self.source.text();
        let near = at.saturating_sub(SHOWN * char::MAX.len_utf8());
        let near = (near..at).find(|byte| text.is_char_boundary(*byte)).unwrap_or(at);
        let (before, behind) = (&text[near..at], &text[at..]);
        let before = &before[memchr::memrchr(b'\n', before.as_bytes()).map_or(0, |newline| newline + 1)..];
        let start = before.char_indices().rev().take(SHOWN).last().map_or(before.len(), |(start, _)| start);
        let behind = behind.chars().take(SHOWN).take_while(|letter| !matches!(letter, '\n' | '\r'));
        let line: String = before[start..].chars().chain(behind).collect();
        let column = before[start..].chars().count() + 1;
        let alone = Source::new(self.source.file(), &line).fault_at(Some((1, column)), message);
        Fault { position: Some(position), ..alone }
    }
}

impl Entity {
    /// A fault of this instance.
    pub(super) fn trouble(&self, message: impl std::fmt::Display) -> Trouble {
        Trouble { id: self.id, message: format!("#{} {}: {message}", self.id, self.kind) }
    }

    /// The value at a place from 0; `$` where the instance has fewer.
    pub(super) fn value(&self, place: usize) -> &Value {
        self.values.get(place).unwrap_or(&Value::Missing)
    }

    fn lacks(&self, place: usize, what: &str) -> Trouble {
        self.trouble(format!("value {} is no {what}", place + 1))
    }

    /// A number that must be there.
    pub(super) fn number(&self, place: usize) -> Read<f64> {
        self.value(place).number().ok_or_else(|| self.lacks(place, "number"))
    }

    /// A number above zero.
    pub(super) fn positive(&self, place: usize) -> Read<f64> {
        let number = self.number(place)?;
        if number > 0.0 { Ok(number) } else { Err(self.lacks(place, "number above zero")) }
    }

    /// A reference that must be there.
    pub(super) fn reference(&self, place: usize) -> Read<u64> {
        self.value(place).reference().ok_or_else(|| self.lacks(place, "reference"))
    }

    /// References in a list; a single one counts as a list of one.
    pub(super) fn references(&self, place: usize) -> Read<Vec<u64>> {
        if let Some(id) = self.value(place).reference() {
            return Ok(vec![id]);
        }
        let ids: Option<Vec<u64>> = self.value(place).items().iter().map(Value::reference).collect();
        ids.filter(|ids| !ids.is_empty()).ok_or_else(|| self.lacks(place, "list of references"))
    }

    /// A text that says something.
    pub(super) fn text(&self, place: usize) -> Option<&str> {
        self.value(place).text().map(str::trim).filter(|text| !text.is_empty())
    }

    /// Whether the instance is of one of some kinds.
    pub(super) fn is(&self, kinds: &[&str]) -> bool {
        kinds.contains(&self.kind.as_str())
    }
}
