//! Models as arrays, made once for all levels that show them.

use std::collections::BTreeMap;
use std::sync::{Arc, PoisonError, RwLock};

use super::encode::{Corners, EncodedPrimitive, Painting, encode};
use crate::model::Model;

/// Models as arrays, made once for all levels that show them. Threads may share it.
#[derive(Debug, Default)]
pub struct EncodedModels {
    /// By address and by the painting of each primitive.
    known: RwLock<BTreeMap<(usize, Vec<Painting>), Encoded>>,
}

#[derive(Debug)]
struct Encoded {
    /// Held so that no other model gets its address.
    _model: Arc<Model>,
    primitives: Arc<[EncodedPrimitive]>,
}

impl EncodedModels {
    /// The triangles of a model, with what the painting of each primitive asks for.
    pub(super) fn get(&self, model: &Arc<Model>, paintings: Vec<Painting>) -> Arc<[EncodedPrimitive]> {
        let key = (Arc::as_ptr(model).addr(), paintings);
        let read = self.known.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = read.get(&key) {
            return Arc::clone(&found.primitives);
        }
        drop(read);
        // Two threads may come here at once: both make the same.
        let primitives: Arc<[EncodedPrimitive]> = encode(model, Corners::Joined, |index| key.1[index]).into();
        let made = Encoded { _model: Arc::clone(model), primitives: Arc::clone(&primitives) };
        self.known.write().unwrap_or_else(PoisonError::into_inner).insert(key, made);
        primitives
    }
}
