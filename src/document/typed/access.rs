//! The parts of lists, mappings and variants, one after the other.

use std::slice::Iter;

use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error, MapAccess, SeqAccess, VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;

use super::{Mismatch, deserialize_named};
use crate::document::node::{Entry, Node};

/// The items of a list.
pub(super) struct Items<'n> {
    items: Iter<'n, Node>,
    index: usize,
}

impl<'n> Items<'n> {
    pub(super) fn of(items: Iter<'n, Node>) -> Self {
        Self { items, index: 0 }
    }
}

impl<'de> SeqAccess<'de> for Items<'_> {
    type Error = Mismatch;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Mismatch> {
        let Some(node) = self.items.next() else { return Ok(None) };
        let index = self.index;
        self.index += 1;
        seed.deserialize(node).map(Some).map_err(|mismatch| mismatch.below(index.into()))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len())
    }
}

/// The entries of a mapping.
pub(super) struct Entries<'n> {
    entries: Iter<'n, Entry>,
    entry: Option<&'n Entry>,
}

impl<'n> Entries<'n> {
    pub(super) fn of(entries: Iter<'n, Entry>) -> Self {
        Self { entries, entry: None }
    }
}

impl<'de> MapAccess<'de> for Entries<'_> {
    type Error = Mismatch;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Mismatch> {
        self.entry = self.entries.next();
        let Some(entry) = self.entry else { return Ok(None) };
        seed.deserialize(Key(&entry.key))
            .map(Some)
            .map_err(|mismatch| mismatch.below(entry.key.as_str().into()))
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Mismatch> {
        let entry = self.entry.take().expect("serde asks for a key before its value");
        seed.deserialize(&entry.value).map_err(|mismatch| mismatch.below(entry.key.as_str().into()))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.entries.len())
    }
}

/// The key of a mapping, or the name of a variant.
struct Key<'n>(&'n str);

impl<'n> Key<'n> {
    fn variant(&self) -> Result<Variant<'n>, Mismatch> {
        Ok(Variant { name: self.0, value: None })
    }
}

impl<'de> Deserializer<'de> for Key<'_> {
    type Error = Mismatch;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        visitor.visit_str(self.0)
    }

    deserialize_named!();

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct seq
        tuple tuple_struct map struct identifier ignored_any
    }
}

/// A word alone, or with a value behind it.
pub(super) struct Variant<'n> {
    pub(super) name: &'n str,
    pub(super) value: Option<&'n Node>,
}

impl<'n> Variant<'n> {
    fn value(&self) -> Result<&'n Node, Mismatch> {
        self.value.ok_or_else(|| Mismatch::custom(format_args!("\"{}\" needs a value", self.name)))
    }

    fn inside<T>(&self, result: Result<T, Mismatch>) -> Result<T, Mismatch> {
        result.map_err(|mismatch| mismatch.below(self.name.into()))
    }
}

impl<'de, 'n> EnumAccess<'de> for Variant<'n> {
    type Error = Mismatch;
    type Variant = Self;

    fn variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<(S::Value, Self), Mismatch> {
        Ok((seed.deserialize(Key(self.name))?, self))
    }
}

impl<'de> VariantAccess<'de> for Variant<'_> {
    type Error = Mismatch;

    fn unit_variant(self) -> Result<(), Mismatch> {
        match self.value {
            Some(value) if !value.is_null() => self.inside(Err(value.mismatch(&"nothing"))),
            _ => Ok(()),
        }
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Mismatch> {
        self.inside(seed.deserialize(self.value()?))
    }

    fn tuple_variant<V: Visitor<'de>>(self, count: usize, visitor: V) -> Result<V::Value, Mismatch> {
        self.inside(self.value()?.deserialize_tuple(count, visitor))
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Mismatch> {
        self.inside(self.value()?.deserialize_map(visitor))
    }
}
