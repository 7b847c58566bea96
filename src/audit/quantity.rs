//! The quantities that findings measure, with their units: people read `0.72 m` and not `0.72`.

/// The quantity that the figures of a finding measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// How far something reaches into something else.
    Depth,
    /// The free space between a side and the nearest body before it.
    FreeDepth,
    /// The gap between a body and its support.
    Gap,
    /// The top of a body above the floor.
    Height,
    /// The widest disc that gets through.
    Width,
    /// From one thing to another.
    Distance,
    /// From a screen to who watches it.
    ScreenDistance,
    /// Between two directions.
    Angle,
    /// A part of a whole.
    Share,
    /// How many pieces or sides.
    Count,
}

/// The unit of [`super::Finding::measured`] and [`super::Finding::threshold`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Metres.
    Metres,
    /// Degrees.
    Degrees,
    /// A share of a whole, shown in percent.
    Share,
    /// Pieces or sides.
    Count,
    /// Diagonals of a screen.
    Diagonals,
}

impl Quantity {
    /// Its name in the documentation.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::FreeDepth => "free depth",
            Self::Gap => "gap",
            Self::Height => "height",
            Self::Width => "width",
            Self::Distance | Self::ScreenDistance => "distance",
            Self::Angle => "angle",
            Self::Share => "share",
            Self::Count => "count",
        }
    }

    /// Its unit.
    #[must_use]
    pub fn unit(self) -> Unit {
        match self {
            Self::Depth | Self::FreeDepth | Self::Gap | Self::Height | Self::Width | Self::Distance => {
                Unit::Metres
            }
            Self::ScreenDistance => Unit::Diagonals,
            Self::Angle => Unit::Degrees,
            Self::Share => Unit::Share,
            Self::Count => Unit::Count,
        }
    }
}

impl Unit {
    /// Its name in the documentation; a count has none.
    #[must_use]
    pub fn name(self) -> Option<&'static str> {
        match self {
            Self::Metres => Some("m"),
            Self::Degrees => Some("degrees"),
            Self::Share => Some("of 1"),
            Self::Count => None,
            Self::Diagonals => Some("diagonals of the screen"),
        }
    }

    /// A figure as people read it.
    #[must_use]
    pub fn show(self, value: f64) -> String {
        match self {
            // Depths of a millimetre or so are what collisions are about.
            Self::Metres if value.abs() < 0.01 && value != 0.0 => format!("{:.1} mm", value * 1000.0),
            Self::Metres => format!("{value:.2} m"),
            Self::Degrees => format!("{value:.0}°"),
            Self::Share => format!("{:.0} %", value * 100.0),
            Self::Count => format!("{value:.0}"),
            Self::Diagonals => format!("{value:.1} diag."),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_shown_in_the_unit_of_their_quantity() {
        let shown = |quantity: Quantity, value: f64| quantity.unit().show(value);
        assert_eq!(shown(Quantity::FreeDepth, 0.5), "0.50 m");
        assert_eq!(shown(Quantity::Share, 0.5), "50 %");
        assert_eq!(shown(Quantity::ScreenDistance, 0.5), "0.5 diag.");
        assert_eq!(shown(Quantity::Depth, 0.0012), "1.2 mm");
        assert_eq!(shown(Quantity::Angle, 29.6), "30°");
        assert_eq!((shown(Quantity::Count, 2.0), shown(Quantity::Gap, 0.0)), ("2".into(), "0.00 m".into()));
    }
}
