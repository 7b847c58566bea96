//! Shows progress on stderr: a bar, plain lines, or JSON lines.

use std::io::{IsTerminal, Write};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use indicatif::{HumanCount, HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::answer::ProgressLine;
use super::arguments::ProgressWord;
use super::summary::failure_answer;
use crate::batch::{BakeReport, Event, Stage, Totals};
use crate::document::printable_json;

/// Time between two plain lines.
const PLAIN_INTERVAL: Duration = Duration::from_secs(5);

/// Redraws of the bar per second.
const REDRAWS: u8 = 5;

/// Shows how far a bake is.
pub(crate) enum Progress {
    /// Nothing.
    None,
    /// A bar on a terminal.
    Bar(ProgressBar),
    /// A line now and then.
    Plain(Mutex<Plain>),
    /// A JSON object per event.
    Json(Instant),
}

/// State of the plain lines.
pub(crate) struct Plain {
    started: Instant,
    last_line: Instant,
    rooms: u64,
    all_rooms: u64,
}

impl Progress {
    /// The requested kind; `auto` looks at stderr.
    pub(crate) fn new(word: ProgressWord, is_quiet: bool) -> Self {
        match word {
            ProgressWord::None => Self::None,
            ProgressWord::Json => Self::Json(Instant::now()),
            _ if is_quiet => Self::None,
            ProgressWord::Bar => Self::Bar(bar()),
            ProgressWord::Auto if std::io::stderr().is_terminal() => Self::Bar(bar()),
            ProgressWord::Auto | ProgressWord::Plain => Self::Plain(Mutex::new(Plain::new())),
        }
    }

    /// Shows a step.
    pub(crate) fn observe(&self, event: &Event<'_>) {
        match self {
            Self::None => {}
            Self::Bar(bar) => show_on_bar(bar, event),
            Self::Plain(plain) => plain.lock().expect("printing does not panic").observe(event),
            Self::Json(_) => print_answer(&event_line(event)),
        }
    }

    /// Clears the bar, or prints the last JSON line.
    pub(crate) fn finish(&self, report: &BakeReport) {
        match self {
            Self::Bar(bar) => bar.finish_and_clear(),
            Self::Json(started) => print_answer(&finished_line(report, started.elapsed())),
            Self::None | Self::Plain(_) => {}
        }
    }
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr_with_hz(REDRAWS));
    let template = "{bar:30} {human_pos} of {human_len} rooms, {per_sec}, {eta} left";
    bar.set_style(ProgressStyle::with_template(template).expect("the template is fixed"));
    bar
}

fn show_on_bar(bar: &ProgressBar, event: &Event<'_>) {
    match event {
        Event::Started { rooms, .. } => {
            bar.set_length(*rooms as u64);
            bar.reset();
        }
        Event::Baked { totals, .. } => bar.inc(totals.rooms),
        Event::Failed(_) => {}
    }
}

impl Plain {
    fn new() -> Self {
        let now = Instant::now();
        Self { started: now, last_line: now, rooms: 0, all_rooms: 0 }
    }

    fn observe(&mut self, event: &Event<'_>) {
        match event {
            Event::Started { rooms, .. } => {
                *self = Self { all_rooms: *rooms as u64, ..Self::new() };
            }
            Event::Baked { totals, .. } => {
                self.rooms += totals.rooms;
                if self.last_line.elapsed() >= PLAIN_INTERVAL {
                    self.last_line = Instant::now();
                    print_line(&self.line(self.started.elapsed()));
                }
            }
            Event::Failed(_) => {}
        }
    }

    fn line(&self, elapsed: Duration) -> String {
        let rate = self.rooms as f64 / elapsed.as_secs_f64().max(f64::EPSILON);
        let missing = self.all_rooms.saturating_sub(self.rooms);
        let left = Duration::try_from_secs_f64(missing as f64 / rate).unwrap_or(Duration::MAX);
        format!(
            "{} of {} rooms, {} rooms/s, {} left",
            HumanCount(self.rooms),
            HumanCount(self.all_rooms),
            HumanCount(rate as u64),
            HumanDuration(left)
        )
    }
}

fn event_line(event: &Event<'_>) -> ProgressLine {
    match *event {
        Event::Started { levels, rooms, kept } => ProgressLine::Started { levels, rooms, kept_levels: kept },
        Event::Baked { building, level, totals: &Totals { rooms, placed, .. } } => ProgressLine::Baked {
            building: building.to_owned(),
            level: level.to_owned(),
            rooms,
            objects: placed,
        },
        Event::Failed(failure) => ProgressLine::Failed(failure_answer(failure)),
    }
}

fn finished_line(report: &BakeReport, elapsed: Duration) -> ProgressLine {
    let seconds = |stage: &Stage| (stage.name().to_owned(), report.timings.of(*stage).as_secs_f64());
    ProgressLine::Finished {
        seconds: elapsed.as_secs_f64(),
        levels: report.baked,
        kept_levels: report.kept,
        rooms: report.written.rooms,
        bytes: report.bytes,
        stage_seconds: Stage::ALL.iter().map(seconds).collect(),
    }
}

fn print_answer(line: &ProgressLine) {
    print_line(&serde_json::to_string(line).expect("lines are plain data"));
}

/// A closed stderr does not stop a bake.
fn print_line(line: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{}", printable_json(line));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plain_line_has_rate_and_time_left() {
        let mut plain = Plain::new();
        plain.observe(&Event::Started { levels: 4, rooms: 9000, kept: 0 });
        plain.rooms = 3000;
        assert_eq!(plain.line(Duration::from_secs(2)), "3,000 of 9,000 rooms, 1,500 rooms/s, 4 seconds left");
    }

    #[test]
    fn events_for_machines_name_themselves() {
        let totals = Totals { rooms: 3, placed: 40, ..Totals::default() };
        let event = Event::Baked { building: "a", level: "1", totals: &totals };
        assert_eq!(
            serde_json::to_value(event_line(&event)).unwrap(),
            serde_json::json!({"event": "baked", "building": "a", "level": "1", "rooms": 3, "objects": 40})
        );
    }
}
