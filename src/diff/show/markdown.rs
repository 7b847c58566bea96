//! A report as Markdown, for a comment on a pull request.

use std::fmt::Write;

use super::lines::{Line, lines};
use super::{counted, kinds, name, sentence, sign};
use crate::diff::report::{LevelDiff, Report};
use crate::document::{printable, xml_text};

/// Lines of a room or level that are shown; the others are counted.
const MOST_LINES: usize = 20;

/// Bytes that are kept for the last line.
const RESERVE: usize = 200;

/// A heading, a table of counts, and a foldable block for each level, in at most `most` bytes. What does not fit is left
/// out and counted. Ids and names come from plans of unknown origin: they stand in code spans, where neither
/// HTML nor a mention means anything.
#[must_use]
pub fn markdown(report: &Report, most: usize) -> String {
    let mut text = format!("### Furniture: {}\n", sentence(report));
    let counts: Vec<_> = kinds(report).collect();
    if !counts.is_empty() {
        let heads: String = counts.iter().map(|(kind, _)| format!(" {kind} |")).collect();
        let rules = " ---: |".repeat(counts.len());
        let numbers: String = counts.iter().map(|(_, count)| format!(" {count} |")).collect();
        let _ = write!(text, "\n|{heads}\n|{rules}\n|{numbers}\n");
    }
    let mut blocks: Vec<String> = Vec::new();
    blocks.extend(report.troubles.iter().map(|trouble| {
        format!("\n- **cannot be read** {}: {}\n", code(&trouble.file), code(&trouble.message))
    }));
    let named = report.buildings.iter().map(|(id, state)| ("building", id, *state));
    let named = named.chain(report.shared.iter().map(|(path, state)| ("shared file", path, *state)));
    blocks.extend(named.map(|(what, name, state)| format!("\n- {} {what} {}\n", sign(state), code(name))));
    blocks.extend(report.levels.iter().map(level_block));
    let all = blocks.len();
    let mut shown = 0;
    for block in blocks {
        if text.len() + block.len() + RESERVE > most {
            break;
        }
        text.push_str(&block);
        shown += 1;
    }
    if shown < all {
        let _ = write!(
            text,
            "\n… and {} left out; the report has them all.\n",
            counted((all - shown) as u64, "more entry").replace("entrys", "entries")
        );
    }
    text
}

fn level_block(level: &LevelDiff) -> String {
    let rooms = match level.rooms.len() as u64 {
        0 => String::new(),
        count => format!(", {}", counted(count, "room")),
    };
    let mut text = format!(
        "\n<details><summary>{} <code>{}</code>{rooms}</summary>\n\n",
        sign(level.state),
        xml_text(&name(level))
    );
    push_lines(&mut text, &lines(&level.changes), "");
    for room in &level.rooms {
        let _ = writeln!(text, "- {} **{}** ({})", sign(room.state), code(&room.room), code(&room.room_type));
        push_lines(&mut text, &lines(&room.changes), "  ");
    }
    text.push_str("\n</details>\n");
    text
}

fn push_lines(text: &mut String, lines: &[Line], indent: &str) {
    for line in lines.iter().take(MOST_LINES) {
        let subject =
            if line.subject.is_empty() { String::new() } else { format!("{} ", code(&line.subject)) };
        let _ = writeln!(text, "{indent}- {} {subject}{}", line.sign, code(&line.text));
    }
    if let Some(more) = lines.len().checked_sub(MOST_LINES).filter(|&more| more > 0) {
        let _ = writeln!(text, "{indent}- … and {more} more");
    }
}

/// A text in which nothing means anything but itself.
fn code(text: &str) -> String {
    format!("`{}`", printable(text).replace('`', "'"))
}
