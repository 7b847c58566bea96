//! The smaller commands, and the two output streams.

use std::io::Read;
use std::process::Stdio;

use super::world::{World, plan};

#[test]
fn check_reports_everything_and_writes_nothing() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    let ran = world.must(&["check", "a.yaml"]);
    assert!(ran.stdout.contains("1 building, 2 levels, 4 rooms: 0 errors"), "{}", ran.stdout);
    assert_eq!(world.names("."), ["a.yaml"]);
}

#[test]
fn check_prints_json() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1).replace("bedroom", "bedrom"));
    let ran = world.run(&["check", "a.yaml", "--json"]);
    assert_eq!(ran.code, Some(1));
    let report: serde_json::Value = serde_json::from_str(&ran.stdout).unwrap();
    let fault = &report["faults"][0];
    assert_eq!(fault["severity"], "error");
    assert!(
        fault["line"].as_u64().is_some() && fault["hint"].as_str().unwrap().contains("bedroom"),
        "{fault}"
    );
}

#[test]
fn check_reports_unknown_styles() {
    let world = World::new();
    let with_style =
        |style: &str| plan("alpha", 1).replace("version: 1\n", &format!("version: 1\nstyle: {style}\n"));
    world.write("a.yaml", with_style("hotell"));
    let ran = world.run(&["check", "a.yaml"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stdout);
    assert!(
        ran.stdout.contains("unknown style \"hotell\"") && ran.stdout.contains("did you mean \"hotel\"?")
    );
}

#[test]
fn bake_prints_json_and_is_quiet() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    let ran = world.must(&["bake", "a.yaml", "--json", "--quiet"]);
    let report: serde_json::Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!((report["baked_levels"].as_u64(), report["totals"]["rooms"].as_u64()), (Some(1), Some(2)));
    assert_eq!(ran.stderr, "");
    let ran = world.must(&["bake", "a.yaml", "--quiet"]);
    assert_eq!((ran.stdout.as_str(), ran.stderr.as_str()), ("", ""));
}

#[test]
fn progress_comes_as_json_lines_on_request() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    let ran = world.must(&["bake", "a.yaml", "--progress", "json", "--quiet"]);
    let events: Vec<serde_json::Value> =
        ran.stderr.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let names: Vec<&str> = events.iter().map(|event| event["event"].as_str().unwrap()).collect();
    assert_eq!(names, ["started", "baked", "baked", "finished"]);
    assert!(events[3]["stage_seconds"]["layout"].as_f64().unwrap() > 0.0);
}

#[test]
fn a_closed_pipe_is_no_error() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    for arguments in
        [&["bake", "a.yaml", "--json"][..], &["check", "a.yaml"], &["draw", "a.yaml"], &["catalog"]]
    {
        let mut child =
            world.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        drop(child.stderr.take());
        assert!(child.wait().unwrap().success(), "{arguments:?}");
    }
}

#[test]
fn a_pipe_closed_in_the_middle_of_a_drawing_is_no_error() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    let mut child = world.command(&["draw", "a.yaml"]).stdout(Stdio::piped()).spawn().unwrap();
    let mut beginning = [0; 4];
    child.stdout.as_mut().unwrap().read_exact(&mut beginning).unwrap();
    drop(child.stdout.take());
    assert_eq!(&beginning, b"<svg");
    assert!(child.wait().unwrap().success());
}

#[test]
fn an_imported_plan_bakes_to_the_same_rooms() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    let ran = world.must(&["import", "a.yaml", "--out", "native/b.yaml"]);
    assert!(ran.stderr.contains("1 level, 2 rooms, 2 openings"), "{}", ran.stderr);
    assert_eq!(world.run(&["import", "a.yaml", "--out", "native/b.yaml"]).code, Some(2), "it exists");
    world.must(&["bake", "a.yaml", "--out", "one"]);
    world.must(&["bake", "native/b.yaml", "--out", "two"]);
    assert_eq!(world.read("one/alpha/1.glb"), world.read("two/alpha/1.glb"));
}

