//! Parses numbers, and advises on mistyped ones.

use std::ops::RangeInclusive;

/// Metres of a unit that users may write behind a length.
const UNITS: [(&str, f64); 10] = [
    ("mm", 0.001),
    ("cm", 0.01),
    ("km", 1000.0),
    ("m", 1.0),
    ("ft", 0.3048),
    ("feet", 0.3048),
    ("'", 0.3048),
    ("inch", 0.0254),
    ("in", 0.0254),
    ("\"", 0.0254),
];

/// Reads a whole number in a range.
pub(super) fn whole_number<T: TryFrom<u64>>(
    range: RangeInclusive<u64>,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static {
    move |text| {
        let number = text.parse::<u64>().ok().filter(|number| range.contains(number));
        number.and_then(|number| T::try_from(number).ok()).ok_or_else(|| {
            let range = match (range.start(), range.end()) {
                (low, &u64::MAX) => format!("from {low} on"),
                (low, high) => format!("from {low} to {high}"),
            };
            format!("write a whole number {range}{}", without_unit(text))
        })
    }
}

/// The largest number of metres or degrees.
const LARGEST: f64 = 999_999.0;

/// Reads metres, from 0 on.
pub(super) fn metres(text: &str) -> Result<f64, String> {
    if let Some(metres) = not_negative(text) {
        return Ok(metres);
    }
    match length(text) {
        Some(metres) => Err(format!("lengths are metres without a unit: write {metres}")),
        None => Err(format!("write metres, as a number from 0 to {LARGEST}")),
    }
}

/// Reads degrees, from 0 on.
pub(super) fn degrees(text: &str) -> Result<f64, String> {
    not_negative(text)
        .ok_or_else(|| format!("write degrees, as a number from 0 to {LARGEST}{}", without_unit(text)))
}

/// Reads finite numbers with commas between them.
pub(super) fn numbers(text: &str) -> Result<Vec<f64>, String> {
    let number = |word: &str| match word.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!("\"{}\" is no number", word.trim())),
    };
    text.split(',').map(number).collect()
}

/// As [`numbers`], so many.
pub(super) fn so_many_numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    numbers(text)?.try_into().map_err(|found: Vec<f64>| format!("{} numbers instead of {N}", found.len()))
}

fn not_negative(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number| (0.0..=LARGEST).contains(number))
}

/// The metres of a length with a unit, to a tenth of a millimetre.
fn length(text: &str) -> Option<f64> {
    let (number, unit) = split_unit(text)?;
    let (_, factor) = UNITS.into_iter().find(|(known, _)| unit.eq_ignore_ascii_case(known))?;
    let metres = not_negative(number)? * factor;
    Some((metres * 1e4).round() / 1e4)
}

fn without_unit(text: &str) -> &'static str {
    if split_unit(text).is_some() { ", without a unit" } else { "" }
}

/// A number and the word behind it.
fn split_unit(text: &str) -> Option<(&str, &str)> {
    let end = text.rfind(|letter: char| letter.is_ascii_digit())? + 1;
    let (number, unit) = text.split_at(end);
    let is_number = number.parse::<f64>().is_ok();
    (is_number && !unit.is_empty()).then(|| (number, unit.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_invalid_number_is_rejected_with_the_range() {
        let effort = whole_number::<u32>(1..=1000);
        assert_eq!(effort("16"), Ok(16));
        for wrong in ["0", "1001", "-3", "many", "", "1.5"] {
            assert_eq!(effort(wrong), Err("write a whole number from 1 to 1000".to_owned()), "{wrong}");
        }
        assert_eq!(whole_number::<u64>(0..=u64::MAX)("-3"), Err("write a whole number from 0 on".to_owned()));
        let angle = whole_number::<u16>(0..=180)("45°");
        assert_eq!(angle, Err("write a whole number from 0 to 180, without a unit".to_owned()));
    }

    #[test]
    fn a_length_with_a_unit_is_converted() {
        assert_eq!(metres("0.5"), Ok(0.5));
        for (typed, converted) in [("14ft", "4.2672"), ("5 mm", "0.005"), ("2'", "0.6096"), ("3M", "3")] {
            let answer = metres(typed).unwrap_err();
            assert_eq!(answer, format!("lengths are metres without a unit: write {converted}"));
        }
        for wrong in ["-1", "far", "14 parsec", "inf", "1e9"] {
            assert_eq!(
                metres(wrong),
                Err("write metres, as a number from 0 to 999999".to_owned()),
                "{wrong}"
            );
        }
        assert_eq!(
            degrees("5deg"),
            Err("write degrees, as a number from 0 to 999999, without a unit".to_owned())
        );
    }
}
