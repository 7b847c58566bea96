//! A report for the terminal.

use super::lines::{Line, lines};
use super::{counted, kinds, name, sentence, sign};
use crate::diff::report::{LevelDiff, Presence, Report};
use crate::document::printable;

/// Lines that a room or level has in a short report, and levels that are listed.
const SHORT: (usize, usize) = (12, 40);

/// A block for each level with its rooms, then the counts. A short report leaves out what is much, and counts it.
#[must_use]
pub fn text(report: &Report, is_short: bool) -> String {
    let (most_lines, most_levels) = if is_short { SHORT } else { (usize::MAX, usize::MAX) };
    let mut shown: Vec<String> = Vec::new();
    for (building, state) in &report.buildings {
        shown.push(format!("{} building {}", sign(*state), printable(building)));
    }
    for (path, state) in report.shared.iter().take(most_lines) {
        shown.push(format!("{} shared {}", sign(*state), printable(path)));
    }
    shown.extend(left_out(report.shared.len(), most_lines, "shared file"));
    for level in report.levels.iter().take(most_levels) {
        push_level(&mut shown, level, most_lines);
    }
    shown.extend(left_out(report.levels.len(), most_levels, "level"));
    shown.push(sentence(report));
    let counts: Vec<String> = kinds(report).map(|(kind, count)| format!("{kind} {count}")).collect();
    if !counts.is_empty() {
        shown.push(counts.join(", "));
    }
    shown.join("\n")
}

fn push_level(shown: &mut Vec<String>, level: &LevelDiff, most: usize) {
    let of_level = lines(&level.changes);
    let is_lone = matches!(level.state, Presence::Added | Presence::Removed);
    let summary = of_level.first().filter(|_| is_lone).map(|line| format!(": {}", printable(&line.text)));
    let unreadable = if level.state == Presence::Unreadable { ": cannot be compared" } else { "" };
    shown.push(format!(
        "{} {}{}{unreadable}",
        sign(level.state),
        printable(&name(level)),
        summary.unwrap_or_default()
    ));
    push_lines(shown, &of_level[usize::from(is_lone).min(of_level.len())..], "    ", most);
    for room in &level.rooms {
        shown.push(format!(
            "  {} {} ({})",
            sign(room.state),
            printable(&room.room),
            printable(&room.room_type)
        ));
        push_lines(shown, &lines(&room.changes), "      ", most);
    }
}

fn push_lines(shown: &mut Vec<String>, lines: &[Line], indent: &str, most: usize) {
    for line in lines.iter().take(most) {
        let subject =
            if line.subject.is_empty() { String::new() } else { format!("{}: ", printable(&line.subject)) };
        shown.push(format!("{indent}{} {subject}{}", line.sign, printable(&line.text)));
    }
    shown.extend(left_out(lines.len(), most, "line").map(|text| format!("{indent}{text}")));
}

fn left_out(count: usize, most: usize, what: &str) -> Option<String> {
    let more = count.checked_sub(most).filter(|&more| more > 0)?;
    Some(format!("… and {}; --all shows them", counted(more as u64, &format!("more {what}"))))
}
