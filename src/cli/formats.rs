//! `formats`: what is read, and what is not.

use serde_json::json;

use super::exit::Outcome;
use super::screen::Screen;
use crate::plan::{READ_FORMATS, unread_formats};

/// Runs the command.
pub(crate) fn run(screen: Screen) -> Outcome {
    if screen.is_json {
        let read: Vec<_> = READ_FORMATS
            .iter()
            .map(|format| {
                json!({"name": format.name, "title": format.title, "input": format.input, "content": format.content})
            })
            .collect();
        let unread: Vec<_> = unread_formats()
            .into_iter()
            .map(|(name, advice)| json!({"name": name, "advice": advice}))
            .collect();
        screen.json(&json!({"read": read, "not_read": unread}));
        return Outcome::Done;
    }
    for format in READ_FORMATS {
        screen.result(&format!(
            "{:<10}{}\n{:10}input  {}\n{:10}read   {}",
            format.name, format.title, "", format.input, "", format.content
        ));
    }
    let names: Vec<&str> = unread_formats().into_iter().map(|(name, _)| name).collect();
    screen.result(&format!("\nKnown and not read: {}.", names.join(", ")));
    Outcome::Done
}
