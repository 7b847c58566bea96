//! Finds all faults of a document that is not of its type, with the JSON Schema of the type.

use serde_json::Value;

use super::choice::{Choice, condense};
use super::fault::{Fault, FaultSeverity, PathStep};
use super::faults::Faults;
use super::format::{Format, Refusal};
use super::limits::FAULT_LIMIT;
use super::node::{Content, Node, Spelling};
use super::schema::{JsonType, SchemaFault, SchemaProblem, schema_faults};
use super::source::Source;
use super::suggest::did_you_mean;

/// How people write the units that files may name, the file's word first.
const UNITS: [&[&str]; 5] = [
    &["m", "metre", "metres", "meter", "meters"],
    &["cm", "centimetre", "centimetres", "centimeter", "centimeters"],
    &["mm", "millimetre", "millimetres", "millimeter", "millimeters"],
    &["ft", "foot", "feet"],
    &["in", "inch", "inches"],
];

/// Everything that is wrong with the text, with places; at least one fault.
///
/// Order: by place. Faults of syntax stand alone, for what follows them is guesswork.
pub(super) fn diagnose(source: &Source, refusal: &Refusal, schema: &dyn Fn() -> Value) -> Faults {
    let is_json = Format::of(source.file()) == Format::Json;
    let tree = match source.tree() {
        Ok(tree) if !(is_json && refusal.is_syntax) => tree,
        Err(flaw) if !is_json => return source.fault_of_flaw(flaw).into(),
        _ => return fault_of_refusal(source, refusal).into(),
    };
    let mut faults = source.flaws();
    faults.merge(departures(source, &tree.root, &schema()));
    if faults.is_empty() {
        faults.push(fault_of_refusal(source, refusal));
    }
    faults.sort();
    shorten(&mut faults, source);
    faults
}

fn departures(source: &Source, root: &Node, schema: &Value) -> Faults {
    let mut diagnosis = Diagnosis { source, root, schema, faults: Faults::default() };
    for fault in &schema_faults(schema, &root.to_value()) {
        diagnosis.take(fault);
    }
    diagnosis.faults
}

fn fault_of_refusal(source: &Source, refusal: &Refusal) -> Fault {
    let fault = source.fault_at(refusal.position, refusal.message.as_str());
    match (refusal.is_cut_off, refusal.is_syntax) {
        (true, _) => fault.with_hint("the file ends here: is it complete?"),
        (false, true) => fault.with_hint("this is no valid JSON from here on"),
        (false, false) => fault,
    }
}

fn shorten(faults: &mut Faults, source: &Source) {
    let more = faults.0.len().saturating_sub(FAULT_LIMIT);
    if more > 0 {
        faults.0.truncate(FAULT_LIMIT);
        faults.push(Fault::of_file(source.file(), format!("and {more} more faults")));
    }
}

struct Diagnosis<'a> {
    source: &'a Source,
    root: &'a Node,
    schema: &'a Value,
    faults: Faults,
}

