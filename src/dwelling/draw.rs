//! Numbers that rooms have in common.

use sha2::{Digest, Sha256};

/// A number even in [0, 1) that depends on the seed and the names only: what rooms share that share the names.
pub(crate) fn shared_draw<Name: AsRef<str>>(seed: u64, names: impl IntoIterator<Item = Name>) -> f64 {
    let mut hash = Sha256::new_with_prefix("shared");
    hash.update(seed.to_le_bytes());
    for name in names {
        let name = name.as_ref();
        hash.update((name.len() as u64).to_le_bytes());
        hash.update(name.as_bytes());
    }
    let bytes = hash.finalize();
    let number = u32::from_le_bytes(bytes[..4].try_into().expect("a hash has 32 bytes"));
    // Of 2^32: never 1, so that a share of one is always met.
    f64::from(number) / 4_294_967_296.0
}
