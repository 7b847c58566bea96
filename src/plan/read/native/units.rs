//! Units of length of the native format.

use schemars::JsonSchema;
use serde::Deserialize;

/// A unit of length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
pub(crate) enum LengthUnit {
    /// Metres.
    #[default]
    #[serde(rename = "m")]
    Metre,
    /// Centimetres.
    #[serde(rename = "cm")]
    Centimetre,
    /// Millimetres.
    #[serde(rename = "mm")]
    Millimetre,
    /// Feet of 0.3048 m.
    #[serde(rename = "ft")]
    Foot,
    /// Inches of 0.0254 m.
    #[serde(rename = "in")]
    Inch,
}

impl LengthUnit {
    /// All units.
    pub(crate) const ALL: [Self; 5] =
        [Self::Metre, Self::Centimetre, Self::Millimetre, Self::Foot, Self::Inch];

    /// Metres of one unit.
    pub(crate) fn metres(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            Self::Centimetre => 0.01,
            Self::Millimetre => 0.001,
            Self::Foot => 0.3048,
            Self::Inch => 0.0254,
        }
    }

    /// A length of this unit in metres. Whole centimetres and millimetres give the very numbers that a plan in
    /// metres would hold, so that equal buildings stay equal.
    pub(crate) fn to_metres(self, length: f64) -> f64 {
        match self {
            Self::Metre => length,
            Self::Centimetre => length / 100.0,
            Self::Millimetre => length / 1000.0,
            Self::Foot | Self::Inch => length * self.metres(),
        }
    }

    /// The word in plans.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Millimetre => "mm",
            Self::Foot => "ft",
            Self::Inch => "in",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metric_units_give_the_same_numbers_as_metres() {
        for (unit, length) in [(LengthUnit::Centimetre, 345.0), (LengthUnit::Millimetre, 3450.0)] {
            assert_eq!(unit.to_metres(length).to_bits(), 3.45_f64.to_bits(), "{}", unit.word());
        }
    }

    #[test]
    fn a_foot_is_twelve_inches() {
        assert!((LengthUnit::Foot.to_metres(1.0) - LengthUnit::Inch.to_metres(12.0)).abs() < 1e-15);
    }
}
