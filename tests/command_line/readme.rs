//! The commands of the README and of the pages that it leads to work as they are written, in their order, from the folder of a
//! newcomer.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::world::World;

const README: &str = include_str!("../../README.md");

/// The heading after the commands that set the project up; `scripts/test.sh` runs those.
const FIRST_HEADING: &str = "\n## Use\n";

/// The page that lists every command.
const COMMANDS: &str = include_str!("../../docs/commands.md");

/// The pages that go on from each other: later ones take what the commands of earlier ones wrote.
const PAGES: [&str; 5] = [
    COMMANDS,
    include_str!("../../docs/output.md"),
    include_str!("../../docs/audit.md"),
    include_str!("../../docs/diff.md"),
    include_str!("../../docs/usd.md"),
];

/// The page about walks.
const WALKING: &str = include_str!("../../docs/walking.md");

/// The page about edits, which begins with a plan.
const EDITS: &str = include_str!("../../docs/edits.md");

/// The project's folder.
fn project() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The lines of indented code blocks that are commands, without their comments.
fn commands(text: &'static str) -> Vec<&'static str> {
    let lines = text.lines().filter_map(|line| line.strip_prefix("    "));
    let lines = lines.filter(|line| line.starts_with("roomwright ") || line.starts_with("python "));
    lines.map(|line| line.split_once(" #").map_or(line, |(command, _)| command).trim_end()).collect()
}

/// Pythons that may have what the scripts need, the one that somebody names first.
fn pythons() -> Vec<PathBuf> {
    let named = std::env::var_os("ROOMWRIGHT_PYTHON").map(PathBuf::from);
    let own = [".venv/bin/python", ".venv-render/bin/python"].map(|path| project().join(path));
    named.into_iter().chain(own).chain([PathBuf::from("python3")]).collect()
}

/// The modules that a script needs, and whether it needs the Khronos validator.
fn needs(script: &str) -> (&'static str, bool) {
    match script {
        "scripts/validate.py" => ("numpy, shapely, trimesh, pxr, tqdm, jsonschema", true),
        "scripts/cluster.py" => ("json", false),
        "scripts/blender_import.py" | "scripts/blender_export.py" => ("bpy", false),
        _ => ("numpy, shapely, pxr, tqdm, jsonschema, PIL", false),
    }
}

/// A Python for a script.
///
/// # Errors
/// Says what is missing.
fn python_for(script: &str) -> Result<PathBuf, String> {
    let (modules, needs_validator) = needs(script);
    if needs_validator && !project().join("python/roomwright/khronos/node_modules/gltf-validator").is_dir() {
        return Err("python/roomwright/khronos/node_modules is missing".to_owned());
    }
    let can_import = |python: &PathBuf| {
        let mut command = Command::new(python);
        command.args(["-c", &format!("import {modules}")]).stdin(Stdio::null());
        command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
    };
    pythons().into_iter().find(can_import).ok_or_else(|| format!("no Python with {modules}"))
}

/// A map of two houses.
const TOWN: &str = r#"{"type": "FeatureCollection", "features": [
  {"type": "Feature", "id": "way/1", "properties": {"building": "house", "building:levels": "2"}, "geometry": {"type": "Polygon",
    "coordinates": [[[13.4, 52.5], [13.40015, 52.5], [13.40015, 52.50008], [13.4, 52.50008], [13.4, 52.5]]]}},
  {"type": "Feature", "id": "way/2", "properties": {"building": "yes"}, "geometry": {"type": "Polygon",
    "coordinates": [[[13.401, 52.5], [13.40112, 52.5], [13.40112, 52.50008], [13.401, 52.50008], [13.401, 52.5]]]}}]}"#;

/// A folder with the program in its PATH, the project's scripts, and the files that stand for a user's.
struct Newcomer {
    world: World,
    path: String,
}

impl Newcomer {
    fn new() -> Self {
        let world = World::new();
        let campus = project().join("tests/cases/plan_import/campus");
        for file in std::fs::read_dir(campus).unwrap() {
            let file = file.unwrap();
            let name = format!("campus-imdf/{}", file.file_name().to_str().unwrap());
            world.write(&name, std::fs::read(file.path()).unwrap());
        }
        world.write("town.geojson", TOWN);
        #[cfg(unix)]
        for folder in ["scripts", "configs"] {
            std::os::unix::fs::symlink(project().join(folder), world.path(folder)).unwrap();
        }
        let program = Path::new(env!("CARGO_BIN_EXE_roomwright")).parent().unwrap();
        let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
        Self { world, path }
    }

