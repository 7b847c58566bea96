//! Tests that the program accepts every command line on the pages of the project.

use std::path::{Path, PathBuf};

use clap::Parser;
use clap::error::ErrorKind;

use super::Arguments;

/// The text before a command in a code block.
const LEADS: [&str; 3] = ["- run: ", "run: ", "$ "];

/// Pages in the project's folder, and those below `docs/`.
const PAGES: [&str; 4] = ["README.md", "ARCHITECTURE.md", "scripts/README.md", "configs/plans/README.md"];

fn pages(project: &Path) -> Vec<PathBuf> {
    let listed = std::fs::read_dir(project.join("docs")).expect("the project has a folder docs/");
    let in_docs = listed.map(|entry| entry.expect("the folder can be read").path());
    let is_page = |path: &PathBuf| path.extension().is_some_and(|end| end == "md");
    let mut pages: Vec<PathBuf> = in_docs.filter(is_page).collect();
    pages.extend(PAGES.map(|page| project.join(page)));
    pages.sort();
    pages
}

/// The commands of a page, each with its line from 1: lines of code blocks, and words between backticks.
fn commands(page: &str) -> Vec<(usize, &str)> {
    let (mut commands, mut is_fenced) = (Vec::new(), false);
    for (index, line) in page.lines().enumerate() {
        let trimmed = line.trim_start();
        if trimmed.starts_with("```") {
            is_fenced = !is_fenced;
            continue;
        }
        let is_code = is_fenced || line.starts_with("    ");
        let block =
            is_code.then(|| LEADS.iter().find_map(|lead| trimmed.strip_prefix(lead)).unwrap_or(trimmed));
        let spans = line.split('`').skip(1).step_by(2).filter(|_| !is_code);
        let found = block.into_iter().chain(spans).filter(|text| text.starts_with("roomwright "));
        commands.extend(found.map(|command| (index + 1, command)));
    }
    commands
}

/// The words of a command as a shell hands them over: up to a comment, a pipe, a redirection or the next command.
fn words(command: &str) -> Vec<String> {
    let is_end =
        |word: &&str| !(word.starts_with(['#', '|', '>', '&', ';', '<']) || *word == "\\" || *word == "2>");
    let plain = |word: &str| word.trim_matches(['"', '\'']).to_owned();
    command.split_whitespace().take_while(is_end).map(plain).collect()
}

/// Why the program does not take a command.
fn refusal(command: &str) -> Option<String> {
    let error = Arguments::try_parse_from(words(command)).err()?;
    let is_page = matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion);
    // A page that speaks of a command need not say all that it needs.
    let is_short = matches!(
        error.kind(),
        ErrorKind::MissingRequiredArgument | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
    );
    (!is_page && !is_short).then(|| error.to_string())
}

#[test]
fn every_command_on_a_page_is_accepted() {
    let project = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut count, mut refused) = (0, Vec::new());
    for path in pages(project) {
        let page = std::fs::read_to_string(&path).expect("the page can be read");
        for (line, command) in commands(&page) {
            count += 1;
            let place = path.strip_prefix(project).unwrap_or(&path).display();
            refused.extend(refusal(command).map(|why| format!("{place}:{line}: {command}\n{why}")));
        }
    }
    assert!(count > 30, "{count} commands were found");
    assert!(refused.is_empty(), "{}", refused.join("\n"));
}

#[test]
fn wrong_commands_are_found_in_blocks_and_between_backticks() {
    let page = "text `roomwright bkae x`\n\n    roomwright bake x --otu y   # no\n```\n- run: roomwright draw a.yaml > b.svg\n```\nroomwright is not a command here\n";
    let found = commands(page);
    assert_eq!(found.iter().map(|(line, _)| *line).collect::<Vec<_>>(), [1, 3, 5]);
    let is_refused: Vec<bool> = found.iter().map(|(_, command)| refusal(command).is_some()).collect();
    assert_eq!(is_refused, [true, true, false]);
}
