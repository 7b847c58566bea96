//! What YAML lets stand for what, and where a mismatch is.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::super::json::parse_json;
use super::super::show_path;
use super::super::tree::Tree;
use super::*;

#[derive(Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Shape {
    Round,
    Wide(f64),
    Box { width: f64 },
}

#[derive(Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
struct Name(String);

fn yaml<T: DeserializeOwned>(text: &str) -> Result<T, (String, String)> {
    read(&Tree::parse(text).unwrap().root)
}

fn json<T: DeserializeOwned>(text: &str) -> Result<T, (String, String)> {
    read(&parse_json(text).unwrap())
}

fn read<T: DeserializeOwned>(root: &Node) -> Result<T, (String, String)> {
    typed(root).map_err(|mismatch| {
        let (message, path) = mismatch.into_parts();
        (message, show_path(&path))
    })
}

#[test]
fn words_of_yaml_stand_for_what_is_asked() {
    assert_eq!(yaml("[12, true, x]"), Ok(["12", "true", "x"].map(str::to_owned)));
    assert_eq!(yaml("[\" 1.5\", 2, '0x10']"), Ok([1.5, 2.0, 16.0]));
    assert_eq!(yaml("[\"true\", FALSE]"), Ok([true, false]));
    assert_eq!(yaml::<BTreeMap<Name, Vec<u8>>>("a:\n1: [2]\n").unwrap()[&Name("1".to_owned())], [2]);
    assert_eq!(yaml("~"), Ok(None::<u8>));
}

#[test]
fn values_of_json_have_one_type() {
    assert!(
        json::<String>("12").is_err() && json::<f64>("\"12\"").is_err() && json::<Vec<u8>>("null").is_err()
    );
    assert_eq!(json("[1, -2.5]"), Ok([1.0, -2.5]));
}

#[test]
fn a_variant_is_a_word_or_a_key() {
    let shapes = vec![Shape::Round, Shape::Wide(2.0), Shape::Box { width: 3.0 }];
    assert_eq!(yaml("[round, {wide: 2}, {box: {width: 3}}]").as_ref(), Ok(&shapes));
    assert_eq!(json("[\"round\", {\"wide\": 2}, {\"box\": {\"width\": 3}}]"), Ok(shapes));
}

#[test]
fn a_mismatch_knows_its_place() {
    let place = |text: &str| yaml::<BTreeMap<String, Vec<Shape>>>(text).unwrap_err();
    assert_eq!(place("a: [round, {wide: x}]").1, "a[1].wide");
    assert_eq!(place("a: [wide]"), ("\"wide\" needs a value".to_owned(), "a[0]".to_owned()));
    assert_eq!(place("a: [round, {round: 1}]").1, "a[1].round");
    assert_eq!(place("b: 3").1, "b");
}

#[test]
fn a_whole_number_may_be_written_as_a_decimal_one() {
    assert_eq!(yaml::<i64>("1e9"), Ok(1_000_000_000));
    assert_eq!(yaml::<u32>("2.0"), Ok(2));
    assert!(yaml::<i64>("1.5").is_err() && yaml::<i64>("1e300").is_err());
    let (message, _) = yaml::<i32>("4294967296").unwrap_err();
    assert_eq!(message, "4294967296 is too large for a number here");
}
