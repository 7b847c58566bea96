//! Where a value departs from a JSON Schema: all faults at once.
//!
//! Knows the keywords of schemas that schemars derives from the types that are read here (a test compares it with a complete
//! validator). The complete validators bring some sixty crates, a quarter of the time of a build from nothing, and report in a
//! form that had to be translated back into these faults.

use serde_json::{Map, Value};

use super::fault::PathStep;

/// A departure from a schema.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SchemaFault {
    /// The value, from the root of the document.
    pub(super) path: Vec<PathStep>,
    /// Its problem.
    pub(super) problem: SchemaProblem,
}

/// The problem of a value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum SchemaProblem {
    /// A mapping has a key that the schema does not know.
    UnknownKey {
        /// The key.
        key: String,
        /// Those that the schema knows.
        known: Vec<String>,
    },
    /// A mapping lacks a key.
    MissingKey(String),
    /// The value is of none of these types.
    Type(Vec<JsonType>),
    /// The value is none of these words.
    Words {
        /// Those that would do.
        options: Vec<Value>,
        /// Whether it is a text at all.
        is_text: bool,
    },
    /// The value breaks a bound; says which.
    Bound(String),
    /// The value fits none of several alternatives: the faults of each.
    Alternatives(Vec<Vec<SchemaFault>>),
}

/// The types of JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum JsonType {
    Array,
    Boolean,
    Integer,
    Null,
    Number,
    Object,
    String,
}

impl JsonType {
    fn named(word: &str) -> Option<Self> {
        Some(match word {
            "array" => Self::Array,
            "boolean" => Self::Boolean,
            "integer" => Self::Integer,
            "null" => Self::Null,
            "number" => Self::Number,
            "object" => Self::Object,
            "string" => Self::String,
            _ => return None,
        })
    }

    fn is_type_of(self, value: &Value) -> bool {
        match self {
            Self::Array => value.is_array(),
            Self::Boolean => value.is_boolean(),
            Self::Integer => value.as_f64().is_some_and(|number| number.fract() == 0.0),
            Self::Null => value.is_null(),
            Self::Number => value.is_number(),
            Self::Object => value.is_object(),
            Self::String => value.is_string(),
        }
    }
}

/// All departures of a value from a schema; none where it obeys.
pub(super) fn schema_faults(schema: &Value, value: &Value) -> Vec<SchemaFault> {
    let mut check = Check { root: schema, path: Vec::new(), faults: Vec::new() };
    check.value(schema, value);
    check.faults
}

/// A walk through schema and value.
struct Check<'s> {
    /// References of the schema start here.
    root: &'s Value,
    /// The value that is looked at.
    path: Vec<PathStep>,
    faults: Vec<SchemaFault>,
}

impl<'s> Check<'s> {
    fn value(&mut self, schema: &'s Value, value: &Value) {
        if *schema == Value::Bool(false) {
            return self.fault(SchemaProblem::Bound("nothing may stand here".to_owned()));
        }
        if let Some(target) = referenced(self.root, schema) {
            self.value(target, value);
        }
        self.types(schema, value);
        self.words(schema, value);
        self.alternatives(schema, value);
        match value {
            Value::Object(keys) => self.object(schema, keys),
            Value::Array(items) => self.array(schema, items),
            Value::Number(_) => self.number(schema, value),
            _ => {}
        }
    }

    fn types(&mut self, schema: &Value, value: &Value) {
        let mut types: Vec<JsonType> = match schema.get("type") {
            Some(Value::String(word)) => JsonType::named(word).into_iter().collect(),
            Some(Value::Array(words)) => {
                words.iter().filter_map(Value::as_str).filter_map(JsonType::named).collect()
            }
            _ => return,
        };
        if !types.iter().any(|kind| kind.is_type_of(value)) {
            types.sort_unstable();
            self.fault(SchemaProblem::Type(types));
        }
    }

    fn words(&mut self, schema: &Value, value: &Value) {
        let options = match (schema.get("enum"), schema.get("const")) {
            (Some(Value::Array(options)), _) => options.clone(),
            (_, Some(only)) => vec![only.clone()],
            _ => return,
        };
        if !options.contains(value) {
            self.fault(SchemaProblem::Words { options, is_text: value.is_string() });
        }
    }

