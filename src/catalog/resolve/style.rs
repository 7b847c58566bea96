//! Resolves styles.

use std::collections::BTreeMap;

use super::names::Names;
use super::number::{ANGLE, FACTOR, Quantity, check_wealth};
use super::request::{ResolvedProgramme, resolve_programme};
use super::{merged_keys, resolve_label};
use crate::catalog::file::{PaletteEntry, RequestEntry, RoomTypeEntry, StyleEntry};
use crate::catalog::report::{Report, Spot};
use crate::catalog::table::{Chain, Table};
use crate::catalog::{Access, ById, Palette, PaletteRef, Request, Style, Untidiness};
use crate::recipes::GeometrySet;

/// The palette of a style that names none.
const DEFAULT_PALETTE: &str = "modern";
/// Metres of untidiness beyond which nothing is where it belongs.
const LARGEST_UNTIDINESS: f64 = 5.0;

/// Lines by room type, as written.
type Programmes = BTreeMap<String, Vec<RequestEntry>>;

/// The definitions that a style may refer to.
pub(crate) struct StyleWorld<'a> {
    /// The classes.
    pub(crate) names: &'a Names<'a>,
    /// The room types.
    pub(crate) room_types: &'a Table<RoomTypeEntry>,
    /// The palettes as written.
    pub(crate) palette_table: &'a Table<PaletteEntry>,
    /// Those that are not broken.
    pub(crate) palettes: &'a ById<Palette>,
}

/// Lines that a style writes for a room type.
pub(crate) struct StyleLines {
    /// The room type.
    pub(crate) room_type: String,
    /// Id of the style that writes them: this one or one that it extends.
    pub(crate) written_by: String,
    /// Whether they stand beside the room type's own lines instead of replacing them.
    pub(crate) is_addition: bool,
    /// Where they are written.
    pub(crate) spot: Spot,
    /// The lines.
    pub(crate) programme: ResolvedProgramme,
}

/// A style and the lines that it was made of.
pub(crate) struct ResolvedStyle {
    /// The style.
    pub(crate) style: Style,
    /// Its programmes and additions.
    pub(crate) lines: Vec<StyleLines>,
}

