//! Levels in the lines that the serializer writes for them, where no text needs quotes: asking that of each key and of each text
//! takes most of the time that it writes a plan in.

use super::file::{Number, OutLevel, OutOpening, OutPoint, OutRoom, OutWall, ROUNDING};

/// What looks like a plain word and is none.
const NO_WORDS: [&str; 11] = ["true", "false", "null", "yes", "no", "on", "off", "y", "n", "nan", "inf"];
/// Letters of a word at most: the serializer may fold longer ones.
const LONGEST_WORD: usize = 60;
/// Steps of [`ROUNDING`] in a number that has no more digits than tell it from its neighbours.
const MOST_STEPS: f64 = 1e15;
/// Digits of the steps in one.
const DECIMALS: usize = 5;
/// Digits of the whole numbers up to [`MOST_STEPS`].
const MOST_DIGITS: usize = 16;

/// The lines of a level that name it, to the end of a text; `None` where a text needs a closer look.
pub(super) fn push_title(text: &mut String, level: &OutLevel) -> Option<()> {
    text.push_str("- id: ");
    push_word(text, &level.id)?;
    push_optional(text, "\n  name: ", level.name.as_deref())?;
    text.push_str("\n  elevation: ");
    push_number(text, level.elevation)?;
    text.push_str("\n  height: ");
    push_number(text, level.height)?;
    text.push('\n');
    Some(())
}

/// The lines of a level after its title; `None` as there, or where it has columns.
pub(super) fn push_content(text: &mut String, level: &OutLevel) -> Option<()> {
    let last = level.rooms.last()?;
    if !level.columns.is_empty() {
        return None;
    }
    text.push_str("  rooms:");
    let mut form = LINES;
    for room in &level.rooms {
        push_room(text, room, form)?;
        // Behind walls, which are maps on one line, the serializer writes the next map on one line too.
        form = if room.walls.is_empty() { LINES } else { ONE_LINE };
    }
    text.push('\n');
    match (level.openings.is_empty(), last.walls.is_empty()) {
        (true, true) => {}
        // The next level would be that map.
        (true, false) => return None,
        (false, true) => {
            text.push_str("  openings: ");
            push_list(text, &level.openings, |text, opening| push_opening(text, &opening.0))?;
            text.push('\n');
        }
        // A list on one line follows on the list of an outline alone.
        (false, false) => {
            text.push_str("  openings:\n");
            for opening in &level.openings {
                text.push_str("  - ");
                push_opening(text, &opening.0)?;
                text.push('\n');
            }
        }
    }
    Some(())
}

