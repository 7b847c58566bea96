//! `formats`: lists the formats that are read, and known ones that are not.

use super::answer::{FormatsAnswer, UnreadFormatAnswer};
use super::exit::Outcome;
use super::screen::Screen;
use crate::plan::{read_formats, unread_formats};

/// Runs the command.
pub(crate) fn run(screen: Screen) -> Outcome {
    if screen.is_json {
        let unread = unread_formats().into_iter();
        let not_read = unread
            .map(|(name, advice)| UnreadFormatAnswer { name: name.to_owned(), advice: advice.to_owned() });
        screen.json(&FormatsAnswer { read: read_formats(), not_read: not_read.collect() });
        return Outcome::Done;
    }
    for format in read_formats() {
        screen.result(&format!(
            "{:<10}{}\n{:10}input  {}\n{:10}read   {}",
            format.name, format.title, "", format.input, "", format.content
        ));
    }
    let names: Vec<&str> = unread_formats().into_iter().map(|(name, _)| name).collect();
    screen.result(&format!("\nKnown and not read: {}.", names.join(", ")));
    Outcome::Done
}
