//! Faults of plans are reported at their place with a hint.

use std::path::{Path, PathBuf};

use roomwright::internals::document::{Fault, Faults};
use roomwright::internals::plan::read_formats;

use super::support::{files, read, repository};
use crate::golden::check_golden;

#[test]
fn every_fault_is_reported_where_it_stands() {
    let cases = files(&repository("tests/cases/plan/faults"), &["yaml"]);
    assert!(cases.len() >= 10);
    let mut differences = Vec::new();
    for case in cases {
        let expected = expected(&case);
        assert!(!expected.is_empty(), "{} expects nothing", case.display());
        let faults = read(std::slice::from_ref(&case)).faults;
        differences.extend(compare(&case, expected, &faults));
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

#[test]
fn files_without_comments_have_their_faults_beside_them() {
    let mut cases = files(&repository("tests/cases/plan/faults"), &["json", "txt"]);
    cases.extend([
        repository("tests/cases/plan/faults/missing.yaml"),
        repository("tests/cases/plan/faults/empty"),
    ]);
    for case in cases {
        let faults = read(std::slice::from_ref(&case)).faults;
        assert!(faults.has_errors(), "{}", case.display());
        let relative: Vec<Fault> = faults.0.into_iter().map(without_folder).collect();
        // A further format changes no golden.
        let formats: Vec<&str> = read_formats().iter().map(|format| format.title).collect();
        let text = Faults(relative).to_string().replace(&formats.join(", "), "<formats>");
        check_golden(&case.with_extension("expect"), &format!("{text}\n"));
    }
}

fn without_folder(fault: Fault) -> Fault {
    Fault { file: PathBuf::from(fault.file.file_name().unwrap_or_default()), ..fault }
}

#[derive(Debug, PartialEq)]
struct Expected {
    line: usize,
    is_error: bool,
    message: String,
}

fn expected(case: &Path) -> Vec<Expected> {
    let text = std::fs::read_to_string(case).unwrap();
    let lines = text.lines().enumerate();
    lines.flat_map(|(index, line)| expected_in(index + 1, line)).collect()
}

fn expected_in(line: usize, text: &str) -> Vec<Expected> {
    let marks = [("# expect: ", true), ("# expect warning: ", false)];
    let Some((is_error, messages)) =
        marks.iter().find_map(|(mark, is_error)| Some((*is_error, text.split_once(mark)?.1)))
    else {
        return Vec::new();
    };
    messages.split(" | ").map(|message| Expected { line, is_error, message: message.to_owned() }).collect()
}

fn compare(case: &Path, mut expected: Vec<Expected>, faults: &Faults) -> Vec<String> {
    let mut differences = Vec::new();
    for fault in faults {
        let hint = fault.hint.as_ref().map(|hint| format!(" ({hint})")).unwrap_or_default();
        let full = format!("{}{hint}", fault.message);
        let line = fault.position.map_or(0, |(line, _)| line);
        let found = expected.iter().position(|expected| {
            let fits = full == expected.message || fault.message == expected.message;
            fits && expected.line == line && expected.is_error == fault.is_error()
        });
        match found {
            Some(index) => drop(expected.remove(index)),
            None => differences.push(format!("not expected: {fault}{hint}")),
        }
    }
    differences.extend(expected.iter().map(|missing| format!("missing: {}: {missing:?}", case.display())));
    differences
}
