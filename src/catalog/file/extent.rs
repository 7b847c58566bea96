//! Coordinates inside a box, as written: `0.05`, `"50%"`, `"100%-0.03"`.

use super::ExtentText;
use crate::catalog::Extent;

const PERCENT: f64 = 100.0;

/// Why a text is no [`Extent`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ExtentFault {
    /// Not of the form `P%`, `P%+m` or `P%-m`.
    Form,
    /// The share is not between 0 % and 100 %.
    Share,
    /// A number is not finite.
    NotFinite,
}

/// Reads a coordinate.
///
/// # Errors
/// The problem of the text. Whether the coordinate lies in the box is checked with the box.
pub(crate) fn read_extent(text: &ExtentText) -> Result<Extent, ExtentFault> {
    let extent = match text {
        ExtentText::Metres(offset) => Extent { share: 0.0, offset: *offset },
        ExtentText::Share(text) => read_share(text).ok_or(ExtentFault::Form)?,
    };
    if !(extent.share.is_finite() && extent.offset.is_finite()) {
        return Err(ExtentFault::NotFinite);
    }
    if !(0.0..=1.0).contains(&extent.share) {
        return Err(ExtentFault::Share);
    }
    Ok(extent)
}

fn read_share(text: &str) -> Option<Extent> {
    let (share, offset) = text.split_once('%')?;
    let share: f64 = share.trim().parse().ok()?;
    let offset = match offset.trim() {
        "" => 0.0,
        signed if signed.starts_with(['+', '-']) => read_offset(signed)?,
        _ => return None,
    };
    Some(Extent { share: share / PERCENT, offset })
}

/// A sign and metres, with or without spaces between them.
fn read_offset(signed: &str) -> Option<f64> {
    let (sign, metres) = signed.split_at(1);
    let metres = metres.trim();
    if metres.starts_with(['+', '-']) {
        return None;
    }
    let metres: f64 = metres.parse().ok()?;
    Some(if sign == "-" { -metres } else { metres })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn share(text: &str) -> Result<Extent, ExtentFault> {
        read_extent(&ExtentText::Share(text.to_owned()))
    }

    #[test]
    fn a_number_is_metres_from_the_low_end() {
        assert_eq!(read_extent(&ExtentText::Metres(0.4)), Ok(Extent { share: 0.0, offset: 0.4 }));
    }

    #[test]
    fn a_share_may_carry_metres() {
        assert_eq!(share("50%"), Ok(Extent { share: 0.5, offset: 0.0 }));
        assert_eq!(share("100%-0.03"), Ok(Extent { share: 1.0, offset: -0.03 }));
        assert_eq!(share(" 25 % + 0.5 "), Ok(Extent { share: 0.25, offset: 0.5 }));
    }

    #[test]
    fn other_texts_are_rejected() {
        for text in ["", "%", "half", "0.5", "50%0.1", "50%+-1", "50%+", "1%2%"] {
            assert_eq!(share(text), Err(ExtentFault::Form), "{text:?}");
        }
        assert_eq!(share("120%"), Err(ExtentFault::Share));
        assert_eq!(share("nan%"), Err(ExtentFault::NotFinite));
        assert_eq!(read_extent(&ExtentText::Metres(f64::INFINITY)), Err(ExtentFault::NotFinite));
    }
}
