//! `formats`: lists the formats that are read, and known ones that are not.

use super::answer::{FormatsAnswer, UnreadFormatAnswer};
use super::exit::Outcome;
use super::screen::Screen;
use crate::plan::{ReadFormat, read_formats, unread_formats};

/// Runs the command.
pub(crate) fn run(screen: Screen) -> Outcome {
    if screen.is_json {
        let unread = unread_formats().into_iter();
        let not_read = unread
            .map(|(name, advice)| UnreadFormatAnswer { name: name.to_owned(), advice: advice.to_owned() });
        screen.json(&FormatsAnswer { read: read_formats(), not_read: not_read.collect() });
        return Outcome::Done;
    }
    screen.result(&listed(&read_formats()));
    let names: Vec<&str> = unread_formats().into_iter().map(|(name, _)| name).collect();
    screen.result(&format!("\nKnown and not read: {}.", names.join(", ")));
    Outcome::Done
}

/// Formats with their names in a column as wide as the longest.
fn listed(formats: &[ReadFormat]) -> String {
    let width = formats.iter().map(|format| format.name.len()).max().unwrap_or_default() + 2;
    let line = |format: &ReadFormat| {
        let ReadFormat { name, title, input, content } = format;
        format!("{name:<width$}{title}\n{0:width$}input  {input}\n{0:width$}read   {content}", "")
    };
    formats.iter().map(line).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_runs_into_its_title() {
        let formats = read_formats();
        let text = listed(&formats);
        let apart =
            |format: &ReadFormat| text.lines().any(|line| line.starts_with(&format!("{}  ", format.name)));
        assert!(formats.iter().all(apart), "{text}");
    }
}
