//! The report on an imported plan, in words.

use crate::plan::{InputReport, LevelReport, Share};

/// The report of one input: a block for each level.
pub(crate) fn text(report: &InputReport) -> String {
    let mut lines = vec![format!("{} ({})", report.path.display(), report.format)];
    for building in &report.buildings {
        lines.push(format!("  building {}", building.id));
        building.levels.iter().for_each(|level| add_level(level, &mut lines));
    }
    lines.join("\n")
}

fn add_level(level: &LevelReport, lines: &mut Vec<String>) {
    lines.push(format!("    level {}", level.id));
    let types: Vec<String> = level.room_types.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
    lines.push(format!("      rooms     {}: {}", share(level.rooms), types.join(", ")));
    if level.guessed > 0 {
        let rooms = match level.guessed {
            1 => "1 room whose word is unknown".to_owned(),
            count => format!("{count} rooms whose words are unknown"),
        };
        lines.push(format!("      guessed   {rooms}"));
    }
    let (between, outside) = (level.between_rooms, level.to_outside);
    let openings = share(level.openings);
    lines.push(format!("      openings  {openings}: {between} between two rooms, {outside} of one room"));
    if level.open_boundaries > 0 {
        lines.push(format!("      found     {} boundaries without a wall", level.open_boundaries));
    }
    if level.columns > 0 {
        lines.push(format!("      columns   {}", level.columns));
    }
    for note in &level.notes {
        lines.push(format!("      note      {note}"));
    }
}

fn share(share: Share) -> String {
    format!("{} of {}", share.read, share.drawn)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::BuildingReport;

    #[test]
    fn the_import_report_has_a_block_for_each_level() {
        let level = LevelReport {
            id: "ground".to_owned(),
            rooms: Share { drawn: 3, read: 2 },
            room_types: [("office".to_owned(), 2)].into(),
            guessed: 1,
            openings: Share { drawn: 1, read: 1 },
            between_rooms: 1,
            notes: vec!["room \"x\" is 5000 m wide".to_owned()],
            ..LevelReport::default()
        };
        let report = InputReport {
            path: "a.ifc".into(),
            format: "ifc",
            buildings: vec![BuildingReport { id: "a".to_owned(), levels: vec![level] }],
        };
        let expected = "a.ifc (ifc)\n  building a\n    level ground\n      rooms     2 of 3: 2 office\n      \
                        guessed   1 room whose word is unknown\n      openings  1 of 1: 1 between two rooms, 0 of one room\n      note      room \"x\" is 5000 m wide";
        assert_eq!(text(&report), expected);
    }
}
