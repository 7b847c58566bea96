//! The keys of `configs/classes/*.yaml`.

use std::borrow::Cow;
use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

use super::building_style::ShareWord;
use super::{Edges, ExtentText, FormatVersion, OneOrMany, Pair, VariedEntry};
use crate::catalog::LightSide;
use crate::catalog::table::Extends;
use crate::catalog::{Along, Era, FittedPart, Side, Turn};

/// Classes of furniture: what they are, where they may stand, what may stand on them.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Classes")]
pub(crate) struct ClassFile {
    #[expect(dead_code, reason = "checked while reading")]
    pub(crate) version: FormatVersion,
    /// The classes by id: lower-case words joined by `_`.
    pub(crate) classes: BTreeMap<String, ClassEntry>,
}

/// The semantic description of one class. Lengths in metres, angles in degrees; seen from above, width is
/// along x and depth along y, the front is at -y, and right is the right hand of a person before the front.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClassEntry {
    /// A title for people; the id with spaces if absent.
    pub(crate) label: Option<String>,
    /// Another class, whose keys are taken where this one has none. Lists and maps are replaced whole, but
    /// `sides` is merged side by side. A class that names itself builds on the definition of an earlier folder.
    pub(crate) extends: Option<String>,
    /// Whether it is only there to be extended; never inherited.
    #[serde(default, rename = "abstract")]
    pub(crate) is_abstract: bool,
    /// Further names under which parents, relations, programmes and `excludes` may refer to it.
    pub(crate) groups: Option<OneOrMany<String>>,
    /// The sizes it is made in, each [width, depth, height].
    pub(crate) sizes: Option<Vec<[f64; 3]>>,
    /// Smaller sizes, taken only where none of `sizes` has a place: each [width, depth, height].
    #[serde(default)]
    pub(crate) spare_sizes: Vec<[f64; 3]>,
    /// Wider sizes that only fill niches: a piece that is `joint` takes one where it reaches from a corner to what closes its other
    /// side, each [width, depth, height].
    #[serde(default)]
    pub(crate) niche_sizes: Vec<[f64; 3]>,
    /// How many looks of each size the recipe makes; default 4.
    pub(crate) looks: Option<i64>,
    /// Whether each piece has a look and a size of its own, like plants and books; else pieces that are furnished
    /// together look alike. `details`: they are of one shape and size, but filled differently, like bookcases.
    pub(crate) varied: Option<VariedEntry>,
    /// The rooms in which these pieces look alike, whatever room types and styles say; `building` for fittings, as baths.
    pub(crate) share: Option<ShareWord>,
    /// The solid parts of its box: `box` (default), `disc`, or a list of parts.
    pub(crate) shape: Option<ShapeEntry>,
    /// Where it may stand, best first.
    pub(crate) parents: Option<OneOrMany<ParentEntry>>,
    /// The places that its own sides offer to children; sides that are not named offer none.
    pub(crate) sides: Option<SidesEntry>,
    /// Regions before its sides that no body may enter.
    pub(crate) clearances: Option<OneOrMany<ClearanceEntry>>,
    /// Wishes about objects that are not its parent.
    pub(crate) relations: Option<OneOrMany<RelationEntry>>,
    /// It lies on the floor under the first of these that stands in the room, and others stand on it: a rug. It is at most
    /// 2 cm high, and laid when all others have their places.
    pub(crate) covers: Option<OneOrMany<String>>,
    /// It is taken away again where none of these stands on it: a television stand.
    pub(crate) carries: Option<OneOrMany<String>>,
    /// It is taken away again where no other of its class stands beside it and others have company: a seat of an auditorium, a
    /// shelf between aisles; default false.
    pub(crate) company: Option<bool>,
    /// Regular intervals instead of random positions.
    pub(crate) grid: Option<GridEntry>,
    /// The part that it plays in a row of fitted units, such as a kitchen: rooms plan the row as a whole, before anything else
    /// is placed. Its depth is that of the row.
    pub(crate) fitted: Option<FittedPart>,
    /// Whether its place is sought together with those of the room's other such pieces, before anything else is placed: toilet,
    /// basin and bath; default false. It stands at walls.
    pub(crate) joint: Option<bool>,
    /// The walls that it likes, as points that count beside its `relations`.
    pub(crate) walls: Option<WallsEntry>,
    /// Pieces with a lower number are left out first when space is short; default 0.
    pub(crate) priority: Option<i32>,
    /// The eras that it is drawn for in styles that name one; any if absent.
    pub(crate) eras: Option<OneOrMany<Era>>,
    /// The cost, 1 (cheap) to 3 (expensive), as a number or [lowest, highest]: styles that name another `wealth` do not
    /// draw it; any if absent.
    pub(crate) wealth: Option<Pair>,
    /// How it looks: a recipe, or a model file.
    pub(crate) model: Option<ModelEntry>,
    /// The light that it gives; none if absent.
    pub(crate) light: Option<LightEntry>,
}

