//! Definitions of one kind, found by their id once and by a reference from then on.

use core::ops::{Index, IndexMut};

use super::palette::Palette;
use super::style::Style;

/// What has an id of its own in configuration, and the type of references to it.
pub trait Definition {
    /// A place in [`ById`].
    type Ref: Copy;

    /// The reference of a place.
    fn reference(place: usize) -> Self::Ref;

    /// The place of a reference.
    fn place(reference: Self::Ref) -> usize;

    /// The word in configuration.
    fn id(&self) -> &str;
}

/// Definitions of one kind, sorted by id. A reference is a place among them: it is looked up when configuration is read, so
/// that no later stage meets an id that is not there.
#[derive(Clone, Debug)]
pub struct ById<T>(Vec<T>);

impl<T> Default for ById<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T: Definition> ById<T> {
    /// The reference of an id.
    #[must_use]
    pub fn find(&self, id: &str) -> Option<T::Ref> {
        self.0.binary_search_by(|one| one.id().cmp(id)).ok().map(T::reference)
    }

    /// The definition of an id.
    #[must_use]
    pub fn get(&self, id: &str) -> Option<&T> {
        self.find(id).map(|place| &self[place])
    }

    /// The same, to be changed in all but its id.
    pub fn get_mut(&mut self, id: &str) -> Option<&mut T> {
        let place = self.find(id)?;
        Some(&mut self[place])
    }

    /// Whether there is a definition of an id.
    #[must_use]
    pub fn contains(&self, id: &str) -> bool {
        self.find(id).is_some()
    }

    /// The ids, sorted.
    pub fn ids(&self) -> impl Iterator<Item = &str> + Clone {
        self.0.iter().map(T::id)
    }

    /// All references, in the order of the ids.
    pub fn refs(&self) -> impl Iterator<Item = T::Ref> + use<T> {
        (0..self.0.len()).map(T::reference)
    }

    /// The definitions in the order of their ids.
    pub fn values(&self) -> impl Iterator<Item = &T> {
        self.0.iter()
    }

    /// The same, to be changed in all but their ids.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.0.iter_mut()
    }

    /// Number of definitions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<T: Definition> FromIterator<T> for ById<T> {
    /// From definitions whose ids differ, in any order.
    fn from_iter<I: IntoIterator<Item = T>>(definitions: I) -> Self {
        let mut all: Vec<T> = definitions.into_iter().collect();
        all.sort_by(|one, other| one.id().cmp(other.id()));
        Self(all)
    }
}

impl<T: Definition> Index<T::Ref> for ById<T> {
    type Output = T;

    fn index(&self, reference: T::Ref) -> &T {
        &self.0[T::place(reference)]
    }
}

impl<T: Definition> IndexMut<T::Ref> for ById<T> {
    fn index_mut(&mut self, reference: T::Ref) -> &mut T {
        &mut self.0[T::place(reference)]
    }
}

/// A style of a catalogue, as other definitions and furnished rooms name it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct StyleRef(usize);

/// A palette of a catalogue, as styles name it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct PaletteRef(usize);

impl Definition for Style {
    type Ref = StyleRef;

    fn reference(place: usize) -> StyleRef {
        StyleRef(place)
    }

    fn place(reference: StyleRef) -> usize {
        reference.0
    }

    fn id(&self) -> &str {
        &self.id
    }
}

impl Definition for Palette {
    type Ref = PaletteRef;

    fn reference(place: usize) -> PaletteRef {
        PaletteRef(place)
    }

    fn place(reference: PaletteRef) -> usize {
        reference.0
    }

    fn id(&self) -> &str {
        &self.id
    }
}
