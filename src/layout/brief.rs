//! The brief of a room: everything that is fixed before anybody searches.

use core::cell::OnceCell;

use crate::catalog::{Catalog, Style, StyleRef};
use crate::geometry::{Bounds, Point, direction};
use crate::plan::{OpeningKind, RoomOpening, RoomRef};
use crate::walk::EmptyFloors;

use super::arrangement::Arrangement;
use super::choice::{Series, room_style};
use super::fitted_row::FreeRow;
use super::furnished::Furnished;
use super::known::Known;
use super::lock::Lock;
use super::options::FurnishOptions;
use super::programme::{self, Piece, Site};
use super::seed::RoomKey;
use super::suggestion::Alternative;
use super::surroundings::{Surroundings, Swings, main_angle};
use super::variant::Variants;

/// The data that is fixed for a room in all of its alternatives.
pub(crate) struct RoomBrief<'a> {
    at: RoomRef<'a>,
    catalog: &'a Catalog,
    style: StyleRef,
    key: RoomKey,
    /// Drawn once: another attempt must not ask for other pieces.
    pieces: Vec<Piece>,
    /// By piece, the one that may stand in for it first.
    substitutes: Vec<Option<usize>>,
    locks: &'a [Lock],
    /// With [`Swings::Simple`].
    surroundings: OnceCell<Surroundings<'a>>,
    /// With [`Swings::Exact`].
    exact_surroundings: OnceCell<Surroundings<'a>>,
    empty_floors: EmptyFloors<'a>,
    known_arrangements: [Known<Arrangement>; 2],
    known_rows: [Known<FreeRow>; 2],
}

/// The data that is fixed for one alternative of a room: complete when it is made, the same for all attempts.
#[derive(Clone, Copy)]
pub(crate) struct Brief<'a> {
    /// Classes and figures.
    pub(crate) catalog: &'a Catalog,
    /// How the room is furnished.
    pub(crate) style: &'a Style,
    /// The same among the styles of the catalogue.
    pub(crate) style_ref: StyleRef,
    /// The key of its random streams.
    pub(crate) key: &'a RoomKey,
    /// The room.
    pub(crate) at: RoomRef<'a>,
    /// The pieces that are asked for, with those that are locked.
    pub(crate) pieces: &'a [Piece],
    /// By piece, the one that may stand in for it first.
    pub(crate) substitutes: &'a [Option<usize>],
    /// The fixed parts of the room.
    pub(crate) surroundings: &'a Surroundings<'a>,
    /// Where people walk in the empty room.
    pub(crate) empty_floors: &'a EmptyFloors<'a>,
    /// How pieces that look for their places together stand, without and with the heed of tags
    /// ([`super::environment::Start::heeds_tags`]), which changes the points.
    pub(crate) known_arrangements: &'a [Known<Arrangement>; 2],
    /// Rows of fitted units at different walls, of usual and of slim units.
    pub(crate) known_rows: &'a [Known<FreeRow>; 2],
    /// The objects that somebody put in their places.
    pub(crate) locks: &'a [Lock],
    /// Which arrangement is wanted, and where somebody says that agents fit.
    pub(crate) alternative: &'a Alternative,
}

impl<'a> RoomBrief<'a> {
    /// The brief of a room.
    ///
    /// # Errors
    /// The empty room where its type is not furnished.
    pub(crate) fn new(
        at: RoomRef<'a>,
        catalog: &'a Catalog,
        options: &FurnishOptions<'a>,
    ) -> Result<Self, Furnished> {
        // A room that somebody pinned keeps its seed when the run has another.
        let seed = options.pinned.unwrap_or(options.seed);
        let key = RoomKey::new(seed, options.building, at);
        let style = room_style(at, catalog, options);
        let room_type = catalog.room_types.get(&at.room.room_type).filter(|room_type| room_type.is_furnished);
        let Some(room_type) = room_type else {
            return Err(Furnished::empty(at.index, key.seed(), style));
        };
        let series = Series::new(at, catalog, options);
        let variants = Variants { seed, series, key: &key };
        let mut pieces = programme::pieces(catalog, &catalog.styles[style], room_type, site(at), &variants);
        programme::add_locked(&mut pieces, options.locks, catalog);
        Ok(Self {
            at,
            catalog,
            style,
            key,
            substitutes: substitutes(&pieces),
            pieces,
            locks: options.locks,
            surroundings: OnceCell::new(),
            exact_surroundings: OnceCell::new(),
            empty_floors: EmptyFloors::new(at, &catalog.audit),
            known_arrangements: Default::default(),
            known_rows: Default::default(),
        })
    }

    /// The brief of one alternative.
    pub(crate) fn alternative<'b>(&'b self, alternative: &'b Alternative) -> Brief<'b> {
        // Places found in the empty room are tight: they are tested against the true arcs of the leaves, which takes longer.
        let surroundings = if alternative.suggestions.is_empty() {
            self.surroundings.get_or_init(|| self.surroundings_with(Swings::Simple))
        } else {
            self.exact_surroundings.get_or_init(|| self.surroundings_with(Swings::Exact))
        };
        let Self { catalog, style: style_ref, key, at, pieces, substitutes, locks, .. } = self;
        Brief {
            catalog,
            style: &catalog.styles[*style_ref],
            style_ref: *style_ref,
            key,
            at: *at,
            pieces,
            substitutes,
            surroundings,
            empty_floors: &self.empty_floors,
            known_arrangements: &self.known_arrangements,
            known_rows: &self.known_rows,
            locks,
            alternative,
        }
    }

    fn surroundings_with(&self, swings: Swings) -> Surroundings<'a> {
        Surroundings::new(self.at, &self.catalog.audit, swings)
    }
}

fn substitutes(pieces: &[Piece]) -> Vec<Option<usize>> {
    let mut substitutes = vec![None; pieces.len()];
    // Backwards: of several the first is asked for first.
    for (index, piece) in pieces.iter().enumerate().rev() {
        if let Some(before) = piece.substitute_for {
            substitutes[before] = Some(index);
        }
    }
    substitutes
}

fn site(at: RoomRef<'_>) -> Site<'_> {
    let RoomRef { level, room, .. } = at;
    let is_window = |side: &&RoomOpening| level.openings[side.opening].kind == OpeningKind::Window;
    let windows = room.openings.iter().filter(is_window).count();
    let window_count = u32::try_from(windows).expect("a room has fewer than 2^32 windows");
    let along = direction(main_angle(room));
    let local = |corner: &Point| Point::new(corner.dot(along), corner.dot(along.perp()));
    let extent = Bounds::around(room.region.outline.corners().iter().map(local)).size();
    Site { area: room.region.area(), window_count, home: room.home.as_ref(), extent }
}
