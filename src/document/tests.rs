//! Documents with every kind of fault, as a user would meet them.

use std::collections::BTreeMap;
use std::path::Path;

use proptest::prelude::*;
use serde::Deserialize;

use schemars::JsonSchema;

use super::*;

/// A sample of everything that formats here use.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)]
struct House {
    version: u32,
    name: Option<String>,
    #[serde(default)]
    rooms: Vec<Room>,
    #[serde(default)]
    classes: BTreeMap<String, Class>,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)]
struct Room {
    id: String,
    kind: Kind,
    #[serde(default)]
    outline: Vec<[f64; 2]>,
    window: Option<Window>,
    gap: Option<Range>,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Kind {
    /// Where one sleeps.
    Bedroom,
    /// Where one cooks.
    Kitchen,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)]
struct Window {
    sill: f64,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
#[allow(dead_code)]
enum Range {
    Exact(f64),
    Between([f64; 2]),
    Named(Limits),
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)]
struct Limits {
    low: f64,
    high: f64,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(dead_code)]
struct Class {
    extends: Option<String>,
}

fn faults(file: &str, text: &str) -> Vec<String> {
    let faults = Source::new(Path::new(file), text).parse::<House>().expect_err("the text has a fault");
    let line = |fault: &Fault| match &fault.hint {
        Some(hint) => format!("{fault} ({hint})"),
        None => fault.to_string(),
    };
    faults.0.iter().map(line).collect()
}

#[test]
fn a_good_document_is_read() {
    let text = "version: 1\nname: 12\nrooms:\n- {id: 101, kind: bedroom, gap: [1, 2], outline: [[0, 1.5]]}\n";
    let house: House = Source::new(Path::new("a.yaml"), text).parse().unwrap();
    assert_eq!((house.rooms[0].id.as_str(), house.name.as_deref()), ("101", Some("12")));
    let json = r#"{"version": 1, "rooms": [{"id": "101", "kind": "kitchen", "gap": {"low": 1, "high": 2}}]}"#;
    let house: House = Source::new(Path::new("a.json"), json).parse().unwrap();
    assert!(matches!(house.rooms[0].gap, Some(Range::Named(_))));
}

#[test]
fn all_faults_of_a_file_are_listed_at_once() {
    let text = "\
version: one
nam: House
rooms:
  - id: 101
    kind: bedrom
    outline: [[0, 0], [1, x], [2]]
  - kind: kitchen
    window: {sil: 0.9}
    gap: {low: 1, heigh: 2}
  - id: c
    kind: [kitchen]
    gap: wide
classes:
  desk: {extends: table}
  chair: {extend: seat}
  desk: {}
";
    assert_eq!(
        faults("house.yaml", text),
        [
            "house.yaml:1:10: expected a whole number, found text \"one\"",
            "house.yaml:2:1: unknown key \"nam\" (did you mean \"name\"?)",
            "house.yaml:5:11: unknown value \"bedrom\" (did you mean \"bedroom\"?)",
            "house.yaml:6:27: expected a number, found text \"x\"",
            "house.yaml:6:31: the list is too short, it takes at least 2 items",
            "house.yaml:7:5: key \"id\" is missing",
            "house.yaml:8:13: key \"sill\" is missing",
            "house.yaml:8:14: unknown key \"sil\" (did you mean \"sill\"?)",
            "house.yaml:9:10: key \"high\" is missing",
            "house.yaml:9:19: unknown key \"heigh\" (did you mean \"high\"?)",
            "house.yaml:11:11: expected a text, found a list",
            "house.yaml:12:10: expected a number or a list or a mapping of keys, found text \"wide\"",
            "house.yaml:15:11: unknown key \"extend\" (did you mean \"extends\"?)",
            "house.yaml:16:3: duplicate key \"desk\", first in line 14 (keep one of them)",
        ]
    );
}

