//! `init`: writes a first plan, style and project.

use std::path::{Path, PathBuf};

use super::answer::InitAnswer;
use super::arguments::InitArguments;
use super::exit::Outcome;
use super::files::{Overwrite, write_text};
use super::screen::Screen;
use crate::catalog::builtin_file;
use crate::document::Faults;

/// Where the files to begin with are, below `configs/`.
const START_FOLDER: &str = "start";

/// The files that are written, each with a description: paths below [`START_FOLDER`].
const START_FILES: [(&str, &str); 3] = [
    ("plans/house.yaml", "a house of two levels, for you to change"),
    ("project.yaml", "the plans that are baked together, their style and seed"),
    ("furniture/styles/mine.yaml", "a style of your own"),
];

/// The schemas that the files name, so that editors complete and check them: paths below `configs/`.
const SCHEMAS: [&str; 4] = [
    "schema/plan.schema.json",
    "schema/project.schema.json",
    "schema/styles.schema.json",
    "schema/edits.schema.json",
];

/// A file of the new folder.
struct StartFile {
    path: PathBuf,
    about: &'static str,
    text: String,
}

/// Runs the command. Files that are there already stay as they are.
pub(crate) fn run(arguments: &InitArguments, screen: Screen) -> Outcome {
    let (mut written, mut kept, mut faults) = (Vec::new(), Vec::new(), Faults::default());
    for file in start_files(&arguments.folder) {
        if file.path.is_file() {
            kept.push(file);
            continue;
        }
        match write_text(&file.path, &file.text, Overwrite::Nothing) {
            Ok(()) => written.push(file),
            Err(found) => faults.merge(found),
        }
    }
    screen.faults(&faults);
    if written.is_empty() && kept.is_empty() {
        return Outcome::NotStarted;
    }
    report(&arguments.folder, [&written, &kept], screen);
    Outcome::of_failures(faults.has_errors())
}

fn start_files(folder: &Path) -> Vec<StartFile> {
    let text = |path: &str| builtin_file(path).expect("a test reads every file of the list").to_owned();
    let start = START_FILES.map(|(path, about)| StartFile {
        path: folder.join(path),
        about,
        // The folder of schemas is one step nearer than in `configs/`.
        text: text(&format!("{START_FOLDER}/{path}")).replacen("$schema=../", "$schema=", 1),
    });
    let schemas = SCHEMAS.map(|path| StartFile {
        path: folder.join(path),
        about: "a JSON Schema, by which editors complete and check such files",
        text: text(path),
    });
    start.into_iter().chain(schemas).collect()
}

fn report(folder: &Path, [written, kept]: [&[StartFile]; 2], screen: Screen) {
    let paths =
        |files: &[StartFile]| files.iter().map(|file| file.path.display().to_string()).collect::<Vec<_>>();
    let next = next_commands(folder);
    if screen.is_json {
        return screen.json(&InitAnswer { written: paths(written), kept: paths(kept), next: next.to_vec() });
    }
    for file in kept {
        screen.note(&format!("{}: is there already and stays as it is", file.path.display()));
    }
    if screen.is_quiet {
        return;
    }
    let width = written.iter().map(|file| file.path.display().to_string().len()).max().unwrap_or(0);
    for file in written {
        screen.result(&format!("{:<width$}  {}", file.path.display().to_string(), file.about));
    }
    screen.result(&format!("Next:\n  {}", next.join("\n  ")));
}

/// The next commands: bake the project, draw it.
fn next_commands(folder: &Path) -> [String; 2] {
    let word =
        |path: &str| shell_word(&if folder == Path::new(".") { path.into() } else { folder.join(path) });
    let [project, out, drawing] = ["project.yaml", "out", "house.svg"].map(word);
    [format!("roomwright bake {project} --out {out}"), format!("roomwright draw {project} --out {drawing}")]
}

/// A path as a shell takes it for one word.
fn shell_word(path: &Path) -> String {
    let text = path.display().to_string();
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "/\\._-:+,@%".contains(letter);
    if text.chars().all(is_plain) { text } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_files_of_the_program_are_written_and_find_their_schemas() {
        let of_program = crate::catalog::builtin_files();
        let prefix = format!("{START_FOLDER}/");
        let listed = of_program.iter().filter_map(|file| file.path.strip_prefix(&prefix));
        let mut named = START_FILES.map(|(path, _)| path);
        named.sort_unstable();
        assert_eq!(listed.collect::<Vec<_>>(), named);
        let files = start_files(Path::new("new"));
        for file in &files[..START_FILES.len()] {
            let (_, schema) = file.text.lines().next().unwrap().split_once("$schema=").unwrap();
            let up = schema.matches("../").count();
            let place = file.path.ancestors().nth(up + 1).unwrap().join(schema.trim_start_matches("../"));
            assert!(files.iter().any(|schema| schema.path == place), "{}", place.display());
        }
    }

    #[test]
    fn a_path_is_one_word_for_the_shell() {
        assert_eq!(shell_word(Path::new("a/b-1.yaml")), "a/b-1.yaml");
        assert_eq!(shell_word(Path::new("my house/it's")), "'my house/it'\\''s'");
    }
}
