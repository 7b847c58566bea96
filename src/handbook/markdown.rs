//! Pieces of Markdown.

use std::path::Path;

/// A table: names of columns, then rows; each line ends with a newline.
pub(super) fn table<const COLUMNS: usize>(
    names: [&str; COLUMNS],
    rows: impl IntoIterator<Item = [String; COLUMNS]>,
) -> String {
    let line = |cells: [String; COLUMNS]| format!("| {} |\n", cells.join(" | "));
    let mut text = line(names.map(str::to_owned)) + &line(names.map(|_| "---".to_owned()));
    text.extend(rows.into_iter().map(|row| line(row.map(|cell| cell.replace('|', "\\|")))));
    text
}

/// The title of what a file defines: its name in words.
pub(super) fn title_of_file(file: &str) -> String {
    let stem = Path::new(file).file_stem().map(|stem| stem.to_string_lossy().replace(['_', '-'], " "));
    let stem = stem.unwrap_or_default();
    let mut letters = stem.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

/// A name as it stands in a file.
pub(super) fn code(name: &str) -> String {
    format!("`{name}`")
}

/// Names as they stand in a file.
pub(super) fn codes<'a>(names: impl IntoIterator<Item = &'a String>) -> String {
    names.into_iter().map(|name| code(name)).collect::<Vec<_>>().join(", ")
}

/// A length or area without the digits that conversions leave behind.
pub(super) fn number(value: f64) -> String {
    const DECIMALS: f64 = 1e3;
    ((value * DECIMALS).round() / DECIMALS).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_does_not_end_its_cell() {
        assert_eq!(
            table(["a", "b"], [["x|y".to_owned(), "z".to_owned()]]),
            "| a | b |\n| --- | --- |\n| x\\|y | z |\n"
        );
    }

    #[test]
    fn a_file_is_called_by_its_name() {
        assert_eq!(title_of_file("configs/rooms/small_shops.yaml"), "Small shops");
        assert_eq!(title_of_file(""), "");
    }
}