#[test]
fn json_faults_are_located_too() {
    let text = "{\n  \"version\": 1,\n  \"rooms\": [{\"id\": 101, \"kind\": \"bed\"}],\n  \"nme\": null\n}";
    assert_eq!(
        faults("house.json", text),
        [
            "house.json:3:20: expected a text, found 101",
            "house.json:3:33: unknown value \"bed\" (did you mean \"bedroom\"?)",
            "house.json:4:3: unknown key \"nme\" (did you mean \"name\"?)",
        ]
    );
    assert_eq!(
        faults("house.json", "{\"version\": 1, \"classes\": {\"a\": {}, \"a\": {}}}"),
        ["house.json:1:37: duplicate key \"a\", first in line 1 (keep one of them)"]
    );
}

#[test]
fn syntax_errors_have_a_place() {
    assert_eq!(
        faults("house.json", "{\"version\": 1,\n \"rooms\": [{\"id\": \"a\""),
        ["house.json:2:21: EOF while parsing an object (the file ends here: is it complete?)"]
    );
    assert_eq!(
        faults("house.json", "{\"version\": NaN}"),
        ["house.json:1:13: expected value (this is no valid JSON from here on)"]
    );
    for text in [
        "version: 1\nrooms: [{id: a\n",
        "version: 1\n  rooms: 2\n",
        "rooms:\n\t- 1\n",
        "version: 1\nrooms: 'a\n",
    ] {
        let found = faults("house.yaml", text);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with("house.yaml:"), "{found:?}");
    }
}

#[test]
fn values_that_are_no_number_are_faults() {
    assert_eq!(
        faults("h.yaml", "version: 1\nrooms:\n- {id: a, kind: kitchen, gap: .inf, window: {sill: 90cm}}\n"),
        [
            "h.yaml:3:31: .inf is not a finite number",
            "h.yaml:3:52: expected a number, found text \"90cm\" (write 90 alone, without a unit)",
        ]
    );
}

#[test]
fn odd_documents_are_faults() {
    for text in ["", "[]", "3", "--- \nversion: 1\n---\nversion: 1\n", "? [a]\n: 1\n", "version: &a [*a]\n"] {
        assert!(!faults("h.yaml", text).is_empty(), "{text}");
    }
    let merged = faults("h.yaml", "version: 1\nclasses:\n  a: &a {}\n  b: {<<: *a}\n");
    assert!(merged[0].starts_with("h.yaml:4:7: merge keys (<<) are not supported"), "{merged:?}");
}

#[test]
fn hostile_documents_are_refused_in_bounds() {
    let mut bomb = String::from("a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n");
    for level in 1..12 {
        let aliases = vec![format!("*a{}", level - 1); 10].join(", ");
        bomb.push_str(&format!("a{level}: &a{level} [{aliases}]\n"));
    }
    assert!(!faults("h.yaml", &bomb).is_empty());
    assert!(!faults("h.yaml", &"[".repeat(100_000)).is_empty());
    assert!(!faults("h.json", &"[".repeat(100_000)).is_empty());
    let many = format!("version: 1\nrooms: [{}]", "{},".repeat(1_000));
    assert_eq!(faults("h.yaml", &many).len(), limits::FAULT_LIMIT + 1);
}

proptest! {
    #[test]
    fn no_text_panics(text in "[ -~\n\t]{0,200}|\\PC{0,60}") {
        let _ = Source::new(Path::new("x.yaml"), &text).parse::<House>();
        let _ = Source::new(Path::new("x.json"), &text).parse::<House>();
    }

    #[test]
    fn no_document_of_the_right_words_panics(
        text in "(version: 1\n)?((rooms|classes|name|nme):( |\n)([-{\\[ \n]{0,3}(id|kind|gap|&a|\\*a|<<)(: |,|\\]|\\}|\n| ){1,2}(kitchen|1|.nan|\"x\")?){0,8}){0,3}"
    ) {
        if let Err(faults) = Source::new(Path::new("x.yaml"), &text).parse::<House>() {
            prop_assert!(!faults.is_empty());
            prop_assert!(faults.has_errors());
        }
    }
}
