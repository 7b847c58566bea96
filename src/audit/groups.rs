//! The groups of classes that rules are about. A class takes part in a rule by naming the group in
//! `configs/classes/`.

/// People sit on it.
pub(crate) const SEAT: &str = "seat";
/// A bed.
pub(crate) const BED: &str = "bed";
/// People lie on it.
pub(crate) const SLEEPING: &str = "sleeping";
/// A television.
pub(crate) const SCREEN: &str = "screen";
/// A desk.
pub(crate) const WORK_SURFACE: &str = "work_surface";
/// People put things on it, and may sit at it.
pub(crate) const SURFACE: &str = "surface";
/// A mirror.
pub(crate) const MIRROR: &str = "mirror_glass";
/// A tub or shower.
pub(crate) const BATHING: &str = "bathing";
/// A toilet or urinal.
pub(crate) const TOILET: &str = "wc";
/// One cooks at it.
pub(crate) const COOKING: &str = "cooking";
/// Small enough to be carried in a hand.
pub(crate) const SMALL: &str = "small";
/// A lamp.
pub(crate) const LIGHT: &str = "light";
/// A chair that is moved whenever it is used.
pub(crate) const MOVABLE: &str = "movable";
/// A plant in a pot.
pub(crate) const PLANT: &str = "greenery";
/// A curtain or blind.
pub(crate) const WINDOW_DRESSING: &str = "window_dressing";
/// Looks bare without small things on it.
pub(crate) const DISPLAY: [&str; 3] = ["work_surface", "display_surface", "kitchen_top"];