/// What stands before a room, between its entries, and behind it.
type Form = [&'static str; 3];
/// A room with a line for each entry.
const LINES: Form = ["\n  - ", "\n    ", ""];
/// A room on one line.
const ONE_LINE: Form = ["\n  - {", ", ", "}"];

fn push_room(text: &mut String, room: &OutRoom, [before, between, behind]: Form) -> Option<()> {
    if !room.holes.is_empty() {
        return None;
    }
    text.push_str(before);
    text.push_str("id: ");
    push_word(text, &room.id)?;
    let words = [
        ("name: ", room.name.as_deref()),
        ("type: ", Some(room.room_type.as_str())),
        ("style: ", room.style.as_deref()),
        ("dwelling: ", room.dwelling.as_deref()),
        ("household: ", room.household.as_deref()),
    ];
    for (key, word) in words.into_iter().filter_map(|(key, word)| Some((key, word?))) {
        text.push_str(between);
        text.push_str(key);
        push_word(text, word)?;
    }
    if let Some(number) = room.number {
        text.push_str(between);
        text.push_str("number: ");
        push_digits(text, u64::from(number), 1);
    }
    text.push_str(between);
    text.push_str("height: ");
    push_number(text, room.height)?;
    text.push_str(between);
    text.push_str("outline: ");
    push_list(text, &room.outline.0, push_point)?;
    if !room.walls.is_empty() {
        text.push_str(between);
        text.push_str("walls: ");
        push_list(text, &room.walls, |text, wall| push_wall(text, &wall.0))?;
    }
    text.push_str(behind);
    Some(())
}

fn push_wall(text: &mut String, wall: &OutWall) -> Option<()> {
    if !wall.tags.is_empty() {
        return None;
    }
    text.push_str("{edge: ");
    push_digits(text, wall.edge as u64, 1);
    text.push_str(if wall.railing { ", railing: true}" } else { "}" });
    Some(())
}

fn push_opening(text: &mut String, opening: &OutOpening) -> Option<()> {
    text.push_str("{id: ");
    push_word(text, &opening.id)?;
    push_optional(text, ", kind: ", Some(opening.kind))?;
    text.push_str(", at: ");
    push_point(text, &opening.at)?;
    text.push_str(", along: ");
    push_point(text, &opening.along)?;
    text.push_str(", rooms: ");
    push_list(text, &opening.rooms.0, |text, room| push_word(text, room))?;
    let measures = [(", width: ", opening.width), (", sill: ", opening.sill), (", head: ", opening.head)];
    for (key, number) in measures {
        text.push_str(key);
        push_number(text, number)?;
    }
    push_optional(text, ", hinge: ", opening.hinge)?;
    push_optional(text, ", opens_into: ", opening.opens_into.as_deref())?;
    if let Some(leaves) = opening.leaves {
        text.push_str(", leaves: ");
        push_digits(text, leaves as u64, 1);
    }
    if let Some(swing) = opening.swing {
        text.push_str(", swing: ");
        push_number(text, swing)?;
    }
    text.push('}');
    Some(())
}

fn push_list<T>(text: &mut String, items: &[T], push: impl Fn(&mut String, &T) -> Option<()>) -> Option<()> {
    text.push('[');
    for (index, item) in items.iter().enumerate() {
        text.push_str(if index > 0 { ", " } else { "" });
        push(text, item)?;
    }
    text.push(']');
    Some(())
}

fn push_point(text: &mut String, point: &OutPoint) -> Option<()> {
    push_list(text, &point.0, |text, number| push_number(text, *number))
}

fn push_optional(text: &mut String, key: &str, word: Option<&str>) -> Option<()> {
    let Some(word) = word else { return Some(()) };
    text.push_str(key);
    push_word(text, word)
}

fn push_word(text: &mut String, word: &str) -> Option<()> {
    let is_part =
        |byte: u8| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-' || byte == b'_';
    let is_plain = word.as_bytes().first().is_some_and(u8::is_ascii_lowercase) && word.bytes().all(is_part);
    let is_plain = is_plain && word.len() <= LONGEST_WORD && !NO_WORDS.contains(&word);
    is_plain.then(|| text.push_str(word))
}

/// A number in the shortest form, which is that of its steps: they have no more digits than all numbers keep.
fn push_number(text: &mut String, number: Number) -> Option<()> {
    let steps = (number.0 * ROUNDING).round();
    if steps.is_nan() || steps.abs() >= MOST_STEPS {
        return None;
    }
    if steps < 0.0 {
        text.push('-');
    }
    let (steps, in_one) = (steps.abs() as u64, ROUNDING as u64);
    push_digits(text, steps / in_one, 1);
    if steps % in_one > 0 {
        text.push('.');
        push_digits(text, steps % in_one, DECIMALS);
        text.truncate(text.trim_end_matches('0').len());
    }
    Some(())
}

/// A whole number with so many digits at least.
fn push_digits(text: &mut String, mut number: u64, least: usize) {
    let mut digits = [b'0'; MOST_DIGITS + 4];
    let mut first = digits.len();
    while number > 0 || digits.len() - first < least {
        first -= 1;
        digits[first] = b'0' + (number % 10) as u8;
        number /= 10;
    }
    text.extend(digits[first..].iter().map(|&digit| char::from(digit)));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(number: f64) -> Option<String> {
        let mut text = String::new();
        push_number(&mut text, Number(number))?;
        Some(text + "\n")
    }

    #[test]
    fn numbers_are_written_as_the_serializer_writes_them() {
        let small = (-2_000..2_000).map(|steps| f64::from(steps) / ROUNDING);
        let large =
            [0.0, -0.0, 1.0, -3.0, 12.5, 100.0, 4.72296, -13.53861, 2.000_004, 123_456_789.012_34, 1e9];
        for number in small.chain(large) {
            let plain = serde_saphyr::to_string(&Number(number)).expect("a number");
            assert_eq!(written(number), Some(plain));
        }
        assert_eq!((written(f64::NAN), written(f64::INFINITY), written(1e12)), (None, None, None));
    }

    #[test]
    fn words_that_may_need_quotes_are_left_to_the_serializer() {
        for word in ["flat-1-living-dining-2", "sliding_door", "w304954715", "none", "yes-1", "e5"] {
            let mut text = String::new();
            assert_eq!(push_word(&mut text, word), Some(()));
            assert_eq!(text + "\n", serde_saphyr::to_string(&word).expect("a word"));
        }
        for word in
            ["", "Kitchen", "1", "-", "a b", "on", "null", "nan", "k\u{fc}che", "a: b", &"long".repeat(16)]
        {
            assert_eq!(push_word(&mut String::new(), word), None, "{word}");
        }
    }
}