    /// One alternative that fits is enough: serde takes the first.
    fn alternatives(&mut self, schema: &'s Value, value: &Value) {
        for part in schemas_of(schema, "allOf") {
            self.value(part, value);
        }
        for keyword in ["anyOf", "oneOf"] {
            let mut branches = Vec::new();
            for part in schemas_of(schema, keyword) {
                let mut branch = Check { root: self.root, path: self.path.clone(), faults: Vec::new() };
                branch.value(part, value);
                branches.push(branch.faults);
            }
            if !branches.is_empty() && branches.iter().all(|faults| !faults.is_empty()) {
                self.fault(SchemaProblem::Alternatives(branches));
            }
        }
    }

    fn object(&mut self, schema: &'s Value, keys: &Map<String, Value>) {
        for required in schema.get("required").and_then(Value::as_array).into_iter().flatten() {
            if let Some(key) = required.as_str().filter(|key| !keys.contains_key(*key)) {
                self.fault(SchemaProblem::MissingKey(key.to_owned()));
            }
        }
        let properties = schema.get("properties").and_then(Value::as_object);
        for (key, value) in keys {
            let own = properties.and_then(|properties| properties.get(key));
            match (own, schema.get("additionalProperties")) {
                (None, Some(Value::Bool(false))) => {
                    let mut known = Vec::new();
                    collect_keys(self.root, schema, &mut known);
                    self.fault(SchemaProblem::UnknownKey { key: key.clone(), known });
                }
                (Some(part), _) | (None, Some(part)) => self.below(key.as_str().into(), part, value),
                (None, None) => {}
            }
        }
    }

    fn array(&mut self, schema: &'s Value, items: &[Value]) {
        let bound = |keyword: &str| schema.get(keyword).and_then(Value::as_u64);
        let count = items.len() as u64;
        if let Some(least) = bound("minItems").filter(|&least| count < least) {
            self.bound(format!("the list is too short, it takes at least {least} items"));
        }
        if let Some(most) = bound("maxItems").filter(|&most| count > most) {
            self.bound(format!("the list is too long, it takes at most {most} items"));
        }
        let is_set = schema.get("uniqueItems") == Some(&Value::Bool(true));
        if is_set && items.iter().enumerate().any(|(index, item)| items[..index].contains(item)) {
            self.bound("the list has two equal items".to_owned());
        }
        let Some(part) = schema.get("items") else { return };
        for (index, item) in items.iter().enumerate() {
            self.below(index.into(), part, item);
        }
    }

    fn number(&mut self, schema: &Value, value: &Value) {
        let Some(number) = value.as_f64() else { return };
        let bound = |keyword: &str| schema.get(keyword).and_then(|limit| Some((limit, limit.as_f64()?)));
        if let Some((limit, _)) = bound("minimum").filter(|(_, least)| number < *least) {
            self.bound(format!("{value} is too small, {limit} is the least"));
        }
        if let Some((limit, _)) = bound("maximum").filter(|(_, most)| number > *most) {
            self.bound(format!("{value} is too large, {limit} is the most"));
        }
        if let Some((limit, _)) = bound("exclusiveMinimum").filter(|(_, least)| number <= *least) {
            self.bound(format!("{value} must be above {limit}"));
        }
        if let Some((limit, _)) = bound("exclusiveMaximum").filter(|(_, most)| number >= *most) {
            self.bound(format!("{value} must be below {limit}"));
        }
    }

    fn below(&mut self, step: PathStep, schema: &'s Value, value: &Value) {
        self.path.push(step);
        self.value(schema, value);
        self.path.pop();
    }

    fn bound(&mut self, message: String) {
        self.fault(SchemaProblem::Bound(message));
    }

    fn fault(&mut self, problem: SchemaProblem) {
        self.faults.push(SchemaFault { path: self.path.clone(), problem });
    }
}

