//! OpenStreetMap in protocol buffers (wiki.openstreetmap.org/wiki/PBF_Format): blocks of elements, each compressed by itself.
//!
//! The crate `osmpbf` would save this file and `wire.rs`. It generates its messages from schemas while it is built, with two dozen
//! further crates, for five messages.

use std::borrow::Cow;
use std::io::Read;
use std::path::{Path, PathBuf};

use flate2::read::ZlibDecoder;

use super::elements::{Body, Element, ElementKind, Elements, Member, Pairs};
use super::wire::{Damaged, Fields, Numbers, Value, signed, summed};
use crate::disk::read_unpacked;
use crate::document::{FILE_SIZE_LIMIT, Fault, Faults};
use crate::geometry::Point;

/// Bytes of the largest header of a block, and of the largest block: the limits of the format.
const LARGEST: (usize, usize) = (64 * 1024, 32 * 1024 * 1024);
/// Bytes of all blocks together after unpacking.
const LARGEST_UNPACKED: u64 = 8 * 1024 * 1024 * 1024;
/// Bytes of all blocks after unpacking for each byte of the file, and for any file: real ones have three times their packed size.
const UNPACKED_SHARE: (u64, u64) = (20, 64 * 1024 * 1024);
/// Nodes of a way, members of a relation or tags of an element at most: the database allows 2,000, 32,000 and a few hundred.
const LONGEST_LIST: usize = 100_000;
/// Features that a file may require of its readers.
const FEATURES: [&[u8]; 2] = [b"OsmSchema-V0.6", b"DenseNodes"];
/// Parts of a degree in which places are counted.
const DEGREE_PARTS: f64 = 1e9;

/// The bytes of a file.
pub(in crate::plan::read) struct PbfFile {
    path: PathBuf,
    bytes: Vec<u8>,
}

/// Why a file cannot be read, in words.
struct Broken(String);

impl From<Damaged> for Broken {
    fn from(_: Damaged) -> Self {
        Self("it is cut off or damaged".to_owned())
    }
}

impl PbfFile {
    /// Reads the bytes of a file.
    ///
    /// # Errors
    /// A file that cannot be read, or is too large.
    pub(in crate::plan::read) fn open(path: &Path) -> Result<Self, Faults> {
        let bytes =
            read_unpacked(path, FILE_SIZE_LIMIT).map_err(|error| Fault::of_file(path, error.to_string()))?;
        Ok(Self { path: path.to_owned(), bytes })
    }

