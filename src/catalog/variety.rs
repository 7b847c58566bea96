//! How much the pieces of one room, dwelling or building may differ.

/// Looks of a class whose numbers are equal modulo this have one shape: recipes make four, and further looks differ from
/// these in what varies by chance, as the books in a bookcase do.
pub const SHAPES: u32 = 4;

/// How many kinds, each of one look and size, a level has of a class of full variety: enough that no two beside each other
/// are equal, and few enough that its file stays small.
pub(crate) const KINDS: u32 = 4;

/// How much pieces of a class that are furnished together differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Variety {
    /// All that share a look (see [`Share`](super::Share)) are equal, and those of a room are of one size.
    #[default]
    None,
    /// Likewise of one shape and one size, but each is filled in its own way: bookcases.
    Details,
    /// Those of a room differ in look and size as far as there are kinds of them, four a level: plants, books.
    Full,
}

impl Variety {
    /// The description for people.
    pub(crate) fn describe(self) -> &'static str {
        match self {
            Self::None => "one for all that are furnished together",
            Self::Details => "one shape for all that are furnished together, filled differently",
            Self::Full => "those of a room differ",
        }
    }
}
