//! Reads a document into a tree that knows the place of every key and value. JSON is read as YAML, of which it is a part.

use std::collections::BTreeMap;

use granit_parser::{Event, Marker, Options, Parser, ScalarStyle, StructureStyle};
use serde_json::Value;

use super::fault::PathStep;
use super::limits::{DEPTH_LIMIT, VALUE_LIMIT};
use super::node::{Content, Entry, Node, Position, Spelling};
use super::scalar::{Plain, resolve};
use super::unique::UniqueKeys;

/// Something wrong with a document whatever it is to mean: a key named twice, an infinite number.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Flaw {
    /// Where in the text.
    pub(super) position: Position,
    /// Where in the document.
    pub(super) path: Vec<PathStep>,
    /// The fact.
    pub(super) message: String,
    /// Advice for the user.
    pub(super) hint: Option<&'static str>,
}

/// A document without syntax errors.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    /// The document; null for an empty file.
    pub(super) root: Node,
    /// Faults that do not keep the text from being read.
    pub(super) flaws: Vec<Flaw>,
}

impl Tree {
    /// Reads a text.
    ///
    /// # Errors
    /// The first flaw that ends the reading: a syntax error or a bound of [`super::limits`].
    pub(super) fn parse(text: &str) -> Result<Self, Flaw> {
        let mut builder = Builder::default();
        for event in Parser::new_from_str_with_options(text, parser_options()) {
            let (event, span) = event.map_err(|error| Flaw {
                position: place(error.marker()),
                path: builder.path(),
                message: error.info().to_string(),
                hint: Some(match error.info().contains("tab") {
                    true => "indent with spaces, not tabs",
                    false => "is an indent, a bracket or a quote missing here or above?",
                }),
            })?;
            builder.take(event, place(&span.start))?;
        }
        let nothing = Content::Scalar { value: Value::Null, spelling: Spelling::Word("".into()) };
        let empty = Node { position: (1, 1), content: nothing };
        Ok(Self { root: builder.root.unwrap_or(empty), flaws: builder.flaws })
    }
}

fn parser_options() -> Options {
    let mut options = Options::default();
    options.set_emit_comments(false);
    options
}

fn place(marker: &Marker) -> Position {
    (marker.line().max(1), marker.col() + 1)
}

/// An unfinished list or mapping.
struct Frame {
    position: Position,
    anchor: usize,
    content: Content,
    /// The key that waits for its value, in a mapping.
    key: Option<(String, Position)>,
    /// The keys so far, in a mapping.
    keys: UniqueKeys,
}

#[derive(Default)]
struct Builder {
    frames: Vec<Frame>,
    root: Option<Node>,
    flaws: Vec<Flaw>,
    anchors: BTreeMap<usize, Node>,
    count: usize,
}

impl Builder {
    fn take(&mut self, event: Event<'_>, position: Position) -> Result<(), Flaw> {
        match event {
            Event::Scalar(text, style, anchor, _) => {
                let node = self.scalar(&text, style, position);
                self.finish(node, anchor)
            }
            Event::SequenceStart(_, anchor, _) => self.open(Content::Sequence(Vec::new()), anchor, position),
            Event::MappingStart(style, anchor, _) => {
                debug_assert!(matches!(style, StructureStyle::Block | StructureStyle::Flow));
                self.open(Content::Mapping(Vec::new()), anchor, position)
            }
            Event::SequenceEnd | Event::MappingEnd => match self.frames.pop() {
                Some(frame) => {
                    let node = Node { position: frame.position, content: frame.content };
                    self.finish(node, frame.anchor)
                }
                None => Ok(()),
            },
            Event::Alias(anchor) => match self.anchors.get(&anchor) {
                Some(node) if self.count + node.count() <= VALUE_LIMIT => {
                    let node = Node { position, content: node.content.clone() };
                    self.count += node.count();
                    self.finish(node, 0)
                }
                Some(_) => Err(self.flaw(position, too_many())),
                None => Err(self.flaw(position, "an alias stands inside the very value it names".to_owned())),
            },
            Event::DocumentStart(..) if self.root.is_some() => {
                Err(self
                    .flaw(position, "a second document begins here; one file holds one document".to_owned()))
            }
            _ => Ok(()),
        }
    }

