//! Inputs that are no plans are rejected by name, and the messages for folders name the missing files.

use std::path::Path;

use roomwright::internals::plan::PlanReading;

use super::support::{read_ready, repository};

/// The only fault of an input.
fn fault(path: &Path) -> (String, String) {
    let PlanReading { plan, faults, .. } = read_ready(&[path.to_owned()]);
    assert!(plan.buildings.is_empty());
    assert_eq!(faults.0.len(), 1, "{}: {faults}", path.display());
    let report = faults.0[0].report();
    assert!(report.len() < 1500, "{} bytes", report.len());
    (faults.0[0].message.clone(), faults.0[0].hint.clone().unwrap_or_default())
}

#[test]
#[cfg_attr(not(shared_data), ignore = "needs shared/data beside the project")]
fn real_files_of_other_formats_are_refused_by_name() {
    let data = repository("../shared/data");
    if !data.is_dir() {
        return println!("skipped: {} is absent", data.display());
    }
    for (file, name) in [
        ("floorplans/mlit-indoor/JRTokyoSta_1_Space.geojson", "a file of a Japanese indoor map"),
        ("floorplans/archilyse/dxf/AL_Sample building_1OG_DXF.dxf.zip", "a ZIP archive"),
        ("floorplans/archilyse/site_1440/areas.json", "the areas of a react-planner drawing"),
        ("floorplans/imdf-spbpu/unit.geojson", "a file of an IMDF folder"),
    ] {
        let (message, hint) = fault(&data.join(file));
        assert!(message.starts_with(&format!("looks like {name}")), "{file}: {message}");
        assert!(hint.contains("read are native YAML"), "{file}: {hint}");
    }
}

#[test]
fn text_and_binary_files_are_no_plans() {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes, message) in [
        ("a.glb", &b"glTF\x02\0\0\0\x0c\0\0\0"[..], "looks like a binary glTF file"),
        ("a.txt", b"hello there", "holds no plan"),
        ("a.csv", b"id,area\n1,2\n", "looks like a table (CSV)"),
        ("a.bin", b"\x01\0\x02", "is no text"),
        ("a.yaml", b"", "the file is empty"),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        assert!(fault(&path).0.contains(message), "{name}: {}", fault(&path).0);
    }
}

#[test]
fn a_folder_without_a_plan_is_reported_with_its_files() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(fault(folder.path()).0, "the folder is empty");
    std::fs::write(folder.path().join("a.dxf"), "0\nSECTION\n").unwrap();
    std::fs::write(folder.path().join("b.glb"), b"glTF\x02\0\0\0\x0c\0\0\0").unwrap();
    let (message, hint) = fault(folder.path());
    assert_eq!(message, "the folder holds no plan");
    assert!(hint.contains("a.dxf (a DXF drawing)") && hint.contains("b.glb (a binary glTF file"), "{hint}");
}

#[test]
fn a_folder_with_misnamed_files_is_reported_with_the_expected_names() {
    let folder = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir(repository("tests/cases/plan_import/campus")).unwrap() {
        let path = entry.unwrap().path();
        let name = path
            .file_name()
            .unwrap()
            .to_string_lossy()
            .replace("unit.", "units.")
            .replace("level.", "Levels.");
        std::fs::write(folder.path().join(name), std::fs::read(&path).unwrap()).unwrap();
    }
    let (message, hint) = fault(folder.path());
    assert_eq!(message, "looks like an IMDF folder, but has no \"level.geojson\" and no \"unit.geojson\"");
    assert!(hint.contains("\"Levels.geojson\" as \"level.geojson\""), "{hint}");
    assert!(hint.contains("\"units.geojson\" as \"unit.geojson\""), "{hint}");
}

#[test]
fn a_site_without_its_drawings_is_reported_with_the_expected_names() {
    for (from, to) in [("react_planner_projects", "projects"), ("areas", "rooms")] {
        let folder = tempfile::tempdir().unwrap();
        for entry in std::fs::read_dir(repository("tests/cases/plan_import/block")).unwrap() {
            let path = entry.unwrap().path();
            let stem = path.file_stem().unwrap().to_string_lossy().into_owned();
            let stem = if stem == from { to } else { &stem };
            std::fs::write(folder.path().join(format!("{stem}.json")), std::fs::read(&path).unwrap())
                .unwrap();
        }
        let (message, hint) = fault(folder.path());
        assert!(message.contains(&format!("has no \"{from}.json\"")), "{message}");
        assert!(hint.contains(&format!("{to}.json")), "{hint}");
    }
}

#[test]
fn a_word_of_megabytes_is_not_printed_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("long.yaml");
    let word = "x".repeat(3 << 20);
    for text in [
        format!("version: 1\nlevels: []\n{word}: 1\n"),
        format!(
            "version: 1\nlevels:\n  - id: a\n    rooms:\n      - {{id: r, type: {word}, rectangle: [0, 0, 3, 3]}}\n"
        ),
        format!("version: 1\nlevels: {word}\n"),
        format!("{{\"version\": 1, \"levels\": [], \"{word}\": 1}}"),
        format!(
            "version: 1\nlevels:\n  - id: {word}\n    rooms:\n      - {{id: r, type: office, rectangle: [0, 0, 3, 3]}}\n"
        ),
        word.clone(),
    ] {
        std::fs::write(&path, text).unwrap();
        let faults = read_ready(std::slice::from_ref(&path)).faults;
        let shown = faults.to_string();
        assert!(faults.has_errors() && shown.len() < 5_000, "{} bytes", shown.len());
    }
}
