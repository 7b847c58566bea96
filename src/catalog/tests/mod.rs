//! Tests of the catalogue as a whole.

mod builtin;
mod cases;
mod descriptions;
mod digest;
mod hostile;
mod resolved;
