//! The attributes of an element of a home, as numbers and lengths in metres.

use quick_xml::XmlVersion;
use quick_xml::events::BytesStart;

use super::faults::Notes;
use crate::geometry::Point;
use crate::plan::limits::COORDINATE;
use crate::plan::units::CENTIMETRE;

/// The hint about a number that is none.
const NUMBER_HINT: &str = "the element is left out; save the home again in Sweet Home 3D";

/// The attributes of an element; the first fault of a number leaves it out.
pub(super) struct Attributes<'notes> {
    values: Vec<(String, String)>,
    element: String,
    /// Byte of the text at which the element stands.
    pub(super) place: usize,
    notes: &'notes mut Notes,
}

impl<'notes> Attributes<'notes> {
    pub(super) fn of(start: &BytesStart<'_>, place: usize, notes: &'notes mut Notes) -> Self {
        let mut values = Vec::new();
        let element = start.name().as_ref().to_owned();
        for attribute in start.attributes().with_checks(false).flatten() {
            let key = attribute.key.as_ref().to_owned();
            match attribute.normalized_value(XmlVersion::Implicit1_0) {
                Ok(value) => values.push((key, value.into_owned())),
                Err(error) => {
                    let message = format!("attribute \"{key}\" of \"{element}\": {error}");
                    notes.warn(place, message, "the attribute is left out");
                }
            }
        }
        Self { values, element, place, notes }
    }

    pub(super) fn find(&self, name: &str) -> Option<&str> {
        self.values.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    pub(super) fn text(&self, name: &str) -> Option<String> {
        self.find(name).map(str::to_owned)
    }

    /// A number, or what it is where the element does not say; none if it is no number.
    pub(super) fn number_or(&mut self, name: &str, usual: f64) -> Option<f64> {
        let Some(text) = self.find(name) else { return Some(usual) };
        // A place beyond that is none of a building.
        let most = COORDINATE / CENTIMETRE;
        let number = text.trim().parse::<f64>().ok().filter(|number| number.abs() <= most);
        if number.is_none() {
            let message = format!("\"{name}\" of \"{}\" is \"{text}\", no number of a home", self.element);
            self.notes.error(self.place, message, NUMBER_HINT);
        }
        number
    }

    pub(super) fn number(&mut self, name: &str) -> Option<f64> {
        if self.find(name).is_none() {
            let message = format!("\"{}\" has no \"{name}\"", self.element);
            self.notes.error(self.place, message, NUMBER_HINT);
            return None;
        }
        self.number_or(name, 0.0)
    }

    /// Metres.
    pub(super) fn length(&mut self, name: &str) -> Option<f64> {
        self.number(name).map(|number| number * CENTIMETRE)
    }

    /// Metres, or those where the element does not say.
    pub(super) fn length_or(&mut self, name: &str, usual: f64) -> Option<f64> {
        self.number_or(name, usual / CENTIMETRE).map(|number| number * CENTIMETRE)
    }

    /// Metres, if the element says; the outer one is none if that is no number.
    pub(super) fn some_length(&mut self, name: &str) -> Option<Option<f64>> {
        match self.find(name) {
            None => Some(None),
            Some(_) => self.length(name).map(Some),
        }
    }

    /// A place, of which y goes down in the file.
    pub(super) fn point(&mut self, [x, y]: [&str; 2]) -> Option<Point> {
        let (x, y) = (self.length(x), self.length(y));
        Some(Point::new(x?, -y?))
    }
}