fn schemas_of<'s>(schema: &'s Value, keyword: &str) -> impl Iterator<Item = &'s Value> {
    schema.get(keyword).and_then(Value::as_array).into_iter().flatten()
}

fn referenced<'s>(root: &'s Value, schema: &'s Value) -> Option<&'s Value> {
    root.pointer(schema.get("$ref")?.as_str()?.trim_start_matches('#'))
}

/// The keys that a schema names itself, by reference, or in one of its alternatives.
fn collect_keys(root: &Value, schema: &Value, keys: &mut Vec<String>) {
    let own = |schema: &Value| -> Vec<String> {
        let properties = schema.get("properties").and_then(Value::as_object);
        properties.map(|properties| properties.keys().cloned().collect()).unwrap_or_default()
    };
    keys.extend(own(schema));
    for keyword in ["allOf", "anyOf", "oneOf"] {
        keys.extend(schemas_of(schema, keyword).flat_map(|part| own(referenced(root, part).unwrap_or(part))));
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use serde_json::json;

    use super::*;

    /// Every keyword that this program's schemas use.
    fn schema() -> Value {
        json!({
            "type": "object", "required": ["id"], "additionalProperties": false,
            "properties": {
                "id": {"type": "string"},
                "count": {"type": ["integer", "null"], "minimum": 0, "maximum": 9},
                "size": {"type": "array", "items": {"type": "number", "exclusiveMinimum": 0}, "minItems": 2, "maxItems": 3},
                "tags": {"type": "array", "uniqueItems": true, "items": {"$ref": "#/$defs/Tag"}},
                "more": {"type": "object", "additionalProperties": {"$ref": "#/$defs/Tag"}},
                "place": {"anyOf": [{"$ref": "#/$defs/Place"}, {"type": "number"}, {"type": "null"}]},
            },
            "$defs": {
                "Tag": {"oneOf": [{"const": "red"}, {"enum": ["green", "blue"]}]},
                "Place": {"type": "object", "properties": {"x": {"type": "number"}}, "required": ["x"],
                    "additionalProperties": false},
            },
        })
    }

    /// Values of the shapes that the schema talks about, right and wrong.
    fn anything() -> impl Strategy<Value = Value> {
        let leaf = prop_oneof![
            Just(Value::Null),
            any::<bool>().prop_map(Value::from),
            (-3_i64..12).prop_map(Value::from),
            Just(json!(1.5)),
            Just(json!(2.0)),
            prop_oneof!["red", "green", "blue", "x"].prop_map(Value::from),
        ];
        let key = prop_oneof!["id", "count", "size", "tags", "more", "place", "x", "odd"];
        leaf.prop_recursive(3, 24, 4, move |inner| {
            prop_oneof![
                prop::collection::vec(inner.clone(), 0..4).prop_map(Value::from),
                prop::collection::btree_map(key.clone(), inner, 0..4)
                    .prop_map(|keys| Value::Object(keys.into_iter().collect())),
            ]
        })
    }

    proptest! {
        #[test]
        fn it_refuses_what_a_complete_validator_refuses(keys in prop::collection::btree_map(
            prop_oneof!["id", "count", "size", "tags", "more", "place", "odd"], anything(), 0..5,
        )) {
            let value = Value::Object(keys.into_iter().collect());
            let complete = jsonschema::validator_for(&schema()).unwrap();
            prop_assert_eq!(schema_faults(&schema(), &value).is_empty(), complete.is_valid(&value), "{}", value);
        }
    }

    #[test]
    fn every_fault_is_named_with_its_place() {
        let value = json!({"count": 12, "size": [1, -1], "tags": ["red", "pink"], "odd": 1});
        let faults = schema_faults(&schema(), &value);
        let places: Vec<String> = faults.iter().map(|fault| super::super::show_path(&fault.path)).collect();
        assert_eq!(places, ["", "count", "", "size[1]", "tags[1]"]);
        assert_eq!(faults[0].problem, SchemaProblem::MissingKey("id".to_owned()));
        assert!(
            matches!(&faults[2].problem, SchemaProblem::UnknownKey { key, known } if key == "odd" && known.len() == 6)
        );
    }
}
