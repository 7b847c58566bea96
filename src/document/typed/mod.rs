//! Reads a typed value from a document in memory.
//!
//! YAML and JSON share this one deserializer: for each type of a file, the compiler makes its code once, and from functions that are
//! as small as may be.

mod access;
mod mismatch;
#[cfg(test)]
mod tests;

use std::slice::Iter;

use serde::de::{DeserializeOwned, Deserializer, Error, Expected, Unexpected, Visitor};
use serde::forward_to_deserialize_any;
use serde_json::Value;

use self::access::{Entries, Items, Variant};
pub(super) use self::mismatch::Mismatch;
use super::node::{Content, Entry, Node, Spelling};
use super::scalar::{Plain, resolve};

/// The value of a document.
///
/// # Errors
/// If it is not of this type.
pub(super) fn typed<T: DeserializeOwned>(root: &Node) -> Result<T, Mismatch> {
    T::deserialize(root)
}

impl Node {
    #[cold]
    fn mismatch(&self, expected: &dyn Expected) -> Mismatch {
        let found = match &self.content {
            Content::Scalar { value, .. } => unexpected(value),
            Content::Sequence(_) => Unexpected::Seq,
            Content::Mapping(_) => Unexpected::Map,
        };
        Mismatch::invalid_type(found, expected)
    }

    /// The text that the value is or, in YAML, may stand for.
    fn text(&self) -> Option<&str> {
        match &self.content {
            Content::Scalar { value: Value::Null, .. } => None,
            Content::Scalar { spelling: Spelling::Word(word), .. } => Some(word),
            Content::Scalar { value, .. } => value.as_str(),
            _ => None,
        }
    }

    /// The value that is no text, also of a text in quotes where YAML lets it stand for one.
    fn untexted(&self) -> Option<Value> {
        let Content::Scalar { value, spelling } = &self.content else { return None };
        match (value, spelling) {
            (Value::String(text), Spelling::Text) => match resolve(text.trim_ascii()) {
                Plain::Value(value) => Some(value),
                Plain::NotFinite => None,
            },
            _ => Some(value.clone()),
        }
    }

    /// The items; those of nothing are none in YAML.
    fn items(&self) -> Option<Iter<'_, Node>> {
        match &self.content {
            Content::Sequence(items) => Some(items.iter()),
            _ => self.is_empty_word().then(|| [].iter()),
        }
    }

    /// The entries; those of nothing are none in YAML.
    fn entries(&self) -> Option<Iter<'_, Entry>> {
        match &self.content {
            Content::Mapping(entries) => Some(entries.iter()),
            _ => self.is_empty_word().then(|| [].iter()),
        }
    }

    /// The word that the value is, or the one key of a mapping with the value behind it.
    fn variant(&self) -> Result<Variant<'_>, Mismatch> {
        match (&self.content, self.text()) {
            (Content::Mapping(entries), _) if entries.len() == 1 => {
                Ok(Variant { name: &entries[0].key, value: Some(&entries[0].value) })
            }
            (_, Some(name)) => Ok(Variant { name, value: None }),
            _ => Err(self.mismatch(&"a word or a mapping of one key")),
        }
    }

    fn is_null(&self) -> bool {
        matches!(&self.content, Content::Scalar { value: Value::Null, .. })
    }

    fn is_empty_word(&self) -> bool {
        matches!(&self.content, Content::Scalar { value: Value::Null, spelling: Spelling::Word(_) })
    }
}

fn unexpected(value: &Value) -> Unexpected<'_> {
    match value {
        Value::Bool(found) => Unexpected::Bool(*found),
        Value::Number(number) => match (number.as_u64(), number.as_i64()) {
            (Some(found), _) => Unexpected::Unsigned(found),
            (None, Some(found)) => Unexpected::Signed(found),
            (None, None) => Unexpected::Float(number.as_f64().unwrap_or_default()),
        },
        Value::String(found) => Unexpected::Str(found),
        _ => Unexpected::Unit,
    }
}