    fn each_block(&self, kind: ElementKind, visit: &mut dyn FnMut(Element<'_>)) -> Result<(), Broken> {
        let mut rest = self.bytes.as_slice();
        let mut unpacked = 0;
        let most = LARGEST_UNPACKED.min(UNPACKED_SHARE.0 * self.bytes.len() as u64 + UNPACKED_SHARE.1);
        while let Some((length, after)) = rest.split_at_checked(4).filter(|_| !rest.is_empty()) {
            let length = length.iter().fold(0_usize, |sum, byte| sum << 8 | usize::from(*byte));
            let (header, after) = split(after, length, LARGEST.0)?;
            let (name, size) = header_of(header)?;
            let (blob, after) = split(after, size, LARGEST.1)?;
            rest = after;
            let block = unpack(blob)?;
            unpacked += block.len() as u64;
            if unpacked > most {
                return Err(Broken(format!("unpacked, its blocks have more than {} MB", most >> 20)));
            }
            match name {
                b"OSMHeader" => check_features(&block)?,
                b"OSMData" => Block::of(&block)?.each(kind, visit)?,
                _ => {}
            }
        }
        if rest.is_empty() { Ok(()) } else { Err(Damaged.into()) }
    }
}

impl Elements for PbfFile {
    fn each(&self, kind: ElementKind, visit: &mut dyn FnMut(Element<'_>)) -> Result<(), Faults> {
        let fault = |Broken(reason)| Fault::of_file(&self.path, format!("cannot be read: {reason}")).into();
        self.each_block(kind, visit).map_err(fault)
    }

    fn fault(&self, _offset: u64, message: &str) -> Fault {
        Fault::of_file(&self.path, message)
    }
}

fn split(bytes: &[u8], length: usize, most: usize) -> Result<(&[u8], &[u8]), Broken> {
    bytes.split_at_checked(length).filter(|_| length <= most).ok_or(Damaged.into())
}

/// Name and size of a block.
fn header_of(header: &[u8]) -> Result<(&[u8], usize), Broken> {
    let (mut name, mut size) = (&[][..], None);
    for field in Fields::of(header) {
        match field? {
            (1, value) => name = value.bytes(),
            (3, value) => size = usize::try_from(value.number()).ok(),
            _ => {}
        }
    }
    Ok((name, size.ok_or(Damaged)?))
}

/// The bytes of a block.
fn unpack(blob: &[u8]) -> Result<Cow<'_, [u8]>, Broken> {
    for field in Fields::of(blob) {
        match field? {
            (1, value) => return Ok(Cow::Borrowed(value.bytes())),
            (3, value) => {
                let mut bytes = Vec::new();
                let most = LARGEST.1 as u64 + 1;
                let read = ZlibDecoder::new(value.bytes()).take(most).read_to_end(&mut bytes);
                return if read.is_ok() && bytes.len() <= LARGEST.1 {
                    Ok(Cow::Owned(bytes))
                } else {
                    Err(Damaged.into())
                };
            }
            (4..=7, _) => {
                let hint = "its blocks are not packed with zlib (`osmium cat -f pbf,pbf_compression=zlib` packs them anew)";
                return Err(Broken(hint.to_owned()));
            }
            _ => {}
        }
    }
    Ok(Cow::Borrowed(&[]))
}

fn check_length(list: &Numbers<'_>) -> Result<(), Broken> {
    if list.clone().take(LONGEST_LIST + 1).count() > LONGEST_LIST { Err(too_long()) } else { Ok(()) }
}

fn too_long() -> Broken {
    Broken(format!("an element of it has a list of more than {LONGEST_LIST} nodes, members or tags"))
}

fn check_features(header: &[u8]) -> Result<(), Broken> {
    for field in Fields::of(header) {
        let (number, value) = field?;
        if number == 4 && !FEATURES.contains(&value.bytes()) {
            let feature = String::from_utf8_lossy(value.bytes()).into_owned();
            return Err(Broken(format!("it requires the feature \"{feature}\", which is not read")));
        }
    }
    Ok(())
}

/// A block of elements.
struct Block<'a> {
    strings: Vec<&'a [u8]>,
    groups: Vec<&'a [u8]>,
    /// Billionths of a degree in a unit of the block.
    granularity: i64,
    /// Billionths of a degree that all longitudes and latitudes begin at.
    offset: (i64, i64),
}

impl<'a> Block<'a> {
    fn of(block: &'a [u8]) -> Result<Self, Broken> {
        let mut found = Self { strings: Vec::new(), groups: Vec::new(), granularity: 100, offset: (0, 0) };
        for field in Fields::of(block) {
            match field? {
                (1, value) => {
                    for text in Fields::of(value.bytes()) {
                        found.strings.push(text?.1.bytes());
                    }
                }
                (2, value) => found.groups.push(value.bytes()),
                (17, value) => found.granularity = value.number() as i64,
                (19, value) => found.offset.1 = value.number() as i64,
                (20, value) => found.offset.0 = value.number() as i64,
                _ => {}
            }
        }
        Ok(found)
    }

    fn each(&self, kind: ElementKind, visit: &mut dyn FnMut(Element<'_>)) -> Result<(), Broken> {
        for group in &self.groups {
            for field in Fields::of(group) {
                match (field?, kind) {
                    ((1, value), ElementKind::Node) => visit(self.element(value, kind)?),
                    ((2, value), ElementKind::Node) => self.each_dense(value.bytes(), visit)?,
                    ((3, value), ElementKind::Way) => visit(self.element(value, kind)?),
                    ((4, value), ElementKind::Relation) => visit(self.element(value, kind)?),
                    _ => {}
                }
            }
        }
        Ok(())
    }

    fn text(&self, index: u64) -> Cow<'a, str> {
        let bytes = usize::try_from(index).ok().and_then(|index| self.strings.get(index));
        String::from_utf8_lossy(bytes.copied().unwrap_or_default())
    }

