//! The report of `audit` for people.

use crate::audit::{AuditSummary, Finding};
use crate::cli::summary::audit_lines;
use crate::document::{counted, printable};

use super::judge::{JudgedLevel, JudgedRoom};

/// A line for each level, then the findings, at most some, then the sums.
pub(crate) fn report(levels: &[JudgedLevel], totals: &AuditSummary, most: usize) -> String {
    let mut lines: Vec<String> = levels.iter().map(level_line).collect();
    let findings = || {
        levels
            .iter()
            .flat_map(|level| level.rooms.iter().map(move |room| (level, room)))
            .flat_map(|(level, room)| room.findings.iter().map(move |finding| (level, room, finding)))
    };
    let count = findings().count();
    // The worst first: a short list shows what fails.
    let mut listed: Vec<_> = findings().collect();
    listed.sort_by_key(|(_, _, finding)| std::cmp::Reverse(finding.severity));
    lines.extend(
        listed.into_iter().take(most).map(|(level, room, finding)| finding_line(level, room, finding)),
    );
    if count > most {
        lines.push(format!("… and {} more findings; --all shows them", count - most));
    }
    let grades = totals.grades;
    lines.push(format!(
        "{} of {}: {} without findings, {} with minor ones, {} failed.",
        counted(totals.room_count(), "room"),
        counted(levels.len(), "level"),
        grades.none,
        grades.minor,
        grades.failed,
    ));
    lines.extend(audit_lines(totals));
    lines.join("\n")
}

fn level_line(level: &JudgedLevel) -> String {
    let totals = &level.totals;
    let grades = totals.grades;
    let mut line = format!(
        "{}: {} without findings, {} with minor ones, {} failed",
        printable(&level.file),
        grades.none,
        grades.minor,
        grades.failed
    );
    if let Some(mean) = totals.score.mean() {
        line.push_str(&format!(", score {mean}"));
    }
    let counts = totals.findings.iter().map(|(code, count)| format!(", {} {count}", code.name()));
    counts.for_each(|count| line.push_str(&count));
    line
}

fn finding_line(level: &JudgedLevel, room: &JudgedRoom, finding: &Finding) -> String {
    let (severity, room_type) = (finding.severity.name(), &room.room_type);
    let line =
        format!("  {severity} {}/{}/{} ({room_type}): {finding}", level.building, level.level, room.room);
    printable(&line)
}