/// All styles that are not broken, sorted by id.
pub(crate) fn resolve_styles(
    chains: &[Chain<'_, StyleEntry>],
    world: &StyleWorld<'_>,
    report: &mut Report<'_>,
) -> Vec<ResolvedStyle> {
    chains.iter().map(|chain| resolve_style(chain, world, report)).collect()
}

fn resolve_style(
    chain: &Chain<'_, StyleEntry>,
    world: &StyleWorld<'_>,
    report: &mut Report<'_>,
) -> ResolvedStyle {
    let mut lines = resolve_lines(chain, false, world, report);
    let programmes = by_room_type(&lines);
    let additions = resolve_lines(chain, true, world, report);
    let density = chain.find("density", |entry| entry.density.as_ref());
    let style = Style {
        id: chain.own().id.clone(),
        label: resolve_label(chain, |entry| entry.label.as_ref()),
        room_types: resolve_room_type_names(chain, world, report),
        programmes,
        additions: by_room_type(&additions),
        geometry: resolve_geometry(chain, report),
        palette: resolve_palette_reference(chain, world, report),
        untidiness: resolve_untidiness(chain, report),
        density: density
            .map_or(1.0, |found| Quantity::plain("density", FACTOR).check(*found.value, &found.spot, report)),
        access: chain
            .find("access", |entry| entry.access.as_ref())
            .map_or_else(Access::default, |found| *found.value),
        era: chain.find("era", |entry| entry.era.as_ref()).map(|found| *found.value),
        wealth: chain
            .find("wealth", |entry| entry.wealth.as_ref())
            .map(|found| check_wealth(*found.value as f64, &found.spot, report)),
    };
    lines.extend(additions);
    warn_of_idle_lines(&style, &lines, report);
    ResolvedStyle { style, lines }
}

/// Lines for a room type that the style is not made for. Inherited ones are no slip: a style may narrow
/// the one that it extends.
fn warn_of_idle_lines(style: &Style, lines: &[StyleLines], report: &mut Report<'_>) {
    for lines in lines.iter().filter(|lines| lines.written_by == style.id && !style.room_types.is_empty()) {
        if !style.room_types.contains(&lines.room_type) {
            let message = format!("style \"{}\" is not made for room type \"{}\"", style.id, lines.room_type);
            report.warning(&lines.spot, message, "add it to `room_types`, or take these lines away");
        }
    }
}

fn by_room_type(lines: &[StyleLines]) -> BTreeMap<String, Vec<Request>> {
    lines.iter().map(|lines| (lines.room_type.clone(), lines.programme.requests.clone())).collect()
}

/// Programmes or additions, merged room type by room type.
fn resolve_lines(
    chain: &Chain<'_, StyleEntry>,
    is_addition: bool,
    world: &StyleWorld<'_>,
    report: &mut Report<'_>,
) -> Vec<StyleLines> {
    let (key, get): (&str, fn(&StyleEntry) -> Option<&Programmes>) = if is_addition {
        ("additions", |entry| entry.additions.as_ref())
    } else {
        ("programmes", |entry| entry.programmes.as_ref())
    };
    let mut lines = Vec::new();
    for room_type in merged_keys(chain, get) {
        let found =
            chain.find(key, |entry| get(entry)?.get(room_type)).expect("the key comes from the chain");
        let spot = found.spot.key(room_type);
        check_room_type(room_type, &spot, world.room_types, report);
        let programme = resolve_programme(found.value, &spot, world.names, report);
        let (room_type, written_by) = (room_type.clone(), found.definition.id.clone());
        lines.push(StyleLines { room_type, written_by, is_addition, spot, programme });
    }
    lines
}

/// Reports a word that is no room type that rooms can be of.
pub(super) fn check_room_type(
    room_type: &str,
    spot: &Spot,
    room_types: &Table<RoomTypeEntry>,
    report: &mut Report<'_>,
) {
    match room_types.get(room_type) {
        Some(definition) if definition.entry.is_abstract => {
            let hint = "name the room types that extend it";
            report.error_with_hint(
                spot,
                format!("room type \"{room_type}\" is abstract, no room is of it"),
                hint,
            );
        }
        Some(_) => (),
        None => report.unknown(spot, "room type", room_type, room_types.ids()),
    }
}

fn resolve_room_type_names(
    chain: &Chain<'_, StyleEntry>,
    world: &StyleWorld<'_>,
    report: &mut Report<'_>,
) -> Vec<String> {
    let Some(found) = chain.find("room_types", |entry| entry.room_types.as_ref()) else { return Vec::new() };
    for (place, room_type) in found.value.items() {
        check_room_type(room_type, &found.spot.item(place), world.room_types, report);
    }
    let mut names: Vec<String> = found.value.items().map(|(_, room_type)| room_type.clone()).collect();
    names.sort();
    names.dedup();
    names
}

fn resolve_geometry(chain: &Chain<'_, StyleEntry>, report: &mut Report<'_>) -> GeometrySet {
    let Some(found) = chain.find("geometry", |entry| entry.geometry.as_ref()) else {
        return GeometrySet::default();
    };
    GeometrySet::find(found.value).unwrap_or_else(|| {
        report.unknown(&found.spot, "geometry set", found.value, GeometrySet::ALL.map(GeometrySet::name));
        GeometrySet::default()
    })
}

/// The palette of a style; any where there is none of its name, which is reported then, or is reported itself.
fn resolve_palette_reference(
    chain: &Chain<'_, StyleEntry>,
    world: &StyleWorld<'_>,
    report: &mut Report<'_>,
) -> PaletteRef {
    let found = chain.find("palette", |entry| entry.palette.as_ref());
    let spot = found.as_ref().map_or_else(|| chain.own().spot.clone(), |found| found.spot.clone());
    let palette = found.map_or_else(|| DEFAULT_PALETTE.to_owned(), |found| found.value.clone());
    if world.palette_table.get(&palette).is_none() {
        report.unknown(&spot, "palette", &palette, world.palette_table.ids());
    }
    world.palettes.find(&palette).unwrap_or_default()
}

fn resolve_untidiness(chain: &Chain<'_, StyleEntry>, report: &mut Report<'_>) -> Untidiness {
    let turn = chain.find("untidiness", |entry| entry.untidiness.as_ref()?.turn.as_ref());
    let distance = chain.find("untidiness", |entry| entry.untidiness.as_ref()?.distance.as_ref());
    let degrees = turn.map_or(0.0, |found| {
        Quantity::degrees("turn", ANGLE).check(*found.value, &found.spot.key("turn"), report)
    });
    let distance = distance.map_or(0.0, |found| {
        let quantity = Quantity::metres("distance", 0.0..=LARGEST_UNTIDINESS);
        quantity.check(*found.value, &found.spot.key("distance"), report)
    });
    Untidiness { turn: degrees.to_radians(), distance }
}
