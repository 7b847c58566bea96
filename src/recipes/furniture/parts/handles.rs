//! Handles and knobs of doors and drawers.

use glam::DVec3;

use super::turned_forward;
use crate::recipes::Slot;
use crate::recipes::kit::{Builder, SINK, lathe, sweep};

/// The forms of a handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum HandleKind {
    /// A bar on two feet, along x.
    Level,
    /// A bar on two feet, upright.
    Upright,
    /// A round knob.
    Knob,
}

/// How a handle looks from the front.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct HandleForm {
    /// Bar or knob.
    pub(in super::super) kind: HandleKind,
    /// Metres of a bar; of no account for a knob.
    pub(in super::super) length: f64,
}

/// Share of the reach that a bar is thick.
const BAR_SHARE: f64 = 0.4;
/// Corners of a knob.
const KNOB_SIDES: usize = 8;

/// A handle of a length on a front whose surface is at `at`, standing `reach` metres out of it.
pub(in super::super) fn handle(builder: &mut Builder, slot: Slot, form: HandleForm, at: DVec3, reach: f64) {
    let HandleForm { kind, length } = form;
    let along = match kind {
        HandleKind::Level => DVec3::X,
        HandleKind::Upright => DVec3::Y,
        HandleKind::Knob => {
            let radius = reach * 0.7;
            let profile = [
                (radius * 0.5, -SINK),
                (radius * 0.4, reach * 0.5),
                (radius, reach * 0.7),
                (radius * 0.7, reach),
            ];
            builder.add(slot, turned_forward(lathe(&profile, KNOB_SIDES)).moved(at.x, at.y, at.z));
            return;
        }
    };
    // A square bar of radius r is r·√2 thick.
    let thickness = reach * BAR_SHARE;
    let radius = thickness * std::f64::consts::FRAC_1_SQRT_2;
    let out = DVec3::Z * (reach - thickness / 2.0);
    let half = along * (length / 2.0 - thickness / 2.0).max(thickness);
    let foot = at - DVec3::Z * SINK;
    let path = [foot - half, at - half + out, at + half + out, foot + half];
    builder.add(slot, sweep(&path, radius, 4));
}
