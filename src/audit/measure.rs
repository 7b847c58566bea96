//! What the figures of a finding count, so that people read `0.72 m` and not `0.72`.

use super::finding::{Code, Finding};

/// The unit of [`Finding::measured`] and [`Finding::threshold`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
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

impl Finding {
    /// What its figures count.
    #[must_use]
    pub fn measure(&self) -> Measure {
        match self.code {
            Code::Unsupported | Code::CrowdedHalf | Code::Unfulfilled | Code::Sparse | Code::Bare => {
                Measure::Share
            }
            Code::Bedside | Code::MissingRequired => Measure::Count,
            Code::Crooked => Measure::Degrees,
            // A mirror that hangs alone lacks one thing below it; the others are turned by an angle.
            Code::Facing if self.threshold == 1.0 => Measure::Count,
            Code::Facing => Measure::Degrees,
            // With a window it is about the depth before it.
            Code::TvPosition if self.objects.len() == 1 => Measure::Diagonals,
            _ => Measure::Metres,
        }
    }
}

impl Measure {
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
    fn figures_are_shown_in_their_unit() {
        let shown = |code, objects: &[&str], threshold: f64| {
            let objects = objects.iter().map(|&id| id.to_owned()).collect();
            let finding = Finding::new(code, objects, 0.5, threshold);
            finding.measure().show(finding.measured)
        };
        assert_eq!(shown(Code::TightUse, &["bed.1"], 0.9), "0.50 m");
        assert_eq!(shown(Code::Unfulfilled, &[], 0.9), "50 %");
        assert_eq!(shown(Code::TvPosition, &["television.1"], 3.5), "0.5 diag.");
        assert_eq!(shown(Code::TvPosition, &["television.1", "window:1"], 0.5), "0.50 m");
        assert_eq!(Measure::Metres.show(0.0012), "1.2 mm");
        assert_eq!(Measure::Degrees.show(29.6), "30°");
        assert_eq!((Measure::Count.show(2.0), Measure::Metres.show(0.0)), ("2".into(), "0.00 m".into()));
    }
}
