//! Files of OpenStreetMap, in XML and in protocol buffers, as one stream of elements; for the readers of maps and of indoor plans.
//!
//! ```text
//! XmlFile::open(path)  ─┐
//! PbfFile::open(path)  ─┴─▶ Elements::each(kind, visit): all relations, ways or nodes, in the order of the file
//! areas_of([outer, inner], nodes_of, places) -> the areas of a multipolygon
//! ```

mod areas;
mod elements;
mod pbf;
mod places;
mod rings;
mod wire;
mod xml;

/// By which the contributors of the map ask to be named (openstreetmap.org/copyright).
pub(super) const ATTRIBUTION: &str = "© OpenStreetMap contributors, ODbL 1.0";

pub(super) use areas::{INCOMPLETE, areas_of, holds};
pub(super) use elements::{Body, Element, ElementKind, Elements};
pub(super) use pbf::PbfFile;
pub(super) use places::Places;
pub(super) use xml::XmlFile;
