//! Why a document is not of a type.

use std::fmt::{self, Display};

use serde::de::{Error, Expected, Unexpected};

use crate::document::PathStep;

/// The first reason that was met.
#[derive(Debug)]
pub(in crate::document) struct Mismatch(Box<Reason>);

#[derive(Debug)]
struct Reason {
    message: String,
    /// From the inside outwards.
    path: Vec<PathStep>,
}

impl Mismatch {
    /// The message, and the path of the value that it is about.
    pub(in crate::document) fn into_parts(self) -> (String, Vec<PathStep>) {
        let Reason { message, mut path } = *self.0;
        path.reverse();
        (message, path)
    }

    #[cold]
    pub(super) fn below(mut self, step: PathStep) -> Self {
        self.0.path.push(step);
        self
    }
}

impl Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.message)
    }
}

impl std::error::Error for Mismatch {}

impl Error for Mismatch {
    #[cold]
    fn custom<T: Display>(message: T) -> Self {
        Self(Box::new(Reason { message: message.to_string(), path: Vec::new() }))
    }

    /// Of numbers, the reader of a whole number knows no more than how its program keeps it.
    #[cold]
    fn invalid_value(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        match found {
            Unexpected::Signed(number) => {
                Self::custom(format!("{number} is too large or too small for a number here"))
            }
            Unexpected::Unsigned(number) => Self::custom(format!("{number} is too large for a number here")),
            _ => Self::custom(format!("invalid value: {found}, expected {expected}")),
        }
    }
}
