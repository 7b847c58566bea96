//! OpenStreetMap in XML, as its interface, Overpass and editors write it.

use std::borrow::Cow;
use std::path::Path;

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use super::elements::{Body, Element, ElementKind, Elements, Member};
use crate::document::{Fault, Faults, Source};
use crate::geometry::Point;

/// The text of a file.
pub(in crate::plan::read) struct XmlFile {
    source: Source,
}

impl XmlFile {
    /// Reads the text of a file.
    ///
    /// # Errors
    /// A file that cannot be read, or is no text.
    pub(in crate::plan::read) fn open(path: &Path) -> Result<Self, Faults> {
        Ok(Self { source: Source::read(path)? })
    }
}

impl Elements for XmlFile {
    fn each(&self, kind: ElementKind, visit: &mut dyn FnMut(Element<'_>)) -> Result<(), Faults> {
        let mut reader = Reader::from_str(self.source.text());
        let mut current: Option<Element<'_>> = None;
        let mut is_closed = false;
        loop {
            let offset = reader.buffer_position();
            let event = reader.read_event().map_err(|error| {
                Faults::from(self.fault(reader.error_position(), &format!("is no sound XML: {error}")))
            })?;
            match event {
                Event::Start(start) => begin(&start, (kind, offset), &mut current),
                Event::Empty(start) => {
                    begin(&start, (kind, offset), &mut current);
                    if kind_of(start.name().as_ref()) == Some(kind) {
                        current.take().map(&mut *visit);
                    }
                }
                Event::End(end) if kind_of(end.name().as_ref()) == Some(kind) => {
                    current.take().map(&mut *visit);
                }
                Event::End(end) => is_closed |= end.name().as_ref() == "osm",
                Event::Eof => break,
                _ => {}
            }
        }
        if is_closed {
            return Ok(());
        }
        let end = self.source.text().len() as u64;
        Err(self.fault(end, "the file is cut off: its element \"osm\" has no end").into())
    }

    fn fault(&self, offset: u64, message: &str) -> Fault {
        let text = self.source.text();
        let mut offset = usize::try_from(offset).unwrap_or(usize::MAX).min(text.len());
        while !text.is_char_boundary(offset) {
            offset -= 1;
        }
        let before = &text[..offset];
        let line = before.bytes().filter(|byte| *byte == b'\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        self.source.fault_at(Some((line, column)), message)
    }
}

fn kind_of(name: &str) -> Option<ElementKind> {
    match name {
        "node" => Some(ElementKind::Node),
        "way" => Some(ElementKind::Way),
        "relation" => Some(ElementKind::Relation),
        _ => None,
    }
}

/// Begins an element of the kind, or adds to the current one.
fn begin<'a>(start: &BytesStart<'a>, (kind, offset): (ElementKind, u64), current: &mut Option<Element<'a>>) {
    let name = start.name();
    match (name.as_ref(), current) {
        (name, current) if kind_of(name).is_some() => {
            *current = if kind_of(name) == Some(kind) { element(start, kind, offset) } else { None };
        }
        ("tag", Some(element)) => {
            if let [Some(key), Some(value)] = values(start, ["k", "v"]) {
                element.tags.push((key, value));
            }
        }
        ("nd", Some(Element { body: Body::Way(nodes), .. })) => {
            let [node] = values(start, ["ref"]);
            nodes.extend(node.and_then(|node| node.parse::<i64>().ok()));
        }
        ("member", Some(Element { body: Body::Relation(members), .. })) => members.extend(member(start)),
        _ => {}
    }
}

/// The element without what stands in it; `None` of one that was deleted or has no id.
fn element<'a>(start: &BytesStart<'a>, kind: ElementKind, offset: u64) -> Option<Element<'a>> {
    let [id, latitude, longitude, visible, action] = values(start, ["id", "lat", "lon", "visible", "action"]);
    if visible.as_deref() == Some("false") || action.as_deref() == Some("delete") {
        return None;
    }
    let degrees =
        |text: Option<Cow<'_, str>>| text.and_then(|text| text.parse::<f64>().ok()).filter(|n| n.is_finite());
    let body = match kind {
        ElementKind::Node => Body::Node(Point::new(degrees(longitude)?, degrees(latitude)?)),
        ElementKind::Way => Body::Way(Vec::new()),
        ElementKind::Relation => Body::Relation(Vec::new()),
    };
    Some(Element { id: id?.parse().ok()?, offset, tags: Vec::new(), body })
}

fn member<'a>(start: &BytesStart<'a>) -> Option<Member<'a>> {
    let [kind, id, role] = values(start, ["type", "ref", "role"]);
    Some(Member { kind: kind_of(&kind?)?, id: id?.parse().ok()?, role: role.unwrap_or_default() })
}

/// The values of some attributes; those that cannot be read are none.
fn values<'a, const COUNT: usize>(
    start: &BytesStart<'a>,
    names: [&str; COUNT],
) -> [Option<Cow<'a, str>>; COUNT] {
    let mut values = [const { None }; COUNT];
    for attribute in start.attributes().with_checks(false).flatten() {
        if let Some(index) = names.iter().position(|name| attribute.key.as_ref() == *name) {
            let value = attribute.normalized_value(XmlVersion::Implicit1_0);
            values[index] = value.ok().map(|value| Cow::Owned(value.into_owned()));
        }
    }
    values
}
