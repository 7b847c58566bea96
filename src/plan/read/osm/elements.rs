//! The elements of OpenStreetMap, as both of its formats give them.

use std::borrow::Cow;

use crate::document::{Fault, Faults};
use crate::geometry::Point;

/// A kind of element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::plan::read) enum ElementKind {
    Node,
    Way,
    Relation,
}

/// Keys and values as they stand in the file.
pub(in crate::plan::read) type Pairs<'a> = Vec<(Cow<'a, str>, Cow<'a, str>)>;

/// An element of a file.
#[derive(Debug)]
pub(in crate::plan::read) struct Element<'a> {
    pub(in crate::plan::read) id: i64,
    /// Where it is in the file; the file's own measure, for [`Elements::fault`].
    pub(in crate::plan::read) offset: u64,
    pub(in crate::plan::read) tags: Pairs<'a>,
    pub(in crate::plan::read) body: Body<'a>,
}

/// What an element has by its kind.
#[derive(Debug)]
pub(in crate::plan::read) enum Body<'a> {
    /// Longitude and latitude.
    Node(Point),
    /// Nodes along a line.
    Way(Vec<i64>),
    /// Members.
    Relation(Vec<Member<'a>>),
}

/// A member of a relation.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::plan::read) struct Member<'a> {
    pub(in crate::plan::read) kind: ElementKind,
    pub(in crate::plan::read) id: i64,
    pub(in crate::plan::read) role: Cow<'a, str>,
}

/// A file of elements.
pub(in crate::plan::read) trait Elements {
    /// Visits all elements of a kind, in the order of the file.
    ///
    /// # Errors
    /// Faults of the file.
    fn each(&self, kind: ElementKind, visit: &mut dyn FnMut(Element<'_>)) -> Result<(), Faults>;

    /// A fault at the offset of an element, where the file has lines.
    fn fault(&self, offset: u64, message: &str) -> Fault;
}

impl Element<'_> {
    /// Whether it has a key.
    pub(in crate::plan::read) fn has(&self, key: &str) -> bool {
        self.tags.iter().any(|(known, _)| known == key)
    }
}
