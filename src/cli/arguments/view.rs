//! The arguments of `view`.

use clap::Args;

use super::number::whole_number;
use super::{FurnishArguments, SourceArguments};

/// `view`.
#[derive(Clone, Debug, Args)]
pub(crate) struct ViewArguments {
    #[command(flatten)]
    pub(crate) sources: SourceArguments,
    #[command(flatten)]
    pub(crate) furnish: FurnishArguments,
    /// Port on this machine; 0 for any that is free.
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true, value_parser = whole_number::<u16>(0..=65535))]
    pub(crate) port: u16,
    /// Print the address, and open no browser.
    #[arg(long)]
    pub(crate) no_open: bool,
    /// Threads that furnish in the background [default: one for each processor].
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole_number::<usize>(1..=256))]
    pub(crate) threads: Option<usize>,
}
