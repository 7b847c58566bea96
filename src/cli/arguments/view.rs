//! The arguments of `view`.

use std::path::PathBuf;

use clap::Args;

use super::number::whole_number;
use super::path::path_or_nothing;
use super::{FurnishArguments, SourceArguments, TextureWord};

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
    /// Resolution of the textures of wood, cloth, tiles and other surfaces.
    #[arg(long, value_enum, default_value = "small")]
    pub(crate) textures: TextureWord,
    /// Folder that keeps textures between runs, or `none` [default: roomwright/ in the system's folder for caches].
    #[arg(long, value_name = "DIR|none", env = "ROOMWRIGHT_CACHE", hide_env_values = true, value_parser = path_or_nothing())]
    pub(crate) cache: Option<PathBuf>,
    /// Print the address, and open no browser.
    #[arg(long)]
    pub(crate) no_open: bool,
    /// Threads that furnish in the background [default: one for each processor].
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole_number::<usize>(1..=256))]
    pub(crate) threads: Option<usize>,
}