/// The walls that a piece likes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WallsEntry {
    /// Points at walls with a tag: `pipes: 2` to stand there, `door: -5` to keep away. Tags are those of the plan, and
    /// `pipes`, `door`, `window`, `open`, `opposite_door`, `end` (of the long axis, away from the doors), `blind`, `longest`, `exterior`, `interior`, `railing`.
    #[serde(default)]
    pub(crate) tags: BTreeMap<String, f64>,
    /// Points at walls where a piece of a class or group stands already: `wc: 3`.
    #[serde(default)]
    pub(crate) with: BTreeMap<String, f64>,
    /// Points for each metre that the wall is long, up to 4 m; default 0.
    pub(crate) metre: Option<f64>,
    /// Points in a corner: where its left or right side is closed, by another wall or by what stands there; default 0.
    pub(crate) corner: Option<f64>,
    /// Points where half of its left or right side is closed, as by a jog of the wall beside its head; default 0.
    pub(crate) half_corner: Option<f64>,
}

/// The light of a lamp.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LightEntry {
    /// Luminous flux in lumens, as printed on bulbs: 400 for a table lamp, 4000 for an office panel.
    pub(crate) lumens: f64,
    /// Colour temperature: 2700 warm white, 4000 neutral, 6500 daylight; default 2700.
    pub(crate) kelvin: Option<f64>,
    /// Where the light comes out of the box; default `below`.
    pub(crate) from: Option<LightSide>,
}

impl ClassEntry {
    /// The model file whose size is the class's own, if this definition says so.
    pub(crate) fn sized_file(&self) -> Option<(&ModelFields, f64)> {
        match &self.model {
            Some(ModelEntry::Fields(fields)) => fields.scale.map(|scale| (fields, scale)),
            _ => None,
        }
    }
}

impl Extends for ClassEntry {
    const KIND: &'static str = "class";
    const TABLE: &'static str = "classes";

    fn base(&self) -> Option<&str> {
        self.extends.as_deref()
    }
}

/// The solid parts of a box.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub(crate) enum ShapeEntry {
    /// `box` or `disc`.
    Word(String),
    /// Boxes and discs.
    Parts(Vec<PartEntry>),
}

impl JsonSchema for ShapeEntry {
    fn schema_name() -> Cow<'static, str> {
        "Shape".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let part = generator.subschema_for::<PartEntry>();
        json_schema!({
            "anyOf": [{"enum": ["box", "disc"]}, {"type": "array", "items": part, "minItems": 1}]
        })
    }
}

/// A box-shaped or round part of a shape.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PartEntry {
    /// Whether the part is round.
    #[serde(default)]
    pub(crate) disc: bool,
    /// Its left, front and underside.
    pub(crate) from: [ExtentText; 3],
    /// Its right, back and top.
    pub(crate) to: [ExtentText; 3],
}

