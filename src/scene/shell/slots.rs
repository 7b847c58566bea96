//! Material slots of the shell that neither plan nor style chooses.

/// Slots of frames and sills, handles of windows, glass, and what else leaves no choice.
pub(super) const FRAME_SLOT: &str = "painted";
pub(super) const HANDLE_SLOT: &str = "metal";
pub(super) const GLASS_SLOT: &str = "glass";
pub(super) const SKIRTING_SLOT: &str = "painted";
pub(super) const RAILING_SLOT: &str = "metal_dark";
/// Slot of walls seen from the open air, whatever the room behind them is lined with.
pub(super) const FACADE_SLOT: &str = "plaster";