impl Diagnosis<'_> {
    fn take(&mut self, fault: &SchemaFault) {
        let path = &fault.path;
        match &fault.problem {
            SchemaProblem::UnknownKey { key, known } => {
                let hint = did_you_mean(key, known);
                let path = [path.as_slice(), &[key.as_str().into()]].concat();
                self.faults.push(self.source.fault_of_key(&path, format!("unknown key \"{key}\""), hint));
            }
            SchemaProblem::MissingKey(key) => {
                let is_version = key == "version" && path.is_empty();
                let hint = is_version.then(|| "begin the file with `version: 1`".to_owned());
                self.add(path, format!("key \"{key}\" is missing"), hint);
            }
            SchemaProblem::Type(types) => self.wrong_type(path, types),
            SchemaProblem::Words { options, .. } => self.unknown_word(path, options),
            SchemaProblem::Bound(message) => self.add(path, message.clone(), None),
            SchemaProblem::Alternatives(branches) => match condense(branches, path) {
                Choice::Types(types) => self.wrong_type(path, &types),
                Choice::Words(options) => self.unknown_word(path, &options),
                Choice::Nearest(faults) => faults.into_iter().for_each(|fault| self.take(fault)),
            },
        }
    }

    fn wrong_type(&mut self, path: &[PathStep], expected: &[JsonType]) {
        let Some(node) = self.root.find(path) else { return };
        let found = match &node.content {
            // YAML lets an unquoted number stand where a text is asked for, and so does serde.
            Content::Scalar { value, spelling: Spelling::Word(_) }
                if expected.contains(&JsonType::String) && !value.is_null() && self.is_yaml() =>
            {
                return;
            }
            Content::Scalar { value: Value::Null, .. } => "nothing".to_owned(),
            Content::Scalar { value: Value::String(text), .. } => format!("text \"{text}\""),
            Content::Scalar { value, .. } => value.to_string(),
            Content::Sequence(_) => "a list".to_owned(),
            Content::Mapping(_) => "a mapping of keys".to_owned(),
        };
        let is_asked = |kind: &&JsonType| **kind != JsonType::Null || expected.len() == 1;
        let names: Vec<&str> = expected.iter().filter(is_asked).map(|kind| type_name(*kind)).collect();
        let is_measure = expected.iter().any(|kind| matches!(kind, JsonType::Number | JsonType::Integer));
        let hint = match &node.content {
            Content::Scalar { value: Value::String(text), .. } if is_measure => self.measure_hint(text),
            Content::Mapping(_) if *expected == [JsonType::Array] && self.is_yaml() => {
                Some("write the items of a list one below the other, each behind `- `".to_owned())
            }
            _ => None,
        };
        self.add(path, format!("expected {}, found {found}", names.join(" or ")), hint);
    }

    /// Advice for a text that begins with a number: `14ft`, `3,5`, `8' 2"`.
    fn measure_hint(&self, text: &str) -> Option<String> {
        let is_digit = |letter: char| letter.is_ascii_digit() || matches!(letter, '.' | ',');
        let (number, rest) =
            text.trim().split_at(text.trim().find(|c| !is_digit(c)).unwrap_or(text.trim().len()));
        let number = number.trim_end_matches(['.', ',']).replace(',', ".");
        if !number.starts_with(|letter: char| letter.is_ascii_digit()) {
            return None;
        }
        if rest.contains(['\'', '"']) {
            return Some("write feet and inches as one number: 8' 2\" is 8.167 feet".to_owned());
        }
        let asks_unit = self.schema.pointer("/properties/units").is_some();
        let unit = UNITS.iter().find(|names| names.contains(&rest.trim().to_lowercase().as_str()));
        Some(match unit {
            Some(names) if asks_unit => {
                format!(
                    "write {number} alone; `units: {}` says what all lengths of the file are in",
                    names[0]
                )
            }
            _ if rest.is_empty() => format!("write {number} without quotes"),
            _ => format!("write {number} alone, without a unit"),
        })
    }

    fn unknown_word(&mut self, path: &[PathStep], options: &[Value]) {
        let Some(node) = self.root.find(path) else { return };
        let candidates: Vec<String> = options.iter().map(plain_text).collect();
        let found = node.to_value();
        if found.is_array() || found.is_object() || found.is_null() {
            self.wrong_type(path, &[JsonType::String]);
            return;
        }
        let (word, listed) = (plain_text(&found), candidates.join(", "));
        let one_only = candidates.len() == 1;
        let lower = word.to_lowercase();
        let unit = UNITS.iter().find(|names| names.contains(&lower.as_str())).map(|names| names[0]);
        let unit = unit.filter(|unit| candidates.iter().any(|known| known == unit));
        let hint = match unit {
            Some(unit) => Some(format!("did you mean \"{unit}\"?")),
            None if one_only => Some(format!("it must be {listed}")),
            None => did_you_mean(&word, &candidates),
        };
        self.add(path, format!("unknown value {found}"), hint);
    }

    fn add(&mut self, path: &[PathStep], message: String, hint: Option<String>) {
        self.faults.push(self.source.fault(path, message, hint, FaultSeverity::Error));
    }

    fn is_yaml(&self) -> bool {
        Format::of(self.source.file()) == Format::Yaml
    }
}

fn plain_text(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

fn type_name(kind: JsonType) -> &'static str {
    match kind {
        JsonType::Array => "a list",
        JsonType::Boolean => "true or false",
        JsonType::Integer => "a whole number",
        JsonType::Null => "nothing",
        JsonType::Number => "a number",
        JsonType::Object => "a mapping of keys",
        JsonType::String => "a text",
    }
}