#[test]
fn import_lists_what_was_read_and_left_out() {
    let world = World::new();
    let far = "      - {id: far, type: office, rectangle: [0, 50, 5000, 3]}\n    openings:";
    world.write("a.yaml", plan("alpha", 1).replacen("    openings:", far, 1));
    let ran = world.run(&["import", "a.yaml", "--out", "b.yaml", "--report"]);
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    for line in
        ["a.yaml (native)", "rooms     2 of 2: 1 bedroom, 1 study", "1 between two rooms, 1 of one room"]
    {
        assert!(ran.stdout.contains(line), "{line}: {}", ran.stdout);
    }
    let ran = world.run(&["import", "a.yaml", "--out", "b.yaml", "--report", "--json", "--force"]);
    let result: serde_json::Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(result["report"][0]["buildings"][0]["levels"][0]["openings"]["read"], 2);
    assert!(result["faults"][0]["message"].as_str().unwrap().contains("5000 m wide"));
}

#[test]
fn formats_lists_what_is_read_and_what_is_not() {
    let world = World::new();
    let text = world.must(&["formats"]).stdout;
    assert!(
        text.contains("IMDF") && text.contains("level.geojson") && text.contains("a DXF drawing"),
        "{text}"
    );
    let listed: serde_json::Value = serde_json::from_str(&world.must(&["formats", "--json"]).stdout).unwrap();
    assert!(listed["read"].as_array().unwrap().iter().any(|format| format["name"] == "ifc"));
}

#[test]
fn the_catalogue_lists_and_describes() {
    let world = World::new();
    assert!(world.must(&["catalog", "rooms"]).stdout.contains("bedroom"));
    assert!(world.must(&["catalog", "classes", "desk"]).stdout.contains("desk"));
    let ran = world.run(&["catalog", "classes", "desq"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("did you mean"), "{}", ran.stderr);
}

#[test]
fn a_room_is_explained_as_text_and_as_json() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    let report: serde_json::Value =
        serde_json::from_str(&world.must(&["explain", "a.yaml", "study", "--level", "2", "--json"]).stdout)
            .unwrap();
    let objects = report["objects"].as_array().unwrap();
    assert_eq!(objects.len() as u64, report["placed"].as_u64().unwrap());
    assert!(objects.len() > 3 && objects.iter().all(|object| object["search"]["places"].as_u64() > Some(0)));
    let text = world.must(&["explain", "a.yaml", "2/study"]).stdout;
    for object in objects {
        let id = object["id"].as_str().unwrap();
        assert!(text.lines().any(|line| line.starts_with(&format!("{id}  "))), "{id}");
    }
    assert!(text.lines().all(|line| line.trim_end() == line));
}

#[test]
fn an_unknown_or_ambiguous_room_is_a_fault_with_a_hint() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    for (arguments, hint) in [
        (&["explain", "a.yaml", "stdy", "--level", "2"][..], "did you mean \"study\"?"),
        (&["explain", "a.yaml", "study"], "alpha/1/study, alpha/2/study"),
        (&["explain", "a.yaml", "study", "--level", "3"], "possible here: 1, 2"),
        (&["explain", "a.yaml", "study", "--building", "alfa"], "did you mean \"alpha\"?"),
    ] {
        let ran = world.run(arguments);
        assert_eq!(ran.code, Some(2), "{arguments:?}");
        assert!(ran.stderr.contains(hint), "{arguments:?}: {}", ran.stderr);
    }
}

#[test]
fn merge_needs_a_folder() {
    let world = World::new();
    let ran = world.run(&["merge", "nowhere"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("nowhere"));
}

#[test]
fn wrong_arguments_end_with_two() {
    let world = World::new();
    for arguments in [
        &["bake", "--threads", "0"][..],
        &["bake", "--shard", "5/4"],
        &["bake", "--format", "no-format"],
        &["bake", "--sed", "1"],
        &["baek"],
    ] {
        assert_eq!(world.run(arguments).code, Some(2), "{arguments:?}");
    }
    assert_eq!(world.names("."), [""; 0]);
}
