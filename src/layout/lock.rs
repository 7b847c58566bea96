//! Locked objects: somebody put them where they are.

use crate::catalog::{ClassIndex, Side};
use crate::geometry::Point;

use super::furnished::Parent;

/// An object at a place that is not searched for. It may stand where the layout would put nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Lock {
    /// Index into the catalogue's classes.
    pub class: ClassIndex,
    /// Counts the objects of the class; where the programme asks for none of this number there is one more.
    pub number: u32,
    /// Which of the class's variants; the one that is drawn where nothing is said.
    pub variant: Option<u32>,
    /// The object or room part that it stands on or belongs to.
    pub on: LockSupport,
    /// The side of that which it touches.
    pub side: Side,
    /// Middle of its underside: in the level's plan frame, or in the frame of the object that it stands on (x to its
    /// right, y to its back).
    pub position: Point,
    /// Metres above the floor, or above the underside of that object; its top where nothing is said.
    pub elevation: Option<f64>,
    /// Radians counter-clockwise, in the same frame.
    pub angle: f64,
}

/// The support of a locked object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LockSupport {
    /// A part of the room; not [`Parent::Object`].
    Part(Parent),
    /// Another object, by class and number; while it is not there, the locked object searches as others do.
    Object(ClassIndex, u32),
}