/// One way to stand somewhere.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ParentEntry {
    /// `floor`, `ceiling`, `wall`, `door`, `window`, `column`, or classes and groups.
    pub(crate) on: OneOrMany<String>,
    /// The parent's sides that will do, best first. Needed where the parent is a class; room parts have
    /// their own: floor above, ceiling below, wall, door and window front, column all four.
    pub(crate) side: Option<OneOrMany<Side>>,
    /// A tag that the wall or room must carry.
    pub(crate) tag: Option<String>,
    /// How to turn; default `quarter` on the floor, else `parallel`.
    pub(crate) turn: Option<Turn>,
    /// Random offset of the turn, up to this many degrees either way; default 0.
    pub(crate) jitter: Option<f64>,
    /// Where along the side; default `random`.
    pub(crate) along: Option<Along>,
    /// Metres between the touching sides; below zero it slides under the parent; default 0.
    pub(crate) gap: Option<Pair>,
    /// Metres of the underside above the floor, for what hangs; default 0.
    pub(crate) elevation: Option<Pair>,
    /// On a window or door: metres of the top above its head, in place of `elevation`. The piece then covers the
    /// opening and takes the largest of its sizes that is not much wider and higher.
    pub(crate) above_head: Option<f64>,
}

/// The places that the sides offer to children.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SidesEntry {
    /// Where one uses it from.
    pub(crate) front: Option<SideEntry>,
    /// Opposite the front.
    pub(crate) back: Option<SideEntry>,
    /// Left of the person before the front.
    pub(crate) left: Option<SideEntry>,
    /// Right of the person before the front.
    pub(crate) right: Option<SideEntry>,
    /// The top.
    pub(crate) above: Option<SideEntry>,
    /// The underside.
    pub(crate) below: Option<SideEntry>,
}

impl SidesEntry {
    /// The keys of a side.
    pub(crate) fn get(&self, side: Side) -> Option<&SideEntry> {
        match side {
            Side::Front => self.front.as_ref(),
            Side::Back => self.back.as_ref(),
            Side::Left => self.left.as_ref(),
            Side::Right => self.right.as_ref(),
            Side::Above => self.above.as_ref(),
            Side::Below => self.below.as_ref(),
        }
    }
}

/// The places that one side offers to children.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SideEntry {
    /// How many children it takes.
    pub(crate) places: Option<i64>,
    /// Metres free along the side; default its length.
    pub(crate) space: Option<f64>,
    /// Above only: height of the carrying surface where it is not the top of the box (a mattress).
    pub(crate) surface: Option<f64>,
    /// Above only: metres at the edges that do not carry, one number or [left, front, right, back].
    pub(crate) margin: Option<Edges>,
}

/// A region before a side that people need to use it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClearanceEntry {
    /// Before which sides: front, back, left or right.
    pub(crate) side: OneOrMany<Side>,
    /// Metres that must stay free.
    pub(crate) minimum: f64,
    /// Metres that should stay free; default `minimum`.
    pub(crate) good: Option<f64>,
    /// Metres left and right of the side's ends that belong to it; default 0.
    pub(crate) margin: Option<f64>,
    /// Metres from the underside up to which it reaches; default 2.
    pub(crate) height: Option<f64>,
    /// Whether children of that side may stand in it (the chair before a desk); default false.
    #[serde(default)]
    pub(crate) children: bool,
    /// Whether one of the sides is enough (the side by which people get into a bed); default false: all of them.
    #[serde(default)]
    pub(crate) either: bool,
}

