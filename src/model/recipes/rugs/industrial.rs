//! Flat-woven stripes across.

use super::{Form, ROOT, add_panel, layer, strips};
use crate::model::kit::{Builder, SINK};

/// Shares of the height that warp and stripes of the first colour have.
const WARP: f64 = 0.6;
const GROUND: f64 = 0.9;
/// Metres of warp that show along the sides.
const SELVAGE: f64 = 0.004;

/// Which colour a stripe has, and its width as a share of their sum.
type Stripe = (usize, f64);

const EVEN: &[Stripe] = &[(0, 1.0), (1, 1.0), (0, 1.0), (1, 1.0), (0, 1.0), (1, 1.0), (0, 1.0)];
const ENDS: &[Stripe] = &[(1, 0.7), (0, 0.35), (2, 0.7), (0, 6.0), (2, 0.7), (0, 0.35), (1, 0.7)];
const GRADED: &[Stripe] =
    &[(0, 3.0), (1, 0.3), (0, 2.4), (1, 0.6), (0, 1.8), (1, 0.9), (0, 1.2), (1, 1.2), (0, 0.6), (1, 1.5)];
const LINED: &[Stripe] = &[
    (0, 2.0),
    (2, 0.3),
    (1, 2.0),
    (2, 0.3),
    (0, 2.0),
    (2, 0.3),
    (1, 2.0),
    (2, 0.3),
    (0, 2.0),
    (2, 0.3),
    (1, 2.0),
];

/// Stripes of one width, a few at the ends, ever broader ones, or broad ones with lines between them.
pub(super) fn rug(builder: &mut Builder, form: Form) {
    let bay = builder.bay();
    let (slots, stripes) = [
        (["fabric", "fabric_light", "fabric_accent"], EVEN),
        (["fabric_light", "fabric", "fabric_accent"], ENDS),
        (["carpet", "fabric_accent", "fabric_light"], GRADED),
        (["fabric_light", "fabric", "fabric_accent"], LINED),
    ][form.look];
    add_panel(builder, slots[0], layer(bay, 0.0, WARP));
    // Stripes of the first colour are the ground, which others vary in width against.
    let widths: Vec<f64> =
        stripes.iter().map(|&(color, wide)| if color == 0 { wide } else { wide * form.scale }).collect();
    let woven = bay.inset(SELVAGE + SINK, 0.0, SELVAGE);
    for (strip, &(color, _)) in strips(woven, &widths).into_iter().zip(stripes) {
        let top = if color == 0 { GROUND } else { 1.0 };
        add_panel(builder, slots[color], layer(strip, ROOT, top));
    }
}
