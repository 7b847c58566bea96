//! A small modelling kit: closed solids, cut and placed in the box of a class.
//!
//! Frame of everything here: glTF's, metres, Y up; origin in the middle of the underside of the class's
//! box, front at +Z, right (as seen by the person standing before the front) at +X.
//!
//! Every [`Solid`] is closed (each edge belongs to exactly two triangles) and faces outwards.
//!
//! | to make | take |
//! |---|---|
//! | boards, carcasses, doors: pieces of the box | [`Bay`] to cut them, [`Builder::cuboid`] to add them, [`rounded_box`] for softer edges |
//! | a flat shape with thickness: a side panel, a letter | [`extrude()`], whose [`Axis`] says in which plane the profile lies |
//! | what is turned or tapers: legs, vases, basins, shades | [`lathe`], [`cylinder`], [`loft()`]; [`loft_ring`] where it is hollow |
//! | bars, frames, cables along a path, also a leaning leg | [`sweep()`], [`pipe`] with bends of [`rounded_path`] |
//! | bent sheets and free bodies: shells, plywood | [`sheet`], [`skin()`] |
//! | cushions, pillows, curtains, leaves | [`crowned`], [`pillow`], [`hung`], [`blade()`] |
//! | what differs from look to look | [`Sampler`], the random stream of the look |
//!
//! [`Builder::add`] takes a solid and its material slot, [`Builder::add_pair`] also its mirror image.

mod bay;
mod blade;
mod builder;
mod cloth;
mod extrude;
mod loft;
mod mend;
mod normals;
mod outline;
mod projection;
mod reduce;
mod rounded;
mod sampler;
mod simplify;
mod skin;
mod soft;
mod solid;
mod sweep;

pub(crate) use bay::Bay;
pub(crate) use blade::{Blade, blade};
pub(crate) use builder::Builder;
pub(crate) use cloth::{Level, hung};
pub(crate) use extrude::{Axis, extrude};
pub(crate) use loft::{cylinder, lathe, loft, loft_ring};
pub(crate) use outline::{Outline, Slice};
pub(crate) use reduce::TOLERANCES;
pub(crate) use rounded::{cuboid, rounded_box};
pub(crate) use sampler::Sampler;
pub(crate) use simplify::simplified_surface;
pub(crate) use skin::{Station, sheet, skin};
pub(crate) use soft::{crowned, pillow};
pub(crate) use solid::{Shading, Solid};
pub(crate) use sweep::{pipe, rounded_path, sweep};

/// How far touching parts sink into each other, in metres: faces that lie back to back in one plane flicker
/// and render black, so no two parts share a plane.
pub(crate) const SINK: f64 = 0.0005;

/// Anything thinner than this is left out, in metres: it could not be seen, and its triangles would have
/// hardly any area.
pub(crate) const THINNEST: f64 = 0.0002;
