//! The elements of OpenStreetMap, as both of its formats give them.

use std::borrow::Cow;

use crate::document::Faults;
use crate::geometry::Point;
use crate::plan::read::footprint::facts::{TagValue, Tags};

/// A kind of element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ElementKind {
    Node,
    Way,
    Relation,
}

/// Keys and values as they stand in the file.
pub(super) type Pairs<'a> = Vec<(Cow<'a, str>, Cow<'a, str>)>;

/// An element of a file.
#[derive(Debug)]
pub(super) struct Element<'a> {
    pub(super) id: i64,
    pub(super) tags: Pairs<'a>,
    pub(super) body: Body<'a>,
}

/// What an element has by its kind.
#[derive(Debug)]
pub(super) enum Body<'a> {
    /// Longitude and latitude.
    Node(Point),
    /// Nodes along a line.
    Way(Vec<i64>),
    /// Members.
    Relation(Vec<Member<'a>>),
}

/// A member of a relation.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Member<'a> {
    pub(super) kind: ElementKind,
    pub(super) id: i64,
    pub(super) role: Cow<'a, str>,
}

/// A file of elements.
pub(super) trait Elements {
    /// Visits all elements of a kind, in the order of the file.
    ///
    /// # Errors
    /// Faults of the file.
    fn each(&self, kind: ElementKind, visit: &mut dyn FnMut(Element<'_>)) -> Result<(), Faults>;
}

impl Element<'_> {
    /// Whether it has a key.
    pub(super) fn has(&self, key: &str) -> bool {
        self.tags.iter().any(|(known, _)| known == key)
    }

    /// Its tags by key.
    pub(super) fn tags(&self) -> Tags {
        let mut tags = Tags::default();
        for (key, value) in &self.tags {
            tags.add(key.as_ref(), TagValue::Text(value.clone().into_owned()));
        }
        tags
    }
}