    fn scalar(&mut self, text: &str, style: ScalarStyle, position: Position) -> Node {
        let is_text = style != ScalarStyle::Plain || self.awaits_key();
        let resolved = if is_text { Plain::Value(Value::String(text.to_owned())) } else { resolve(text) };
        let value = match resolved {
            Plain::Value(value) => value,
            Plain::NotFinite => {
                let flaw = self.flaw(position, format!("{text} is not a finite number"));
                self.flaws.push(flaw);
                Value::from(0.0)
            }
        };
        let spelling = if value.is_string() { Spelling::Text } else { Spelling::Word(text.into()) };
        Node { position, content: Content::Scalar { value, spelling } }
    }

    fn open(&mut self, content: Content, anchor: usize, position: Position) -> Result<(), Flaw> {
        if self.frames.len() >= DEPTH_LIMIT {
            return Err(self.flaw(position, format!("nested deeper than {DEPTH_LIMIT} levels")));
        }
        self.frames.push(Frame { position, anchor, content, key: None, keys: UniqueKeys::default() });
        Ok(())
    }

    fn finish(&mut self, node: Node, anchor: usize) -> Result<(), Flaw> {
        self.count += 1;
        if self.count > VALUE_LIMIT {
            return Err(self.flaw(node.position, too_many()));
        }
        if anchor != 0 {
            self.count += node.count();
            self.anchors.insert(anchor, node.clone());
        }
        let awaits_key = self.awaits_key();
        match self.frames.last_mut() {
            None => self.root = Some(node),
            Some(Frame { content: Content::Sequence(items), .. }) => items.push(node),
            Some(_) if awaits_key => self.take_key(node),
            Some(frame) => {
                if let (Content::Mapping(entries), Some((key, key_position))) =
                    (&mut frame.content, frame.key.take())
                {
                    entries.push(Entry { key, key_position, value: node });
                }
            }
        }
        Ok(())
    }

    fn take_key(&mut self, node: Node) {
        let Content::Scalar { value: Value::String(key), .. } = node.content else {
            let flaw = self.flaw(node.position, "a key must be a word".to_owned());
            self.flaws.push(flaw);
            return self.take_word("?".to_owned(), node.position);
        };
        self.take_word(key, node.position);
    }

    fn take_word(&mut self, key: String, position: Position) {
        let Some(Frame { content: Content::Mapping(entries), keys, .. }) = self.frames.last_mut() else {
            return;
        };
        if !keys.insert(entries, &key) {
            let earlier = entries.iter().find(|entry| entry.key == key);
            let line = earlier.map_or(position.0, |entry| entry.key_position.0);
            let mut flaw = self.flaw(position, format!("duplicate key \"{key}\", first in line {line}"));
            flaw.hint = Some("keep one of them");
            self.flaws.push(flaw);
        }
        if key == "<<" {
            let mut flaw = self.flaw(position, "merge keys (<<) are not supported".to_owned());
            flaw.hint = Some("write the keys out, or use what the format has for it (extends, prototypes)");
            self.flaws.push(flaw);
        }
        let frame = self.frames.last_mut().expect("a key stands in a mapping");
        frame.key = Some((key, position));
    }

    fn awaits_key(&self) -> bool {
        self.frames
            .last()
            .is_some_and(|frame| matches!(frame.content, Content::Mapping(_)) && frame.key.is_none())
    }

    fn flaw(&self, position: Position, message: String) -> Flaw {
        Flaw { position, path: self.path(), message, hint: None }
    }

    /// The path of the value that is being read.
    fn path(&self) -> Vec<PathStep> {
        let step = |frame: &Frame| match &frame.content {
            Content::Sequence(items) => Some(PathStep::Index(items.len())),
            _ => frame.key.as_ref().map(|(key, _)| PathStep::Key(key.clone())),
        };
        self.frames.iter().filter_map(step).collect()
    }
}