    /// Runs a line as a shell does.
    ///
    /// # Errors
    /// Says why it is skipped.
    fn run(&self, line: &str) -> Result<(), String> {
        let words: Vec<&str> = line.split_whitespace().collect();
        let mut typed = line.to_owned();
        if words[0] == "python" {
            let python = python_for(words[1])?;
            typed = typed.replacen("python", &format!("'{}'", python.display()), 1);
        }
        let blend = words.iter().find(|word| word.ends_with(".blend"));
        if let Some(blend) = blend.filter(|_| words[1].ends_with("export.py"))
            && !self.world.path(blend).exists()
        {
            return Err(format!("{blend} was not made"));
        }
        if words.contains(&"edited.glb") && !self.world.path("edited.glb").exists() {
            self.world.write("edited.glb", self.world.read("out/house/ground.glb"));
        }
        if words[1] == "view" {
            self.serve(&typed);
            return Ok(());
        }
        let output = self.shell(&typed).output().unwrap();
        // Differences of the kinds that somebody asks for are an answer, too.
        let is_answer =
            output.status.success() || (line.contains("--fail-on") && output.status.code() == Some(1));
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(is_answer, "{line}: {:?}\n{stderr}", output.status.code());
        Ok(())
    }

    fn shell(&self, line: &str) -> Command {
        let mut command = Command::new("sh");
        command.args(["-c", line]).current_dir(self.world.path(".")).env("PATH", &self.path);
        command.env("ROOMWRIGHT_CACHE", self.world.path("cache")).stdin(Stdio::null());
        command.env("ROOMWRIGHT_CLUSTER_FOLDER", self.world.path("node"));
        command
    }

    /// Runs a server until it says where it is. No browser opens in tests.
    fn serve(&self, line: &str) {
        let mut command = self.shell(&format!("exec {line} --no-open"));
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let mut address = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut address).unwrap();
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(address.starts_with("http://127.0.0.1:"), "{line}: {address:?}");
    }
}

/// Runs commands one after the other from a newcomer's folder, in which they make files.
#[expect(clippy::print_stdout, reason = "a test says what it leaves out")]
fn run_all(commands: &[&str], made: &[&str]) {
    let newcomer = Newcomer::new();
    let mut skipped: BTreeMap<&str, String> = BTreeMap::new();
    for line in commands {
        if let Err(reason) = newcomer.run(line) {
            println!("skipped: {line}: {reason}");
            skipped.insert(line, reason);
        }
    }
    assert!(skipped.keys().all(|line| line.starts_with("python ")), "{skipped:?}");
    for file in made {
        assert!(newcomer.world.path(file).exists(), "{file}");
    }
}

#[test]
#[cfg(unix)]
fn every_command_of_the_readme_runs_as_it_is_written() {
    let (_, text) = README.split_once(FIRST_HEADING).unwrap();
    let made =
        ["out/house/upper.glb", "campus/manifest.json", "house.svg", "again/manifest.json", "diff.html"];
    run_all(&commands(text), &made);
}

#[test]
#[cfg(unix)]
fn every_command_of_the_pages_runs_as_it_is_written() {
    let lines: Vec<&str> = PAGES.iter().flat_map(|page| commands(page)).collect();
    let made = [
        "out/house/ground.glb",
        "house.svg",
        "drawings/house/upper.svg",
        "diff.html",
        "page.html",
        "man/roomwright.1",
    ];
    run_all(&lines, &made);
}

#[test]
#[cfg(unix)]
fn every_command_of_the_page_about_edits_runs_as_it_is_written() {
    let lines: Vec<&str> = [&["roomwright init"], &*commands(EDITS)].concat();
    run_all(&lines, &["out/house/ground.glb", "plans/house.edits.yaml"]);
}

#[test]
#[cfg(unix)]
fn every_command_of_the_page_about_walks_runs_as_it_is_written() {
    let lines: Vec<&str> = [&["roomwright init"], &*commands(WALKING)].concat();
    assert!(lines.len() > 4, "{lines:?}");
    run_all(&lines, &["plans/house.yaml"]);
}

#[test]
fn the_page_of_commands_names_every_command() {
    let world = World::new();
    let help = world.must(&["--help"]).stdout;
    let (_, list) = help.split_once("Commands:\n").unwrap();
    let names: Vec<&str> = list
        .lines()
        .take_while(|line| !line.is_empty())
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(names.len() > 10, "{names:?}");
    for name in names.into_iter().filter(|name| *name != "help") {
        assert!(COMMANDS.contains(&format!("roomwright {name}")), "{name}");
    }
}
