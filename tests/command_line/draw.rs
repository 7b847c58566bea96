//! The files of `draw`: their places, and the files that they may replace.

use super::world::{World, plan};

/// A folder with a plan of two levels.
fn world() -> World {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 2));
    world
}

fn text(world: &World, path: &str) -> String {
    String::from_utf8(world.read(path)).unwrap()
}

#[test]
fn an_svg_file_shows_all_levels_of_a_building() {
    let world = world();
    world.must(&["draw", "a.yaml", "--out", "alpha.svg"]);
    let svg = text(&world, "alpha.svg");
    assert_eq!(svg.matches("<svg").count(), 3, "the sheet and its two levels");
    assert!(svg.contains("alpha / 1<") && svg.contains("alpha / 2<"));
    assert_eq!(world.must(&["draw", "a.yaml"]).stdout, svg, "stdout is a file, too");
    assert_eq!(world.must(&["draw", "a.yaml", "--sheet"]).stdout, svg);
    world.must(&["draw", "a.yaml", "--sheet", "--out", "drawings"]);
    assert_eq!(text(&world, "drawings/alpha.svg"), svg);
}

#[test]
fn a_folder_gets_a_file_for_each_level_and_a_level_can_be_drawn_alone() {
    let world = world();
    world.must(&["draw", "a.yaml", "--out", "drawings"]);
    assert_eq!(world.names("drawings"), ["alpha/1.svg", "alpha/2.svg"]);
    world.must(&["draw", "a.yaml", "--level", "2", "--out", "two.SVG"]);
    assert_eq!(world.read("two.SVG"), world.read("drawings/alpha/2.svg"));
}

#[test]
fn several_buildings_need_a_folder() {
    let world = world();
    world.write("b.yaml", plan("beta", 1));
    for extra in [&[][..], &["--out", "all.svg"]] {
        let ran = world.run(&[&["draw", "a.yaml", "b.yaml"][..], extra].concat());
        assert_eq!((ran.code, ran.stdout.as_str()), (Some(2), ""), "{}", ran.stderr);
        assert!(
            ran.stderr.contains("2 buildings") && ran.stderr.contains("--building alpha"),
            "{}",
            ran.stderr
        );
    }
    world.must(&["draw", "a.yaml", "b.yaml", "--out", "drawings", "--sheet"]);
    assert_eq!(world.names("drawings"), ["alpha.svg", "beta.svg"]);
}

#[test]
fn an_unknown_building_or_level_gets_a_suggestion() {
    let ran = world().run(&["draw", "a.yaml", "--building", "alfa"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("did you mean \"alpha\"?"), "{}", ran.stderr);
}

#[test]
fn a_file_of_another_format_is_refused_before_anything_is_drawn() {
    let world = world();
    let ran = world.run(&["draw", "a.yaml", "--out", "plan.png"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("plan.png: drawings are SVG, not PNG"), "{}", ran.stderr);
    assert!(ran.stderr.contains("--out plan.svg") && !world.path("plan.png").exists(), "{}", ran.stderr);
}

#[test]
fn a_drawing_is_renewed_unless_it_was_edited() {
    let world = world();
    let draw = |seed: &str| world.run(&["draw", "a.yaml", "--out", "alpha.svg", "--seed", seed]);
    assert_eq!(draw("1").code, Some(0));
    let first = text(&world, "alpha.svg");
    assert_eq!(draw("2").code, Some(0));
    assert_ne!(text(&world, "alpha.svg"), first);
    let edited = first.replace("alpha / 1", "My house");
    world.write("alpha.svg", &edited);
    let ran = draw("2");
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("was changed since") && ran.stderr.contains("--force"), "{}", ran.stderr);
    assert_eq!(text(&world, "alpha.svg"), edited);
    world.must(&["draw", "a.yaml", "--out", "alpha.svg", "--force"]);
    assert_eq!(text(&world, "alpha.svg"), first);
}

/// `script` gives the command a terminal.
#[test]
#[cfg(target_os = "linux")]
fn a_terminal_gets_the_name_of_a_file_and_no_svg() {
    let world = world();
    let line = format!("'{}' draw a.yaml", env!("CARGO_BIN_EXE_roomwright"));
    let mut script = std::process::Command::new("script");
    script.args(["--quiet", "--return", "--command", &line, "/dev/null"]).current_dir(world.path("."));
    let Ok(output) = script.stdin(std::process::Stdio::null()).output() else {
        return println!("skipped: no `script`");
    };
    let shown = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{shown}");
    assert_eq!(shown.trim(), "alpha.svg");
    assert!(text(&world, "alpha.svg").starts_with("<svg"));
}
