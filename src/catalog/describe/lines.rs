//! Aligns text and formats numbers for people.

use crate::catalog::{Catalog, ClassIndex, ParentName};

/// Facts, one a line, their names in a column.
#[derive(Debug, Default)]
pub(super) struct Lines(Vec<(String, String)>);

impl Lines {
    /// Adds a fact; one without text is left out.
    pub(super) fn add(&mut self, name: &str, text: &str) {
        if !text.is_empty() {
            self.add_all(name, broken(text));
        }
    }

    /// Adds a fact of several lines; only the first bears the name.
    pub(super) fn add_all(&mut self, name: &str, texts: impl IntoIterator<Item = String>) {
        for (index, text) in texts.into_iter().enumerate() {
            self.0.push((if index == 0 { name.to_owned() } else { String::new() }, text));
        }
    }

    /// The text, each line ended by a newline.
    pub(super) fn text(&self) -> String {
        let width = self.0.iter().map(|(name, _)| name.len()).max().unwrap_or_default();
        self.0.iter().map(|(name, text)| format!("  {name:width$}  {text}\n")).collect()
    }
}

/// Letters of a fact's line from which on it goes on in the next.
const LONGEST: usize = 92;

/// A text in lines, broken at spaces.
fn broken(text: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let length = lines.last().map_or(0, |line| line.chars().count());
        if length > 0 && length + 1 + word.chars().count() > LONGEST {
            lines.push(String::new());
        }
        let line = lines.last_mut().expect("there is always a line");
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    lines
}

/// Rows with their columns aligned, each ended by a newline.
pub(super) fn table<const COLUMNS: usize>(rows: &[[String; COLUMNS]]) -> String {
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default();
    let widths: [usize; COLUMNS] = std::array::from_fn(width);
    let mut text = String::new();
    for row in rows {
        let cells: Vec<String> =
            row.iter().zip(widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        text.push_str(cells.join("  ").trim_end());
        text.push('\n');
    }
    text
}

/// Decimals beyond which a figure says nothing: tenths of a millimetre.
const DECIMALS: f64 = 1e4;

/// A number without the digits that conversions leave behind.
pub(super) fn rounded(value: f64) -> f64 {
    let rounded = (value * DECIMALS).round() / DECIMALS;
    // Minus zero would show its sign.
    if rounded == 0.0 { 0.0 } else { rounded }
}

/// An angle in degrees.
pub(super) fn degrees(radians: f64) -> f64 {
    rounded(radians.to_degrees())
}

/// `0.5`, or `0.5 to 1`.
pub(super) fn range((low, high): (f64, f64)) -> String {
    let (low, high) = (rounded(low), rounded(high));
    if low == high { low.to_string() } else { format!("{low} to {high}") }
}

/// The names of classes in order.
pub(super) fn class_names<'a>(catalog: &'a Catalog, classes: &[ClassIndex]) -> Vec<&'a str> {
    classes.iter().map(|&class| catalog.classes[class].id.as_str()).collect()
}

/// A room part, or the names of classes.
pub(super) fn parent_names<'a>(catalog: &'a Catalog, parent: &ParentName) -> Vec<&'a str> {
    match parent {
        ParentName::Floor => vec!["floor"],
        ParentName::Ceiling => vec!["ceiling"],
        ParentName::Wall => vec!["wall"],
        ParentName::Door => vec!["door"],
        ParentName::Window => vec!["window"],
        ParentName::Column => vec!["column"],
        ParentName::Classes(classes) => class_names(catalog, classes),
    }
}
