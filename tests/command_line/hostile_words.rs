//! Names and words that would control a terminal, or break a format, are made harmless.

use super::world::{Ran, World, plan};

/// Clears a screen, hides, turns the direction of writing, and begins a line of its own.
const HARM: &str = "x\u{1b}[2J\u{9b}1m\u{202e}\n::warning::y";

/// Nothing that was printed does anything to a terminal or a service for continuous integration.
fn assert_harmless(ran: &Ran, what: &str) {
    for text in [&ran.stdout, &ran.stderr] {
        let is_harm = |letter: char| (letter.is_control() && letter != '\n') || letter == '\u{202e}';
        assert!(!text.contains(is_harm), "{what}: {text:?}");
        assert!(!text.lines().any(|line| line.trim_start().starts_with("::")), "{what}: {text}");
    }
}

/// The text as a YAML or JSON string.
fn quoted(text: &str) -> String {
    serde_json::to_string(text).unwrap()
}

#[test]
fn words_on_the_command_line() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    let harm = HARM;
    for words in [
        &[harm][..],
        &["bake", harm],
        &["bake", "a.yaml", "--style", harm],
        &["bake", "a.yaml", "--seed", harm],
        &["bake", "a.yaml", "--reroll", harm],
        &["draw", "a.yaml", "--level", harm],
        &["explain", "a.yaml", harm],
        &["catalog", "classes", harm],
        &["audit", harm],
        &["diff", harm, harm],
    ] {
        let ran = world.run(words);
        assert_ne!(ran.code, Some(0), "{words:?}");
        assert_harmless(&ran, &format!("{words:?}"));
    }
}

#[test]
fn names_in_plans_edits_and_catalogues() {
    let world = World::new();
    let harm = quoted(HARM);
    let named = plan("alpha", 1).replace("{id: study,", &format!("{{id: study, name: {harm},"));
    for text in [
        named.clone(),
        plan("alpha", 1).replace("type: study", &format!("type: {harm}")),
        plan("alpha", 1).replace("id: alpha", &format!("id: {harm}")),
        plan("alpha", 1).replace("{id: study,", &format!("{{id: {harm},")),
        plan("alpha", 1).replace("version: 1\n", &format!("version: 1\n{harm}: 1\n")),
    ] {
        world.write("a.yaml", &text);
        for words in [
            &["check", "a.yaml"][..],
            &["bake", "a.yaml"],
            &["check", "a.yaml", "--json"],
            &["explain", "a.yaml", "nope"],
        ] {
            assert_harmless(&world.run(words), &text);
        }
    }
    world.write("a.yaml", named);
    world.write(
        "a.edits.yaml",
        format!("version: 1\nedits:\n- {{level: \"1\", room: study, objects: {{{harm}: {{turn: 3}}}}}}\n"),
    );
    assert_harmless(&world.run(&["bake", "a.yaml"]), "edits");
    std::fs::remove_file(world.path("a.edits.yaml")).unwrap();
    world.write(
        "mine/classes/a.yaml",
        format!("version: 1\nclasses:\n  thing: {{extends: chair, label: {harm}}}\n"),
    );
    assert_harmless(&world.run(&["catalog", "thing", "--catalog", "mine"]), "label");
    assert_harmless(&world.run(&["catalog", "classes", "--catalog", "mine", "--json"]), "label");
}

#[test]
fn ids_in_finished_files() {
    let world = World::new();
    world.write("a.yaml", plan("alpha", 1));
    world.must(&["bake", "a.yaml", "--format", "gltf"]);
    let text = String::from_utf8(world.read("out/alpha/1.gltf")).unwrap();
    let inside = quoted(HARM);
    let harmed =
        text.replace("\"study\"", &inside).replace("\"desk.1\"", &inside).replace("\"alpha\"", &inside);
    assert_ne!(harmed, text);
    world.write("harm/1.gltf", harmed);
    world.write("harm/1.bin", world.contents("out/alpha").remove("1.bin").unwrap_or_default());
    for words in [
        &["audit", "harm/1.gltf", "--all"][..],
        &["audit", "harm/1.gltf", "--json"],
        &["diff", "out/alpha/1.gltf", "harm/1.gltf", "--all"],
        &["diff", "out/alpha/1.gltf", "harm/1.gltf", "--markdown"],
        &["edits", "capture", "harm/1.gltf", "harm/1.gltf", "--edits", "e.yaml"],
        &["edits", "lock", "harm/1.gltf", "bed", "--edits", "e.yaml"],
    ] {
        assert_harmless(&world.run(words), &format!("{words:?}"));
    }
    let markdown = world.run(&["diff", "out/alpha/1.gltf", "harm/1.gltf", "--markdown"]).stdout;
    assert!(!markdown.contains("\n::") && markdown.contains("\\n::warning"), "{markdown}");
}

#[test]
#[cfg(unix)]
fn names_of_files() {
    let world = World::new();
    let name = "a\u{1b}[2J\n::error::.yaml";
    world.write(name, plan("alpha", 1).replace("version: 1", "version: 9"));
    assert_harmless(&world.run(&["check", "."]), "name of a file");
    world.write(name, plan("alpha", 1));
    assert_harmless(&world.must(&["import", name, "--out", "b\u{1b}.yaml"]), "import");
    assert_harmless(&world.must(&["draw", name, "--out", "b\u{1b}.svg"]), "draw");
}

#[test]
fn long_words_are_cut() {
    let world = World::new();
    let long = "y".repeat(5000);
    world.write("a.yaml", plan("alpha", 1).replace("type: study", &format!("type: {long}")));
    for words in [
        &["check", "a.yaml"][..],
        &["bake", "a.yaml", "--style", &long],
        &["bake", "--seed", &long],
        &["catalog", &long],
    ] {
        let ran = world.run(words);
        let said = ran.stdout + &ran.stderr;
        assert!(said.contains('…') && said.len() < 2000, "{said}");
    }
}

#[test]
fn a_drawing_holds_only_what_xml_allows() {
    let world = World::new();
    // As escapes: YAML takes such characters in no other way. The reader replaces them in names, the page in file names.
    let name = r#""A\uFFFEB\uFFFFC\x01<&>\"""#;
    world.write("a.yaml", plan("alpha", 1).replace("{id: study,", &format!("{{id: study, name: {name},")));
    let svg = world.must(&["draw", "a.yaml"]).stdout;
    assert!(svg.contains("A B C &lt;&amp;&gt;&quot;"), "the name is drawn");
    assert!(!svg.contains(['\u{fffe}', '\u{ffff}', '\u{1}']));
}
