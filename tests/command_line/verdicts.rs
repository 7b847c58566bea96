//! The verdicts of a bake in the files, in the manifest and on the screen.

use std::collections::BTreeMap;

use serde_json::Value;

use super::world::{World, plan};

/// Sums over the rooms of a floor.
#[derive(Debug, Default, PartialEq)]
struct Sums {
    grades: BTreeMap<String, u64>,
    findings: BTreeMap<String, u64>,
    given: BTreeMap<String, u64>,
    scored: u64,
    /// In the ten-thousandths that scores are rounded to.
    score: i64,
}

fn ten_thousandths(score: &Value) -> i64 {
    (score.as_f64().unwrap() * 1e4).round() as i64
}

impl Sums {
    fn of_rooms(gltf: &Value) -> Self {
        let mut sums = Self::default();
        let extras = gltf["nodes"].as_array().unwrap().iter().map(|node| &node["extras"]);
        for room in extras.filter(|extras| extras["kind"] == "room") {
            *sums.grades.entry(room["grade"].as_str().unwrap().to_owned()).or_default() += 1;
            for finding in room["findings"].as_array().unwrap() {
                let counts =
                    if finding["severity"] == "given" { &mut sums.given } else { &mut sums.findings };
                *counts.entry(finding["code"].as_str().unwrap().to_owned()).or_default() += 1;
            }
            assert_eq!(room["score"].is_null(), room["requested"] == 0);
            if !room["score"].is_null() {
                sums.scored += 1;
                sums.score += ten_thousandths(&room["score"]);
            }
        }
        sums
    }

    fn of_totals(totals: &Value) -> Self {
        let map = |value: &Value| serde_json::from_value::<BTreeMap<String, u64>>(value.clone()).unwrap();
        let grades =
            ["none", "minor", "failed"].map(|grade| (grade.to_owned(), totals[grade].as_u64().unwrap()));
        let sums = Self {
            grades: grades.into_iter().filter(|(_, count)| *count > 0).collect(),
            findings: map(&totals["findings"]),
            given: map(&totals["given"]),
            scored: totals["score"]["rooms"].as_u64().unwrap(),
            score: ten_thousandths(&totals["score"]["sum"]),
        };
        let mean = sums.score as f64 / sums.scored as f64 / 1e4;
        // Four decimals; a mean right between two of them may go either way in binary numbers.
        assert!((totals["score"]["mean"].as_f64().unwrap() - mean).abs() <= 0.5e-4 + 1e-9);
        sums
    }
}

#[test]
fn sums_in_the_manifest_and_in_the_report_are_those_of_the_rooms() {
    let world = World::new();
    // Hardly any room is good enough for these.
    world.write(
        "strict/audit.yaml",
        "version: 1\nthresholds:\n  balance: {least_area: 1, share: 0.5}\n  facing: {angle: 0}\n  alignment: {angle: 0}\n  windows: {depth: 3, low_piece: 0.1, slim_width: 0.1}\n",
    );
    world.write("a.yaml", plan("alpha", 2));
    let bake = ["bake", "a.yaml", "--catalog", "strict", "--format", "gltf", "--json", "--quiet"];
    let ran = world.must(&bake);
    let report: Value = serde_json::from_str(&ran.stdout).unwrap();
    let manifest: Value = serde_json::from_slice(&world.read("out/manifest.json")).unwrap();
    let mut all = Sums::default();
    for level in manifest["levels"].as_array().unwrap() {
        let path = format!("out/{}", level["files"][0]["path"].as_str().unwrap());
        let sums = Sums::of_rooms(&serde_json::from_slice(&world.read(&path)).unwrap());
        assert_eq!(Sums::of_totals(&level["totals"]), sums, "{path}");
        for (own, others) in
            [(&mut all.grades, sums.grades), (&mut all.findings, sums.findings), (&mut all.given, sums.given)]
        {
            others.into_iter().for_each(|(key, count)| *own.entry(key).or_default() += count);
        }
        all.scored += sums.scored;
        all.score += sums.score;
    }
    assert!(!all.findings.is_empty() && all.scored == 4, "{all:?}");
    assert_eq!(Sums::of_totals(&manifest["totals"]), all);
    assert_eq!(Sums::of_totals(&report["totals"]), all);
    let again: Value = serde_json::from_str(&world.must(&bake).stdout).unwrap();
    assert_eq!((&again["kept_levels"], &again["totals"]), (&Value::from(2), &report["totals"]));
}

#[test]
fn the_summary_has_the_mean_score() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    let ran = world.must(&["bake", "a.yaml"]);
    assert!(ran.stdout.contains("Mean score of 2 furnished rooms: 0."), "{}", ran.stdout);
}
