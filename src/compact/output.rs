//! Compact files as a format of the table, for clients in browsers: all nodes are there with their extras, so that programs which
//! read levels back find what they look for, and all that is drawn is below one more node.

use super::{Coloring, CompactOptions, Instancing, Known, Shapes, write_compact};
use crate::model::Detail;
use crate::output::{LevelToWrite, Output, OutputFormat, TooLarge, WrittenLevel, shared_images};

/// One binary file per level, of few draw calls.
pub(crate) const WEB: OutputFormat = OutputFormat {
    name: "web",
    about: "One binary file per level with few draw calls, for browsers",
    extensions: &["glb"],
    shows_textures: true,
    shares_all_images: false,
    has_index: false,
    is_read_back: true,
    begin: |_, options| {
        let most_draws = if options.detail == Detail::Full { DRAWS_OF_FULL } else { DRAWS_OF_COARSER };
        Box::new(WebOutput { most_draws, instancing: options.instancing, known: Known::default() })
    },
};

/// Draw calls of a level up to which equal models are instances.
const DRAWS_OF_FULL: usize = 380;
const DRAWS_OF_COARSER: usize = 240;
/// Metres of the coarsest steps of positions.
const COARSEST_STEP: f64 = 0.003;

/// The format in a run.
struct WebOutput {
    most_draws: usize,
    instancing: Instancing,
    known: Known,
}

impl Output for WebOutput {
    fn level<'s>(&'s self, level: &LevelToWrite<'s>) -> Result<WrittenLevel<'s>, TooLarge> {
        let options = CompactOptions {
            coloring: Coloring::Materials,
            least_size: 0.0,
            shapes: Shapes::Kept,
            coarsest_step: COARSEST_STEP,
            instancing: self.instancing,
            most_draws: self.most_draws,
            has_normal_maps: true,
            keeps_nodes: true,
        };
        let scene = level.scene;
        let bytes = write_compact(scene, &scene.materials, &self.known, &options)
            .map_err(|error| TooLarge { message: error.to_string(), hint: "split the level" })?;
        Ok(WrittenLevel {
            files: vec![("glb", bytes)],
            shared: shared_images(scene.textures(), level.folder()),
        })
    }
}