    fn place(&self, longitude: i64, latitude: i64) -> Point {
        let degrees = |offset: i64, units: i64| {
            offset.wrapping_add(units.wrapping_mul(self.granularity)) as f64 / DEGREE_PARTS
        };
        Point::new(degrees(self.offset.0, longitude), degrees(self.offset.1, latitude))
    }

    /// A node that is not packed, a way or a relation: their fields have different numbers but for ids, keys and values.
    fn element(&self, message: Value<'a>, kind: ElementKind) -> Result<Element<'a>, Broken> {
        let empty = || Value::Bytes(&[]).numbers();
        let (mut id, mut keys, mut values) = (0, empty(), empty());
        // Roles, members and their kinds of a relation; latitude and longitude of a node; nodes of a way come first.
        let mut lists = [empty(), empty(), empty()];
        for field in Fields::of(message.bytes()) {
            match field? {
                (1, value) => id = value.number(),
                (2, value) => keys = value.numbers(),
                (3, value) => values = value.numbers(),
                (8, value) => lists[0] = value.numbers(),
                (9, value) => lists[1] = value.numbers(),
                (10, value) => lists[2] = value.numbers(),
                _ => {}
            }
        }
        let [first, second, third] = lists;
        for list in [&keys, &first, &second] {
            check_length(list)?;
        }
        let tags = keys.zip(values).map(|(key, value)| (self.text(key), self.text(value))).collect();
        let one = |mut numbers: Numbers<'_>| signed(numbers.next().unwrap_or_default());
        let (id, body) = match kind {
            ElementKind::Node => (signed(id), Body::Node(self.place(one(second), one(first)))),
            ElementKind::Way => (id as i64, Body::Way(summed(first).collect())),
            ElementKind::Relation => (id as i64, Body::Relation(self.members(first, second, third))),
        };
        Ok(Element { id, offset: 0, tags, body })
    }

    fn members(&self, roles: Numbers<'_>, ids: Numbers<'_>, kinds: Numbers<'_>) -> Vec<Member<'a>> {
        let member = |((role, id), kind): ((u64, i64), u64)| {
            let kind = match kind {
                0 => ElementKind::Node,
                1 => ElementKind::Way,
                _ => ElementKind::Relation,
            };
            Member { kind, id, role: self.text(role) }
        };
        roles.zip(summed(ids)).zip(kinds).map(member).collect()
    }

    /// Nodes packed as lists of differences; keys and values of all follow each other, with a zero behind those of a node.
    fn each_dense(&self, message: &'a [u8], visit: &mut dyn FnMut(Element<'_>)) -> Result<(), Broken> {
        let mut lists = [const { Value::Bytes(&[]) }; 4];
        for field in Fields::of(message) {
            match field? {
                (1, value) => lists[0] = value,
                (8, value) => lists[1] = value,
                (9, value) => lists[2] = value,
                (10, value) => lists[3] = value,
                _ => {}
            }
        }
        let [ids, latitudes, longitudes, tags] = lists.map(Value::numbers);
        let mut tags = tags;
        for ((id, latitude), longitude) in summed(ids).zip(summed(latitudes)).zip(summed(longitudes)) {
            let mut pairs = Pairs::new();
            while let Some(key) = tags.next().filter(|key| *key != 0) {
                if pairs.len() == LONGEST_LIST {
                    return Err(too_long());
                }
                pairs.push((self.text(key), self.text(tags.next().unwrap_or_default())));
            }
            visit(Element { id, offset: 0, tags: pairs, body: Body::Node(self.place(longitude, latitude)) });
        }
        Ok(())
    }
}
