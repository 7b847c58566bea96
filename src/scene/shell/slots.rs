//! Material slots of the shell that neither plan nor style chooses.

use crate::recipes::Slot;

/// Slots of frames and sills, handles of windows, glass, and what else leaves no choice.
pub(super) const FRAME_SLOT: Slot = Slot::Painted;
pub(super) const HANDLE_SLOT: Slot = Slot::Metal;
pub(super) const GLASS_SLOT: Slot = Slot::Glass;
pub(super) const SKIRTING_SLOT: Slot = Slot::Painted;
pub(super) const RAILING_SLOT: Slot = Slot::MetalDark;
/// Slot of walls seen from the open air, whatever the room behind them is lined with.
pub(super) const FACADE_SLOT: Slot = Slot::Plaster;