/// A wish about another object: exactly one of the kinds, with what it is about (classes, groups, or
/// `window`, `door`, `wall`, `column`).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RelationEntry {
    /// Its front points at the target.
    pub(crate) faces: Option<OneOrMany<String>>,
    /// Its front points at the target, and no wall of the room is between them. Rows of a class that sees something begin before it, go
    /// across its axis, and reach as far to both sides as the room usually does.
    pub(crate) sees: Option<OneOrMany<String>>,
    /// Stands across from the target, fronts towards each other.
    pub(crate) opposite: Option<OneOrMany<String>>,
    /// Within the distance.
    pub(crate) near: Option<OneOrMany<String>>,
    /// At least the lowest distance away.
    pub(crate) away_from: Option<OneOrMany<String>>,
    /// Not in front of the target.
    pub(crate) not_before: Option<OneOrMany<String>>,
    /// Side by side with the target.
    pub(crate) beside: Option<OneOrMany<String>>,
    /// Fronts or backs on one line.
    pub(crate) aligned_with: Option<OneOrMany<String>>,
    /// The body is at least the lowest distance away from where the leaves of the target (`door`) swing.
    pub(crate) clear_of: Option<OneOrMany<String>>,
    /// Metres that are good, [lowest, highest]; one number is the highest, from 0, but the lowest of
    /// `away_from` and `clear_of`.
    pub(crate) distance: Option<Pair>,
    /// Degrees off the axis that are good; default 30.
    pub(crate) angle: Option<f64>,
    /// Share in the score; default 1.
    pub(crate) weight: Option<f64>,
    /// Whether the object is left out where this is not met (a television that no seat faces); default false.
    #[serde(default)]
    pub(crate) needed: bool,
}

/// A regular layout.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct GridEntry {
    /// Metres between neighbours, one number or [along x, along y]: along the width and the depth of the class
    /// where it turns by quarters, else of the parent's side.
    pub(crate) interval: Pair,
    /// Most places along x and along y without an aisle; blocks differ by one place at most. Default [0, 0], no aisles.
    pub(crate) block: Option<[i64; 2]>,
    /// Metres that an aisle adds to the interval; default 0.
    pub(crate) aisle: Option<f64>,
    /// Whether the grid is centred on the side instead of starting at a random place; default false.
    #[serde(default)]
    pub(crate) centered: bool,
    /// Whether an aisle is in the middle, with as many columns on both sides of it; default false.
    #[serde(default)]
    pub(crate) halved: bool,
    /// Whether two stand back to back at each place, which their depths share; default false.
    #[serde(default)]
    pub(crate) back_to_back: bool,
    /// Metres that stay free between the outermost pieces and the walls, one number or [left, front, right, back];
    /// given up along the width or the depth where it would leave nothing; default 0.
    pub(crate) margin: Option<Edges>,
}

/// How a class looks.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub(crate) enum ModelEntry {
    /// The name of a recipe.
    Recipe(String),
    /// A recipe with parameters, or a file.
    Fields(ModelFields),
}

/// The long form of a model.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct ModelFields {
    /// The name of a recipe.
    pub(crate) recipe: Option<String>,
    /// A `.glb` or `.gltf`, relative to the file that names it.
    pub(crate) file: Option<String>,
    /// Degrees by which the file's model is turned so that its front faces +Z.
    pub(crate) turn: Option<f64>,
    /// The class has the size of the file's model times this, in place of `sizes`.
    pub(crate) scale: Option<f64>,
    /// Parameters of the recipe.
    #[serde(flatten)]
    pub(crate) parameters: BTreeMap<String, Parameter>,
}

/// A parameter of a recipe.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged)]
pub(crate) enum Parameter {
    /// A number.
    Number(f64),
    /// On is 1, off is 0.
    Switch(bool),
}

impl JsonSchema for ModelEntry {
    fn schema_name() -> Cow<'static, str> {
        "Model".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": ["string", "object"],
            "properties": {
                "recipe": {"type": "string", "description": "The name of a recipe; its parameters stand beside it."},
                "file": {"type": "string", "description": "A .glb or .gltf file, relative to this file."},
                "turn": {"type": "number", "description": "Degrees that turn the file's front to +Z."},
                "scale": {"type": "number", "description": "The class has the size of the file's model times this, in place of `sizes`; without it, the model is fitted to `sizes`."}
            },
            "additionalProperties": {"type": ["number", "boolean"]}
        })
    }
}
