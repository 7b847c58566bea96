//! Writes numbers in the shortest form of JSON: whole ones without a point.

use serde::{Serialize, Serializer};
use serde_json::Value;

/// A coordinate of a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ShortNumber(pub f32);

impl Serialize for ShortNumber {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match whole(f64::from(self.0)) {
            Some(number) => serializer.serialize_i32(number),
            None => serializer.serialize_f32(self.0),
        }
    }
}

/// A coordinate of an accessor's bounds.
pub(super) fn short_number(number: f64) -> Value {
    whole(number).map_or_else(|| Value::from(number), Value::from)
}

/// The number, if nothing is lost by writing it without a point; a negative zero would be.
fn whole(number: f64) -> Option<i32> {
    let whole = number as i32;
    (f64::from(whole).to_bits() == number.to_bits()).then_some(whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_have_no_point_and_the_others_all_digits() {
        let text = |number: f32| serde_json::to_string(&ShortNumber(number)).unwrap();
        assert_eq!([0.0, -3.0, 2.5, 0.1].map(text), ["0", "-3", "2.5", "0.1"]);
        assert_eq!(text(-0.0), "-0.0");
        assert_eq!(text(1e20).parse(), Ok(1e20_f32), "too large for a whole number");
        assert_eq!([0.0, 1.25].map(|number| short_number(number).to_string()), ["0", "1.25"]);
    }
}