fn too_many() -> String {
    format!("the document holds more than {VALUE_LIMIT} values, aliases counted each time")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    const PLAN: &str = "levels:\n  - id: ground\n    rooms:\n      - {id: hall, size: [1, 2.5]}\n";

    #[test]
    fn values_are_those_of_the_text() {
        let tree = Tree::parse(PLAN).unwrap();
        let expected = json!({"levels": [{"id": "ground", "rooms": [{"id": "hall", "size": [1, 2.5]}]}]});
        assert_eq!(tree.root.to_value(), expected);
        assert!(tree.flaws.is_empty());
    }

    #[test]
    fn json_is_read_too() {
        let tree = Tree::parse("{\n\t\"a\": [1, {\"b\": \"x\\n\\u00e9\\/\"}],\n\t\"c\": null\n}").unwrap();
        assert_eq!(tree.root.to_value(), json!({"a": [1, {"b": "x\né/"}], "c": null}));
        assert_eq!(tree.root.locate(&["a".into(), 1.into(), "b".into()]), (2, 17));
    }

    #[test]
    fn a_path_points_at_the_value_or_at_its_key() {
        let root = Tree::parse(PLAN).unwrap().root;
        let rooms = ["levels".into(), 0.into(), "rooms".into()];
        assert_eq!(root.locate(&rooms), (3, 5), "the list begins on a later line than its key");
        let width = [&rooms[..], &[0.into(), "size".into(), 1.into()]].concat();
        assert_eq!(root.locate(&width), (4, 30));
        let missing = [&rooms[..], &[0.into(), "height".into()]].concat();
        assert_eq!(root.locate(&missing), (4, 9), "the mapping that lacks the key");
    }

    #[test]
    fn duplicate_keys_and_infinite_numbers_are_flaws() {
        let tree = Tree::parse("a: 1\nb: {c: .nan}\na: 2\n").unwrap();
        let messages: Vec<&str> = tree.flaws.iter().map(|flaw| flaw.message.as_str()).collect();
        assert_eq!(messages, [".nan is not a finite number", "duplicate key \"a\", first in line 1"]);
        assert_eq!(tree.flaws[0].path, ["b".into(), "c".into()]);
        assert_eq!(tree.flaws[1].position, (3, 1));
    }

    #[test]
    fn many_keys_of_a_mapping_take_time_by_their_number() {
        let text = |count: usize| (0..count).map(|key| format!("k{key}: 1\n")).collect::<String>();
        let parse = |text: String| assert!(Tree::parse(&text).unwrap().flaws.is_empty());
        let power = crate::growth::growth(2_000, 8, 1.3, text, parse);
        assert!(power < 1.3, "{power}");
    }

    #[test]
    fn aliases_are_bounded() {
        let mut bomb = String::from("a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n");
        for level in 1..12 {
            let aliases = vec![format!("*a{}", level - 1); 10].join(", ");
            bomb.push_str(&format!("a{level}: &a{level} [{aliases}]\n"));
        }
        assert!(Tree::parse(&bomb).unwrap_err().message.contains("more than"));
        assert!(Tree::parse("a: &a [1, *a]").is_err());
        let twice = Tree::parse("a: &a {b: 1}\nc: *a\n").unwrap();
        assert_eq!(twice.root.to_value(), json!({"a": {"b": 1}, "c": {"b": 1}}));
    }

    #[test]
    fn deep_nesting_is_refused() {
        assert!(Tree::parse(&"[".repeat(10_000)).is_err());
        assert!(Tree::parse(&"- ".repeat(10_000)).is_err());
    }

    #[test]
    fn syntax_errors_have_a_place() {
        let flaw = Tree::parse("a: [1, 2\nb: 3\n").unwrap_err();
        assert!(flaw.position.0 >= 1 && !flaw.message.is_empty(), "{flaw:?}");
    }
}
