//! Plain pile with a narrow bound edge.

use super::{BACKING, Form, ROOT, add_band, add_panel, layer, strips};
use crate::recipes::Slot;
use crate::recipes::kit::{Bay, Builder};

/// Metres of the bound edge, and of a line that is let into the pile.
const BINDING: f64 = 0.022;
const LINE: f64 = 0.035;
/// Share of the height up to which bands reach that lie lower than the pile.
const LOW: f64 = 0.92;

/// One pile, a line let into it, three fields side by side, or a broad frame.
pub(super) fn rug(builder: &mut Builder, form: Form) {
    let bay = builder.bay();
    let [field, other, binding] = [
        [Slot::Carpet, Slot::Carpet, Slot::FabricLight],
        [Slot::FabricLight, Slot::FabricAccent, Slot::Fabric],
        [Slot::Fabric, Slot::FabricLight, Slot::Fabric],
        [Slot::FabricLight, Slot::FabricAccent, Slot::FabricAccent],
    ][form.look];
    add_panel(builder, binding, layer(bay, 0.0, BACKING));
    let edge = if form.look == 0 { BINDING * 1.6 } else { BINDING };
    let pile = layer(bay.inset(edge, 0.0, edge), ROOT, 1.0);
    match form.look {
        0 => add_panel(builder, field, pile),
        1 => {
            let inside = add_band(builder, field, pile, form.band(bay, 0.16));
            let inside = add_band(builder, other, layer_of(inside, LOW), LINE);
            add_panel(builder, field, inside.with_y(pile.y()));
        }
        2 => {
            let parts = strips(pile, &[0.52, 0.16 * form.scale, 0.32]);
            for (part, (slot, share)) in
                parts.into_iter().zip([(field, 1.0), (Slot::FabricAccent, LOW), (other, 1.0)])
            {
                add_panel(builder, slot, layer_of(part, share));
            }
        }
        _ => {
            let inside = add_band(builder, other, pile, form.band(bay, 0.24));
            add_panel(builder, field, layer_of(inside, LOW));
        }
    }
}

/// A piece of pile, shorn to a share of the rug's height.
fn layer_of(pile: Bay, share: f64) -> Bay {
    pile.with_y([pile.low.y, pile.high.y * share])
}
