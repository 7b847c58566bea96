//! One value of a document, with the place of every key and value in it.

use serde_json::Value;

use super::fault::PathStep;

/// Line and column, both from 1; 0 where they were not looked for.
pub(super) type Position = (usize, usize);

/// One value and its place.
#[derive(Clone, Debug)]
pub(super) struct Node {
    /// Its first letter; that of the first key for a mapping without braces.
    pub(super) position: Position,
    /// The content.
    pub(super) content: Content,
}

/// The content of a [`Node`].
#[derive(Clone, Debug)]
pub(super) enum Content {
    /// A single value.
    Scalar {
        /// The value.
        value: Value,
        /// How it is spelled.
        spelling: Spelling,
    },
    /// A list.
    Sequence(Vec<Node>),
    /// A mapping, in the order of the file.
    Mapping(Vec<Entry>),
}

/// How a single value is spelled.
#[derive(Clone, Debug)]
pub(super) enum Spelling {
    /// In JSON, where a value has one type only.
    Json,
    /// As a text of YAML, which may stand for a number or a boolean as well.
    Text,
    /// As this unquoted word of YAML that means something else, but may stand for a text as well.
    Word(Box<str>),
}

/// A key and its value.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// The key.
    pub(super) key: String,
    /// Where the key stands.
    pub(super) key_position: Position,
    /// The value.
    pub(super) value: Node,
}

impl Node {
    /// The value without places. Not deeper than the limit on depth, for the tree is not.
    pub(super) fn to_value(&self) -> Value {
        match &self.content {
            Content::Scalar { value, .. } => value.clone(),
            Content::Sequence(items) => Value::Array(items.iter().map(Self::to_value).collect()),
            Content::Mapping(entries) => Value::Object(
                entries.iter().map(|entry| (entry.key.clone(), entry.value.to_value())).collect(),
            ),
        }
    }

    /// The value at a path, if it exists.
    pub(super) fn find(&self, path: &[PathStep]) -> Option<&Self> {
        path.iter().try_fold(self, |node, step| node.child(step).map(|(_, child)| child))
    }

    /// Where to point for a path: at its value if that begins on the line of its key, else at the key; at
    /// the nearest value around it if there is nothing at the path.
    pub(super) fn locate(&self, path: &[PathStep]) -> Position {
        let (mut node, mut position) = (self, self.position);
        for step in path {
            let Some((key_position, child)) = node.child(step) else { break };
            let same_line = key_position.is_none_or(|key| key.0 == child.position.0);
            position = if same_line { child.position } else { key_position.unwrap_or(child.position) };
            node = child;
        }
        position
    }

    /// Where the key at the end of a path stands, if the path exists and ends with a key.
    pub(super) fn locate_key(&self, path: &[PathStep]) -> Option<Position> {
        let (last, parents) = path.split_last()?;
        self.find(parents)?.child(last)?.0
    }

    fn child(&self, step: &PathStep) -> Option<(Option<Position>, &Self)> {
        match (&self.content, step) {
            (Content::Sequence(items), PathStep::Index(index)) => items.get(*index).map(|item| (None, item)),
            (Content::Mapping(entries), PathStep::Key(key)) => {
                let entry = entries.iter().find(|entry| entry.key == *key)?;
                Some((Some(entry.key_position), &entry.value))
            }
            _ => None,
        }
    }

    pub(super) fn count(&self) -> usize {
        1 + match &self.content {
            Content::Scalar { .. } => 0,
            Content::Sequence(items) => items.iter().map(Self::count).sum(),
            Content::Mapping(entries) => entries.iter().map(|entry| entry.value.count()).sum(),
        }
    }
}
