//! The kinds of differences; their names are part of the output and of `--fail-on`.

use schemars::JsonSchema;
use serde::Serialize;

/// The kinds of differences.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// A level that was added or removed, or stands at another place or height.
    Levels,
    /// A room that was added or removed.
    Rooms,
    /// A room with another outline, hole, column or height.
    Outline,
    /// A room of another type.
    Type,
    /// A room in another style.
    Style,
    /// A room furnished from another seed.
    Seed,
    /// A door, window or passage that was added, removed, moved or changed.
    Openings,
    /// An object that was added.
    Added,
    /// An object that was removed.
    Removed,
    /// An object that stands elsewhere.
    Moved,
    /// An object that is turned.
    Turned,
    /// An object of another size.
    Resized,
    /// An object of another class where one of another class stood.
    Class,
    /// An object in another variant of its class.
    Variant,
    /// An object with other materials.
    Material,
    /// An object that stands on, or belongs to, something else.
    Parent,
    /// A piece that was asked for and is missing now.
    Missing,
    /// A piece that was missing and is no longer.
    MissingGone,
    /// A finding of the audit that is new.
    Findings,
    /// A finding of the audit that is gone.
    FindingsGone,
    /// A room that fails and did not.
    FailedRooms,
    /// Parts of rooms or openings that look different.
    Shell,
    /// Models of furniture that look different.
    Models,
    /// Materials, textures or lights that are defined differently.
    Looks,
    /// Objects that only have another number.
    Renumbered,
    /// The program or the seed of the run.
    Settings,
    /// Other bytes, and none of the above.
    Bytes,
}

impl Kind {
    /// All kinds, in the order of their declaration.
    pub const ALL: [Self; 27] = [
        Self::Levels,
        Self::Rooms,
        Self::Outline,
        Self::Type,
        Self::Style,
        Self::Seed,
        Self::Openings,
        Self::Added,
        Self::Removed,
        Self::Moved,
        Self::Turned,
        Self::Resized,
        Self::Class,
        Self::Variant,
        Self::Material,
        Self::Parent,
        Self::Missing,
        Self::MissingGone,
        Self::Findings,
        Self::FindingsGone,
        Self::FailedRooms,
        Self::Shell,
        Self::Models,
        Self::Looks,
        Self::Renumbered,
        Self::Settings,
        Self::Bytes,
    ];

    /// The word in the output.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Levels => "levels",
            Self::Rooms => "rooms",
            Self::Outline => "outline",
            Self::Type => "type",
            Self::Style => "style",
            Self::Seed => "seed",
            Self::Openings => "openings",
            Self::Added => "added",
            Self::Removed => "removed",
            Self::Moved => "moved",
            Self::Turned => "turned",
            Self::Resized => "resized",
            Self::Class => "class",
            Self::Variant => "variant",
            Self::Material => "material",
            Self::Parent => "parent",
            Self::Missing => "missing",
            Self::MissingGone => "missing-gone",
            Self::Findings => "findings",
            Self::FindingsGone => "findings-gone",
            Self::FailedRooms => "failed-rooms",
            Self::Shell => "shell",
            Self::Models => "models",
            Self::Looks => "looks",
            Self::Renumbered => "renumbered",
            Self::Settings => "settings",
            Self::Bytes => "bytes",
        }
    }

    /// Whether it is about what people see or use, and not about how the file came to be.
    #[must_use]
    pub fn is_visible(self) -> bool {
        !matches!(self, Self::Seed | Self::Renumbered | Self::Settings | Self::Bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_the_serialized_words_and_all_lists_each_once_in_order() {
        for kind in Kind::ALL {
            assert_eq!(serde_json::to_value(kind).unwrap(), kind.name());
        }
        assert!(Kind::ALL.is_sorted() && Kind::ALL.last() == Some(&Kind::Bytes));
    }
}