fn visit_scalar<'de, V: Visitor<'de>>(value: &Value, visitor: V) -> Result<V::Value, Mismatch> {
    match value {
        Value::Bool(found) => visitor.visit_bool(*found),
        Value::Number(number) => match (number.as_u64(), number.as_i64()) {
            (Some(found), _) => visitor.visit_u64(found),
            (None, Some(found)) => visitor.visit_i64(found),
            (None, None) => visitor.visit_f64(number.as_f64().unwrap_or_default()),
        },
        Value::String(found) => visitor.visit_str(found),
        _ => visitor.visit_unit(),
    }
}

/// The whole number that a decimal one is, as `1e9`; others as they are.
fn whole(value: Value) -> Value {
    /// The largest below which each whole number is a decimal one.
    const EXACT: f64 = 9_007_199_254_740_992.0;
    match value.as_f64() {
        Some(number) if value.is_f64() && number.fract() == 0.0 && number.abs() < EXACT => {
            Value::from(number as i64)
        }
        _ => value,
    }
}

/// Reading what is no text: from the value itself, or from the text that stands for it.
macro_rules! deserialize_untexted {
    ($read:expr => $($method:ident)*) => {
        $(fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
            match self.untexted().map($read) {
                Some(value) => visit_scalar(&value, visitor),
                None => Err(self.mismatch(&visitor)),
            }
        })*
    };
}

/// Reading types with a name: a newtype is what it holds, an enum is read from the variant. For values and for keys.
macro_rules! deserialize_named {
    () => {
        fn deserialize_newtype_struct<V: Visitor<'de>>(
            self,
            _: &'static str,
            visitor: V,
        ) -> Result<V::Value, Mismatch> {
            visitor.visit_newtype_struct(self)
        }

        fn deserialize_enum<V: Visitor<'de>>(
            self,
            _: &'static str,
            _: &'static [&'static str],
            visitor: V,
        ) -> Result<V::Value, Mismatch> {
            visitor.visit_enum(self.variant()?)
        }
    };
}
use deserialize_named;

impl<'de> Deserializer<'de> for &Node {
    type Error = Mismatch;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        match &self.content {
            Content::Scalar { value, .. } => visit_scalar(value, visitor),
            Content::Sequence(_) => self.deserialize_seq(visitor),
            Content::Mapping(_) => self.deserialize_map(visitor),
        }
    }

    deserialize_untexted! {
        whole => deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_i128 deserialize_u8
        deserialize_u16 deserialize_u32 deserialize_u64 deserialize_u128
    }
    deserialize_untexted! { std::convert::identity => deserialize_bool deserialize_f32 deserialize_f64 }

    deserialize_named!();

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        match self.text() {
            Some(text) => visitor.visit_str(text),
            None => Err(self.mismatch(&visitor)),
        }
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        self.deserialize_str(visitor)
    }

    fn deserialize_char<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        self.deserialize_str(visitor)
    }

    fn deserialize_identifier<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        self.deserialize_str(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        if self.is_null() { visitor.visit_none() } else { visitor.visit_some(self) }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        let Some(items) = self.items() else { return Err(self.mismatch(&visitor)) };
        visitor.visit_seq(Items::of(items))
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, count: usize, visitor: V) -> Result<V::Value, Mismatch> {
        let Some(items) = self.items() else { return Err(self.mismatch(&visitor)) };
        if items.len() > count {
            return Err(Mismatch::invalid_length(items.len(), &visitor));
        }
        visitor.visit_seq(Items::of(items))
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        count: usize,
        visitor: V,
    ) -> Result<V::Value, Mismatch> {
        self.deserialize_tuple(count, visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        let Some(entries) = self.entries() else { return Err(self.mismatch(&visitor)) };
        visitor.visit_map(Entries::of(entries))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Mismatch> {
        self.deserialize_map(visitor)
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Mismatch> {
        visitor.visit_unit()
    }

    forward_to_deserialize_any! { bytes byte_buf unit unit_struct }
}
